//! An angel in a glass ball (Chang et al. 2010, Fig. 3): materials within each other.

use super::super::SceneEntry;
use super::super::shapes::{ellipsoid, smooth_union, tube};
use super::parts::{assemble, clear};
use super::rays_through;
use super::revolve::ball;
use super::surface::surface;
use crate::scene::Scene;
use glam::Vec3;
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] =
    &[("angel-ball", "an angel of amber in a ball of glass: materials within each other", scene)];

fn scene() -> Scene {
    let mut scene = rays_through("angel-ball");
    scene.camera.azimuth = 18.0;
    scene
}

pub(in super::super) fn mesh(name: &str) -> Mesh {
    let angel = surface(Vec3::new(-0.72, -0.4, -0.78), Vec3::new(0.72, 0.4, 0.72), 0.013, angel);
    assemble(
        name,
        vec![
            (ball(1.0, 6), clear("ball", 1.33, [0.93, 0.97, 0.98], 1.0)),
            (angel, clear("angel", 1.55, [0.90, 0.48, 0.10], 0.35)),
        ],
    )
}

/// Feathers of one wing: root, tip, width.
const FEATHERS: [([f32; 3], [f32; 3], f32); 6] = [
    ([0.07, -0.10, 0.30], [0.42, -0.24, 0.58], 0.060),
    ([0.08, -0.11, 0.27], [0.54, -0.27, 0.44], 0.062),
    ([0.08, -0.12, 0.23], [0.57, -0.28, 0.26], 0.062),
    ([0.08, -0.12, 0.19], [0.52, -0.27, 0.08], 0.060),
    ([0.07, -0.12, 0.15], [0.42, -0.25, -0.08], 0.056),
    ([0.06, -0.12, 0.11], [0.30, -0.22, -0.20], 0.050),
];

/// Signed distance, about: it looks along +y.
pub(super) fn angel(position: Vec3) -> f32 {
    // Both sides are alike.
    let p = Vec3::new(position.x.abs(), position.y, position.z);
    let robe = tube(p, (Vec3::new(0.0, 0.0, 0.22), 0.115), (Vec3::new(0.0, 0.0, -0.48), 0.245));
    // Cut off straight below.
    let robe = robe.max(-0.62 - p.z);
    let shoulders = ellipsoid(p, Vec3::new(0.0, 0.0, 0.27), Vec3::new(0.165, 0.10, 0.10));
    let neck = tube(p, (Vec3::new(0.0, 0.0, 0.3), 0.05), (Vec3::new(0.0, 0.01, 0.42), 0.05));
    let head = ellipsoid(p, Vec3::new(0.0, 0.02, 0.48), Vec3::new(0.098, 0.105, 0.122));
    let elbow = Vec3::new(0.17, 0.10, 0.08);
    let arm = tube(p, (Vec3::new(0.14, 0.01, 0.27), 0.052), (elbow, 0.058));
    let forearm = tube(p, (elbow, 0.056), (Vec3::new(0.018, 0.21, 0.20), 0.034));
    let body = [robe, shoulders, neck].into_iter().fold(f32::INFINITY, |a, b| smooth_union(a.min(9.0), b, 0.06));
    let body = smooth_union(body, head, 0.03);
    let body = smooth_union(body, smooth_union(arm, forearm, 0.03), 0.03);
    let wing = FEATHERS.iter().fold(9.0, |wing: f32, (root, tip, width)| {
        // Flat: thin along y, where it is bent backwards.
        let flat = |point: Vec3| Vec3::new(point.x, (point.y + 0.5 * point.x) * 2.2, point.z);
        let ends = [Vec3::from_array(*root), Vec3::from_array(*tip)].map(flat);
        smooth_union(wing, 0.5 * tube(flat(p), (ends[0], 0.7 * width), (ends[1], *width)), 0.02)
    });
    let body = smooth_union(body, wing, 0.03);
    // The halo is a part of its own.
    let around = Vec3::new(p.x, p.y - 0.0, 0.0).length() - 0.12;
    let halo = Vec3::new(around, 0.0, p.z - 0.655).length() - 0.022;
    body.min(halo)
}
