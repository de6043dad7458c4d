//! Pictures by photons from the source.

use super::angles::Angles;
use super::estimate::{BATCHES, batches};
use super::{Camera, End, Estimate, Orders, Photon, Random, Scene};

/// Points of a photon's way, between two collisions, at which it is seen.
const POINTS: u32 = 4;

/// What became of a source's light.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ledger {
    /// The flux of all photons that started, in W.
    pub emitted: f64,
    /// That of those that left the box.
    pub escaped: f64,
    /// That of those that the medium absorbed, by the collision at which it did, from the first one.
    pub absorbed: Vec<f64>,
}

impl Ledger {
    fn enter(&mut self, flux: f64, end: End) {
        self.emitted += flux;
        match end {
            End::Escaped => self.escaped += flux,
            End::Absorbed(collision) => {
                let needed = self.absorbed.len().max(collision as usize);
                self.absorbed.resize(needed, 0.0);
                self.absorbed[collision as usize - 1] += flux;
            }
        }
    }

    fn add(&mut self, other: &Self) {
        self.emitted += other.emitted;
        self.escaped += other.escaped;
        self.absorbed.resize(self.absorbed.len().max(other.absorbed.len()), 0.0);
        self.absorbed.iter_mut().zip(&other.absorbed).for_each(|(sum, flux)| *sum += flux);
    }
}

/// A picture by photons.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The mean radiance over the area of each pixel, row by row from the top, in W / (sr · world unit²).
    pub pixels: Vec<Orders>,
    /// What became of the light.
    pub ledger: Ledger,
}

/// The picture of scattered light that photons make, which are seen from the eye on all their ways through the medium:
/// the ball hides what is behind it, and what one would see mirrored in it or through it is not in the picture.
///
/// Its variance is finite if the eye is outside of the medium. Within, a photon that passes the eye at a distance h
/// counts as 1 / h, and the variance has no limit, though it grows with the number of photons only as its logarithm:
/// now and then a pixel is off by more than its error says.
///
/// `photons` are rounded up to batches of equal size.
#[must_use]
pub fn picture(scene: &Scene, camera: &Camera, photons: u64, seed: u64) -> Picture {
    let each = photons.div_ceil(BATCHES).max(1);
    let share = 1.0 / each as f64;
    let parts = batches(seed, |random| {
        let (mut sums, mut ledger) = (vec![[0.0; 2]; camera.pixels()], Ledger::default());
        for _ in 0..each {
            let photon = Photon::start(scene, random);
            let end = photon.follow(scene, random, |photon, way, collisions, random| {
                shine(scene, camera, photon, way, random, |pixel, radiance| {
                    sums[pixel][usize::from(collisions > 0)] += radiance * share;
                });
            });
            ledger.enter(photon.flux * share / BATCHES as f64, end);
        }
        (sums, ledger)
    });
    let of = |pixel: usize, part: usize| Estimate::of(parts.iter().map(move |(sums, _)| sums[pixel][part]));
    let pixels = (0..camera.pixels()).map(|pixel| Orders { once: of(pixel, 0), more: of(pixel, 1) }).collect();
    let mut ledger = Ledger::default();
    parts.iter().for_each(|(_, part)| ledger.add(part));
    Picture { pixels, ledger }
}

/// Calls `adds` with the pixels, and the mean radiance in each, that light of one straight part of a photon's way
/// makes, at some random points of what the picture shows of it.
fn shine(
    scene: &Scene,
    camera: &Camera,
    photon: &Photon,
    way: [f64; 2],
    random: &mut Random,
    mut adds: impl FnMut(usize, f64),
) {
    let Some(shown) = camera.shows(photon.at, photon.towards, way) else { return };
    let (medium, eye) = (&scene.medium, camera.eye());
    let angles = Angles::new(eye, photon.at, photon.towards, shown);
    for point in 0..POINTS {
        let distance = angles.at((f64::from(point) + random.share()) / f64::from(POINTS));
        let at = photon.at + photon.towards * distance;
        let Some((pixel, seen)) = camera.sees(at) else { continue };
        if scene.ball.is_some_and(|ball| ball.hides(at, eye)) {
            continue;
        }
        let phase = medium.phase((eye - at).normalize().dot(photon.towards));
        let transmittance = medium.behind(distance - way[0]) * medium.transmittance(eye, at);
        let density = f64::from(POINTS) * angles.density(distance);
        adds(pixel, photon.flux * medium.scattering * phase * transmittance * seen / density);
    }
}
