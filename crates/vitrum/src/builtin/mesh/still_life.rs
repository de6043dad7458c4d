//! Balls and a filled glass on a table (after sweep, Fig. 13).

use super::super::SceneEntry;
use super::goblet::{parts, swept_before_a_wall};
use super::parts::{assemble, clear};
use super::rays_through;
use super::revolve::ball;
use crate::scene::Scene;
use glam::Vec3;
use vitrum_io::{Material, Mesh};

pub(in super::super) const SCENES: &[SceneEntry] = &[
    ("still-life", "a plane sweep through meshes of a filled glass and coloured balls on a table", swept),
    ("still-life/rays", "rays through the meshes of a filled glass and coloured balls", rays),
];

/// Height of the table.
const TABLE: f32 = -0.965;

fn swept() -> Scene {
    let mut scene = swept_before_a_wall("still-life");
    scene.camera.elevation = 22.0;
    scene.camera.distance = Some(5.577);
    if let Some(wall) = &mut scene.wall {
        wall.distance = Some(1.3);
    }
    scene
}

fn rays() -> Scene {
    let mut scene = rays_through("still-life");
    scene.camera.elevation = 22.0;
    scene
}

pub(in super::super) fn mesh(name: &str) -> Mesh {
    let mut all = parts();
    for (part, _) in &mut all {
        *part = std::mem::take(part).moved(|position| position + Vec3::new(-0.35, -0.1, 0.0));
    }
    let balls: [(f32, [f32; 2], Material); 3] = [
        (0.40, [0.62, -0.05], clear("ruby", 1.6, [0.90, 0.10, 0.12], 0.6)),
        (0.26, [0.28, 0.58], clear("emerald", 1.57, [0.10, 0.75, 0.30], 0.5)),
        (0.22, [0.86, 0.60], clear("crystal", 1.5, [0.97, 0.98, 0.98], 0.5)),
    ];
    for (radius, [x, y], material) in balls {
        let centre = Vec3::new(x, y, TABLE + radius);
        all.push((ball(radius, 5).moved(|position| position + centre), material));
    }
    assemble(name, all)
}
