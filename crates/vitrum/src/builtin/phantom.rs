//! A head-like phantom of soft tissue, a skull and eight beads, in bytes: the volume that other programs are timed with.
//!
//! It is defined by formulas that a few lines of NumPy repeat (`docs/benchmarks.md` has them), so that every program renders the
//! same voxels: x fastest, then y, then z, with y up in the picture and z towards the viewer.

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::Grid;
use super::shapes::smoothstep;
use crate::scene::{Camera, Environment, EnvironmentKind, Light, OpacityPoint, Scene, TransferFunction};
use glam::Vec3;
use std::f32::consts::FRAC_1_SQRT_2 as DIAGONAL;
use vitrum_io::{Error, Volume, Voxels};

pub(super) const SCENES: &[SceneEntry] = &[
    ("phantom", "a head-like phantom with an opaque skull, the volume that other programs are timed with", opaque),
    ("phantom/translucent", "the phantom with a skull that lets most light through", translucent),
];

fn opaque() -> Scene {
    scene(opacities([
        (0.0, 0.0),
        (20.0, 0.0),
        (60.0, 0.01),
        (75.0, 0.015),
        (110.0, 0.05),
        (170.0, 0.25),
        (190.0, 0.4),
        (255.0, 0.6),
    ]))
}

fn translucent() -> Scene {
    scene(opacities([
        (0.0, 0.0),
        (20.0, 0.0),
        (60.0, 0.01),
        (75.0, 0.015),
        (110.0, 0.05),
        (170.0, 0.01),
        (190.0, 0.02),
        (255.0, 0.03),
    ]))
}

fn scene(opacity: Vec<OpacityPoint>) -> Scene {
    Scene {
        volume: procedural("phantom"),
        camera: Camera { azimuth: 0.0, elevation: 0.0, distance: Some(5.198), ..Camera::default() },
        light: vec![Light { azimuth: 26.6, elevation: 33.9, ..Light::default() }],
        transfer: TransferFunction {
            // A voxel of the default resolution.
            reference_length: Some(1.0 / 128.0),
            color: colors([
                (0.0, [0.0, 0.0, 0.0]),
                (70.0, [0.9, 0.6, 0.5]),
                (100.0, [0.8, 0.3, 0.2]),
                (170.0, [1.0, 1.0, 0.9]),
                (255.0, [1.0, 1.0, 1.0]),
            ]),
            opacity,
            ior: iors([(20.0, 1.0), (70.0, 1.05), (190.0, 1.1)]),
            ..TransferFunction::default()
        },
        environment: Environment { kind: EnvironmentKind::Color, color: [0.1, 0.1, 0.15], ..Environment::default() },
        ..Scene::default()
    }
}

/// Centres of the beads, on a ring that goes up and down three times.
const BEADS: [Vec3; 8] = {
    const fn bead(x: f32, y: f32, z: f32) -> Vec3 {
        Vec3::new(0.45 * x, 0.45 * y, 0.3 * z)
    }
    [
        bead(1.0, 0.0, 0.0),
        bead(DIAGONAL, DIAGONAL, DIAGONAL),
        bead(0.0, 1.0, -1.0),
        bead(-DIAGONAL, DIAGONAL, DIAGONAL),
        bead(-1.0, 0.0, 0.0),
        bead(-DIAGONAL, -DIAGONAL, -DIAGONAL),
        bead(0.0, -1.0, 1.0),
        bead(DIAGONAL, -DIAGONAL, -DIAGONAL),
    ]
};

/// The stored value at a point of the cube from −1 to 1.
fn value(p: Vec3) -> u8 {
    let r = (p / Vec3::new(0.80, 0.90, 0.95)).length();
    let tissue = 70.0 * (1.0 - smoothstep(0.97, 1.0, r));
    let skull = 120.0 * (smoothstep(0.78, 0.80, r) * (1.0 - smoothstep(0.86, 0.88, r)));
    let bead = |centre: &Vec3| 100.0 * (1.0 - smoothstep(0.12, 0.15, (p - *centre).length()));
    // The cast cuts the fraction off, as NumPy's does.
    (tissue + skull + BEADS.iter().map(bead).sum::<f32>()).clamp(0.0, 255.0) as u8
}

/// The phantom with the stored y upright and the stored z towards the front.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::ONE, resolution)?.with_spacing(2.0 / resolution as f32);
    let volume = grid.volume(name, Voxels::from(grid.sample(value)?))?;
    let half = 1.0 - 0.5 * grid.spacing();
    Ok(Volume { axes: [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]], origin: [half, -half, -half], ..volume })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum of all voxels at 64³, and the number of voxels above 0, that the definition in `docs/benchmarks.md` gives in NumPy.
    const NUMPY_SUM: u64 = 8_408_332;
    const NUMPY_COUNTS: [(u8, usize); 4] = [(0, 168_888), (70, 63_224), (190, 11_672), (170, 1964)];

    #[test]
    fn voxels_are_those_of_the_definition_in_numpy() {
        let volume = volume("phantom", 64).unwrap();
        let Voxels::U8(voxels) = &volume.voxels else { panic!("not stored in bytes") };
        let count = |wanted: u8| voxels.iter().filter(|voxel| **voxel == wanted).count();
        let sum: u64 = voxels.iter().map(|voxel| u64::from(*voxel)).sum();
        // Rounding may move a voxel whose value is close to a whole number.
        assert!(sum.abs_diff(NUMPY_SUM) < 20, "{sum}");
        for (value, expected) in NUMPY_COUNTS {
            assert!(count(value).abs_diff(expected) <= 8, "{value}: {} instead of {expected}", count(value));
        }
    }
}
