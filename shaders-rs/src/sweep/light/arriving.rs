//! The light that arrives at a texel, shared out so that none is counted twice.
//!
//! A texel of the plane behind is a cell, whose edges lie half-way between the texels' middles and move with them. Its light falls on the
//! texels that the moved cell covers, on each as much as it covers of it: all shares of a cell add up to 1. So whatever a texel looks at, all
//! texels together never get more light than there was behind. Where cells do not overlap they leave no gaps: the light of a smooth map is
//! that of its Jacobian. Within a cell light rises or falls as it does between its neighbours, or a peak would be blurred by each plane that
//! makes it narrower.

use crate::abi::record::{light as record, trace as traced};
use crate::abi::sweep::SweepUniforms;
use crate::field::access::{read, read_inside};
use crate::math::{absolute, clamp, floor_to_int, max, min, select, xyz};
use crate::sweep::light::around::Way;
use crate::sweep::light::look_up::shift;
use crate::sweep::light::slopes::limited;
use crate::sweep::light::unoccluded::stays_on_texel;
use spirv_std::glam::Vec3;

/// What arrives.
#[derive(Clone, Copy)]
pub struct Arriving {
    /// Flux, see [`record`].
    pub flux: Vec3,
    /// The same without absorption.
    pub concentration: f32,
}

/// The least width of a cell, in texels: rounding must not matter in its shares.
const NARROWEST: f32 = 1.0 / 16.0;

/// Farther than any look-up that matters.
const FAR: f32 = 32768.0;

/// The texels that are looked at: those around the one where the way back ends, or around its own where it is short.
#[derive(Clone, Copy)]
struct Middle {
    /// Columns from the texel.
    across: i32,
    /// Rows from the texel.
    up: i32,
    /// The way of unoccluded light, on which texels beyond the grid are.
    drift: (f32, f32),
    /// The flux of texels beyond the grid that comes in.
    outside: f32,
}

/// Texels from the texel to the middle of those that are looked at.
#[inline(always)]
fn middle(way: f32) -> i32 {
    let nearest = floor_to_int(way + 0.5, -FAR, FAR);
    let (back, ahead) = (way >= -1.0, way < 1.0);
    if back & ahead { 0 } else { nearest }
}

/// A component of the texel `across` columns and `up` rows from the middle one; beyond the grid, `outside`.
///
/// # Safety
/// If `NEAR`, the texel must lie in the grid, and the grid's components inside the buffer.
#[inline(always)]
unsafe fn component<const NEAR: bool>(
    u: &SweepUniforms,
    buffer: &[f32],
    (x, y): (u32, u32),
    middle: &Middle,
    (across, up): (i32, i32),
    component: usize,
    outside: f32,
) -> f32 {
    let (width, height) = (u.light_grid.width as i32, u.light_grid.height as i32);
    let plane = component as i32 * (width * height);
    if NEAR {
        // SAFETY: the caller's promise.
        unsafe { read_inside(buffer, plane + (y as i32 + up) * width + across, x) }
    } else {
        let (column, row) = (x as i32 + middle.across + across, y as i32 + middle.up + up);
        let inside = (column >= 0) & (column < width) & (row >= 0) & (row < height);
        select(inside, read(buffer, plane + row * width + column), outside)
    }
}

/// The part of a cell that falls on a texel, along one axis.
#[derive(Clone, Copy)]
struct Part {
    /// Its width over that of the cell.
    share: f32,
    /// That times the distance of its middle from that of the cell, over the cell's width.
    moment: f32,
}

/// The part of a cell that falls on a texel at 0: the cell is at `at`, and moved by `own`, those before and behind it by `before` and
/// `behind`.
#[inline(always)]
fn part(at: f32, before: f32, own: f32, behind: f32) -> Part {
    let low = at - 0.5 + 0.5 * (before + own);
    let high = at + 0.5 + 0.5 * (own + behind);
    let middle = 0.5 * (low + high);
    let inverse = 1.0 / max(absolute(high - low), NARROWEST);
    let (first, last) = (max((-0.5 - middle) * inverse, -0.5), min((0.5 - middle) * inverse, 0.5));
    let share = max(last - first, 0.0);
    let offset = 0.5 * (first + last);
    // What was before is behind in a cell that is turned over.
    Part { share, moment: share * select(high < low, -offset, offset) }
}

/// How light rises across a cell of light `own`, over that light, between cells of light `before` and `behind`. At most 1, so that no part
/// of a cell is darker than black.
#[inline(always)]
fn rise(before: f32, own: f32, behind: f32) -> f32 {
    clamp(limited(own - before, behind - own) / max(own, 1e-20), -1.0, 1.0)
}

/// `sum`, and what arrives from the texel `across` columns and `up` rows from the middle one.
///
/// # Safety
/// As in [`arriving`].
#[inline(always)]
unsafe fn add<const NEAR: bool>(
    sum: Arriving,
    u: &SweepUniforms,
    (behind, trace): (&[f32], &[f32]),
    at: (u32, u32),
    middle: &Middle,
    (across, up): (i32, i32),
    clear: bool,
) -> Arriving {
    // Written out: what a closure captures becomes a pointer that SPIR-V refuses.
    // SAFETY: the caller's promise.
    let (x, y) = unsafe {
        (
            part(
                (middle.across + across) as f32,
                component::<NEAR>(u, trace, at, middle, (across - 1, up), traced::AHEAD_X, middle.drift.0),
                component::<NEAR>(u, trace, at, middle, (across, up), traced::AHEAD_X, middle.drift.0),
                component::<NEAR>(u, trace, at, middle, (across + 1, up), traced::AHEAD_X, middle.drift.0),
            ),
            part(
                (middle.up + up) as f32,
                component::<NEAR>(u, trace, at, middle, (across, up - 1), traced::AHEAD_Y, middle.drift.1),
                component::<NEAR>(u, trace, at, middle, (across, up), traced::AHEAD_Y, middle.drift.1),
                component::<NEAR>(u, trace, at, middle, (across, up + 1), traced::AHEAD_Y, middle.drift.1),
            ),
        )
    };
    let outside = middle.outside;
    // SAFETY: the caller's promise.
    let (here, left, right, below, above) = unsafe {
        (
            component::<NEAR>(u, behind, at, middle, (across, up), record::CONCENTRATION, outside),
            component::<NEAR>(u, behind, at, middle, (across - 1, up), record::CONCENTRATION, outside),
            component::<NEAR>(u, behind, at, middle, (across + 1, up), record::CONCENTRATION, outside),
            component::<NEAR>(u, behind, at, middle, (across, up - 1), record::CONCENTRATION, outside),
            component::<NEAR>(u, behind, at, middle, (across, up + 1), record::CONCENTRATION, outside),
        )
    };
    let rise_x = rise(left, here, right);
    let rise_y = rise(below, here, above);
    let share = max(x.share * y.share + (rise_x * x.moment * y.share + rise_y * x.share * y.moment), 0.0);
    // SAFETY: the caller's promise.
    let red = unsafe { component::<NEAR>(u, behind, at, middle, (across, up), record::FLUX, outside) };
    let (mut green, mut blue) = (red, red);
    if !clear {
        // SAFETY: the caller's promise.
        (green, blue) = unsafe {
            (
                component::<NEAR>(u, behind, at, middle, (across, up), record::FLUX + 1, outside),
                component::<NEAR>(u, behind, at, middle, (across, up), record::FLUX + 2, outside),
            )
        };
    }
    Arriving { flux: sum.flux + Vec3::new(red, green, blue) * share, concentration: sum.concentration + here * share }
}

/// The light that arrives at the texel that a way back starts from.
///
/// # Safety
/// If `NEAR`, the way must be less than a texel long along both axes, the texel have two others on each side, and the grid's components lie
/// inside the buffers.
#[inline(always)]
pub unsafe fn arriving<const NEAR: bool>(
    u: &SweepUniforms,
    buffers: (&[f32], &[f32]),
    way: &Way,
    clear: bool,
) -> Arriving {
    let middle = Middle {
        across: if NEAR { 0 } else { middle(way.across) },
        up: if NEAR { 0 } else { middle(way.up) },
        drift: shift(u, xyz(u.light.direction), u.step.distance),
        outside: select(stays_on_texel(u), 0.0, 1.0),
    };
    let at = (way.x, way.y);
    let none = Arriving { flux: Vec3::new(0.0, 0.0, 0.0), concentration: 0.0 };
    // SAFETY: the caller's promise.
    unsafe {
        let below = add::<NEAR>(none, u, buffers, at, &middle, (-1, -1), clear);
        let below = add::<NEAR>(below, u, buffers, at, &middle, (0, -1), clear);
        let below = add::<NEAR>(below, u, buffers, at, &middle, (1, -1), clear);
        let beside = add::<NEAR>(below, u, buffers, at, &middle, (-1, 0), clear);
        let beside = add::<NEAR>(beside, u, buffers, at, &middle, (0, 0), clear);
        let beside = add::<NEAR>(beside, u, buffers, at, &middle, (1, 0), clear);
        let above = add::<NEAR>(beside, u, buffers, at, &middle, (-1, 1), clear);
        let above = add::<NEAR>(above, u, buffers, at, &middle, (0, 1), clear);
        add::<NEAR>(above, u, buffers, at, &middle, (1, 1), clear)
    }
}
