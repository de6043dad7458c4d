//! A glass vase (Chang et al. 2010, Fig. 4).

use super::super::SceneEntry;
use super::parts::{assemble, clear};
use super::rays_through;
use super::revolve::{revolve, smooth_outline};
use crate::scene::{Scene, Surfaces};
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] = &[
    ("vase", "rays through all surfaces of a glass vase", scene),
    ("vase/two", "the vase with two refractions only", two),
    ("vase/exact", "the vase's triangles themselves, for comparison", exact),
];

fn scene() -> Scene {
    rays_through("vase")
}

fn with(surfaces: Surfaces) -> Scene {
    let mut scene = scene();
    scene.voxels.surfaces = surfaces;
    scene
}

fn two() -> Scene {
    with(Surfaces::Two)
}

fn exact() -> Scene {
    with(Surfaces::Exact)
}

pub(in super::super) fn mesh(name: &str) -> Mesh {
    let glass = clear("glass", 1.5, [0.62, 0.88, 0.92], 0.5);
    assemble(name, vec![(revolve(&smooth_outline(&OUTLINE), 6), glass)])
}

/// Distance from the axis and height, from the middle of the foot over the outside and the lip to the bottom inside.
#[rustfmt::skip]
const OUTLINE: [[f32; 2]; 30] = [
    [0.0, -0.985], [0.15, -0.99], [0.29, -0.998], [0.335, -0.99], [0.34, -0.96],
    [0.30, -0.90], [0.30, -0.84], [0.38, -0.72], [0.50, -0.56], [0.58, -0.36], [0.60, -0.16],
    [0.555, 0.06], [0.45, 0.27], [0.33, 0.45], [0.255, 0.60], [0.235, 0.72], [0.26, 0.84], [0.33, 0.94], [0.395, 0.99],
    [0.385, 1.012], [0.35, 0.998], [0.275, 0.93], [0.205, 0.84], [0.18, 0.72],
    [0.21, 0.57], [0.39, 0.25], [0.525, -0.16], [0.44, -0.53], [0.20, -0.76], [0.0, -0.80],
];
