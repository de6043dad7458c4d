//! Look-ups in the transfer function tables.

use super::access::read;
use crate::abi::tables::{
    IOR_ABSCISSA, IOR_CELLS, IOR_LEAST, IOR_LEVEL_BITS, IOR_NO_RISE, IOR_OFFSET, IOR_PIECES, IOR_RISE, IOR_STEP,
    PIECE_WORDS, SEGMENT_ABSCISSA, SEGMENT_EXPONENT, SEGMENT_PIECES, SEGMENT_SIZE, SEGMENT_WORDS,
};
use crate::math::{absolute, clamp, floor_to_int, half_to_f32, lerp, max, min, select};
use spirv_std::glam::Vec3;

/// Optical depths and emission between two scalars, for a segment of the reference length.
#[derive(Clone, Copy)]
pub struct Segment {
    /// Optical depth of the particles, τ.
    pub particles: f32,
    /// Optical depth of the medium for each colour, κ.
    pub medium: Vec3,
    /// τ · particle colour, q. Zero where only attenuation is asked for.
    pub emission: Vec3,
    /// First moment of `particles` along the segment: times their mean place, 0 at the front and 1 at the back. Zero where only attenuation is asked for.
    pub moment: f32,
}

/// A float of the tables.
#[inline(always)]
fn float(tables: &[u32], at: u32) -> f32 {
    f32::from_bits(read(tables, at as i32))
}

/// What piece `piece` of the abscissa at word `abscissa` adds to the place of a scalar.
#[inline(always)]
fn piece(tables: &[u32], abscissa: u32, piece: u32, scalar: f32) -> f32 {
    let word = abscissa + piece * PIECE_WORDS;
    let (start, rate, entries) = (float(tables, word), float(tables, word + 1), float(tables, word + 2));
    clamp((scalar - start) * rate, 0.0, entries)
}

/// Entries per scalar behind `scalar`, if it lies in a piece from `piece` on, else `before`.
#[inline(always)]
fn rate(tables: &[u32], abscissa: u32, piece: u32, scalar: f32, before: f32) -> f32 {
    let word = abscissa + piece * PIECE_WORDS;
    select(scalar >= float(tables, word), float(tables, word + 1), before)
}

/// The place of a normalised scalar in the preintegration table along one axis, 0 to [`SEGMENT_SIZE`] − 1.
#[inline(always)]
pub fn segment_place(tables: &[u32], scalar: f32) -> f32 {
    let at = |number: u32| piece(tables, SEGMENT_ABSCISSA, number, scalar);
    ((at(0) + at(1)) + (at(2) + at(3))) + ((at(4) + at(5)) + (at(6) + at(7)))
}

/// The place of a normalised scalar in the η table, 0 to [`IOR_CELLS`].
#[inline(always)]
pub fn ior_place(tables: &[u32], scalar: f32) -> f32 {
    let at = |number: u32| piece(tables, IOR_ABSCISSA, number, scalar);
    (at(0) + at(1)) + (at(2) + at(3))
}

/// Index of refraction at a normalised scalar.
#[inline(always)]
pub fn ior(tables: &[u32], scalar: f32) -> f32 {
    ior_and_slope(tables, scalar).0
}

/// Index of refraction at a normalised scalar, and its derivative over the scalar.
#[inline(always)]
pub fn ior_and_slope(tables: &[u32], scalar: f32) -> (f32, f32) {
    let at = ior_place(tables, scalar);
    let index = floor_to_int(at, 0.0, (IOR_CELLS - 1) as f32);
    let word = read(tables, IOR_OFFSET as i32 + index);
    let level = (word >> (32 - IOR_LEVEL_BITS)) as i32 as f32;
    let rise = ((word & (2 * IOR_NO_RISE - 1)) as i32 - IOR_NO_RISE as i32) as f32 * float(tables, IOR_RISE);
    let eta = float(tables, IOR_LEAST) + level * float(tables, IOR_STEP) + rise * (at - index as f32);

    let rate = |number: u32, before: f32| rate(tables, IOR_ABSCISSA, number, scalar, before);
    let behind = rate(3, rate(2, rate(1, float(tables, IOR_ABSCISSA + 1))));
    let extent = IOR_ABSCISSA + IOR_PIECES * PIECE_WORDS;
    let within = (scalar >= float(tables, extent)) & (scalar <= float(tables, extent + 1));
    (eta, rise * select(within, behind, 0.0))
}

/// Where (front, back) lies in the table.
struct Cell {
    base: i32,
    front: f32,
    back: f32,
    /// The part of the segment whose scalars are below those of the table: beyond its ends the functions are constant.
    below: Part,
    /// The part whose scalars are among those of the table.
    within: Part,
    /// The part whose scalars are above those of the table.
    above: Part,
}

/// A part of a segment.
struct Part {
    /// Its share of the segment.
    share: f32,
    /// Where it starts, 0 at the segment's front and 1 at its back.
    start: f32,
}

#[inline(always)]
fn cell(tables: &[u32], front: f32, back: f32) -> Cell {
    let last = (SEGMENT_SIZE - 1) as f32;
    let (f, b) = (segment_place(tables, front), segment_place(tables, back));
    let i = floor_to_int(f, 0.0, last - 1.0);
    let j = floor_to_int(b, 0.0, last - 1.0);
    let extent = SEGMENT_ABSCISSA + SEGMENT_PIECES * PIECE_WORDS;
    let (low, high) = (float(tables, extent), float(tables, extent + 1));
    let way = back - front;
    let inverse = 1.0 / select(absolute(way) < 1e-20, 1.0, way);
    let below = (min(back, low) - min(front, low)) * inverse;
    let above = (max(back, high) - max(front, high)) * inverse;
    let rises = way > 0.0;
    let first = select(rises, below, above);
    let last = 1.0 - select(rises, above, below);
    Cell {
        base: (i * SEGMENT_SIZE as i32 + j) * SEGMENT_WORDS as i32,
        front: f - i as f32,
        back: b - j as f32,
        below: Part { share: below, start: select(rises, 0.0, last) },
        within: Part { share: 1.0 - (below + above), start: first },
        above: Part { share: above, start: select(rises, last, 0.0) },
    }
}

/// Bilinear interpolation of the pair of halves in word `word` of the entries around a cell, and the halves at the ends of the table.
struct Pair {
    within: (f32, f32),
    below: (f32, f32),
    above: (f32, f32),
}

#[inline(always)]
fn halves(word: u32) -> (f32, f32) {
    (half_to_f32(word, SEGMENT_EXPONENT), half_to_f32(word >> 16, SEGMENT_EXPONENT))
}

#[inline(always)]
fn pair(tables: &[u32], cell: &Cell, word: i32) -> Pair {
    let words = SEGMENT_WORDS as i32;
    let row = SEGMENT_SIZE as i32 * words;
    let near = halves(read(tables, cell.base + word));
    let beside = halves(read(tables, cell.base + word + words));
    let behind = halves(read(tables, cell.base + word + row));
    let across = halves(read(tables, cell.base + word + row + words));
    let mix = |a: f32, b: f32, c: f32, d: f32| lerp(lerp(a, b, cell.back), lerp(c, d, cell.back), cell.front);
    Pair {
        within: (mix(near.0, beside.0, behind.0, across.0), mix(near.1, beside.1, behind.1, across.1)),
        below: halves(read(tables, word)),
        above: halves(read(tables, (SEGMENT_SIZE * SEGMENT_SIZE - 1) as i32 * words + word)),
    }
}

/// The mean over the parts of a segment.
#[inline(always)]
fn mean(cell: &Cell, within: f32, below: f32, above: f32) -> f32 {
    within * cell.within.share + (below * cell.below.share + above * cell.above.share)
}

/// The means of a pair over the parts of a segment.
#[inline(always)]
fn means(tables: &[u32], cell: &Cell, word: i32) -> (f32, f32) {
    let Pair { within, below, above } = pair(tables, cell, word);
    (mean(cell, within.0, below.0, above.0), mean(cell, within.1, below.1, above.1))
}

/// The particles' optical depth and its first moment.
#[inline(always)]
fn moments(cell: &Cell, particles: (f32, f32, f32), moment: f32) -> (f32, f32) {
    let (within, below, above) = particles;
    let of = |part: &Part, moment: f32, depth: f32| part.share * (part.start * depth + part.share * moment);
    let ends = of(&cell.below, 0.5 * below, below) + of(&cell.above, 0.5 * above, above);
    (mean(cell, within, below, above), of(&cell.within, moment, within) + ends)
}

/// As [`attenuation`], where the medium is clear everywhere.
#[inline(always)]
pub fn attenuation_of_particles(tables: &[u32], front: f32, back: f32) -> Segment {
    let nothing = Vec3::new(0.0, 0.0, 0.0);
    let particles = means(tables, &cell(tables, front, back), 1).1;
    Segment { particles, medium: nothing, emission: nothing, moment: 0.0 }
}

/// Attenuation between the scalars `front` and `back`, as light needs it.
#[inline(always)]
pub fn attenuation(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(tables, front, back);
    let (green, blue) = means(tables, &cell, 0);
    let (red, particles) = means(tables, &cell, 1);
    Segment { particles, medium: Vec3::new(red, green, blue), emission: Vec3::new(0.0, 0.0, 0.0), moment: 0.0 }
}

/// Attenuation and colour between the scalars `front` and `back`, as a viewing ray needs them.
#[inline(always)]
pub fn segment(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(tables, front, back);
    let (medium_green, medium_blue) = means(tables, &cell, 0);
    let (first, second) = (pair(tables, &cell, 1), pair(tables, &cell, 2));
    let (green, blue) = means(tables, &cell, 3);
    let (particles, moment) = moments(&cell, (first.within.1, first.below.1, first.above.1), second.within.0);
    Segment {
        particles,
        medium: Vec3::new(mean(&cell, first.within.0, first.below.0, first.above.0), medium_green, medium_blue),
        emission: Vec3::new(mean(&cell, second.within.1, second.below.1, second.above.1), green, blue),
        moment,
    }
}

/// As [`segment`], where the medium is clear everywhere.
#[inline(always)]
pub fn segment_of_particles(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(tables, front, back);
    let (first, second) = (pair(tables, &cell, 1), pair(tables, &cell, 2));
    let (green, blue) = means(tables, &cell, 3);
    let (particles, moment) = moments(&cell, (first.within.1, first.below.1, first.above.1), second.within.0);
    let red = mean(&cell, second.within.1, second.below.1, second.above.1);
    Segment { particles, medium: Vec3::new(0.0, 0.0, 0.0), emission: Vec3::new(red, green, blue), moment }
}
