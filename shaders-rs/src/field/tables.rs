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
    /// The shares of the segment whose scalars are below those of the table, among them, and above: beyond the table, its ends hold.
    below: f32,
    within: f32,
    above: f32,
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
    Cell {
        base: (i * SEGMENT_SIZE as i32 + j) * SEGMENT_WORDS as i32,
        front: f - i as f32,
        back: b - j as f32,
        below,
        within: 1.0 - (below + above),
        above,
    }
}

/// Bilinear interpolation of the pair of halves in word `word` of the entries around a cell, and the mean with the ends of the table.
#[inline(always)]
fn interpolate(tables: &[u32], cell: &Cell, word: i32) -> (f32, f32) {
    let words = SEGMENT_WORDS as i32;
    let row = SEGMENT_SIZE as i32 * words;
    let w00 = read(tables, cell.base + word);
    let w01 = read(tables, cell.base + word + words);
    let w10 = read(tables, cell.base + word + row);
    let w11 = read(tables, cell.base + word + row + words);
    let first = read(tables, word);
    let last = read(tables, (SEGMENT_SIZE * SEGMENT_SIZE - 1) as i32 * words + word);
    let e = SEGMENT_EXPONENT;
    let mix = |a: u32, b: u32, c: u32, d: u32, below: u32, above: u32| {
        let front = lerp(half_to_f32(a, e), half_to_f32(b, e), cell.back);
        let back = lerp(half_to_f32(c, e), half_to_f32(d, e), cell.back);
        let ends = half_to_f32(below, e) * cell.below + half_to_f32(above, e) * cell.above;
        lerp(front, back, cell.front) * cell.within + ends
    };
    (mix(w00, w01, w10, w11, first, last), mix(w00 >> 16, w01 >> 16, w10 >> 16, w11 >> 16, first >> 16, last >> 16))
}

/// As [`attenuation`], where the medium is clear everywhere.
#[inline(always)]
pub fn attenuation_of_particles(tables: &[u32], front: f32, back: f32) -> Segment {
    let nothing = Vec3::new(0.0, 0.0, 0.0);
    Segment { particles: interpolate(tables, &cell(tables, front, back), 0).0, medium: nothing, emission: nothing }
}

/// Attenuation between the scalars `front` and `back`, as light needs it.
#[inline(always)]
pub fn attenuation(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(tables, front, back);
    let (particles, red) = interpolate(tables, &cell, 0);
    let (green, blue) = interpolate(tables, &cell, 1);
    Segment { particles, medium: Vec3::new(red, green, blue), emission: Vec3::new(0.0, 0.0, 0.0) }
}

/// Attenuation and colour between the scalars `front` and `back`, as a viewing ray needs them.
#[inline(always)]
pub fn segment(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(tables, front, back);
    let (particles, medium_red) = interpolate(tables, &cell, 0);
    let (medium_green, medium_blue) = interpolate(tables, &cell, 1);
    let (red, green) = interpolate(tables, &cell, 2);
    let (blue, _) = interpolate(tables, &cell, 3);
    Segment {
        particles,
        medium: Vec3::new(medium_red, medium_green, medium_blue),
        emission: Vec3::new(red, green, blue),
    }
}

/// As [`segment`], where the medium is clear everywhere.
#[inline(always)]
pub fn segment_of_particles(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(tables, front, back);
    let (red, green) = interpolate(tables, &cell, 2);
    let (blue, particles) = interpolate(tables, &cell, 3);
    Segment { particles, medium: Vec3::new(0.0, 0.0, 0.0), emission: Vec3::new(red, green, blue) }
}
