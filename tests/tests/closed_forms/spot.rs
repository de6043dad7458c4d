//! 8: a ball lens, R = 1, n = 1.5: the share of its light inside radius a on the plane at distance z behind its centre. At z = 1.5 is
//! the focus; behind it light crosses, and only light carried forward is right there.

use crate::setup::{backends, cube, light_on_planes, refracting};
use vitrum::backend::Backend;
use vitrum::method::sweep::Sweep;
use vitrum::scene::Transport;
use vitrum::{Assets, OutputRequest};
use vitrum_conformance::closed_forms::BEYOND;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::rays::follow;

/// (z, a, share).
const TRUTH: [(f64, f64, f64); 9] = [
    (1.5, 0.05, 0.2776),
    (1.5, 0.1, 0.4061),
    (1.5, 0.25, 0.6226),
    (1.5, 0.5, 0.7878),
    (2.0, 0.1, 0.0739),
    (2.0, 0.25, 0.2694),
    (2.0, 0.5, 0.5106),
    (3.0, 0.25, 0.0571),
    (3.0, 0.5, 0.1840),
];

/// Where the ray at impact height h meets the plane at z, by Snell's law at both surfaces.
fn radius(h: f64, z: f64) -> f64 {
    let turn = 2.0 * (h.asin() - (h / 1.5).asin());
    // At the rim light turns by more than 90° and meets no plane behind.
    if turn.cos() > 0.0 { (h - z * turn.sin()).abs() / turn.cos() } else { f64::INFINITY }
}

/// The share of a parallel beam of radius 1 that falls inside radius `a`.
fn share(z: f64, a: f64) -> f64 {
    const RINGS: u32 = 100_000;
    let inside = (0..RINGS).filter(|ring| radius(((f64::from(*ring) + 0.5) / f64::from(RINGS)).sqrt(), z) < a);
    inside.count() as f64 / f64::from(RINGS)
}

#[test]
fn the_table_is_snells_law() {
    for (z, a, truth) in &TRUTH {
        assert!((share(*z, *a) - truth).abs() < 2e-4, "z = {z}, a = {a}: {} instead of {truth}", share(*z, *a));
    }
}

/// Edge of the volume.
const SIZE: f32 = 2.4;

/// The thickness of the ball's surface: five voxels of `n`³.
fn thickness(n: u32) -> f64 {
    5.0 * f64::from(SIZE) / f64::from(n)
}

/// The index of refraction at the distance `r` from the centre of a ball whose surface is so thick, and its slope.
fn ior(r: f64, thickness: f64) -> (f64, f64) {
    let t = ((1.0 - r) / thickness + 0.5).clamp(0.0, 1.0);
    (1.0 + 0.5 * t * t * (3.0 - 2.0 * t), -3.0 * t * (1.0 - t) / thickness)
}

/// As [`radius`], through the thick surface.
fn radius_through(h: f64, z: f64, thickness: f64) -> f64 {
    const STEPS: u32 = 2000;
    let slope = |x: [f64; 2]| {
        let r = x[0].hypot(x[1]);
        let (eta, slope) = ior(r, thickness);
        x.map(|along| eta * slope * along / r)
    };
    let outside = 1.0 + 0.5 * thickness;
    let left = follow(&slope, h, [-outside, outside], 2.0 * outside / f64::from(STEPS));
    left.map_or(f64::INFINITY, |left| left.across_at(z).abs())
}

/// As [`share`], through the thick surface, of all light that it bends.
fn share_through(z: f64, a: f64, thickness: f64) -> f64 {
    const RINGS: u32 = 4000;
    let outside = (1.0 + 0.5 * thickness).powi(2);
    let at = |ring: u32| (f64::from(ring) + 0.5) / f64::from(RINGS) * outside;
    let inside = (0..RINGS).filter(|ring| radius_through(at(*ring).sqrt(), z, thickness) < a);
    inside.count() as f64 / f64::from(RINGS) * outside
}

/// The distance of the plane and the share found on it for each row of the table, in a ball of `n`³ voxels.
fn shares(n: u32, backend: &mut dyn Backend) -> Vec<(f64, f64)> {
    let volume = cube(n, SIZE, |[x, y, z]| ior((x * x + y * y + z * z).sqrt(), thickness(n)).0);
    // Not a multiple of the voxels': light that samples every voxel at the same place sees its interpolation's error everywhere.
    let mut scene = refracting(&volume, 16);
    scene.sweep.light = Transport::Forward;
    scene.sweep.light_cells = Some(217);
    let assets = Assets::from(volume);
    let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend).expect("the scene is sound");
    let (planes, grid) = (sweep.light_planes(), sweep.light_grid);
    let centre = sweep.light_view().expect("light is carried forward").point(Default::default());
    let nearest = |z: f64| {
        let off = |plane: &u32| (planes.depth(*plane) - centre.z - z).abs();
        (0..planes.count + BEYOND).min_by(|a, b| off(a).total_cmp(&off(b))).expect("there are planes")
    };
    let wanted = TRUTH.map(|(z, ..)| nearest(z));
    let mut found = Vec::new();
    light_on_planes(
        &sweep,
        backend,
        |plane| wanted.contains(&plane),
        |plane, light| {
            let z = planes.depth(plane) - centre.z;
            for (_, (.., a, _)) in wanted.iter().zip(TRUTH).filter(|(at, _)| **at == plane) {
                // What the ball brought: all light inside the radius, less the beam that passed it by.
                let mut inside = 0.0;
                for (index, irradiance) in light.iter().enumerate() {
                    let (column, row) = (index as u32 % grid.size[0], index as u32 / grid.size[0]);
                    let at = |i: u32, corner: f64, middle: f64| corner + (f64::from(i) + 0.5) * grid.texel - middle;
                    let r = at(column, grid.corner.x, centre.x).hypot(at(row, grid.corner.y, centre.y));
                    // A texel on the edge counts by how far it is inside.
                    let part = ((a - r) / grid.texel + 0.5).clamp(0.0, 1.0);
                    inside += f64::from(*irradiance) * part * grid.texel * grid.texel;
                }
                found.push((z, inside / std::f64::consts::PI));
            }
        },
    );
    assert_eq!(found.len(), TRUTH.len(), "some planes were not visited");
    found
}

#[test]
fn light_carried_forward_has_the_spot_behind_the_focus() {
    for mut backend in backends() {
        let [coarse, fine] = [96, 192].map(|n| {
            let found = shares(n, backend.as_mut());
            let ratios = TRUTH
                .iter()
                .zip(found)
                .map(|((_, a, _), (z, found))| [found / share_through(z, *a, thickness(n)), found / share(z, *a)]);
            ratios.collect::<Vec<_>>()
        });
        println!(
            "{}: share over truth, and over the truth of a surface without thickness, with 96³ and 192³ voxels",
            backend.name()
        );
        for (((z, a, truth), coarse), fine) in TRUTH.iter().zip(&coarse).zip(&fine) {
            println!("z = {z}, a = {a}: {truth} x {coarse:.4?}, x {fine:.4?}");
        }
        for (plane, of_share) in [(1.5, table::SPOT_FOCUS), (2.0, table::SPOT_BEHIND), (3.0, table::SPOT_FAR)] {
            let errors =
                TRUTH.iter().zip(&fine).filter(|((z, ..), _)| *z == plane).map(|(_, [ratio, _])| (ratio - 1.0).abs());
            of_share.hold(errors.fold(0.0, larger), backend.as_ref());
        }
        // Towards Snell's surface it goes with the thickness of the layer.
        let error = |ratios: &[[f64; 2]]| {
            ratios.iter().map(|[_, ratio]| (ratio - 1.0).abs()).sum::<f64>() / ratios.len() as f64
        };
        assert!(error(&fine) < 0.7 * error(&coarse), "{} to {} when the voxels halve", error(&coarse), error(&fine));
    }
}
