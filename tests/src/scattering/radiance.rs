//! Radiance by paths from the eye.
//!
//! Light that was scattered n times comes along a path of n vertices from the eye. The last vertex is not the end of a
//! free path, since the light of a lamp grows without limit near it and the variance with it: it is drawn at equal
//! angles as seen from the lamp (Kulla and Fajardo 2012). Nor is the ray that it lies on drawn from the phase function
//! alone, since the airlight of a ray that passes the lamp at a distance h grows as 1 / h. The variance is finite then.

use super::angles::Angles;
use super::estimate::{BATCHES, batches};
use super::{Camera, Estimate, Lamp, Orders, Random, Scene};
use std::f64::consts::PI;
use vitrum_kernels::glam::DVec3;

/// The least weight of a path, as a share of what it started with, that is followed for certain.
const LEAST_WEIGHT: f64 = 0.25;

/// Points of a ray at which its airlight is taken.
const POINTS: u32 = 4;

/// The least sine of the angle between a ray and the direction of a lamp, so that nothing is divided by 0.
const LEAST_SINE: f64 = 1e-12;

/// Radiance in the eye along a viewing ray of a unit direction, of light that was scattered once, and of light that was
/// scattered twice to `highest` times, in W / (sr · world unit²). Light from the source itself is not in it, and the
/// scene's ball is left out.
///
/// `samples` are rounded up to batches of equal size.
#[must_use]
pub fn radiance(scene: &Scene, eye: DVec3, direction: DVec3, highest: u32, samples: u64, seed: u64) -> Orders {
    mean(scene, highest, samples, seed, |_| (eye, direction))
}

/// The mean radiance over the area of a pixel, by its column and row from the upper left one; else as [`radiance`].
#[must_use]
pub fn pixel(
    scene: &Scene,
    camera: &Camera,
    [column, row]: [usize; 2],
    highest: u32,
    samples: u64,
    seed: u64,
) -> Orders {
    mean(scene, highest, samples, seed, |random| {
        let (across, down) = (column as f64 + random.share(), row as f64 + random.share());
        (camera.eye(), camera.direction(across, down))
    })
}

/// The mean over viewing rays.
fn mean(
    scene: &Scene,
    highest: u32,
    samples: u64,
    seed: u64,
    ray: impl Fn(&mut Random) -> (DVec3, DVec3) + Sync,
) -> Orders {
    let each = samples.div_ceil(BATCHES).max(1);
    let parts = batches(seed, |random| {
        let mut sums = [0.0; 2];
        for _ in 0..each {
            let (eye, direction) = ray(random);
            let found = path(scene, eye, direction, highest, random);
            sums = [0, 1].map(|part: usize| sums[part] + found[part]);
        }
        sums.map(|sum| sum / each as f64)
    });
    let of = |part: usize| Estimate::of(parts.iter().map(move |sums| sums[part]));
    Orders { once: of(0), more: of(1) }
}

/// The radiance of one path along a viewing ray: scattered once, and more often.
fn path(scene: &Scene, eye: DVec3, direction: DVec3, highest: u32, random: &mut Random) -> [f64; 2] {
    let medium = &scene.medium;
    let Some(crossing) = medium.crossing(eye, direction) else { return [0.0; 2] };
    let once = airlight(scene, eye, direction, random);
    let (distance, start) = first_vertex(scene, eye, direction, crossing, random);
    let (mut at, mut towards, mut weight, mut more) = (eye + direction * distance, direction, 1.0, 0.0);
    for _ in 2..=highest {
        more += weight * scattered(scene, at, towards, random);
        towards = medium.scatter(towards, random);
        let flight = random.exponential() / medium.extinction();
        if medium.crossing(at, towards).is_none_or(|[_, leaves]| flight >= leaves) {
            break;
        }
        at += towards * flight;
        weight *= medium.albedo();
        if weight < LEAST_WEIGHT {
            if random.happens(0.5) {
                break;
            }
            weight *= 2.0;
        }
    }
    [once, start * more]
}

/// A distance along a viewing ray, and σ_s times the transmittance to it over its density. Half the time it is drawn
/// from the free paths within the box, and half the time, if there is a lamp, at equal angles from it, near which there
/// is most light.
fn first_vertex(
    scene: &Scene,
    eye: DVec3,
    towards: DVec3,
    [enters, leaves]: [f64; 2],
    random: &mut Random,
) -> (f64, f64) {
    let medium = &scene.medium;
    let (extinction, length) = (medium.extinction(), leaves - enters);
    let collides = 1.0 - medium.behind(length);
    let angles = match scene.lamp {
        Lamp::Point { position, .. } => Some(Angles::new(position, eye, towards, [enters, leaves])),
        Lamp::Distant { .. } => None,
    };
    let distance = match &angles {
        Some(angles) if random.happens(0.5) => angles.at(random.share()),
        _ => enters + free_path(random.share() * collides, extinction),
    };
    let transmittance = medium.behind(distance - enters);
    let free = extinction * transmittance / collides;
    let density = angles.map_or(free, |angles| 0.5 * (free + angles.density(distance)));
    (distance, medium.scattering * transmittance / density)
}

/// The free path than which a share of all are shorter.
fn free_path(share: f64, extinction: f64) -> f64 {
    -(1.0 - share).ln() / extinction
}

/// Radiance that a vertex scatters of light that was scattered once before, per σ_s and length. Rays to the sides are
/// drawn from the phase function and, if there is a lamp, at equal angles from it, where the airlight of a ray grows as
/// the inverse sine; each is weighted by the densities of both (the balance heuristic of Veach 1997).
fn scattered(scene: &Scene, at: DVec3, towards: DVec3, random: &mut Random) -> f64 {
    let medium = &scene.medium;
    let freely = medium.scatter(towards, random);
    let Lamp::Point { position, .. } = scene.lamp else { return airlight(scene, at, freely, random) };
    let to_lamp = (position - at).normalize();
    let aside = random.at_equal_angles(to_lamp);
    let mut of = |direction: DVec3| {
        let sine = direction.cross(to_lamp).length().max(LEAST_SINE);
        let phase = medium.phase(direction.dot(towards));
        phase / (phase + 1.0 / (2.0 * PI * PI * sine)) * airlight(scene, at, direction, random)
    };
    of(freely) + of(aside)
}

/// Radiance along a ray of light that was scattered once, at random points of the ray, each in its part of all.
fn airlight(scene: &Scene, from: DVec3, towards: DVec3, random: &mut Random) -> f64 {
    let medium = &scene.medium;
    let Some([enters, leaves]) = medium.crossing(from, towards) else { return 0.0 };
    let shares = (0..POINTS).map(|point| (f64::from(point) + random.share()) / f64::from(POINTS));
    let sum: f64 = match scene.lamp {
        Lamp::Point { position, intensity } => {
            let angles = Angles::new(position, from, towards, [enters, leaves]);
            let of = |share: f64| {
                let distance = angles.at(share);
                let at = from + towards * distance;
                let way = at - position;
                let phase = medium.phase(-way.dot(towards) / way.length());
                let transmittance = medium.behind(distance - enters) * medium.transmittance(position, at);
                medium.scattering * intensity * phase * transmittance
                    / (way.length_squared() * angles.density(distance))
            };
            shares.map(of).sum()
        }
        Lamp::Distant { direction, irradiance } => {
            let collides = 1.0 - medium.behind(leaves - enters);
            let intensity = medium.albedo() * collides * irradiance * medium.phase(-direction.dot(towards));
            let of = |share: f64| {
                let at = from + towards * (enters + free_path(share * collides, medium.extinction()));
                intensity * medium.crossing(at, -direction).map_or(1.0, |[_, way]| medium.behind(way))
            };
            shares.map(of).sum()
        }
    };
    sum / f64::from(POINTS)
}
