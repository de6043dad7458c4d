//! Colours of voxels: factors of the colour that the transfer functions give, and of their extinction, interpolated between voxels.
//!
//! They carry what a scalar cannot tell: the colours of a photographed volume, or the opacity at the gradient's magnitude beside that at the scalar
//! (two-dimensional transfer functions: Kniss, Kindlmann & Hansen 2001, "Interactive volume rendering using multi-dimensional transfer functions").

use super::stencil::{Cell, cell};
use super::tables::Segment;
use super::voxels::{Rows, words};
use crate::abi::format::VoxelFormat;
use crate::abi::grid::Grid;
use crate::math::{clamp, lerp, select};
use crate::optics::isosurfaces::Sheet;
use spirv_std::glam::Vec3;

/// The factors at a point.
#[derive(Clone, Copy)]
pub struct Tint {
    /// Of the particles' colour, linear, 0 to 1.
    pub color: Vec3,
    /// Of the particles' extinction, 0 to 1.
    pub extinction: f32,
}

impl Tint {
    /// The factors where voxels have no colours.
    pub const NONE: Self = Self { color: Vec3::new(1.0, 1.0, 1.0), extinction: 1.0 };
}

/// A linear value of a value in sRGB, 0 to 1: within 0.002 of the curve, which has powers that kernels lack.
#[inline(always)]
fn linear(coded: f32) -> f32 {
    coded * (coded * (coded * 0.305_306_02 + 0.682_171_1) + 0.012_522_878)
}

/// The number in the byte of `word` that begins at bit `shift`, over 255.
#[inline(always)]
pub(super) fn share_of_word(word: u32, shift: u32) -> f32 {
    ((word >> shift) & 0xff) as i32 as f32 * (1.0 / 255.0)
}

/// A voxel's factors.
#[inline(always)]
pub(super) fn factors(word: u32) -> Tint {
    let color =
        Vec3::new(linear(share_of_word(word, 0)), linear(share_of_word(word, 8)), linear(share_of_word(word, 16)));
    Tint { color, extinction: share_of_word(word, 24) }
}

/// The factors between `a` and `b`, `share` of the way. Vectors of four lanes would keep a processor from taking many rays at once.
#[inline(always)]
pub(super) fn mix(a: Tint, b: Tint, share: f32) -> Tint {
    Tint { color: a.color + (b.color - a.color) * share, extinction: lerp(a.extinction, b.extinction, share) }
}

/// The factors at voxel coordinates `at`.
#[inline(always)]
fn tint<V: VoxelFormat>(colors: &[u32], grid: &Grid, at: Vec3) -> Tint {
    let Cell { rows: Rows { columns, y, z }, fraction } = cell::<V>(colors, grid, at);
    let along_x = |row: i32| {
        let (left, right) = words(colors, row, &columns);
        mix(factors(left), factors(right), fraction.x)
    };
    let near = mix(along_x(z[1] + y[1]), along_x(z[1] + y[2]), fraction.y);
    let far = mix(along_x(z[2] + y[1]), along_x(z[2] + y[2]), fraction.y);
    mix(near, far, fraction.z)
}

/// The point between voxel coordinates `from` and `to`, `share` of the way.
#[inline(always)]
pub fn between(from: Vec3, to: Vec3, share: f32) -> Vec3 {
    Vec3::new(lerp(from.x, to.x, share), lerp(from.y, to.y, share), lerp(from.z, to.z, share))
}

/// The factors in a segment between voxel coordinates `from` and `to`, at the mean place of its particles.
#[inline(always)]
pub fn tint_of<V: VoxelFormat>(colors: &[u32], grid: &Grid, (from, to): (Vec3, Vec3), segment: &Segment) -> Tint {
    if !V::COLORED {
        return Tint::NONE;
    }
    let there = segment.particles > 1e-9;
    let place = clamp(segment.moment / select(there, segment.particles, 1.0), 0.0, 1.0);
    tint::<V>(colors, grid, between(from, to, select(there, place, 0.5)))
}

/// The factor of extinction in the middle between voxel coordinates `from` and `to`.
#[inline(always)]
pub fn extinction_between<V: VoxelFormat>(colors: &[u32], grid: &Grid, from: Vec3, to: Vec3) -> f32 {
    if V::COLORED { tint::<V>(colors, grid, between(from, to, 0.5)).extinction } else { 1.0 }
}

impl Segment {
    /// The segment with factors of colour and extinction.
    #[inline(always)]
    #[must_use]
    pub fn tinted<V: VoxelFormat>(self, tint: &Tint) -> Self {
        if !V::COLORED {
            return self;
        }
        Self {
            particles: self.particles * tint.extinction,
            moment: self.moment * tint.extinction,
            emission: self.emission * (tint.color * tint.extinction),
            ..self
        }
    }

    /// The segment with a factor of extinction, as light needs it.
    #[inline(always)]
    #[must_use]
    pub fn thinned<V: VoxelFormat>(self, extinction: f32) -> Self {
        if V::COLORED { Self { particles: self.particles * extinction, ..self } } else { self }
    }
}

impl Sheet {
    /// The sheet with a factor of colour. Its opacity is its own.
    #[inline(always)]
    #[must_use]
    pub fn tinted<V: VoxelFormat>(self, tint: &Tint) -> Self {
        if V::COLORED { Self { color: self.color * tint.color, ..self } } else { self }
    }
}
