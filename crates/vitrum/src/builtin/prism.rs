//! A glass prism that spreads light into a spectrum on the wall.

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::Grid;
use super::shapes::coverage;
use crate::scene::{Camera, Ground, IorPoint, Light, Scene, Shading, TransferFunction, Wall};
use glam::{Vec2, Vec3};
use vitrum_io::{Error, Volume};

pub(super) const SCENES: &[SceneEntry] = &[("prism", "a glass prism that spreads light into a spectrum", scene)];

fn scene() -> Scene {
    // Light of any colour passes it about symmetrically, at its smallest deviation.
    let glass = IorPoint { abbe: Some(10.0), ..IorPoint::new(1.0, 1.5) };
    let mut ior = iors([(0.0, 1.0), (1.0, 1.5)]);
    ior[1] = glass;
    let mut scene = Scene {
        volume: procedural("prism"),
        camera: Camera { azimuth: 0.0, elevation: 12.0, ..Camera::default() },
        light: vec![Light { azimuth: 19.0, elevation: 22.0, angular_radius: 0.0, ..Light::default() }],
        transfer: TransferFunction {
            reference_length: Some(0.1),
            opacity: opacities([(0.0, 0.0)]),
            ior,
            filter: colors([(0.0, [1.0; 3]), (1.0, [0.99, 0.993, 0.992])]),
            ..TransferFunction::default()
        },
        shading: Shading { roughness: 0.08, ..Shading::default() },
        ground: Some(Ground { height: Some(-1.0), color: [0.60, 0.58, 0.56], ..Ground::default() }),
        wall: Some(Wall { distance: Some(2.2), azimuth: 0.0, color: [0.75, 0.75, 0.75] }),
        ..Scene::default()
    };
    scene.sweep.wavelengths = 7;
    scene
}

/// Distance of the faces from the axis.
const INRADIUS: f32 = 0.22;
/// Half the height.
const HALF_HEIGHT: f32 = 0.8;

/// An upright prism with three equal sides, an edge towards +x. Its scalar falls from 1 to 0 over six voxels: faces that are to
/// bend light evenly must not follow the voxels.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::new(1.25, 1.25, 2.0), resolution)?;
    // cos 30°; the side faces' normals and the base's.
    let slant = 0.866_025_4;
    let normals = [Vec2::new(0.5, slant), Vec2::new(0.5, -slant), Vec2::new(-1.0, 0.0)];
    let width = 6.0 * grid.spacing();
    grid.unit_volume(name, |position| {
        let sides = normals.map(|normal| coverage(normal.dot(position.truncate()) - INRADIUS, width));
        sides[0] * sides[1] * sides[2] * coverage(position.z.abs() - HALF_HEIGHT, width)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prism_has_its_volume() {
        let volume = volume("prism", 128).unwrap();
        let [width, depth, height] = volume.dimensions;
        let count = width * depth * height;
        let sum: f64 = (0..count)
            .map(|index| f64::from(volume.value(index % width, index / width % depth, index / (width * depth))))
            .sum();
        let (edge, inradius) = (f64::from(volume.spacing[0]), f64::from(INRADIUS));
        let found = sum * edge * edge * edge;
        // Its base is 3√3 r²; the corners, where two faces are soft, have a little less.
        let truth = 3.0 * 3.0_f64.sqrt() * inradius * inradius * 2.0 * f64::from(HALF_HEIGHT);
        assert!((found / truth - 1.0).abs() < 0.02, "{found} instead of {truth}");
    }
}
