//! Where the light of a texel comes from: the back trace to the plane behind (sweep §4.2, Algorithm 1, lines 7 and 8).

use crate::abi::record::{Trace, light as record, trace};
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::access::{read, read_inside};
use crate::kernel::skip::{Reach, Same};
use crate::math::select;
use crate::sweep::light::around::{Way, direction_around, is_near};
use crate::sweep::light::look_up::{holds, shift};
use crate::sweep::light::unoccluded::stays_on_texel;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The light stays on its texel.
    pub const STILL: u32 = 1;
    /// It comes from less than a texel away.
    pub const NEAR: u32 = 3;
    /// It comes from anywhere.
    pub const FAR: u32 = 7;
}

/// The way of light that stays on its texel.
const STILL: Trace = Trace { across: 0.0, up: 0.0, ahead_x: 0.0, ahead_y: 0.0 };

/// The direction at texel (x, y).
#[inline(always)]
fn here<const INSIDE: bool>(u: &SweepUniforms, light: &[f32], x: u32, y: u32) -> Vec3 {
    let base = (y * u.light_grid.width) as i32;
    let texels = (u.light_grid.width * u.light_grid.height) as i32;
    let component = |c: usize| {
        if INSIDE {
            // SAFETY: (x, y) lies in the grid, and only where the grid lies in the buffer is `INSIDE` asked for.
            unsafe { read_inside(light, c as i32 * texels + base, x) }
        } else {
            read(light, c as i32 * texels + base + x as i32)
        }
    };
    Vec3::new(component(record::DIRECTION), component(record::DIRECTION + 1), component(record::DIRECTION + 2))
}

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level(x: u32, y: u32, u: &SweepUniforms, _mode: u32, light: &[f32]) -> u32 {
    if !holds(u, light, record::SIZE) {
        return level::FAR;
    }
    let (sx, sy) = shift(u, here::<true>(u, light, x, y), u.step.distance);
    let still = (sx == 0.0) & (sy == 0.0);
    let near = is_near(u, &Way { x, y, across: -sx, up: -sy });
    let moving = if near { level::NEAR } else { level::FAR };
    if still { level::STILL } else { moving }
}

/// Unoccluded light comes from its own texel, if texels move as it does.
#[inline(always)]
pub fn same(u: &SweepUniforms) -> Option<Same<{ trace::SIZE }>> {
    stays_on_texel(u).then_some(Same { record: STILL.store(), reach: Reach::OWN })
}

/// The way, in texels, to texel (x, y) from the point of the plane behind from which its light comes.
///
/// The paper takes the direction at the same texel of the plane behind. Light flies straight from plane to plane with the
/// direction it has where it starts, so the default takes one more step of the fixed-point iteration p = x − s(p).
#[inline(always)]
pub fn invoke<const LEVEL: u32>(x: u32, y: u32, u: &SweepUniforms, _mode: u32, light: &[f32]) -> [f32; trace::SIZE] {
    if LEVEL == level::STILL {
        return STILL.store();
    }
    let v = if LEVEL == level::NEAR { here::<true>(u, light, x, y) } else { here::<false>(u, light, x, y) };
    let (first_x, first_y) = shift(u, v, u.step.distance);
    let way = Way { x, y, across: -first_x, up: -first_y };
    // SAFETY: only if `level` found this texel's look-up near, and the grid inside the buffer, is the near one asked for.
    let v = unsafe {
        if LEVEL == level::NEAR {
            direction_around::<true>(u, light, &way)
        } else {
            direction_around::<false>(u, light, &way)
        }
    };
    let (second_x, second_y) = shift(u, v, u.step.distance);
    let euler = u.flags & flag::EULER != 0;
    Trace {
        across: select(euler, first_x, second_x),
        up: select(euler, first_y, second_y),
        ahead_x: first_x,
        ahead_y: first_y,
    }
    .store()
}
