//! The tree over the beams of a round: a node stands for the beams of 2^l × 2^l texels of the lattice. Nodes are found by their place alone, in the
//! order of Morton's curve.

use crate::abi::beams::BeamsUniforms;
use crate::field::access::read;
use spirv_std::glam::Vec3;

/// A node: its level, 0 for a single texel, and its number along Morton's curve of that level.
#[derive(Clone, Copy)]
pub struct Node {
    /// log₂ of the texels along an edge.
    pub level: u32,
    /// The number.
    pub number: u32,
}

/// Every other bit of `word`, from bit 0 on.
#[inline(always)]
fn every_other(word: u32) -> u32 {
    let word = word & 0x5555_5555;
    let word = (word | (word >> 1)) & 0x3333_3333;
    let word = (word | (word >> 2)) & 0x0f0f_0f0f;
    let word = (word | (word >> 4)) & 0x00ff_00ff;
    (word | (word >> 8)) & 0x0000_ffff
}

impl Node {
    /// Column and row of the node in its level.
    #[inline(always)]
    pub fn place(self) -> (u32, u32) {
        (every_other(self.number), every_other(self.number >> 1))
    }

    /// The first of the four nodes below.
    #[inline(always)]
    #[must_use]
    pub fn below(self) -> Self {
        Self { level: self.level - 1, number: self.number << 2 }
    }

    /// The node behind all that are below this one: number 1 of the highest level, `top`, is behind all.
    #[inline(always)]
    #[must_use]
    pub fn behind(self, top: u32) -> Self {
        let mut next = Self { number: self.number + 1, ..self };
        while (next.number & 3 == 0) & (next.level < top) {
            next = Self { level: next.level + 1, number: next.number >> 2 };
        }
        next
    }
}

/// The level of the root of a lattice of `count` × `count` texels: one node covers all.
#[inline(always)]
pub fn top(count: u32) -> u32 {
    let mut level = 0;
    while (1 << level) < count {
        level += 1;
    }
    level
}

/// Nodes of the levels below `level` of a tree whose root is at level `top`: 4^top + 4^(top − 1) + ….
#[inline(always)]
pub fn nodes_below(top: u32, level: u32) -> u32 {
    ((1 << (2 * top)) - (1 << (2 * (top - level)))) / 3 * 4
}

/// Nodes of a tree whose root is at level `top`.
#[inline(always)]
pub fn nodes(top: u32) -> u32 {
    nodes_below(top, top) + 1
}

/// Invocations in a row of the dispatch over the nodes.
pub const ROW: u32 = 64;

/// Rows of the dispatch over the nodes of a tree whose root is at level `top`; their records have room for whole rows.
#[inline(always)]
pub fn rows(top: u32) -> u32 {
    (nodes(top) + ROW - 1) / ROW
}

/// The tree of a round.
#[derive(Clone, Copy)]
pub struct Tree {
    /// The level of its root.
    pub root: u32,
    /// The first float of its records.
    pub first: u32,
    /// The number of its records.
    pub count: u32,
}

impl Tree {
    /// The tree over the beams of a round.
    #[inline(always)]
    pub fn of_round(u: &BeamsUniforms, round: u32) -> Self {
        let root = top(u.lattice.count);
        Self { root, first: round * u.limits.bundle_pitch, count: rows(root) * ROW }
    }

    /// Three components of the record of a node from `component` on.
    #[inline(always)]
    pub fn vector(&self, records: &[f32], node: Node, component: usize) -> Vec3 {
        let at = nodes_below(self.root, node.level) + node.number;
        let begin = self.first + component as u32 * self.count + at;
        let of = |number: u32| read(records, (begin + number * self.count) as i32);
        Vec3::new(of(0), of(1), of(2))
    }
}
