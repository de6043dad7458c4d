//! The light that refracted cells of the wavefront bring to a receiver: each cell once, where it crosses it.

use crate::abi::record::{Node, node_status as status};
use crate::abi::sweep::SweepUniforms;
use crate::abi::vector::{Affine, Vec3};
use crate::field::sums::Sums;
use crate::math::{affine, dot, max, xyz};
use crate::sweep::light::quad::{Corner, Target, scatter};
use crate::sweep::light::receiver_map::place;
use crate::sweep::light::wavefront::{coordinates, is_cell_straight, node};
use spirv_std::glam::Vec2;

/// The receivers that light lands on.
pub mod on {
    /// The ground.
    pub const GROUND: u32 = 0;
    /// The wall.
    pub const WALL: u32 = 1;
    /// The plane on which the light is an output.
    pub const OBSERVED: u32 = 2;
}

/// The receiver's plane in the wavefront's frame, positive on the side from which light comes.
#[inline(always)]
fn plane(u: &SweepUniforms, which: u32) -> Affine {
    let wall = which == on::WALL;
    let receiver = if wall { u.receivers.wall.plane } else { u.receivers.ground.plane };
    let observed = Affine { factors: Vec3::new(0.0, 0.0, -1.0), constant: u.wavefront.observed };
    if which == on::OBSERVED { observed } else { receiver }
}

/// Where a node's light lands, in texels of the map.
#[inline(always)]
fn corner(u: &SweepUniforms, node: &Node, plane: Affine) -> Corner {
    let w = &u.wavefront;
    let height = affine(plane, node.position);
    let speed = -dot(xyz(plane.factors), node.direction);
    let lands = (height > 0.0) & (speed > 1e-6);
    let at = node.position + node.direction * (height / max(speed, 1e-6));
    // A spherical wavefront has no coordinates behind its source.
    let ahead = (w.spherical == 0) | (at.z > 0.0);
    Corner {
        at: place(w, coordinates(w, at)),
        flux: node.flux,
        aside: Vec2::new(0.0, 0.0),
        turned: (node.status == status::TURNED) | !(lands & ahead),
    }
}

/// Scatters cell (x, y) onto receiver `which`, one of [`on`].
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(x: u32, y: u32, u: &SweepUniforms, which: u32, nodes: &[f32], sums: &mut S) {
    let w = &u.wavefront;
    if !is_cell_straight(w, nodes, x, y) {
        let plane = plane(u, which);
        let a = corner(u, &node(w, nodes, x, y), plane);
        let b = corner(u, &node(w, nodes, x + 1, y), plane);
        let c = corner(u, &node(w, nodes, x, y + 1), plane);
        let d = corner(u, &node(w, nodes, x + 1, y + 1), plane);
        let target = Target { columns: w.map.size.width as i32, rows: w.map.size.height as i32 };
        // Nothing looks at bricks where light lands.
        scatter::<S, true>(u, &[0], sums, target, (&a, &b, &c, &d));
    }
}
