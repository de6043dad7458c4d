//! The light of the wavefront's nodes, blurred as by a light of some width (not in the paper): on the way from an obstacle, the edge of its shadow
//! spreads over the light's disc as seen from there.
//!
//! A uniform disc of angular radius ρ, at the distance d behind the obstacle, has the variance (d tan ρ)² / 4 along each axis. From plane to plane light
//! therefore diffuses by the difference of that variance, where d is the distance from the mean depth at which it was absorbed: over many planes the
//! variance is right, and light is conserved, since each node gives to a neighbour what this one takes.

use crate::abi::record::{Blurred, blurred as record, node, node_status as status};
use crate::abi::sweep::{SweepUniforms, blurred};
use crate::abi::wavefront::Wavefront;
use crate::field::access::read;
use crate::math::{absolute, max, min, select};
use crate::sweep::light::wavefront::{columns, edge, nodes};
use spirv_std::glam::Vec3;

/// The largest share of its light that a node gives to a neighbour in one pass: with four neighbours, more than a quarter would overshoot.
pub const MOST: f32 = 0.2;
/// Less light than this share of unoccluded light tells no depth at which it was absorbed.
const LEAST: f32 = 1e-6;
/// Less than this is nothing.
const TRACES: f32 = 1e-12;

/// Whether the light of nodes of this status is blurred: of all that are under way.
#[inline(always)]
pub fn is_blurred(fate: f32) -> bool {
    fate == status::ACTIVE
}

/// The light of a node.
#[derive(Clone, Copy)]
struct There {
    flux: Vec3,
    absorbed_at: f32,
    blurred: bool,
}

/// The light of node (x, y).
#[inline(always)]
fn there(w: &Wavefront, which: u32, nodes_in: &[f32], behind: &[f32], x: i32, y: i32) -> There {
    let (width, height) = (w.cells.width as i32, w.cells.height as i32);
    let inside = (x >= 0) & (x <= width) & (y >= 0) & (y <= height);
    let count = nodes(w) as i32;
    let at = if inside { y * columns(w) as i32 + x } else { 0 };
    let fate = read(nodes_in, node::STATUS as i32 * count + at);
    let blurred = inside & is_blurred(fate);
    if which == blurred::NODES {
        let first = node::FLUX as i32 * count + at;
        let flux = Vec3::new(read(nodes_in, first), read(nodes_in, first + count), read(nodes_in, first + 2 * count));
        There { flux, absorbed_at: read(nodes_in, node::ABSORBED_AT as i32 * count + at), blurred }
    } else {
        let first = record::FLUX as i32 * count + at;
        let flux = Vec3::new(read(behind, first), read(behind, first + count), read(behind, first + 2 * count));
        There { flux, absorbed_at: read(behind, record::ABSORBED_AT as i32 * count + at), blurred }
    }
}

/// The share of its light that is absorbed, mean of the colours.
#[inline(always)]
fn absorbed(there: &There) -> f32 {
    1.0 - (there.flux.x + there.flux.y + there.flux.z) * (1.0 / 3.0)
}

/// The share of the difference of two neighbours' light that goes from one to the other.
#[inline(always)]
fn exchange(u: &SweepUniforms, own: &There, other: &There) -> f32 {
    let w = &u.wavefront;
    let lost = absorbed(own) + absorbed(other);
    let depth = (own.absorbed_at + other.absorbed_at) / max(lost, LEAST);
    let before = max(u.step.behind - depth, 0.0);
    let after = max(u.step.ahead - depth, 0.0);
    let radius = w.softness / edge(w, u.step.ahead);
    // Shares c to each of two neighbours make the variance 2c.
    let share = 0.125 * (radius * radius) * (after * after - before * before) * w.blur;
    select(own.blurred & other.blurred & (lost > LEAST), min(max(share, 0.0), MOST), 0.0)
}

/// `x`, or 0 if it is so little that it is on its way to denormal numbers, with which processors are slow.
#[inline(always)]
fn without_traces(x: f32) -> f32 {
    select(absolute(x) < TRACES, 0.0, x)
}

/// The light of node (x, y), blurred.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, which: u32, nodes_in: &[f32], behind: &[f32]) -> [f32; record::SIZE] {
    let w = &u.wavefront;
    let (column, row) = (x as i32, y as i32);
    let own = there(w, which, nodes_in, behind, column, row);
    let mut flux = own.flux;
    let mut absorbed_at = own.absorbed_at;
    let mut neighbour = 0;
    while neighbour < 4 {
        let step = if neighbour & 1 != 0 { 1 } else { -1 };
        let across = if neighbour < 2 { step } else { 0 };
        let other = there(w, which, nodes_in, behind, column + across, row + (step - across));
        let share = exchange(u, &own, &other);
        flux += (other.flux - own.flux) * share;
        absorbed_at += (other.absorbed_at - own.absorbed_at) * share;
        neighbour += 1;
    }
    let flux = Vec3::new(without_traces(flux.x), without_traces(flux.y), without_traces(flux.z));
    Blurred { flux, absorbed_at: without_traces(absorbed_at) }.store()
}
