//! Light gathered from the plane behind: a bilinear look-up where it comes from, and its intensity correction (sweep §4.2,
//! Eqs. 11 to 13, Algorithm 1, lines 9 to 13).

use crate::abi::record::{light as record, trace as traced};
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::access::{read, read_inside};
use crate::field::light::{holds, light_of_texel};
use crate::field::light_around::{Way, is_inner_row, is_near, light_around};
use crate::math::{absolute, min, select, sqrt};

/// How much of the kernel an invocation needs.
pub mod level {
    /// The light stays on its texel.
    pub const STILL: u32 = 1;
    /// It comes from less than a texel away.
    pub const NEAR: u32 = 3;
    /// It comes from anywhere, or the texel lies on the grid's border.
    pub const FAR: u32 = 7;
}

/// The way back, in texels, from the texel `across` columns from column `x`, in line `y`.
#[inline(always)]
fn back<const INSIDE: bool>(u: &SweepUniforms, trace: &[f32], x: u32, across: i32, y: i32) -> (f32, f32) {
    let base = y * u.size.z as i32 + across;
    let texels = (u.size.z * u.size.w) as i32;
    let (across, up) = if INSIDE {
        // SAFETY: `level` found the grid inside the buffer, and the texel on a row with neighbours.
        unsafe { (read_inside(trace, base, x), read_inside(trace, texels + base, x)) }
    } else {
        (read(trace, base + x as i32), read(trace, texels + base + x as i32))
    };
    (-across, -up)
}

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level(x: u32, y: u32, u: &SweepUniforms, _mode: u32, behind: &[f32], trace: &[f32]) -> u32 {
    if !(holds(u, behind, record::SIZE) & holds(u, trace, traced::SIZE)) {
        return level::FAR;
    }
    let (across, up) = back::<true>(u, trace, x, 0, y as i32);
    let still = (across == 0.0) & (up == 0.0) & is_inner_row(u, y);
    let moving = if is_near(u, &Way { x, y, across, up }) { level::NEAR } else { level::FAR };
    if still { level::STILL } else { moving }
}

/// The mean of two differences, limited to twice the smaller one and 0 where the signs differ: the mean where a map is
/// smooth, almost nothing where it jumps (van Leer's monotonised central limiter).
#[inline(always)]
fn limited(a: f32, b: f32) -> f32 {
    let mean = 0.5 * (a + b);
    let most = 2.0 * min(absolute(a), absolute(b));
    let size = min(absolute(mean), most);
    select(a * b > 0.0, select(mean < 0.0, -size, size), 0.0)
}

/// A derivative's deviation from no refraction, from the differences to both sides: limited where it makes light brighter.
#[inline(always)]
fn deviation(a: f32, b: f32) -> f32 {
    let mean = 0.5 * (a + b);
    select(mean > 0.0, limited(a, b), mean)
}

/// Eq. 12 with S from the neighbours' back-traced points: how much denser the light is here than where it comes from.
///
/// Where refracted light meets unrefracted light the back trace jumps, and a difference across the jump is no derivative: it
/// would multiply the light anew on every plane. So the differences to both sides are limited; where the map is smooth they
/// agree.
#[inline(always)]
fn intensity<const INSIDE: bool>(u: &SweepUniforms, trace: &[f32], column: u32, line: u32) -> f32 {
    let (x, y) = (column as i32, line as i32);
    let (cx, cy) = back::<INSIDE>(u, trace, column, 0, y);
    let (lx, ly) = back::<INSIDE>(u, trace, column, -1, y);
    let (rx, ry) = back::<INSIDE>(u, trace, column, 1, y);
    let (bx, by) = back::<INSIDE>(u, trace, column, 0, y - 1);
    let (ax, ay) = back::<INSIDE>(u, trace, column, 0, y + 1);
    // Beyond the grid's border light is undisturbed.
    let (left, right) = (x > 0, x < u.size.z as i32 - 1);
    let (below, above) = (INSIDE | (y > 0), INSIDE | (y < u.size.w as i32 - 1));
    let change = |exists: bool, from: f32, to: f32| (to - from) * select(exists, 1.0, 0.0);
    let dx_x = 1.0 + deviation(change(left, lx, cx), change(right, cx, rx));
    let dx_y = limited(change(left, ly, cy), change(right, cy, ry));
    let dy_x = limited(change(below, bx, cx), change(above, cx, ax));
    let dy_y = 1.0 + deviation(change(below, by, cy), change(above, cy, ay));
    let jacobian = absolute(dx_x * dy_y - dx_y * dy_x);
    // Eq. 13: wrong by √(1 + s²) for a sheared map.
    let paper = sqrt(dx_x * dx_x + dx_y * dx_y) * sqrt(dy_x * dy_x + dy_y * dy_y);
    let flags = u.dispatch.w;
    select(flags & flag::NO_INTENSITY != 0, 1.0, select(flags & flag::PAPER_INTENSITY != 0, paper, jacobian))
}

/// The light that arrives at texel (x, y) of this plane.
///
/// What is stored is the irradiance E = L cos θ of the plane. Flux through the plane, E dS, is then conserved by the factor of
/// areas alone (Eqs. 11 and 12).
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    behind: &[f32],
    trace: &[f32],
) -> [f32; record::SIZE] {
    let (arriving, denser) = if LEVEL == level::STILL {
        // SAFETY: `level` found the grid inside the buffer.
        (unsafe { light_of_texel(u, behind, x, y) }, intensity::<true>(u, trace, x, y))
    } else if LEVEL == level::NEAR {
        let (across, up) = back::<true>(u, trace, x, 0, y as i32);
        // SAFETY: `level` found this texel's look-up near, and the grid inside the buffer.
        let light = unsafe { light_around::<true>(u, behind, &Way { x, y, across, up }) };
        (light, intensity::<true>(u, trace, x, y))
    } else {
        let (across, up) = back::<false>(u, trace, x, 0, y as i32);
        // SAFETY: not near, nothing to promise.
        let light = unsafe { light_around::<false>(u, behind, &Way { x, y, across, up }) };
        (light, intensity::<false>(u, trace, x, y))
    };
    let flux = arriving.flux * denser;
    let v = arriving.direction;
    [flux.x, flux.y, flux.z, v.x, v.y, v.z]
}
