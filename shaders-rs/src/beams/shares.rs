//! The shares of a beam's light that single rays get beside coarse pixels.
//!
//! A wide beam is drawn in coarse pixels of a pyramid, and [`super::resolve`] interpolates between their centres. Where coarse pixels end, at the border
//! of a block of another level or where a surface stands in the beam, interpolation would spread light across the border: there
//! the single rays get the rest of their light, which may be negative, so that levels add up to 1 everywhere.

use super::covered::Levels;
use super::drawn::Drawn;
use super::look_around::depths_around;
use super::pyramid::size;
use super::scattered::Scattered;
use crate::abi::beams::{BeamsUniforms, medium};
use crate::abi::record::{Around, Beam};
use crate::math::{floor_to_int, limit, select};

/// A beam, and what its drawing reads.
#[derive(Clone, Copy)]
pub struct Drawing<'a> {
    /// The uniform block.
    pub u: &'a BeamsUniforms,
    /// The beam.
    pub beam: Beam,
    /// The beam in the picture.
    pub drawn: Drawn,
    /// The levels of the block of columns, and of those beside it.
    pub levels: Levels,
    /// Records of [`crate::abi::record::Sight`].
    pub sights: &'a [f32],
    /// Records of [`crate::abi::record::Around`].
    pub depths: &'a [f32],
    /// The beam's number.
    pub number: i32,
    /// Records of materials, and behind them the medium's density.
    pub materials: &'a [f32],
    /// Optical depths at the nodes of viewing rays, and behind them at the nodes of beams.
    pub optical_depths: &'a [f32],
}

impl Drawing<'_> {
    /// The light of the beam at the middle of a pixel of a level, by its place along the beam's axes, and the depths around it; `MODE` is one
    /// of [`medium`].
    #[inline(always)]
    pub fn look<const MODE: u32>(&self, level: u32, major: i32, minor: i32) -> (Scattered, Around) {
        let fine = (1 << level) as f32;
        let (along, across) = ((major as f32 + 0.5) * fine - 0.5, (minor as f32 + 0.5) * fine - 0.5);
        let (x, y) = self.drawn.place(along, across);
        let (column, row) = self.drawn.pixel(major, minor);
        let around = depths_around(self.u, self.depths, level, column, row);
        let middle = (1 << level) >> 1;
        let (width, height) = (self.u.picture.width as i32, self.u.picture.height as i32);
        let (inner_column, inner_row) = ((column << level) + middle, (row << level) + middle);
        let line = self.sightline(limit(inner_column, width), limit(inner_row, height));
        (self.scattered::<MODE>(x, y, &line), around)
    }

    /// Whether the beam is drawn in a pixel of a level.
    #[inline(always)]
    fn is_drawn(&self, level: u32, major: i32, minor: i32) -> bool {
        let (light, around) = self.look::<{ medium::HOMOGENEOUS }>(level, major, minor);
        let of_level = self.levels.at(major << level) == level;
        of_level & (light.distance > 0.0) & (light.distance < around.nearest)
    }

    /// The weight that interpolation gives a pixel of a level, if the beam is drawn there. The pixel is limited to the level as the look-up limits it.
    #[inline(always)]
    fn tap(&self, level: u32, (columns, rows): (i32, i32), major: i32, minor: i32, weight: f32) -> f32 {
        select(self.is_drawn(level, limit(major, columns), limit(minor, rows)), weight, 0.0)
    }

    /// `share` without the share of its light that a single ray gets from the pixels of a coarse level; level 0 stands for none. Without a loop: drivers
    /// that end long ones count this one in all loops around it.
    #[inline(always)]
    fn without(&self, share: f32, level: u32, major: i32, minor: i32) -> f32 {
        let of_level = self.drawn.along_axes(size(self.u.picture, level));
        let inverse = 1.0 / (1 << level) as f32;
        let (x, y) = ((major as f32 + 0.5) * inverse - 0.5, (minor as f32 + 0.5) * inverse - 0.5);
        let (left, top) = (floor_to_int(x, -1.0, 1e6), floor_to_int(y, -1.0, 1e6));
        let (fx, fy) = (x - left as f32, y - top as f32);
        let rest = share - self.tap(level, of_level, left, top, (1.0 - fx) * (1.0 - fy));
        let rest = rest - self.tap(level, of_level, left + 1, top, fx * (1.0 - fy));
        let rest = rest - self.tap(level, of_level, left, top + 1, (1.0 - fx) * fy);
        let rest = rest - self.tap(level, of_level, left + 1, top + 1, fx * fy);
        select(level == 0, share, rest)
    }

    /// The share of its light that a single ray does not get from coarse pixels, of which there are `COARSE` levels at most.
    #[inline(always)]
    pub fn rest<const COARSE: u32>(&self, major: i32, minor: i32) -> f32 {
        let [first, second, third] = self.levels.coarse();
        if COARSE == 0 {
            1.0
        } else if COARSE == 1 {
            // The one that there is.
            self.without(1.0, first + second + third, major, minor)
        } else {
            let share = self.without(1.0, first, major, minor);
            let share = self.without(share, second, major, minor);
            self.without(share, third, major, minor)
        }
    }
}
