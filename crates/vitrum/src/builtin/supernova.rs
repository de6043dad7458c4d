//! The turbulent shells of a supernova inside a clear outer layer (sweep, Fig. 6).

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::Grid;
use super::noise::{fbm, ridged, vector};
use super::shapes::{coverage, smoothstep};
use crate::scene::{Camera, Ground, Light, Scene, Shading, TransferFunction};
use glam::Vec3;
use vitrum_io::{Error, Volume};

/// Scalar of the outermost layer, on a plateau; the ejecta rise from it to 1 in the core.
const LAYER: f32 = 0.25;

pub(super) const SCENES: &[SceneEntry] = &[
    ("supernova", "turbulent shells in a clear purple layer that casts caustics; as supernova/3", || layer(1.12)),
    ("supernova/1", "the outermost layer does not refract", || layer(1.0)),
    ("supernova/2", "the outermost layer has index 1.05", || layer(1.05)),
    ("supernova/3", "the outermost layer has index 1.12", || layer(1.12)),
    ("supernova/4", "the outermost layer has index 1.25", || layer(1.25)),
];

/// The scene with the outermost layer's index of refraction.
fn layer(ior: f32) -> Scene {
    Scene {
        volume: procedural("supernova"),
        camera: Camera { azimuth: 0.0, elevation: 22.0, distance: Some(4.4786), ..Camera::default() },
        light: vec![Light { azimuth: 0.0, elevation: 55.0, angular_radius: 0.5, intensity: 1.0, ..Light::default() }],
        transfer: TransferFunction {
            reference_length: Some(0.1),
            color: colors([
                (0.36, [0.55, 0.10, 0.05]),
                (0.50, [0.95, 0.35, 0.05]),
                (0.70, [1.00, 0.75, 0.20]),
                (0.95, [0.85, 0.92, 1.00]),
            ]),
            opacity: opacities([(0.30, 0.0), (0.40, 0.12), (0.46, 0.05), (0.55, 0.8), (0.75, 0.95)]),
            ior: iors([(0.0, 1.0), (LAYER, ior), (0.5, 1.0)]),
            filter: colors([(0.0, [1.0; 3]), (LAYER, [0.93, 0.84, 0.96]), (0.4, [0.97, 0.9, 0.9])]),
            ..TransferFunction::default()
        },
        shading: Shading { roughness: 0.2, ..Shading::default() },
        ground: Some(Ground { height: Some(-1.0), color: [0.55; 3], ..Ground::default() }),
        ..Scene::default()
    }
}

/// Shells that convection has folded, within a bumpy surface of about 0.85 radius.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::splat(2.0), resolution)?;
    grid.unit_volume(name, |position| scalar(position, 3.0 * grid.spacing()))
}

fn scalar(position: Vec3, edge: f32) -> f32 {
    let radius = position.length();
    if radius > 0.98 {
        return 0.0;
    }
    if radius > EJECTA {
        // Plumes push the surface out; ripples give it its small lenses.
        let surface = 0.83 + 0.09 * fbm(position * 1.7, 2, 11) + 0.03 * fbm(position * 4.5, 2, 23);
        return LAYER * coverage(radius - surface.max(EJECTA + edge), edge);
    }
    let folded = position + 0.12 * vector(position * 3.5, 31);
    let turbulence = 0.6 * fbm(folded * 3.2, 4, 41) + 0.25 * (ridged(folded * 2.3, 3, 53) - 0.6);
    let depth = 0.62 - radius + 0.28 * turbulence;
    let core = smoothstep(0.0, 0.62, depth) * smoothstep(EJECTA, EJECTA - 0.06, radius);
    LAYER + (1.0 - LAYER) * core
}

/// Radius within which the folded shells lie; the outermost layer's surface is further out.
const EJECTA: f32 = 0.68;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outer_layer_is_closed_and_surrounded_by_air() {
        let volume = volume("supernova", 48).unwrap();
        assert_eq!(volume.value(0, 24, 24), 0.0);
        let air = volume.histogram(100)[0] as f32 / volume.voxel_count() as f32;
        assert!((0.5..0.8).contains(&air), "{air}");
    }
}
