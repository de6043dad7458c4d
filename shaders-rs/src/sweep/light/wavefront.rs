//! The wavefront's grid: nodes at the corners of cells, where unrefracted light would carry them, in the wavefront's own frame.

use crate::abi::record::{Node, node as record, node_status};
use crate::abi::vector;
use crate::abi::wavefront::Wavefront;
use crate::field::access::read;
use crate::math::{affine, length, max, normalize, select, select_vector};
use crate::optics::step::flight;
use crate::sweep::light::placed::{way, weight};
use spirv_std::glam::{Vec2, Vec3};

/// Nodes in a row.
#[inline(always)]
pub fn columns(w: &Wavefront) -> u32 {
    w.cells.width + 1
}

/// Nodes in all.
#[inline(always)]
pub fn nodes(w: &Wavefront) -> u32 {
    columns(w) * (w.cells.height + 1)
}

/// Length at `depth` over the length in the units of the grid.
#[inline(always)]
fn spread(w: &Wavefront, depth: f32) -> f32 {
    select(w.spherical != 0, depth - w.source.z, 1.0)
}

/// Edge of a cell at `depth`.
#[inline(always)]
pub fn edge(w: &Wavefront, depth: f32) -> f32 {
    w.cell * spread(w, depth)
}

/// The point at `depth` of unrefracted light with coordinates (x, y), in cells.
#[inline(always)]
pub fn unrefracted(w: &Wavefront, x: f32, y: f32, depth: f32) -> Vec3 {
    let spread = spread(w, depth);
    Vec3::new((w.corner_x + x * w.cell) * spread, (w.corner_y + y * w.cell) * spread, depth)
}

/// Coordinates, in cells, of the unrefracted light through a point of the wavefront's frame.
#[inline(always)]
pub fn coordinates(w: &Wavefront, at: Vec3) -> Vec2 {
    let inverse = 1.0 / max(spread(w, at.z), 1e-12);
    Vec2::new((at.x * inverse - w.corner_x) * w.inverse_cell, (at.y * inverse - w.corner_y) * w.inverse_cell)
}

/// The unit direction of unrefracted light at a point of the wavefront's frame.
#[inline(always)]
pub fn unrefracted_direction(w: &Wavefront, at: Vec3) -> Vec3 {
    select_vector(w.spherical != 0, normalize(way(w, at)), Vec3::new(0.0, 0.0, 1.0))
}

/// A point of the view frame in the wavefront's frame.
#[inline(always)]
pub fn in_frame(w: &Wavefront, at: Vec3) -> Vec3 {
    Vec3::new(affine(w.row_x, at), affine(w.row_y, at), affine(w.row_z, at))
}

/// A direction of the wavefront's frame in the view frame.
#[inline(always)]
pub fn from_frame(w: &Wavefront, v: Vec3) -> Vec3 {
    let turned = |x: vector::Vec3, by: f32| Vec3::new(x.x * by, x.y * by, x.z * by);
    turned(w.row_x.factors, v.x) + turned(w.row_y.factors, v.y) + turned(w.row_z.factors, v.z)
}

/// Node (x, y); its flux is that of a cell around it, over the flux of one around the frame's axis.
#[inline(always)]
pub fn node(w: &Wavefront, nodes_in: &[f32], x: u32, y: u32) -> Node {
    let count = nodes(w) as i32;
    let at = (y * columns(w) + x) as i32;
    let component = |c: usize| read(nodes_in, c as i32 * count + at);
    let vector = |c: usize| Vec3::new(component(c), component(c + 1), component(c + 2));
    Node {
        position: vector(record::POSITION),
        direction: vector(record::DIRECTION),
        flux: vector(record::FLUX) * weight(w, x, y),
        inside: component(record::INSIDE),
        bent: component(record::BENT),
        status: component(record::STATUS),
        absorbed_at: component(record::ABSORBED_AT),
        left_at: component(record::LEFT_AT),
    }
}

/// The share of unoccluded light that is left at node (x, y).
#[inline(always)]
pub fn flux(w: &Wavefront, nodes_in: &[f32], x: u32, y: u32) -> Vec3 {
    let count = nodes(w) as i32;
    let at = record::FLUX as i32 * count + (y * columns(w) + x) as i32;
    Vec3::new(read(nodes_in, at), read(nodes_in, at + count), read(nodes_in, at + 2 * count))
}

/// Whether node (x, y) is where unrefracted light is.
#[inline(always)]
pub fn is_straight(w: &Wavefront, nodes_in: &[f32], x: u32, y: u32) -> bool {
    let count = nodes(w) as i32;
    let at = (y * columns(w) + x) as i32;
    let (bent, status) =
        (read(nodes_in, record::BENT as i32 * count + at), read(nodes_in, record::STATUS as i32 * count + at));
    (bent == 0.0) & (status != node_status::TURNED)
}

/// Whether the four nodes of cell (x, y) are where unrefracted light is.
#[inline(always)]
pub fn is_cell_straight(w: &Wavefront, nodes: &[f32], x: u32, y: u32) -> bool {
    is_straight(w, nodes, x, y)
        & is_straight(w, nodes, x + 1, y)
        & is_straight(w, nodes, x, y + 1)
        & is_straight(w, nodes, x + 1, y + 1)
}

/// The point at `depth` to which a node flies from where it last bent.
#[inline(always)]
pub fn point_at(node: &Node, depth: f32) -> Vec3 {
    let sigma = flight(node.direction, depth - node.position.z);
    Vec3::new(node.position.x + node.direction.x * sigma, node.position.y + node.direction.y * sigma, depth)
}

/// Cosine of the angle between unrefracted light and the planes' normal over the cosine of a node's light: its fluence over the fluence that the same
/// flux has if nothing refracts it. Light along the planes is limited.
#[inline(always)]
pub fn fluence_of_flux(w: &Wavefront, direction: Vec3, at: Vec3) -> f32 {
    let across = length(direction) / max(direction.z, 1e-6);
    let straight = unrefracted_direction(w, at).z * across;
    select(straight < MOST_FLUENCE, straight, MOST_FLUENCE)
}

/// The most fluence of flux along the planes.
const MOST_FLUENCE: f32 = 8.0;
