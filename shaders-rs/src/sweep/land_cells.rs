//! The light that cells of the wavefront bring to a receiver: each cell once, where it crosses it.
//!
//! Of crisp light refracted cells alone land here: [`super::collect_receiver`] finds the others in their place. Soft light is told by its changes:
//! each cell takes what it has lost from the place where unrefracted light would be, spread as far as the source's disc spreads it on the way from where
//! it was lost; a refracted cell brings what is left to where it is, spread over the way from where it last bent.

use crate::abi::record::{Node, node_status as status};
use crate::abi::sweep::{SweepUniforms, receiver};
use crate::abi::vector::{Affine, Vec3};
use crate::field::sums::Sums;
use crate::math::{affine, dot, length, max, min, select, sqrt, xyz};
use crate::sweep::light::quad::{Corner, Target, scatter};
use crate::sweep::light::receiver_map::place;
use crate::sweep::light::wavefront::{coordinates, is_cell_straight, node, unrefracted, unrefracted_direction};
use spirv_std::glam::{self, Vec2};

/// The receiver's plane in the wavefront's frame, positive on the side from which light comes.
#[inline(always)]
fn plane(u: &SweepUniforms, which: u32) -> Affine {
    let wall = which == receiver::WALL;
    let seen = if wall { u.receivers.wall.plane } else { u.receivers.ground.plane };
    let observed = Affine { factors: Vec3::new(0.0, 0.0, -1.0), constant: u.wavefront.observed };
    if which == receiver::OBSERVED { observed } else { seen }
}

/// The way to a plane along a direction, in lengths of the direction; negative if there is none.
#[inline(always)]
fn way(plane: Affine, from: glam::Vec3, direction: glam::Vec3) -> f32 {
    let height = affine(plane, from);
    let speed = -dot(xyz(plane.factors), direction);
    select((height >= 0.0) & (speed > 1e-6), height / max(speed, 1e-6), -1.0)
}

/// A corner of a cell where its light lands, in texels of the map, and the length of the way from where it last bent.
#[inline(always)]
fn corner(u: &SweepUniforms, node: &Node, plane: Affine) -> (Corner, f32) {
    let w = &u.wavefront;
    let way = way(plane, node.position, node.direction);
    let at = node.position + node.direction * max(way, 0.0);
    // A spherical wavefront has no coordinates behind its source.
    let ahead = (w.spherical == 0) | (at.z > w.source.z);
    let corner = Corner {
        at: place(w, coordinates(w, at)),
        flux: node.flux,
        turned: (node.status == status::TURNED) | (way < 0.0) | !ahead,
    };
    (corner, max(way, 0.0) * length(node.direction) * select(node.bent != 0.0, 1.0, 0.0))
}

/// A corner of a cell that takes light, in texels of the map.
#[inline(always)]
fn taking(u: &SweepUniforms, x: u32, y: u32, node: &Node, straight: bool) -> Corner {
    let w = &u.wavefront;
    let at = Vec2::new(x as i32 as f32, y as i32 as f32);
    let all = glam::Vec3::new(-1.0, -1.0, -1.0);
    Corner { at: place(w, at), flux: if straight { node.flux + all } else { all }, turned: false }
}

/// How much of a node's light has left its straight way, mean of the colours.
#[inline(always)]
fn lost(node: &Node) -> f32 {
    let left = (node.flux.x + node.flux.y + node.flux.z) * (1.0 / 3.0);
    1.0 - select(node.bent != 0.0, 0.0, left)
}

/// The depth at which a node's light left its straight way, times how much of it did.
#[inline(always)]
fn lost_at(node: &Node) -> f32 {
    select(node.bent != 0.0, node.left_at, node.absorbed_at)
}

/// The length of a way whose blur is still to come, of one of length `way` from `depth` on, as nodes were blurred up to the last plane or to the
/// receiver: the difference of the variances.
#[inline(always)]
fn unblurred(u: &SweepUniforms, depth: f32, way: f32) -> f32 {
    let done = max(min(u.step.ahead - depth, way), 0.0);
    select(u.wavefront.blur > 0.0, sqrt(max(way * way - done * done, 0.0)), way)
}

/// Texels of the map that a soft light spreads over on a way of this length, as a radius.
#[inline(always)]
fn blur(u: &SweepUniforms, way: f32) -> f32 {
    let w = &u.wavefront;
    w.softness * way * w.inverse_cell * w.map.texels
}

/// Scatters cell (x, y) onto receiver `which`, one of [`receiver`].
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(x: u32, y: u32, u: &SweepUniforms, which: u32, nodes: &[f32], sums: &mut S) {
    let w = &u.wavefront;
    let straight = is_cell_straight(w, nodes, x, y);
    let soft = w.softness > 0.0;
    if !straight | soft {
        let plane = plane(u, which);
        let target = Target { columns: w.map.size.width as i32, rows: w.map.size.height as i32 };
        let (first, second) = (node(w, nodes, x, y), node(w, nodes, x + 1, y));
        let (third, fourth) = (node(w, nodes, x, y + 1), node(w, nodes, x + 1, y + 1));
        if !straight {
            let (a, b) = (corner(u, &first, plane), corner(u, &second, plane));
            let (c, d) = (corner(u, &third, plane), corner(u, &fourth, plane));
            let way = max(max(a.1, b.1), max(c.1, d.1));
            scatter::<S>(u, sums, target, (&a.0, &b.0, &c.0, &d.0), blur(u, way));
        }
        let all = (lost(&first) + lost(&second)) + (lost(&third) + lost(&fourth));
        if soft & (all > 0.0) {
            let depth = ((lost_at(&first) + lost_at(&second)) + (lost_at(&third) + lost_at(&fourth))) / all;
            let from = unrefracted(w, x as i32 as f32 + 0.5, y as i32 as f32 + 0.5, depth);
            let to = way(plane, from, unrefracted_direction(w, from));
            if to >= 0.0 {
                let a = taking(u, x, y, &first, straight);
                let b = taking(u, x + 1, y, &second, straight);
                let c = taking(u, x, y + 1, &third, straight);
                let d = taking(u, x + 1, y + 1, &fourth, straight);
                scatter::<S>(u, sums, target, (&a, &b, &c, &d), blur(u, unblurred(u, depth, to)));
            }
        }
    }
}
