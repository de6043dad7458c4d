//! A solid glass ball that casts its caustic on the ground and a wall.

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::Grid;
use super::shapes::coverage;
use crate::scene::{Camera, Ground, Light, Scene, Shading, TransferFunction, Transport, Wall};
use glam::Vec3;
use vitrum_io::{Error, Volume};

pub(super) const SCENES: &[SceneEntry] = &[
    ("ball", "a solid glass ball that casts its caustic on the ground", scene),
    ("ball/texels", "the ball in light on texels, as the paper carries it", texels),
];

fn texels() -> Scene {
    let mut scene = scene();
    scene.sweep.light = Transport::Texels;
    scene
}

fn scene() -> Scene {
    Scene {
        volume: procedural("ball"),
        camera: Camera { azimuth: 0.0, elevation: 18.0, ..Camera::default() },
        light: vec![Light { azimuth: 40.0, elevation: 28.0, angular_radius: 0.5, ..Light::default() }],
        transfer: TransferFunction {
            reference_length: Some(0.1),
            opacity: opacities([(0.0, 0.0)]),
            ior: iors([(0.0, 1.0), (1.0, 1.5)]),
            filter: colors([(0.0, [1.0; 3]), (1.0, [0.985, 0.993, 0.990])]),
            ..TransferFunction::default()
        },
        shading: Shading { roughness: 0.08, ..Shading::default() },
        ground: Some(Ground { height: Some(-1.0), color: [0.75, 0.72, 0.68], ..Ground::default() }),
        wall: Some(Wall { distance: Some(1.8), azimuth: 0.0, color: [0.70, 0.72, 0.75] }),
        ..Scene::default()
    }
}

/// Voxels between the ball and the volume's faces.
const MARGIN: u32 = 4;

/// A ball of radius 1 whose scalar falls from 1 to 0 over two voxels.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::ONE, resolution)?;
    let grid = grid.with_spacing(2.0 / (resolution - 2 * MARGIN) as f32);
    grid.unit_volume(name, |position| coverage(position.length() - 1.0, 2.0 * grid.spacing()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_ball_has_its_volume() {
        let volume = volume("ball", 64).unwrap();
        let sum: f64 =
            (0..64 * 64 * 64u32).map(|index| f64::from(volume.value(index % 64, index / 64 % 64, index / 4096))).sum();
        let edge = f64::from(volume.spacing[0]);
        assert!((sum * edge * edge * edge / (4.0 / 3.0 * PI) - 1.0).abs() < 1e-3);
    }
}
