//! A torus that stands on its edge, to be twisted.

use super::super::SceneEntry;
use super::parts::assemble;
use super::parts::clear;
use super::rays_through;
use super::revolve::{circle, revolve};
use crate::scene::Scene;
use glam::{Vec2, Vec3};
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] = &[
    ("torus", "rays through a glass torus; `mesh.0.twist` deforms it from frame to frame", scene),
    ("torus/twisted", "the torus with its top turned by half a turn", twisted),
];

/// Major radius: from the middle of the torus to the middle of the tube.
const RADIUS: f32 = 0.7;
const TUBE: f32 = 0.28;

fn scene() -> Scene {
    let mut scene = rays_through("torus");
    scene.camera.azimuth = 30.0;
    scene
}

fn twisted() -> Scene {
    let mut scene = scene();
    scene.mesh.iter_mut().for_each(|mesh| mesh.twist = 180.0);
    scene
}

pub(in super::super) fn mesh(name: &str) -> Mesh {
    let outline: Vec<Vec2> = circle(4).iter().map(|turn| Vec2::new(RADIUS, 0.0) + TUBE * *turn).collect();
    let upright = |position: Vec3| Vec3::new(position.x, -position.z, position.y);
    let ring = revolve(&outline, 6).moved(upright);
    assemble(name, vec![(ring, clear("glass", 1.5, [0.80, 0.93, 0.95], 1.0))])
}
