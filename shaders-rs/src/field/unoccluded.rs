//! Light that nothing has stood in the way of, bent or filtered: the same on all texels.

use crate::abi::record::light as record;
use crate::abi::sweep::SweepUniforms;
use crate::field::light::shift;
use crate::math::xyz;

/// What a kernel makes of unoccluded light: where that is all that an invocation looks at, this is its record.
#[derive(Clone, Copy)]
pub struct Unoccluded<const N: usize> {
    /// The record.
    pub record: [f32; N],
    /// Where an invocation looks.
    pub reach: Reach,
}

/// How many texels beyond its own an invocation looks at, in each direction.
#[derive(Clone, Copy, Default)]
pub struct Reach {
    /// Towards smaller x.
    pub left: i32,
    /// Towards larger x.
    pub right: i32,
    /// Towards smaller y.
    pub below: i32,
    /// Towards larger y.
    pub above: i32,
}

impl Reach {
    /// The texels next to its own.
    pub const NEIGHBOURS: Self = Self { left: 1, right: 1, below: 1, above: 1 };
    /// None beyond its own.
    pub const OWN: Self = Self { left: 0, right: 0, below: 0, above: 0 };
}

/// The record of unoccluded light.
#[inline(always)]
pub fn light(u: &SweepUniforms) -> [f32; record::SIZE] {
    [1.0, 1.0, 1.0, u.light_direction.x, u.light_direction.y, u.light_direction.z, 0.0, 0.0, 1.0]
}

/// Whether unoccluded light stays on its texel from plane to plane, exactly.
#[inline(always)]
pub fn stays_on_texel(u: &SweepUniforms) -> bool {
    let (x, y) = shift(u, xyz(u.light_direction), u.plane.z);
    (x == 0.0) & (y == 0.0)
}
