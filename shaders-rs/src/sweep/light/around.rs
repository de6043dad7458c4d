//! Bilinear look-ups in the light grid at some way from a texel.
//!
//! A look-up less than a texel away can do with the texel's row and column and those next to them, which neighbouring
//! invocations read as contiguous loads instead of scattered ones. Nothing here chooses between loaded values: LLVM would make that a
//! load from a chosen address.

use crate::abi::record::{Light, light as record};
use crate::abi::sweep::SweepUniforms;
use crate::field::access::{read, read_inside};
use crate::math::{floor_to_int, select};
use spirv_std::glam::Vec3;

/// The way from texel (x, y) to a look-up, in texels.
#[derive(Clone, Copy)]
pub struct Way {
    /// The texel's column.
    pub x: u32,
    /// The texel's row.
    pub y: u32,
    /// The way along the row.
    pub across: f32,
    /// The way over the rows.
    pub up: f32,
}

/// One axis of a look-up: the nearer column (or row) on the texel's side, the one beyond it, and that one's weight.
struct Axis {
    nearer: i32,
    towards: i32,
    weight: f32,
}

/// Farther than any look-up that matters.
const FAR: f32 = 32768.0;

#[inline(always)]
fn axis(way: f32) -> Axis {
    let whole = floor_to_int(way, -FAR, FAR);
    let fraction = way - whole as f32;
    let back = whole < 0;
    Axis {
        nearer: if back { whole + 1 } else { whole },
        towards: if back { -1 } else { 1 },
        weight: select(back, 1.0 - fraction, fraction),
    }
}

/// Whether row `y` has two rows below and two above. Its texels' neighbours, diagonal ones too, then lie in the buffer: those beyond
/// the rows' ends in the rows next to them, where they have no weight.
#[inline(always)]
pub fn is_inner_row(u: &SweepUniforms, y: u32) -> bool {
    (y > 1) & (y + 2 < u.light_grid.height)
}

#[inline(always)]
fn is_inside(u: &SweepUniforms, way: &Way) -> bool {
    let (x, y) = (way.x as i32 as f32 + way.across, way.y as i32 as f32 + way.up);
    let (right, top) = (u.light_grid.width as i32 as f32 - 1.0, u.light_grid.height as i32 as f32 - 1.0);
    (x >= 0.0) & (x <= right) & (y >= 0.0) & (y <= top)
}

/// Whether a look-up lies in the grid, and so near an inner row's texel that the `_near` functions can do it.
#[inline(always)]
pub fn is_near(u: &SweepUniforms, way: &Way) -> bool {
    let close = (way.across >= -1.0) & (way.across < 1.0) & (way.up >= -1.0) & (way.up < 1.0);
    is_inner_row(u, way.y) & is_inside(u, way) & close
}

/// A component of the light.
///
/// # Safety
/// If `NEAR`, [`is_near`] must be true, and the grid's components lie inside `light`.
#[inline(always)]
unsafe fn interpolate<const NEAR: bool>(
    u: &SweepUniforms,
    light: &[f32],
    way: &Way,
    component: usize,
    outside: f32,
) -> f32 {
    let width = u.light_grid.width as i32;
    let base = component as i32 * (u.light_grid.width * u.light_grid.height) as i32 + way.y as i32 * width;
    let (x, y) = (axis(way.across), axis(way.up));
    if NEAR {
        let (left, right) = (select(x.towards < 0, x.weight, 0.0), select(x.towards < 0, 0.0, x.weight));
        let (below, above) = (select(y.towards < 0, y.weight, 0.0), select(y.towards < 0, 0.0, y.weight));
        // SAFETY: around an inner row's texel all lies in the grid's rows, and the grid in the buffer.
        let (a, b, c) = unsafe {
            (
                row_near(light, base - width, way.x, left, right),
                row_near(light, base, way.x, left, right),
                row_near(light, base + width, way.x, left, right),
            )
        };
        b + ((a - b) * below + (c - b) * above)
    } else {
        let nearer = row(light, base + y.nearer * width + way.x as i32, &x);
        let beyond = row(light, base + (y.nearer + y.towards) * width + way.x as i32, &x);
        select(is_inside(u, way), nearer + (beyond - nearer) * y.weight, outside)
    }
}

/// # Safety
/// `base + x` and the elements before and after it must lie inside the buffer.
#[inline(always)]
unsafe fn row_near(light: &[f32], base: i32, x: u32, left: f32, right: f32) -> f32 {
    // SAFETY: the caller's promise.
    let (a, b, c) =
        unsafe { (read_inside(light, base - 1, x), read_inside(light, base, x), read_inside(light, base + 1, x)) };
    b + ((a - b) * left + (c - b) * right)
}

#[inline(always)]
fn row(light: &[f32], at: i32, x: &Axis) -> f32 {
    let nearer = read(light, at + x.nearer);
    nearer + (read(light, at + x.nearer + x.towards) - nearer) * x.weight
}

/// The direction; beyond the grid, the initial one.
///
/// # Safety
/// If `NEAR`, [`is_near`] must be true, and the grid's components lie inside `light`.
#[inline(always)]
pub unsafe fn direction_around<const NEAR: bool>(u: &SweepUniforms, light: &[f32], way: &Way) -> Vec3 {
    // SAFETY: the caller's promise.
    let component = |c: usize, outside: f32| unsafe { interpolate::<NEAR>(u, light, way, c, outside) };
    Vec3::new(
        component(record::DIRECTION, u.light.direction.x),
        component(record::DIRECTION + 1, u.light.direction.y),
        component(record::DIRECTION + 2, u.light.direction.z),
    )
}

/// All components of a texel's record; beyond the grid, those of unoccluded light. In a clear medium its colours are equal.
///
/// # Safety
/// If `NEAR`, [`is_near`] must be true, and the grid's components lie inside `light`.
#[inline(always)]
pub unsafe fn record_around<const NEAR: bool>(
    u: &SweepUniforms,
    light: &[f32],
    way: &Way,
    clear: bool,
) -> [f32; record::SIZE] {
    // SAFETY: the caller's promise.
    let component = |c: usize, outside: f32| unsafe { interpolate::<NEAR>(u, light, way, c, outside) };
    let red = component(record::FLUX, 1.0);
    let (mut green, mut blue) = (red, red);
    if !clear {
        (green, blue) = (component(record::FLUX + 1, 1.0), component(record::FLUX + 2, 1.0));
    }
    let light = Light {
        flux: Vec3::new(red, green, blue),
        direction: Vec3::new(
            component(record::DIRECTION, u.light.direction.x),
            component(record::DIRECTION + 1, u.light.direction.y),
            component(record::DIRECTION + 2, u.light.direction.z),
        ),
        displacement_x: component(record::DISPLACEMENT_X, 0.0),
        displacement_y: component(record::DISPLACEMENT_Y, 0.0),
        concentration: component(record::CONCENTRATION, 1.0),
    };
    light.store()
}

/// The record of texel (x, y) itself.
///
/// # Safety
/// (x, y) must lie in the grid, and the grid's components inside `light`.
#[inline(always)]
pub unsafe fn record_of_texel(u: &SweepUniforms, light: &[f32], x: u32, y: u32) -> [f32; record::SIZE] {
    let texels = (u.light_grid.width * u.light_grid.height) as i32;
    let base = y as i32 * u.light_grid.width as i32;
    // SAFETY: the caller's promise.
    let component = |c: usize| unsafe { read_inside(light, c as i32 * texels + base, x) };
    let vector = |c: usize| Vec3::new(component(c), component(c + 1), component(c + 2));
    let light = Light {
        flux: vector(record::FLUX),
        direction: vector(record::DIRECTION),
        displacement_x: component(record::DISPLACEMENT_X),
        displacement_y: component(record::DISPLACEMENT_Y),
        concentration: component(record::CONCENTRATION),
    };
    light.store()
}
