//! The tree over the beams of a round: a node stands for the beams of 2^l × 2^l texels of the lattice. Nodes are found by their place alone, in the
//! order of Morton's curve.

use crate::abi::beams::BeamsUniforms;
use crate::abi::record::bundle;
use crate::field::access::{read, read_inside};
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

    /// The node behind all that are below this one, in a tree whose roots are at level `top`.
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

/// The highest level of nodes: a node of more texels would take long to make, and tell little.
const HIGHEST: u32 = 6;

/// The level of a node that would cover all of a lattice of `count` × `count` texels.
#[inline(always)]
fn whole(count: u32) -> u32 {
    let mut level = 0;
    while (1 << level) < count {
        level += 1;
    }
    level
}

/// The level of the roots of a lattice of `count` × `count` texels.
#[inline(always)]
pub fn top(count: u32) -> u32 {
    let level = whole(count);
    if level < HIGHEST { level } else { HIGHEST }
}

/// The number of roots.
#[inline(always)]
pub fn roots(count: u32) -> u32 {
    1 << (2 * (whole(count) - top(count)))
}

/// Nodes of the levels below `level` of a tree that would have its root at level `whole`: 4^whole + 4^(whole − 1) + ….
#[inline(always)]
fn below(whole: u32, level: u32) -> u32 {
    ((1 << (2 * whole)) - (1 << (2 * (whole - level)))) / 3 * 4
}

/// Nodes of the levels below `level`, over a lattice of `count` × `count` texels.
#[inline(always)]
pub fn nodes_below(count: u32, level: u32) -> u32 {
    below(whole(count), level)
}

/// Nodes over a lattice of `count` × `count` texels.
#[inline(always)]
pub fn nodes(count: u32) -> u32 {
    nodes_below(count, top(count)) + roots(count)
}

/// Invocations in a row of the dispatch over the nodes.
pub const ROW: u32 = 64;

/// Rows of the dispatch over the nodes; their records have room for whole rows.
#[inline(always)]
pub fn rows(count: u32) -> u32 {
    nodes(count).div_ceil(ROW)
}

/// Level of the nodes whose texels are looked at together: 16 texels, as many as the processor's vectors have lanes.
const GROUP: u32 = 2;

/// Lanes for the texels of a node of the lowest level.
#[inline(always)]
pub fn lanes() -> u32 {
    #[cfg(target_arch = "spirv")]
    {
        1 << (2 * GROUP)
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        const { assert!(1 << (2 * GROUP) == crate::kernel::LANES) };
        crate::kernel::lanes::whole() as u32
    }
}

/// A texel of a node of the lowest level.
#[derive(Clone, Copy)]
pub struct Texel {
    /// Its number in the lattice, row by row.
    pub number: i32,
    /// Whether there is one.
    pub is_texel: bool,
}

/// The tree of a round.
#[derive(Clone, Copy)]
pub struct Tree {
    /// The level of a node that would cover all of the lattice.
    pub whole: u32,
    /// The level of its roots.
    pub root: u32,
    /// Their number.
    pub roots: u32,
    /// The first float of its records.
    pub first: u32,
    /// The number of its records.
    pub count: u32,
}

impl Tree {
    /// The tree over the beams of a round.
    #[inline(always)]
    pub fn of_round(u: &BeamsUniforms, round: u32) -> Self {
        let texels = u.lattice.count;
        Self {
            whole: whole(texels),
            root: top(texels),
            roots: roots(texels),
            first: round * u.limits.bundle_pitch,
            count: rows(texels) * ROW,
        }
    }

    /// The level of the lowest nodes of a walk: their texels are looked at together.
    #[inline(always)]
    pub fn lowest(&self) -> u32 {
        if self.root < GROUP { self.root } else { GROUP }
    }

    /// The texel of a lane in a node of the lowest level; none if `is_texel` is not set.
    #[inline(always)]
    pub fn texel(&self, node: Node, lane: u32, count: u32) -> Texel {
        let lowest = self.lowest();
        let leaf = Node { level: 0, number: (node.number << (2 * lowest)) + lane };
        let (column, row) = leaf.place();
        let is_texel = (lane < 1 << (2 * lowest)) & (column < count) & (row < count);
        Texel { number: if is_texel { (row * count + column) as i32 } else { 0 }, is_texel }
    }

    /// The first node of a walk through all.
    #[inline(always)]
    pub fn first(&self) -> Node {
        Node { level: self.root, number: 0 }
    }

    /// Whether a walk has not come to its end.
    #[inline(always)]
    pub fn holds(&self, node: Node) -> bool {
        (node.level < self.root) | (node.number < self.roots)
    }

    /// Three components of the record of a node from `component` on.
    #[inline(always)]
    pub fn vector(&self, records: &[f32], node: Node, component: usize) -> Vec3 {
        let at = below(self.whole, node.level) + node.number;
        let begin = self.first + component as u32 * self.count + at;
        let of = |number: u32| read(records, (begin + number * self.count) as i32);
        Vec3::new(of(0), of(1), of(2))
    }

    /// Whether there are records for all lanes of a node of the lowest level, as [`Self::vector_of_lane`] reads them.
    #[inline(always)]
    pub fn has_lanes(&self, records: &[f32], node: Node) -> bool {
        let end = (node.number << (2 * self.lowest())) + (1 << (2 * GROUP));
        let last = self.first as usize + bundle::SIZE * self.count as usize;
        (end <= self.count) & (last <= records.len())
    }

    /// Three components, from `component` on, of the record of a texel's own node, by its lane in a node of the lowest level: records of lanes
    /// follow one another.
    ///
    /// # Safety
    /// [`Self::has_lanes`] must hold, and `component` must be three below the number of components at most.
    #[inline(always)]
    pub unsafe fn vector_of_lane(&self, records: &[f32], node: Node, lane: u32, component: usize) -> Vec3 {
        let begin = self.first + component as u32 * self.count + (node.number << (2 * self.lowest()));
        // SAFETY: the caller's promise.
        let of = |number: u32| unsafe { read_inside(records, (begin + number * self.count) as i32, lane) };
        Vec3::new(of(0), of(1), of(2))
    }
}
