//! How a map from texels to texels stretches: its derivatives from differences between neighbouring texels.

use crate::abi::sweep::SweepUniforms;
use crate::field::access::{read, read_inside};
use crate::math::{absolute, min, select, sqrt};

/// The derivatives of the map p(x, y).
#[derive(Clone, Copy)]
pub struct Slopes {
    /// ∂p/∂x.
    pub along_x: (f32, f32),
    /// ∂p/∂y.
    pub along_y: (f32, f32),
}

/// The mean of two differences, limited to twice the smaller one and 0 where the signs differ: the mean where a map is
/// smooth, almost nothing where it jumps (van Leer's monotonised central limiter).
#[inline(always)]
pub fn limited(a: f32, b: f32) -> f32 {
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

/// A planar pair of components at the texel `across` columns from column `x`, in line `y`.
#[inline(always)]
fn pair<const INSIDE: bool>(
    u: &SweepUniforms,
    buffer: &[f32],
    first: usize,
    x: u32,
    across: i32,
    y: i32,
) -> (f32, f32) {
    let texels = (u.light_grid.width * u.light_grid.height) as i32;
    let base = first as i32 * texels + y * u.light_grid.width as i32 + across;
    if INSIDE {
        // SAFETY: the caller's promise.
        unsafe { (read_inside(buffer, base, x), read_inside(buffer, base + texels, x)) }
    } else {
        (read(buffer, base + x as i32), read(buffer, base + texels + x as i32))
    }
}

/// The slopes at texel (x, y) of the map to its own place plus `sign` times the components `first` and `first` + 1 of `buffer`.
///
/// Where refracted light meets unrefracted light the map jumps, and a difference across the jump is no derivative. So the
/// differences to both sides are limited; where the map is smooth they agree. At the grid's border a side is missing and counts
/// as undisturbed.
///
/// # Safety
/// If `INSIDE`, the row must have one below and one above, and the components lie inside the buffer.
#[inline(always)]
pub unsafe fn slopes<const INSIDE: bool>(
    u: &SweepUniforms,
    buffer: &[f32],
    first: usize,
    sign: f32,
    column: u32,
    line: u32,
) -> Slopes {
    let (x, y) = (column as i32, line as i32);
    let (cx, cy) = pair::<INSIDE>(u, buffer, first, column, 0, y);
    let (lx, ly) = pair::<INSIDE>(u, buffer, first, column, -1, y);
    let (rx, ry) = pair::<INSIDE>(u, buffer, first, column, 1, y);
    let (bx, by) = pair::<INSIDE>(u, buffer, first, column, 0, y - 1);
    let (ax, ay) = pair::<INSIDE>(u, buffer, first, column, 0, y + 1);
    let weight = |exists: bool| select(exists, sign, 0.0);
    let (left, right) = (weight(x > 0), weight(x < u.light_grid.width as i32 - 1));
    let (below, above) = (weight(INSIDE | (y > 0)), weight(INSIDE | (y < u.light_grid.height as i32 - 1)));
    Slopes {
        along_x: (1.0 + deviation((cx - lx) * left, (rx - cx) * right), limited((cy - ly) * left, (ry - cy) * right)),
        along_y: (limited((cx - bx) * below, (ax - cx) * above), 1.0 + deviation((cy - by) * below, (ay - cy) * above)),
    }
}

/// |∂p/∂x × ∂p/∂y|: the area that a texel's light comes from, in texels (Eq. 12).
#[inline(always)]
pub fn jacobian(s: &Slopes) -> f32 {
    absolute(s.along_x.0 * s.along_y.1 - s.along_x.1 * s.along_y.0)
}

/// Eq. 13, |∂p/∂x| · |∂p/∂y|: wrong by √(1 + s²) for a map with shear s.
#[inline(always)]
pub fn product_of_lengths(s: &Slopes) -> f32 {
    let x = s.along_x.0 * s.along_x.0 + s.along_x.1 * s.along_x.1;
    let y = s.along_y.0 * s.along_y.0 + s.along_y.1 * s.along_y.1;
    sqrt(x) * sqrt(y)
}
