//! A filled wine glass on a ground plane before a wall (sweep, Fig. 8).

use super::SceneEntry;
use super::curves::{colors, iors, opacities, procedural};
use super::grid::{Grid, quantize_unit};
use super::shapes::{Outline, coverage, smoothstep};
use crate::scene::{Camera, Environment, Ground, Light, Rgb, Scene, Shading, TransferFunction, Transport, Wall};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use vitrum_io::{Error, Volume};

/// Scalar values of the materials. Every surface passes only through values between its two sides; the liquid's surface passes
/// that of glass, a film as thin as the surface.
const AIR: f32 = 0.0;
const GLASS: f32 = 0.5;
const LIQUID: f32 = 1.0;

/// Height at which the glass stands: its foot's surface, which has some width, ends there.
const FOOT: f32 = -0.985;

pub(super) const SCENES: &[SceneEntry] = &[
    ("glass", "a glass of beer on a ground plane before a wall; as glass/beer", beer),
    ("glass/plain", "clear water in clear glass", plain),
    ("glass/porter-duff", "plain volume rendering: no refraction, reflective colours only", porter_duff),
    ("glass/straight", "medium colours, but no refraction", straight),
    ("glass/beer", "medium colours and refraction, nothing opaque", beer),
    ("glass/juice", "a liquid dense with pigment, with a dark shadow on the wall", juice),
    ("glass/wine", "red wine in green glass", wine),
    ("glass/texels", "the beer in light on texels, as the paper carries it: its foci are missing", texels),
];

fn base() -> Scene {
    Scene {
        volume: procedural("glass"),
        camera: Camera { azimuth: 0.0, elevation: 14.0, ..Camera::default() },
        light: vec![Light { azimuth: 44.0, elevation: 17.0, ..Light::default() }],
        transfer: TransferFunction { reference_length: Some(0.1), ..TransferFunction::default() },
        shading: Shading { roughness: 0.12, ambient: [0.34; 3], ..Shading::default() },
        environment: Environment::default(),
        ground: Some(Ground { height: Some(FOOT), color: [0.78, 0.76, 0.73], ..Ground::default() }),
        wall: Some(Wall { distance: Some(1.1), azimuth: 0.0, color: [0.78, 0.76, 0.73] }),
        ..Scene::default()
    }
}

/// Refracting materials whose colour is the share of light that a tenth of a world unit lets pass.
fn filled(glass: Rgb, liquid: Rgb) -> Scene {
    let mut scene = base();
    scene.transfer.opacity = opacities([(AIR, 0.0)]);
    scene.transfer.ior = iors([(AIR, 1.0), (GLASS, 1.5), (LIQUID, 1.34)]);
    scene.transfer.filter = colors([(AIR, [1.0; 3]), (GLASS, glass), (LIQUID, liquid)]);
    scene
}

const CLEAR: Rgb = [0.985, 0.993, 0.988];
const AMBER: Rgb = [0.985, 0.90, 0.66];

fn plain() -> Scene {
    filled(CLEAR, [0.990, 0.996, 0.999])
}

fn porter_duff() -> Scene {
    let mut scene = base();
    scene.transfer.color = colors([(GLASS, [0.75, 0.85, 0.85]), (LIQUID, [0.95, 0.62, 0.12])]);
    scene.transfer.opacity = opacities([(AIR, 0.0), (GLASS, 0.16), (LIQUID, 0.16)]);
    scene
}

fn straight() -> Scene {
    let mut scene = beer();
    scene.transfer.ior.clear();
    scene.transfer.opacity = opacities([(AIR, 0.0), (GLASS, 0.004), (LIQUID, 0.004)]);
    scene
}

fn beer() -> Scene {
    filled(CLEAR, AMBER)
}

fn juice() -> Scene {
    let mut scene = beer();
    scene.transfer.color = colors([(GLASS, [0.98, 0.62, 0.10])]);
    scene.transfer.opacity = opacities([(0.6, 0.0), (LIQUID, 0.75)]);
    scene
}

fn texels() -> Scene {
    let mut scene = beer();
    scene.sweep.light = Transport::Texels;
    scene
}

fn wine() -> Scene {
    filled([0.86, 0.96, 0.84], [0.80, 0.36, 0.40])
}

/// The wine glass, 2 world units high, about 1.3 wide, filled by two thirds.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, Vec3::new(1.28, 1.28, 2.0), resolution)?;
    let [width, _, depth] = grid.dimensions();
    let body = Outline::smooth(&BODY, &[]);
    let cavity = Outline::smooth(&BODY[CAVITY..], &[[0.0, BODY[CAVITY][1]]]);
    // A surface that is wider than a few voxels bends neighbouring rays alike; the wall has its full index in its middle where the resolution allows both.
    let edge = (0.8 * WALL).clamp(2.5 * grid.spacing(), 4.5 * grid.spacing());
    // The glass is a surface of revolution: tabulate it over radius and height, then turn it around the axis.
    let step = 0.5 * grid.spacing();
    let radii = (1.5 * width as f32) as usize;
    let table: Vec<Vec<f32>> = (0..depth)
        .into_par_iter()
        .map(|z| {
            let height = grid.position([0, 0, z]).z;
            let value = |radius| material(&body, &cavity, Vec2::new(radius, height), edge);
            (0..radii).map(|index| value(index as f32 * step)).collect()
        })
        .collect();
    let voxels = grid.sample_indices(|index| {
        let position = grid.position(index);
        let at = position.truncate().length() / step;
        let row = &table[index[2] as usize];
        let inner = (at as usize).min(radii - 2);
        quantize_unit(row[inner] + (row[inner + 1] - row[inner]) * (at - inner as f32).min(1.0))
    })?;
    grid.volume_of(name, voxels)
}

/// The scalar at a point given by its distance from the axis and its height.
fn material(body: &Outline, cavity: &Outline, point: Vec2, edge: f32) -> f32 {
    let glass = coverage(body.distance(point), edge);
    // The liquid fills the cavity to its level and, hidden by the glass, half of the wall.
    let depth = cavity.distance(point);
    let liquid = if depth < 0.5 * WALL {
        let climb = MENISCUS * smoothstep(-3.0 * MENISCUS, 0.0, depth);
        coverage(point.y - LEVEL - climb, edge)
    } else {
        0.0
    };
    GLASS * glass + LIQUID * (1.0 - glass) * liquid
}

/// Height of the liquid on the axis.
pub(super) const LEVEL: f32 = 0.46;
/// Height of the meniscus: the liquid's rise at the wall.
pub(super) const MENISCUS: f32 = 0.03;
/// Thickness of the bowl's wall.
pub(super) const WALL: f32 = 0.045;
/// The first point of [`BODY`] that belongs to the bowl's inside.
pub(super) const CAVITY: usize = 25;

/// Outline of the glass: distance from the axis and height, from the foot's underside over the outside and the rim to the
/// bowl's deepest point.
#[rustfmt::skip]
pub(super) const BODY: [[f32; 2]; 36] = [
    [0.0, -0.940], [0.20, -0.945], [0.38, -0.964], [0.440, -0.965],
    [0.458, -0.950], [0.444, -0.932], [0.36, -0.920], [0.22, -0.895], [0.12, -0.850], [0.070, -0.770],
    [0.055, -0.660], [0.052, -0.540], [0.060, -0.440], [0.090, -0.370], [0.160, -0.315], [0.270, -0.245],
    [0.400, -0.120], [0.500, 0.040], [0.552, 0.220], [0.560, 0.380], [0.540, 0.560], [0.505, 0.740],
    [0.468, 0.920], [0.462, 0.945], [0.446, 0.962],
    [0.428, 0.945], [0.425, 0.920], [0.460, 0.740], [0.495, 0.560], [0.515, 0.380], [0.507, 0.220],
    [0.458, 0.060], [0.365, -0.085], [0.245, -0.195], [0.120, -0.250], [0.0, -0.268],
];

#[cfg(test)]
mod tests {
    use super::*;

    /// The value on the axis or beside it, at a height.
    fn at(volume: &Volume, radius: f32, height: f32) -> f32 {
        let [width, depth, tall] = volume.dimensions;
        let index = |position: f32, size: u32| (position / volume.spacing[0] + 0.5 * (size - 1) as f32).round() as u32;
        volume.value(index(radius, width), depth / 2, index(height, tall))
    }

    #[test]
    fn materials_are_where_they_belong() {
        let volume = volume("glass", 256).unwrap();
        for (radius, height, value, what) in [
            (0.0, -0.99, AIR, "below the foot"),
            (0.3, -0.935, GLASS, "foot"),
            (0.0, -0.6, GLASS, "stem"),
            (0.3, -0.6, AIR, "beside the stem"),
            (0.0, 0.0, LIQUID, "bowl"),
            (0.0, 0.6, AIR, "above the liquid"),
            (0.537, 0.34, GLASS, "wall"),
        ] {
            let found = at(&volume, radius, height);
            assert!((found - value).abs() < 0.02, "{what}: {found}, not {value}");
        }
    }

    #[test]
    fn borders_are_air() {
        let volume = volume("glass", 128).unwrap();
        let [width, _, tall] = volume.dimensions;
        for a in 0..width {
            for b in 0..width {
                let faces = [volume.value(a, b, 0), volume.value(a, b, tall - 1), volume.value(0, a, b)];
                assert_eq!(faces, [AIR; 3]);
            }
        }
    }
}
