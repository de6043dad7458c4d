//! A glass ball in fog, and the light that it focuses.

use super::super::SceneEntry;
use super::in_medium;
use super::parts::clear;
use super::patches::with_normals;
use super::revolve;
use crate::scene::{Camera, Film, Light, LightKind, Medium, Scene};
use glam::Vec3;
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] =
    &[("ball-in-fog", "the beam that a glass ball focuses in fog, in the light of a bulb above it", scene)];

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

/// Radius 1. The normals are those of the sphere, so that caustics have no facets.
pub(in super::super) fn mesh(name: &str) -> Mesh {
    let part = revolve::ball(1.0, 6);
    let normals = part.positions.iter().map(|position| Vec3::from_array(*position).normalize()).collect();
    with_normals(part, normals, name, clear("glass", 1.5, [1.0; 3], 1.0))
}
