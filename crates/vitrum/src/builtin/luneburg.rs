//! The Luneburg lens, η² = 2 − r²: a parallel beam meets at the antipode.

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::Grid;
use crate::scene::{Camera, Environment, EnvironmentKind, Light, Scene, Shading, TransferFunction};
use glam::Vec3;
use vitrum_io::{Error, Volume, Voxels};

pub(super) const SCENES: &[SceneEntry] = &[
    ("luneburg", "a Luneburg lens before a checkerboard; the scalar is the index of refraction", scene),
    ("luneburg/fog", "the same filled with thin fog, which shows how a beam meets at the far side", fog),
];

fn scene() -> Scene {
    Scene {
        volume: procedural("luneburg"),
        camera: Camera { azimuth: 0.0, elevation: 10.0, ..Camera::default() },
        transfer: TransferFunction {
            reference_length: Some(0.1),
            opacity: opacities([(1.0, 0.0)]),
            ior: iors([(1.0, 1.0), (std::f32::consts::SQRT_2, std::f32::consts::SQRT_2)]),
            ..TransferFunction::default()
        },
        environment: Environment {
            kind: EnvironmentKind::Checkerboard,
            color: [0.10, 0.16, 0.24],
            horizon: [0.85, 0.83, 0.78],
            ..Environment::default()
        },
        ..Scene::default()
    }
}

fn fog() -> Scene {
    let mut scene = scene();
    scene.light =
        vec![Light { azimuth: -75.0, elevation: 0.0, angular_radius: 0.0, intensity: 3.0, ..Light::default() }];
    scene.transfer.color = colors([(1.0, [1.0, 0.9, 0.7])]);
    scene.transfer.opacity = opacities([(1.0, 0.0), (1.02, 0.008)]);
    scene.shading = Shading { specular: 0.0, ambient: [0.0; 3], ..Shading::default() };
    scene.environment =
        Environment { kind: EnvironmentKind::Color, color: [0.01, 0.015, 0.03], ..Environment::default() };
    scene
}

/// Voxels between the lens and the volume's faces.
const MARGIN: u32 = 4;

/// The index of refraction itself, for a lens of radius 1; 1 outside.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::ONE, resolution)?;
    let grid = grid.with_spacing(2.0 / (resolution - 2 * MARGIN) as f32);
    grid.volume(name, Voxels::from(grid.sample(|position| (2.0 - position.length_squared().min(1.0)).sqrt())?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_the_closed_form_and_symmetric() {
        let volume = volume("luneburg", 40).unwrap();
        let position = |index: u32| f64::from(index) / 16.0 - 39.0 / 32.0;
        for (x, y, z) in [(0, 0, 0), (20, 20, 20), (3, 20, 20), (10, 14, 30), (4, 19, 20), (25, 8, 17)] {
            let radius2: f64 = [x, y, z].map(|index| position(index) * position(index)).iter().sum();
            let truth = if radius2 < 1.0 { (2.0 - radius2).sqrt() } else { 1.0 };
            let value = volume.value(x, y, z);
            assert!((f64::from(value) - truth).abs() < 1e-6, "{value}, not {truth}");
            assert_eq!(value, volume.value(39 - x, y, z));
            assert_eq!(value, volume.value(z, 39 - y, x));
        }
        assert_eq!(volume.range[0], 1.0);
        assert!(volume.range[1] < std::f32::consts::SQRT_2);
    }
}
