//! The angel of the glass ball by itself, as a statue of glass in fog.

use super::super::SceneEntry;
use super::angel_ball::angel;
use super::in_medium;
use super::parts::{assemble, clear};
use super::surface::surface;
use crate::scene::{Camera, Ground, Light, LightKind, Medium, Scene};
use glam::Vec3;
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] =
    &[("statue", "a glass angel in fog, in the light of a spot above it", scene)];

/// Factor on the size of the angel in the ball.
const SCALE: f32 = 1.5;

fn scene() -> Scene {
    let mut scene = Scene {
        camera: Camera {
            position: Some([-1.6, 6.6, 0.9]),
            target: Some([0.0, 0.0, 0.0]),
            field_of_view: 30.0,
            ..Camera::default()
        },
        light: vec![Light {
            position: Some([2.2, 1.2, 3.2]),
            intensity: 30.0,
            cone_angle: 20.0,
            penumbra: 0.2,
            color: [1.0, 0.96, 0.88],
            ..Light::of_kind(LightKind::Spot)
        }],
        ground: Some(Ground { height: None, color: [0.6; 3], ..Ground::default() }),
        ..in_medium("statue", Medium { absorption: [0.003; 3], scattering: [0.1; 3], ..Medium::default() })
    };
    scene.environment.color = [0.01, 0.012, 0.018];
    scene.film.exposure = 1.7;
    scene
}

/// Upright, the face towards +y.
pub(in super::super) fn mesh(name: &str) -> Mesh {
    let figure = surface(Vec3::new(-0.72, -0.4, -0.78), Vec3::new(0.72, 0.4, 0.72), 0.013, angel);
    let figure = figure.moved(|position| position * SCALE);
    assemble(name, vec![(figure, clear("glass", 1.5, [0.92, 0.97, 0.98], 2.0))])
}
