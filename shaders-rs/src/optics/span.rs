//! A part of a segment.

use crate::math::{max, min, select};

/// A part of a segment, by where it starts and ends: 0 at the segment's front, 1 at its back. It is empty if it ends before it starts.
#[derive(Clone, Copy)]
pub struct Span {
    /// Where it starts.
    pub start: f32,
    /// Where it ends.
    pub end: f32,
}

impl Span {
    /// The whole segment.
    pub const WHOLE: Self = Self { start: 0.0, end: 1.0 };

    /// The share of the segment's length.
    #[inline(always)]
    #[must_use]
    pub fn length(self) -> f32 {
        max(self.end - self.start, 0.0)
    }

    /// The part of it that lies in `other`, too.
    #[inline(always)]
    #[must_use]
    pub fn within(self, other: Self) -> Self {
        Self { start: max(self.start, other.start), end: min(self.end, other.end) }
    }

    /// This part if `condition`, else the whole segment.
    #[inline(always)]
    #[must_use]
    pub fn only_if(self, condition: bool) -> Self {
        Self { start: select(condition, self.start, 0.0), end: select(condition, self.end, 1.0) }
    }

    /// The place in the segment that is at `place` in the span.
    #[inline(always)]
    #[must_use]
    pub fn at(self, place: f32) -> f32 {
        self.start + self.length() * place
    }
}
