//! Light gathered from the plane behind: its direction by a bilinear look-up where it comes from (sweep §4.2, Algorithm 1, lines 9 to
//! 13), its flux shared out among texels.

use crate::abi::record::{Light, light as record, trace as traced};
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::access::{read, read_inside};
use crate::kernel::skip::{Reach, Same};
use crate::math::{max, min, select, xyz};
use crate::sweep::light::around::{Way, is_inner_row, is_near, record_around, record_of_texel};
use crate::sweep::light::arriving::arriving;
use crate::sweep::light::look_up::{holds, shift};
use crate::sweep::light::slopes::{product_of_lengths, slopes};
use crate::sweep::light::unoccluded::{self, stays_on_texel};

/// How much of the kernel an invocation needs.
pub mod level {
    /// The light stays on its texel.
    pub const STILL: u32 = 1;
    /// It comes from less than a texel away.
    pub const NEAR: u32 = 3;
    /// It comes from anywhere, or the texel lies on the grid's border.
    pub const FAR: u32 = 7;
    /// It is not conserved: its intensity is corrected as in the paper, or not at all.
    pub const UNCONSERVED: u32 = 15;
}

/// Where an invocation looks for unoccluded light.
const REACH: Reach = Reach { left: 2, right: 2, below: 2, above: 2 };

/// The most that the paper's product over planes may reach: behind a focus it grows without bound.
const DENSEST: f32 = 1e6;

/// The way back, in texels, from texel (x, y).
#[inline(always)]
fn back<const INSIDE: bool>(u: &SweepUniforms, trace: &[f32], x: u32, y: u32) -> (f32, f32) {
    let base = (y * u.light_grid.width) as i32;
    let texels = (u.light_grid.width * u.light_grid.height) as i32;
    let (across, up) = if INSIDE {
        // SAFETY: `level` found the grid inside the buffer.
        unsafe { (read_inside(trace, base, x), read_inside(trace, texels + base, x)) }
    } else {
        (read(trace, base + x as i32), read(trace, texels + base + x as i32))
    };
    (-across, -up)
}

/// Whether light is conserved.
#[inline(always)]
fn is_conserved(u: &SweepUniforms) -> bool {
    u.flags & (flag::PAPER_INTENSITY | flag::NO_INTENSITY) == 0
}

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level(x: u32, y: u32, u: &SweepUniforms, _mode: u32, behind: &[f32], trace: &[f32]) -> u32 {
    if !is_conserved(u) {
        return level::UNCONSERVED;
    }
    if !(holds(u, behind, record::SIZE) & holds(u, trace, traced::SIZE)) {
        return level::FAR;
    }
    let (across, up) = back::<true>(u, trace, x, y);
    let inner = is_inner_row(u, y) & (x > 1) & (x + 2 < u.light_grid.width);
    let still = (across == 0.0) & (up == 0.0) & inner;
    let near = is_near(u, &Way { x, y, across, up }) & inner;
    let moving = if near { level::NEAR } else { level::FAR };
    if still { level::STILL } else { moving }
}

/// Unoccluded light stays what it is, if texels move as it does.
#[inline(always)]
pub fn same(u: &SweepUniforms) -> Option<Same<{ record::SIZE }>> {
    stays_on_texel(u).then_some(Same { record: unoccluded::light(u), reach: REACH })
}

/// The light that arrives at texel (x, y) of this plane.
///
/// Its direction, and how far it has been displaced, are those of the point from which it comes. Its flux is what the texels around that
/// point send here ([`arriving`]); its concentration is the same without absorption. [`super::concentrate_light`] holds that against the
/// displacement.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    behind: &[f32],
    trace: &[f32],
) -> [f32; record::SIZE] {
    let far = LEVEL >= level::FAR;
    let (across, up) = if far { back::<false>(u, trace, x, y) } else { back::<true>(u, trace, x, y) };
    let way = Way { x, y, across, up };
    // SAFETY: only if `level` found this texel's look-up near, and the grid inside the buffer, is the near one asked for.
    let record = unsafe {
        if LEVEL == level::STILL {
            record_of_texel(u, behind, x, y)
        } else if LEVEL == level::NEAR {
            record_around::<true>(u, behind, &way, mode::is_clear(chosen))
        } else {
            record_around::<false>(u, behind, &way, mode::is_clear(chosen))
        }
    };
    let unrefracted = shift(u, xyz(u.light.direction), u.step.distance);
    let mut light = Light::load(&record);
    light.displacement_x += across + unrefracted.0;
    light.displacement_y += up + unrefracted.1;
    if (LEVEL == level::UNCONSERVED) & !is_conserved(u) {
        let denser = unconserved(u, trace, x, y);
        let denser = min(denser, DENSEST / max(light.concentration, 1.0));
        light.flux *= denser;
        light.concentration *= denser;
    } else {
        // SAFETY: as above.
        let arriving = unsafe {
            if LEVEL >= level::FAR {
                arriving::<false>(u, (behind, trace), &way, mode::is_clear(chosen))
            } else {
                arriving::<true>(u, (behind, trace), &way, mode::is_clear(chosen))
            }
        };
        light.flux = arriving.flux;
        light.concentration = arriving.concentration;
    }
    light.store()
}

/// How much denser light is by Eq. 13, or not at all.
#[inline(always)]
fn unconserved(u: &SweepUniforms, trace: &[f32], x: u32, y: u32) -> f32 {
    // SAFETY: nothing is read unchecked.
    let slopes = unsafe { slopes::<false>(u, trace, traced::ACROSS, -1.0, x, y) };
    select(u.flags & flag::NO_INTENSITY != 0, 1.0, product_of_lengths(&slopes))
}
