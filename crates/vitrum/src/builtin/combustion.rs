//! A plane jet flame: mixture fraction and scalar dissipation rate of a turbulent mixing layer (sweep, Fig. 12).

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::{Grid, quantize_unit};
use super::noise::{fbm, gradient, vector};
use super::shapes::smoothstep;
use crate::scene::{Camera, Environment, EnvironmentKind, Light, Rgb, Scene, Shading, TransferFunction};
use glam::Vec3;
use vitrum_io::{Error, Volume};

pub(super) const SCENES: &[SceneEntry] = &[
    ("combustion", "dissipation rate of a turbulent flame, refracting and opaque; as combustion/both", both),
    ("combustion/opaque", "dissipation rate as opacity", || opaque(1.0)),
    ("combustion/faint", "dissipation rate as a low opacity", || opaque(0.12)),
    ("combustion/refractive", "dissipation rate as index of refraction only", refractive),
    ("combustion/both", "index of refraction, and opacity where the rate is high", both),
    ("combustion/mixture", "rate as index of refraction, mixture fraction as opacity", mixture),
];

/// Particle colours from low to high.
const HEAT: [(f32, Rgb); 4] =
    [(0.10, [0.10, 0.22, 0.50]), (0.35, [0.75, 0.72, 0.62]), (0.60, [0.95, 0.50, 0.10]), (0.90, [0.65, 0.04, 0.03])];

fn base() -> Scene {
    Scene {
        volume: procedural("combustion"),
        camera: Camera { azimuth: 0.0, elevation: 0.0, distance: Some(3.708), ..Camera::default() },
        light: vec![Light { azimuth: -30.0, elevation: 40.0, ..Light::default() }],
        transfer: TransferFunction {
            reference_length: Some(0.02),
            color: colors(HEAT),
            opacity: opacities([(0.0, 0.0)]),
            ..TransferFunction::default()
        },
        shading: Shading { specular: 0.3, ..Shading::default() },
        environment: Environment { kind: EnvironmentKind::Color, color: [0.9; 3], ..Environment::default() },
        ..Scene::default()
    }
}

fn opaque(share: f32) -> Scene {
    let mut scene = base();
    scene.transfer.opacity = opacities([(0.04, 0.0), (0.5, 0.6 * share), (1.0, 0.9 * share)]);
    scene
}

fn refractive() -> Scene {
    let mut scene = base();
    scene.transfer.ior = iors([(0.02, 1.0), (1.0, 1.25)]);
    scene.environment = Environment::default();
    scene
}

fn both() -> Scene {
    let mut scene = refractive();
    scene.transfer.opacity = opacities([(0.45, 0.0), (0.7, 0.5)]);
    scene
}

fn mixture() -> Scene {
    let mut scene = refractive();
    scene.ior_volume = Some(scene.volume);
    scene.volume = procedural("combustion-mixture");
    scene.transfer.opacity = opacities([(0.3, 0.0), (0.8, 0.3)]);
    scene
}

/// The slab's size in world units; the jet flows along x between two streams above and below.
const EXTENT: Vec3 = Vec3::new(2.0, 0.3333, 1.3333);

/// The mixture fraction: 1 in the fuel jet, 0 in the air around it.
pub(super) fn mixture_volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    Grid::covering(name, EXTENT, resolution)?.unit_volume(name, |position| mixture_fraction(position) * fade(position))
}

/// The scalar dissipation rate χ = 2D|∇Z|² of the mixture fraction Z, compressed to 0…1 by χ/(χ + χ₀).
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, EXTENT, resolution)?;
    let fraction = grid.sample(mixture_fraction)?;
    let size = grid.dimensions();
    let voxels = grid.sample_indices(|index| {
        let value = |axis: usize, step: i32| {
            let mut at = index;
            at[axis] = at[axis].saturating_add_signed(step).min(size[axis] - 1);
            fraction[(at[0] + size[0] * (at[1] + size[1] * at[2])) as usize]
        };
        let slope = Vec3::from_array([0, 1, 2].map(|axis| value(axis, 1) - value(axis, -1)));
        let rate = (slope / (2.0 * grid.spacing())).length_squared();
        quantize_unit(rate / (rate + REFERENCE_RATE) * fade(grid.position(index)))
    })?;
    grid.volume_of(name, voxels)
}

/// The rate, over twice the diffusivity, that maps to one half.
const REFERENCE_RATE: f32 = 150.0;

fn mixture_fraction(position: Vec3) -> f32 {
    // Large eddies roll the layers up, smaller ones fold them.
    let mut folded = position;
    for (scale, fold, seed) in [(0.45, 0.85, 3), (0.19, 0.85, 5), (0.09, 0.7, 7)] {
        folded += scale * fold * vector(folded / scale, seed);
    }
    let jet = smoothstep(0.46, 0.30, folded.z.abs() + 0.05 * gradient(position * 3.0, 13));
    jet * (0.75 + 0.25 * fbm(folded * 6.0, 2, 17))
}

/// Falls to 0 at the slab's faces, so that they do not show as windows.
fn fade(position: Vec3) -> f32 {
    let inside = 0.5 * EXTENT - position.abs();
    inside.to_array().map(|distance| smoothstep(0.0, 0.06, distance)).iter().product()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dissipation_is_confined_to_layers() {
        let volume = volume("combustion", 96).unwrap();
        assert_eq!(volume.dimensions, [96, 16, 64]);
        let low = volume.histogram(20)[0] as f32 / volume.voxel_count() as f32;
        assert!((0.3..0.8).contains(&low), "{low}");
    }

    #[test]
    fn fuel_is_inside_and_air_outside() {
        let volume = mixture_volume("combustion-mixture", 96).unwrap();
        assert!(volume.value(48, 8, 32) > 0.3);
        assert_eq!(volume.value(48, 8, 0), 0.0);
    }
}
