//! A polished ring on a table, and the caustic that it reflects.

use super::super::SceneEntry;
use super::in_medium;
use super::patches::Patches;
use super::revolve::circle;
use crate::scene::{Attachment, Camera, Ground, Light, Material as SceneMaterial, Medium, Scene};
use glam::{Vec2, Vec3};
use vitrum_io::{Material, Mesh};

pub(in super::super) const SCENES: &[SceneEntry] =
    &[("ring", "the caustic of a silver ring in low sunlight, on a table and in thin fog", scene)];

/// Radius of the inside.
const RADIUS: f32 = 1.0;
const HEIGHT: f32 = 0.7;
const WALL: f32 = 0.02;
const REFLECTANCE: f32 = 0.9;
/// Cosine and sine of 40°, the sun's height above the horizon.
const SUN: [f32; 2] = [0.766_044_4, 0.642_787_6];

fn scene() -> Scene {
    let mut scene = Scene {
        material: vec![SceneMaterial {
            name: Some("silver".to_owned()),
            mirror: true,
            color: Some([REFLECTANCE; 3]),
            ..SceneMaterial::default()
        }],
        camera: Camera {
            position: Some([-1.7, -3.3, 2.6]),
            target: Some([0.05, 0.0, 0.12]),
            field_of_view: 36.0,
            ..Camera::default()
        },
        light: vec![Light {
            attachment: Some(Attachment::World),
            direction: Some([SUN[0], 0.0, -SUN[1]]),
            angular_radius: 0.0,
            color: [1.0, 0.95, 0.86],
            ..Light::default()
        }],
        ground: Some(Ground { height: None, color: [0.8; 3], ..Ground::default() }),
        ..in_medium(
            "ring",
            Medium { absorption: [0.002; 3], scattering: [0.03; 3], extent: Some(3.0), ..Medium::default() },
        )
    };
    scene.beams.rays = 256;
    scene.shading.ambient = [0.02; 3];
    scene.environment.color = [0.01, 0.012, 0.015];
    scene
}

/// The normal at a turn of the circle.
type Normal = fn(Vec2) -> Vec3;

/// The band stands on z = 0. Its sides have the normals of cylinders, its edges are crisp.
pub(in super::super) fn mesh(name: &str) -> Mesh {
    let mut turns = circle(8);
    turns.push(turns[0]);
    let outside = RADIUS + WALL;
    let at = |turn: &Vec2, radius: f32, height: f32| (*turn * radius).extend(height);
    let row = |radius: f32, height: f32, normal: Normal| -> Vec<(Vec3, Vec3)> {
        turns.iter().map(|turn| (at(turn, radius, height), normal(*turn))).collect()
    };
    let outwards: Normal = |turn| turn.extend(0.0);
    let inwards: Normal = |turn| (-turn).extend(0.0);
    let (up, down): (Normal, Normal) = (|_| Vec3::Z, |_| Vec3::NEG_Z);
    let mut patches = Patches::default();
    patches.grid(&[row(outside, 0.0, outwards), row(outside, HEIGHT, outwards)]);
    patches.grid(&[row(outside, HEIGHT, up), row(RADIUS, HEIGHT, up)]);
    patches.grid(&[row(RADIUS, HEIGHT, inwards), row(RADIUS, 0.0, inwards)]);
    patches.grid(&[row(RADIUS, 0.0, down), row(outside, 0.0, down)]);
    let silver = Material {
        name: "silver".to_owned(),
        base_color: Some([REFLECTANCE; 3]),
        opacity: Some(1.0),
        ..Material::default()
    };
    patches.into_mesh(name, silver)
}
