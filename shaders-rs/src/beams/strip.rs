//! Strips: as many pixels of a beam's picture as a block has columns, which are computed together and then added to the sums.
//!
//! On the processor a strip's contributions go to local arrays first: the loop over its lanes has no stores that may meet its reads, and becomes vector
//! code. Lanes are columns along the beam, and where pixels are coarse, so that a block has fewer columns of them, several rows as well: each column's
//! rows begin where the beam does.

use super::pyramid::sums_of;
use super::shares::Drawing;
use super::trapezoid::{LEAST, Trapezoid};
use crate::abi::beams::BLOCK;
use crate::field::sums::{Sums, add_words_of_row, words};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::lanes::whole;
use crate::math::{floor_to_int, select_vector};
#[cfg(not(target_arch = "spirv"))]
use crate::math::{max, min};
use spirv_std::glam::Vec3;

/// Columns of a block: a power of two.
const COLUMNS: u32 = BLOCK;
/// The logarithm of their number.
const COLUMNS_LOG: u32 = COLUMNS.ilog2();

/// The pixels of a level, in a block of columns, in which a beam is drawn.
#[derive(Clone, Copy)]
pub struct Rows {
    /// The level.
    pub level: u32,
    /// The first of its columns.
    pub first: i32,
    /// The last one.
    pub last: i32,
    /// The first row that is drawn.
    pub low: i32,
    /// The last one.
    pub high: i32,
}

/// Light that a beam sends to a pixel.
#[derive(Clone, Copy)]
pub struct Light {
    /// Whether it does.
    pub is_seen: bool,
    /// Radiance over the density of the flux.
    pub radiance: Vec3,
    /// Whether single rays of a coarse pixel have to be looked at.
    pub is_shared: bool,
}

/// A way to light the pixels of a strip.
pub trait Lit {
    /// The light of a pixel, by its place along the beam's axes.
    fn light(&self, drawing: &Drawing<'_>, major: i32, minor: i32) -> Light;
}

/// Rows of coarse pixels whose single rays have to be looked at.
#[derive(Clone, Copy)]
pub struct Shared {
    /// The first; behind the last one if there is none.
    pub first: i32,
    /// The last.
    pub last: i32,
}

impl Shared {
    /// None.
    pub const NONE: Self = Self { first: i32::MAX, last: -1 };
}

/// The contribution of a pixel to the sums: the index of its first word, the two words of each colour, and the row if it is shared, else −1.
type Contribution = [u32; 8];

impl Rows {
    /// Steps in which all rows of all columns are drawn.
    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    fn steps(&self, drawing: &Drawing<'_>) -> i32 {
        let edge = (1 << self.level) as f32;
        let ends = |column: i32| {
            let section = drawing.drawn.section((column as f32 + 0.5) * edge - 0.5);
            (section.middle, drawing.drawn.half_width(&section, edge))
        };
        let ((a, half_a), (b, half_b)) = (ends(self.first), ends(self.last));
        // Widths are sums of sizes that change in proportion to the column: none in between is wider than both.
        let half = max(half_a, half_b);
        let (low, high) = (self.low as f32 * edge, (self.high + 1) as f32 * edge);
        let shows = (max(a, b) + half >= low - edge) & (min(a, b) - half <= high + edge);
        let most = floor_to_int(2.0 * half / edge, 0.0, (self.high - self.low) as f32) + 1;
        if shows { (most + (1 << self.level) - 1) >> self.level } else { 0 }
    }

    /// The contribution of a lane in a step.
    #[inline(always)]
    fn contribution<L: Lit>(&self, drawing: &Drawing<'_>, lit: &L, lane: &Lane, step: i32) -> Contribution {
        let Drawing { u, drawn, .. } = drawing;
        let edge = (1 << self.level) as f32;
        let minor = lane.begin + (step << self.level);
        let is_drawn = minor <= lane.end;
        let across = ((minor as f32 + 0.5) * edge - 0.5 - lane.middle) * drawn.filter;
        let filter = drawn.filter * edge;
        let density = lane.trapezoid.filtered(across, filter, 1.0 / filter);
        let light = lit.light(drawing, lane.major, minor);
        let (column, row) = drawn.pixel(lane.major, minor);
        let zero = Vec3::new(0.0, 0.0, 0.0);
        let units = select_vector(is_drawn & light.is_seen, light.radiance * (density * u.sums.scale), zero);
        let ((r, r_high), (g, g_high), (b, b_high)) = (words(units.x), words(units.y), words(units.z));
        let shared = if is_drawn & light.is_shared { minor } else { -1 };
        [sums_of(u, self.level, column, row) as u32, r, r_high, g, g_high, b, b_high, shared as u32]
    }

    /// Draws the beam in all rows, and gives the rows that are shared.
    #[cfg(target_arch = "spirv")]
    #[inline(always)]
    pub fn draw<L: Lit, S: Sums + ?Sized>(&self, drawing: &Drawing<'_>, lit: &L, sums: &mut S) -> Shared {
        let mut shared = Shared::NONE;
        let mut number = 0;
        while number < COLUMNS as i32 {
            let lane = Lane::new(self, drawing, number);
            let mut step = 0;
            while lane.begin + (step << self.level) <= lane.end {
                take(self.contribution(drawing, lit, &lane, step), &mut shared, sums);
                step += 1;
            }
            number += 1;
        }
        shared
    }

    /// Draws the beam in all rows, and gives the rows that are shared.
    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    pub fn draw<L: Lit, S: Sums + ?Sized>(&self, drawing: &Drawing<'_>, lit: &L, sums: &mut S) -> Shared {
        let mut shared = Shared::NONE;
        let mut lanes = [[0.0f32; COLUMNS as usize]; Lane::SIZE];
        for number in 0..whole() {
            put(&mut lanes, number, Lane::new(self, drawing, number as i32).store());
        }
        for step in 0..self.steps(drawing) {
            let mut contributions = [[0u32; COLUMNS as usize]; 8];
            for number in 0..whole() {
                let lane = Lane::load(take_lane(&lanes, number));
                put(&mut contributions, number, self.contribution(drawing, lit, &lane, step));
            }
            for number in 0..COLUMNS as usize {
                take(take_lane(&contributions, number), &mut shared, sums);
            }
        }
        shared
    }
}

/// A lane: rows of a column.
struct Lane {
    /// The column along the major axis.
    major: i32,
    /// Its first row.
    begin: i32,
    /// The row up to which there may be more.
    end: i32,
    /// The beam's middle along the minor axis.
    middle: f32,
    /// The beam across its edge function.
    trapezoid: Trapezoid,
}

impl Lane {
    /// A lane by its number.
    #[inline(always)]
    fn new(rows: &Rows, drawing: &Drawing<'_>, number: i32) -> Self {
        let drawn = &drawing.drawn;
        let edge = (1 << rows.level) as f32;
        let columns = COLUMNS_LOG - rows.level;
        let major = rows.first + (number & ((1 << columns) - 1));
        let section = drawn.section((major as f32 + 0.5) * edge - 0.5);
        let half = drawn.half_width(&section, edge);
        let inverse = 1.0 / edge;
        let begin = (section.middle - half + 0.5) * inverse - 0.5;
        let end = (section.middle + half + 0.5) * inverse - 0.5;
        let (low, high) = (rows.low as f32, rows.high as f32);
        let end = floor_to_int(end, low - 1.0, high);
        Self {
            major,
            begin: floor_to_int(begin + 1.0, low, high + 1.0) + (number >> columns),
            end: if major <= rows.last { end } else { -1 },
            middle: section.middle,
            trapezoid: Trapezoid::new(section.first, section.second, LEAST * edge * drawn.filter),
        }
    }
}

#[cfg(not(target_arch = "spirv"))]
impl Lane {
    /// Components of a lane's record.
    const SIZE: usize = 8;

    /// Its record.
    #[inline(always)]
    fn store(&self) -> [f32; Self::SIZE] {
        let Trapezoid { half, narrow, slope, height } = self.trapezoid;
        [self.major as f32, self.begin as f32, self.end as f32, self.middle, half, narrow, slope, height]
    }

    /// The lane of a record.
    #[inline(always)]
    fn load([major, begin, end, middle, half, narrow, slope, height]: [f32; Self::SIZE]) -> Self {
        let number = |x: f32| floor_to_int(x, -1e9, 1e9);
        let trapezoid = Trapezoid { half, narrow, slope, height };
        Self { major: number(major), begin: number(begin), end: number(end), middle, trapezoid }
    }
}

/// Writes the record of a lane.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
fn put<T: Copy, const N: usize>(lanes: &mut [[T; COLUMNS as usize]; N], number: usize, record: [T; N]) {
    for (lanes, component) in lanes.iter_mut().zip(record) {
        // SAFETY: lanes are counted to at most the number of columns.
        unsafe { *lanes.get_unchecked_mut(number) = component };
    }
}

/// The record of a lane.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
fn take_lane<T: Copy, const N: usize>(lanes: &[[T; COLUMNS as usize]; N], number: usize) -> [T; N] {
    // SAFETY: as in `put`.
    core::array::from_fn(|component| unsafe { *lanes[component].get_unchecked(number) })
}

/// Adds a contribution to the sums. A pass draws along one of the picture's axes, and each row of its dispatch has columns of its own.
#[inline(always)]
fn take<S: Sums + ?Sized>(contribution: Contribution, shared: &mut Shared, sums: &mut S) {
    let [at, r, r_high, g, g_high, b, b_high, row] = contribution;
    add_words_of_row(sums, at as i32, r, r_high);
    add_words_of_row(sums, at as i32 + 2, g, g_high);
    add_words_of_row(sums, at as i32 + 4, b, b_high);
    let row = row as i32;
    if row >= 0 {
        shared.first = if row < shared.first { row } else { shared.first };
        shared.last = if row > shared.last { row } else { shared.last };
    }
}
