//! Look-ups in the transfer function tables.

use super::access::read;
use crate::abi::tables::{
    IOR_CELLS, IOR_LEAST, IOR_LEVEL_BITS, IOR_NO_RISE, IOR_OFFSET, IOR_RISE, IOR_STEP, SEGMENT_EXPONENT, SEGMENT_SIZE,
    SEGMENT_WORDS,
};
use crate::math::{floor_to_int, half_to_f32, lerp};
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

/// Index of refraction at a normalised scalar.
#[inline(always)]
pub fn ior(tables: &[u32], scalar: f32) -> f32 {
    ior_and_slope(tables, scalar).0
}

/// Index of refraction at a normalised scalar, and its derivative over the scalar.
#[inline(always)]
pub fn ior_and_slope(tables: &[u32], scalar: f32) -> (f32, f32) {
    let cells = IOR_CELLS as f32;
    let at = scalar * cells;
    let index = floor_to_int(at, 0.0, cells - 1.0);
    let word = read(tables, IOR_OFFSET as i32 + index);
    let unit = |of: u32| f32::from_bits(read(tables, of as i32));
    let level = (word >> (32 - IOR_LEVEL_BITS)) as i32 as f32;
    let rise = ((word & (2 * IOR_NO_RISE - 1)) as i32 - IOR_NO_RISE as i32) as f32 * unit(IOR_RISE);
    (unit(IOR_LEAST) + level * unit(IOR_STEP) + rise * (at - index as f32), rise * cells)
}

/// Where (front, back) lies in the table.
struct Cell {
    base: i32,
    front: f32,
    back: f32,
}

#[inline(always)]
fn cell(front: f32, back: f32) -> Cell {
    let last = (SEGMENT_SIZE - 1) as f32;
    let (f, b) = (front * last, back * last);
    let i = floor_to_int(f, 0.0, last - 1.0);
    let j = floor_to_int(b, 0.0, last - 1.0);
    Cell { base: (i * SEGMENT_SIZE as i32 + j) * SEGMENT_WORDS as i32, front: f - i as f32, back: b - j as f32 }
}

/// Bilinear interpolation of the pair of halves in word `word` of the entries around a cell.
#[inline(always)]
fn interpolate(tables: &[u32], cell: &Cell, word: i32) -> (f32, f32) {
    let words = SEGMENT_WORDS as i32;
    let row = SEGMENT_SIZE as i32 * words;
    let w00 = read(tables, cell.base + word);
    let w01 = read(tables, cell.base + word + words);
    let w10 = read(tables, cell.base + word + row);
    let w11 = read(tables, cell.base + word + row + words);
    let mix = |a: u32, b: u32, c: u32, d: u32| {
        let e = SEGMENT_EXPONENT;
        let front = lerp(half_to_f32(a, e), half_to_f32(b, e), cell.back);
        let back = lerp(half_to_f32(c, e), half_to_f32(d, e), cell.back);
        lerp(front, back, cell.front)
    };
    (mix(w00, w01, w10, w11), mix(w00 >> 16, w01 >> 16, w10 >> 16, w11 >> 16))
}

/// As [`attenuation`], where the medium is clear everywhere.
#[inline(always)]
pub fn attenuation_of_particles(tables: &[u32], front: f32, back: f32) -> Segment {
    let nothing = Vec3::new(0.0, 0.0, 0.0);
    Segment { particles: interpolate(tables, &cell(front, back), 0).0, medium: nothing, emission: nothing }
}

/// Attenuation between the scalars `front` and `back`, as light needs it.
#[inline(always)]
pub fn attenuation(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(front, back);
    let (particles, red) = interpolate(tables, &cell, 0);
    let (green, blue) = interpolate(tables, &cell, 1);
    Segment { particles, medium: Vec3::new(red, green, blue), emission: Vec3::new(0.0, 0.0, 0.0) }
}

/// Attenuation and colour between the scalars `front` and `back`, as a viewing ray needs them.
#[inline(always)]
pub fn segment(tables: &[u32], front: f32, back: f32) -> Segment {
    let cell = cell(front, back);
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
    let cell = cell(front, back);
    let (red, green) = interpolate(tables, &cell, 2);
    let (blue, particles) = interpolate(tables, &cell, 3);
    Segment { particles, medium: Vec3::new(0.0, 0.0, 0.0), emission: Vec3::new(red, green, blue) }
}
