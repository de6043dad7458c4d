//! Boxes around beams, for the trees over them ([`super::tree`]).

use super::store_beam::{beam_of, has_flux};
use super::tree::{Node, nodes, nodes_below, top};
use crate::abi::beams::{BeamsUniforms, ENDS, PIECES};
use crate::abi::record::{Beam, Bounds, bounds};
use crate::math::{absolute, max, min};
use crate::optics::receiver::FAR;
use spirv_std::glam::Vec3;

#[inline(always)]
fn sizes(v: Vec3) -> Vec3 {
    Vec3::new(absolute(v.x), absolute(v.y), absolute(v.z))
}

/// Half the extent of a beam's cross-section at a distance along it, along the axes.
#[inline(always)]
fn extent(beam: &Beam, distance: f32) -> Vec3 {
    let first = beam.position_u + beam.direction_u * distance;
    let second = beam.position_v + beam.direction_v * distance;
    (sizes(first) + sizes(second)) * 0.5
}

#[inline(always)]
fn lower(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z))
}

#[inline(always)]
fn higher(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z))
}

/// The box of the end of a beam on a surface: as deep along the beam as an oblique or curved surface may be.
#[inline(always)]
fn at_end(beam: &Beam) -> (Vec3, Vec3) {
    let at = extent(beam, beam.reach);
    let middle = beam.position + beam.direction * beam.reach;
    let deep = sizes(beam.direction) * ((at.x + at.y) + at.z);
    (middle - at - deep, middle + at + deep)
}

/// The box of a node: invocations count the nodes of all trees of the round, row by row.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, beams: &[f32]) -> [f32; bounds::SIZE] {
    let count = u.lattice.count;
    let root = top(count);
    let index = y * u.dispatch.width + x;
    let tree = index / nodes(root);
    let in_tree = index - tree * nodes(root);
    let mut level = 0;
    while (level < root) & (in_tree >= nodes_below(root, level + 1)) {
        level += 1;
    }
    let (column, row) = Node { level, number: in_tree - nodes_below(root, level) }.place();
    let size = 1 << level;
    let (first_column, first_row) = (column * size, row * size);
    let mut low = Vec3::new(FAR, FAR, FAR);
    let mut high = low * -1.0;
    let records = (count * count) as i32;
    let first = (u.limits.round * u.limits.pitch) as i32;
    let mut j = first_row;
    while (j < first_row + size) & (j < count) {
        let mut i = first_column;
        while (i < first_column + size) & (i < count) {
            let number = (j * count + i) as i32;
            if has_flux(beams, first, number, records) {
                let beam = beam_of(beams, first, number, records);
                if tree == ENDS {
                    if beam.reach < 0.5 * FAR {
                        let (lowest, highest) = at_end(&beam);
                        low = lower(low, lowest);
                        high = higher(high, highest);
                    }
                } else {
                    let part = beam.length * (1.0 / PIECES as f32);
                    let (near, far) = (part * tree as f32, part * (tree + 1) as f32);
                    let (a, b) = (beam.position + beam.direction * near, beam.position + beam.direction * far);
                    let (at_a, at_b) = (extent(&beam, near), extent(&beam, far));
                    low = lower(low, lower(a - at_a, b - at_b));
                    high = higher(high, higher(a + at_a, b + at_b));
                }
            }
            i += 1;
        }
        j += 1;
    }
    Bounds { low, high }.store()
}
