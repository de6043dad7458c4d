//! The softness filter: what the light grid carries, through three taps on an ellipse (sweep §4.2, after Patel et al. 2013).
//!
//! The taps' offsets are the same for all texels of a plane, so filtering the plane once and then following the refracted light
//! into the filtered plane is the same convolution as filtering at every back-traced point, for a third of the scattered reads.

use crate::abi::record::{Light, light as record};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::field::access::{read, read_inside};
use crate::kernel::skip::{Reach, Same};
use crate::math::{floor_to_int, lerp, select};
use crate::sweep::light::look_up::holds;
use crate::sweep::light::unoccluded;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// All rows it reads lie inside the grid.
    pub const INSIDE: u32 = 1;
    /// Some lie outside.
    pub const BORDER: u32 = 3;
}

/// A tap: whole texels, and the rest.
struct Tap {
    x: i32,
    y: i32,
    fraction_x: f32,
    fraction_y: f32,
}

/// Farther than any tap is.
const FAR: f32 = 32768.0;

#[inline(always)]
fn tap(x: f32, y: f32) -> Tap {
    let (whole_x, whole_y) = (floor_to_int(x, -FAR, FAR), floor_to_int(y, -FAR, FAR));
    Tap { x: whole_x, y: whole_y, fraction_x: x - whole_x as f32, fraction_y: y - whole_y as f32 }
}

#[inline(always)]
fn taps(u: &SweepUniforms) -> (Tap, Tap, Tap) {
    (tap(u.taps.first_x, u.taps.first_y), tap(u.taps.second_x, u.taps.second_y), tap(u.taps.third_x, u.taps.third_y))
}

/// Whether the four texels around a tap of texel (x, y) are in the grid.
#[inline(always)]
fn inside(u: &SweepUniforms, x: i32, y: i32, tap: &Tap) -> bool {
    let (i, j) = (x + tap.x, y + tap.y);
    (i >= 0) & (i < u.light_grid.width as i32 - 1) & (j >= 0) & (j < u.light_grid.height as i32 - 1)
}

/// Whether the two rows around a tap of row `y`, and one more on each side, are in the grid: what lies beyond a row's end is then
/// in the buffer, too.
#[inline(always)]
fn rows_inside(u: &SweepUniforms, y: i32, tap: &Tap) -> bool {
    let row = y + tap.y;
    let (width, height) = (u.light_grid.width as i32, u.light_grid.height as i32);
    (row >= 1) & (row < height - 2) & (tap.x > -width) & (tap.x < width - 1)
}

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level(_x: u32, y: u32, u: &SweepUniforms, _mode: u32, behind: &[f32]) -> u32 {
    let (a, b, c) = taps(u);
    let y = y as i32;
    let rows = rows_inside(u, y, &a) & rows_inside(u, y, &b) & rows_inside(u, y, &c);
    if holds(u, behind, record::SIZE) & rows { level::INSIDE } else { level::BORDER }
}

/// A component of the light at a tap of texel (x, y); beyond the grid, `outside`.
#[inline(always)]
fn at<const LEVEL: u32>(
    u: &SweepUniforms,
    behind: &[f32],
    x: u32,
    y: i32,
    tap: &Tap,
    component: usize,
    outside: f32,
) -> f32 {
    let width = u.light_grid.width as i32;
    let plane = component as i32 * (u.light_grid.width * u.light_grid.height) as i32;
    // Everything but x is the same along a row.
    let base = plane + (y + tap.y) * width + tap.x;
    let (a, b, c, d) = if LEVEL == level::INSIDE {
        // SAFETY: `level` found the rows around inside the grid, and the grid inside the buffer.
        unsafe {
            (
                read_inside(behind, base, x),
                read_inside(behind, base + 1, x),
                read_inside(behind, base + width, x),
                read_inside(behind, base + width + 1, x),
            )
        }
    } else {
        let index = base + x as i32;
        (read(behind, index), read(behind, index + 1), read(behind, index + width), read(behind, index + width + 1))
    };
    let value = lerp(lerp(a, b, tap.fraction_x), lerp(c, d, tap.fraction_x), tap.fraction_y);
    select(inside(u, x as i32, y, tap), value, outside)
}

/// Filtered, unoccluded light stays what it is: the mean of equal numbers is that number.
#[inline(always)]
pub fn same(u: &SweepUniforms) -> Option<Same<{ record::SIZE }>> {
    let (a, b, c) = taps(u);
    // A tap looks at two texels along each axis.
    let farthest = |first: i32, second: i32, third: i32| first.max(second).max(third) + 1;
    let reach = Reach {
        left: farthest(-a.x, -b.x, -c.x),
        right: farthest(a.x, b.x, c.x),
        below: farthest(-a.y, -b.y, -c.y),
        above: farthest(a.y, b.y, c.y),
    };
    Some(Same { record: unoccluded::light(u), reach })
}

/// The filtered light texel (x, y).
#[inline(always)]
pub fn invoke<const LEVEL: u32>(x: u32, y: u32, u: &SweepUniforms, chosen: u32, behind: &[f32]) -> [f32; record::SIZE] {
    let y = y as i32;
    let (first, second, third) = taps(u);
    let mean = |component: usize, outside: f32| {
        let a = at::<LEVEL>(u, behind, x, y, &first, component, outside);
        let b = at::<LEVEL>(u, behind, x, y, &second, component, outside);
        let c = at::<LEVEL>(u, behind, x, y, &third, component, outside);
        // Offsets from one tap, so that equal taps give exactly that tap.
        a + ((b - a) + (c - a)) * (1.0 / 3.0)
    };
    let red = mean(record::FLUX, 1.0);
    let (mut green, mut blue) = (red, red);
    if !mode::is_clear(chosen) {
        (green, blue) = (mean(record::FLUX + 1, 1.0), mean(record::FLUX + 2, 1.0));
    }
    let light = Light {
        flux: Vec3::new(red, green, blue),
        direction: Vec3::new(
            mean(record::DIRECTION, u.light.direction.x),
            mean(record::DIRECTION + 1, u.light.direction.y),
            mean(record::DIRECTION + 2, u.light.direction.z),
        ),
        displacement_x: mean(record::DISPLACEMENT_X, 0.0),
        displacement_y: mean(record::DISPLACEMENT_Y, 0.0),
        concentration: mean(record::CONCENTRATION, 1.0),
    };
    light.store()
}
