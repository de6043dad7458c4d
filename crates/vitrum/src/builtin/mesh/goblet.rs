//! The wine glass of the volume `glass` (sweep, Fig. 8) as a mesh: the glass and the wine.

use super::super::SceneEntry;
use super::super::glass::{BODY, CAVITY, LEVEL, MENISCUS, WALL};
use super::parts::{Part, assemble, clear};
use super::rays_through;
use super::revolve::{revolve, smooth_outline};
use crate::scene::{Camera, Ground, Light, MethodName, Scene, Surfaces, Wall};
use glam::Vec2;
use vitrum_io::{Material, Mesh};

pub(in super::super) const SCENES: &[SceneEntry] = &[
    ("goblet", "a plane sweep through the mesh of a glass of wine, on a ground plane before a wall", swept),
    ("goblet/rays", "rays through the mesh of a glass of wine", rays),
    ("goblet/exact", "rays through the triangles of a glass of wine", exact),
];

/// Finer than elsewhere: a wall is ten times thinner than the bowl is wide.
const HALVINGS: u32 = 6;

fn rays() -> Scene {
    rays_through("goblet")
}

fn exact() -> Scene {
    let mut scene = rays();
    scene.voxels.surfaces = Surfaces::Exact;
    scene
}

fn swept() -> Scene {
    swept_before_a_wall("goblet")
}

/// A plane sweep through the mesh of that name, in daylight from the right.
pub(super) fn swept_before_a_wall(name: &str) -> Scene {
    Scene {
        method: MethodName::Sweep,
        mesh: rays_through(name).mesh,
        camera: Camera { azimuth: 0.0, elevation: 14.0, distance: Some(4.4186), ..Camera::default() },
        light: vec![Light { azimuth: 32.0, elevation: 14.0, ..Light::default() }],
        ground: Some(Ground { height: None, color: [0.72, 0.70, 0.67], ..Ground::default() }),
        wall: Some(Wall { distance: Some(0.95), azimuth: 0.0, color: [0.72, 0.70, 0.67] }),
        ..Scene::default()
    }
}

pub(in super::super) fn mesh(name: &str) -> Mesh {
    assemble(name, parts())
}

/// The glass and the wine.
pub(super) fn parts() -> Vec<(Part, Material)> {
    vec![
        (revolve(&smooth_outline(&BODY), HALVINGS), clear("glass", 1.5, [0.90, 0.97, 0.93], 0.5)),
        (revolve(&wine(), HALVINGS), clear("wine", 1.34, [0.55, 0.06, 0.09], 0.4)),
    ]
}

/// The outline of the wine, from the bottom along the wall to its level. It reaches into half of the wall's thickness: where two bodies
/// overlap, the smaller one fills the space, and that is the glass.
fn wine() -> Vec<Vec2> {
    let mut inside = smooth_outline(&BODY[CAVITY..]);
    inside.reverse();
    let last = inside.len() - 1;
    let within: Vec<Vec2> = (0..=last)
        .map(|index| {
            let along = inside[(index + 1).min(last)] - inside[index.saturating_sub(1)];
            let outwards = Vec2::new(along.y, -along.x).normalize();
            let moved = inside[index] + outwards * (0.5 * WALL);
            // The axis stays the axis.
            if index == 0 { Vec2::new(0.0, inside[0].y - 0.5 * WALL) } else { moved }
        })
        .take_while(|point| point.y < LEVEL)
        .collect();
    let wall = within[within.len() - 1].x;
    let level = [
        [wall, LEVEL + MENISCUS],
        [wall - 0.5 * WALL, LEVEL + MENISCUS],
        [wall - 0.8 * WALL, LEVEL + 0.5 * MENISCUS],
        [wall - 1.5 * WALL, LEVEL + 0.1 * MENISCUS],
        [wall - 3.0 * WALL, LEVEL],
        [0.0, LEVEL],
    ];
    within.into_iter().chain(level.map(Vec2::from_array)).collect()
}
