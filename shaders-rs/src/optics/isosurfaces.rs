//! Isosurfaces: sheets of matter without thickness, where the scalar has a value. What crosses one is attenuated by its opacity, however long the segment is
//! and however steep the scalar.
//!
//! Along a segment the scalar is taken to rise or fall in a straight line, so that the isosurfaces that it crosses are those between its two ends. A surface
//! belongs to the scalars from its value on: of two segments with a common end just one crosses it there.

use crate::abi::tables::{ISOSURFACES, MOST_ISOSURFACES, SHEET_WORDS, SHEETS};
use crate::field::access::read_float;
use crate::math::{absolute, clamp, lerp, max, min, select};
use crate::optics::span::Span;
use spirv_std::glam::Vec3;

/// The isosurfaces that a segment crosses, as one sheet.
#[derive(Clone, Copy)]
pub struct Sheet {
    /// Their transmittance together; 1 where none is crossed.
    pub clear: f32,
    /// Their optical depth together; 0 where none is crossed.
    pub depth: f32,
    /// Their colour, each weighted by what is seen of it from the front of the segment.
    pub color: Vec3,
    /// Their place, weighted alike: 0 at the front of the segment and 1 at its back.
    pub at: f32,
}

impl Sheet {
    /// No sheet.
    pub const NONE: Self = Self { clear: 1.0, depth: 0.0, color: Vec3::new(0.0, 0.0, 0.0), at: 0.5 };

    /// This sheet if `condition`, else none.
    #[inline(always)]
    #[must_use]
    pub fn only_if(self, condition: bool) -> Self {
        Self { clear: select(condition, self.clear, 1.0), depth: select(condition, self.depth, 0.0), ..self }
    }

    /// The sheet in a segment whose scalars change over `span` alone.
    #[inline(always)]
    #[must_use]
    pub fn within(self, span: Span) -> Self {
        Self { at: span.at(self.at), ..self }
    }

    /// The sheet in the first `share` of its segment.
    #[inline(always)]
    #[must_use]
    pub fn before(self, share: f32) -> Self {
        Self { at: min(self.at / max(share, 1e-6), 1.0), ..self }
    }
}

/// 1 if isosurface `surface` has a value up to a normalised scalar, else 0.
#[inline(always)]
fn is_reached(tables: &[u32], scalar: f32, surface: u32) -> i32 {
    (scalar >= read_float(tables, (ISOSURFACES + surface) as i32)) as i32
}

/// The number of isosurfaces with values up to a normalised scalar.
#[inline(always)]
fn number(tables: &[u32], scalar: f32) -> i32 {
    const { assert!(MOST_ISOSURFACES == 8, "unrolled for eight") };
    // No closure: rust-gpu leaves its captured references in memory here.
    ((is_reached(tables, scalar, 0) + is_reached(tables, scalar, 1))
        + (is_reached(tables, scalar, 2) + is_reached(tables, scalar, 3)))
        + ((is_reached(tables, scalar, 4) + is_reached(tables, scalar, 5))
            + (is_reached(tables, scalar, 6) + is_reached(tables, scalar, 7)))
}

/// The first word of the sheet between two scalars.
#[inline(always)]
fn word(tables: &[u32], front: f32, back: f32) -> i32 {
    let row = number(tables, front) * (MOST_ISOSURFACES as i32 + 1);
    SHEETS as i32 + (row + number(tables, back)) * SHEET_WORDS as i32
}

/// The scalars at the ends of a part of the segment from the scalar `front` to `back`; those of the segment's own ends as they are.
#[inline(always)]
fn ends(front: f32, back: f32, part: Span) -> (f32, f32) {
    let at = |place: f32| select(place < 1.0, lerp(front, back, place), back);
    let start = at(part.start);
    (start, select(part.end > part.start, at(part.end), start))
}

/// The transmittance of the isosurfaces between two scalars, in a part of the segment.
#[inline(always)]
pub fn transmittance(tables: &[u32], front: f32, back: f32, part: Span) -> f32 {
    let (front, back) = ends(front, back, part);
    read_float(tables, word(tables, front, back))
}

/// The isosurfaces between two scalars, in a part of the segment.
#[inline(always)]
pub fn sheet(tables: &[u32], front: f32, back: f32, part: Span) -> Sheet {
    let (start, end) = ends(front, back, part);
    let word = word(tables, start, end);
    let float = |at: i32| read_float(tables, word + at);
    let way = back - front;
    let inverse = 1.0 / select(absolute(way) < 1e-20, 1.0, way);
    Sheet {
        clear: float(0),
        depth: float(1),
        color: Vec3::new(float(2), float(3), float(4)),
        at: clamp((float(5) - front) * inverse, 0.0, 1.0),
    }
}
