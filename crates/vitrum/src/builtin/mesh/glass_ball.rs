//! A glass ball in fog and in smoke, and the light that it focuses.

use super::super::SceneEntry;
use super::super::curves::procedural;
use super::in_medium;
use super::parts::clear;
use super::patches::with_normals;
use super::revolve;
use crate::scene::{Camera, Film, Light, LightKind, Medium, Scene};
use glam::Vec3;
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] = &[
    ("ball-in-fog", "the beam that a glass ball focuses in fog, in the light of a bulb above it", scene),
    ("smoke", "a plume of smoke, and the beam that a glass ball in it focuses, in the light of a spot above", smoke),
];

/// A bulb of 40 W, which shines equally to all sides: its radiant intensity, 40 W / 4π, over π.
const BULB: f32 = 1.013_211_8;

fn scene() -> Scene {
    Scene {
        camera: Camera {
            position: Some([0.0, -9.0, 0.5]),
            target: Some([0.0, 0.0, -0.3]),
            field_of_view: 40.0,
            ..Camera::default()
        },
        light: vec![Light { position: Some([0.0, 0.0, 4.0]), intensity: BULB, ..Light::of_kind(LightKind::Point) }],
        film: Film { exposure: 4.5, ..Film::default() },
        ..in_medium("ball", Medium { absorption: [0.02; 3], scattering: [0.1; 3], ..Medium::default() })
    }
}

/// The ball hangs in the wide upper part of the plume, so that its beam lights the narrow and dense part below. A spot from aside keeps the beam
/// apart from the plume's own axis.
fn smoke() -> Scene {
    let medium =
        Medium { absorption: [0.15; 3], scattering: [1.5; 3], density: Some(procedural("smoke")), ..Medium::default() };
    let mut scene = Scene {
        camera: Camera {
            position: Some([0.0, -5.0, 0.35]),
            target: Some([0.0, 0.0, -0.05]),
            field_of_view: 28.0,
            ..Camera::default()
        },
        light: vec![Light {
            position: Some([0.9, -0.6, 3.2]),
            direction: Some([-0.9, 0.6, -2.85]),
            intensity: 12.0,
            cone_angle: 16.0,
            penumbra: 0.3,
            color: [1.0, 0.93, 0.82],
            ..Light::of_kind(LightKind::Spot)
        }],
        ..in_medium("ball", medium)
    };
    scene.mesh.iter_mut().for_each(|ball| (ball.scale, ball.position) = (0.3, [0.0, 0.0, 0.35]));
    scene.beams.rays = 128;
    scene
}

/// Radius 1. The normals are those of the sphere, so that caustics have no facets.
pub(in super::super) fn mesh(name: &str) -> Mesh {
    let part = revolve::ball(1.0, 6);
    let normals = part.positions.iter().map(|position| Vec3::from_array(*position).normalize()).collect();
    with_normals(part, normals, name, clear("glass", 1.5, [1.0; 3], 1.0))
}
