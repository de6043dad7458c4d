//! Cells of the wavefront between four nodes, scattered onto texels of a receiver's map.
//!
//! A cell carries the light between its nodes wherever it is: stretched, folded, collapsed in a focus. It is cut into parts no wider than a
//! texel, each of which shares its flux among the texels under it by area. So flux is conserved whatever becomes of the cell, and any
//! number of cells may cross a texel.

use crate::abi::record::landed;
use crate::abi::sweep::SweepUniforms;
use crate::field::sums::{Sums, add, quantise};
use crate::math::{absolute, clamp, floor_to_int, lerp, max, min, sqrt};
use spirv_std::glam::{Vec2, Vec3};

/// The most parts of a cell; one that needs more has wider ones.
const MOST_PARTS: f32 = 128.0;
/// The narrowest part, in texels.
const NARROWEST: f32 = 1.0 / 1024.0;
/// The widest part, in texels. Lavapipe ends the loops of eight invocations without a word after 65,535 rounds in all: 128 parts of 6 · 6 texels
/// make 37,000.
const WIDEST: f32 = 5.0;
/// Farther than any texel.
const FAR: f32 = 65536.0;
/// The edge of the square whose variance along each axis is that of a disc of radius 1: √3.
const SQUARE: f32 = 1.732_050_8;
/// The shortest edge of the square over which soft light spreads on a receiver, in texels.
const SHORTEST: f32 = 1.0;
/// The most parts of a cell of soft light, and the longest of them, in texels.
const MOST_SOFT_PARTS: f32 = 24.0;
const WIDEST_SOFT: f32 = 8.0;

/// A corner of a cell, and the light there.
#[derive(Clone, Copy)]
pub struct Corner {
    /// Place in texels; centres of texels are whole numbers.
    pub at: Vec2,
    /// Flux over that of unoccluded light through a cell.
    pub flux: Vec3,
    /// Whether the light turned back.
    pub turned: bool,
}

/// The first of two corners whose light did not turn back; the second one if both did.
#[inline(always)]
fn either(first: &Corner, second: &Corner) -> Corner {
    if first.turned { *second } else { *first }
}

/// A corner, or where its light turned back the first of three others whose light did not.
#[inline(always)]
fn instead(corner: &Corner, first: &Corner, second: &Corner, third: &Corner) -> Corner {
    let others = either(first, &either(second, third));
    either(corner, &others)
}

/// A bilinear blend of four corners.
#[inline(always)]
fn blend(a: f32, b: f32, c: f32, d: f32, s: f32, t: f32) -> f32 {
    lerp(lerp(a, b, s), lerp(c, d, s), t)
}

/// The larger side of the box around a vector.
#[inline(always)]
fn extent(v: Vec2) -> f32 {
    max(absolute(v.x), absolute(v.y))
}

/// Into how many parts an edge is cut, for parts no longer than a texel.
#[inline(always)]
fn parts(length: f32) -> f32 {
    // A hair's breadth more than a texel need not be cut.
    (1 + floor_to_int(length - 1e-3, 0.0, MOST_PARTS - 1.0)) as f32
}

/// `count`, made smaller by `factor`, a whole number from 1 on.
#[inline(always)]
fn fewer(count: f32, factor: f32) -> i32 {
    floor_to_int(count * factor, 1.0, MOST_PARTS)
}

/// Part of the length from `low` to `low + width` that lies in texel `i`, as a share of the whole.
#[inline(always)]
fn share(i: i32, low: f32, width: f32) -> f32 {
    let start = max(low, i as f32 - 0.5);
    let end = min(low + width, i as f32 + 0.5);
    max(end - start, 0.0) / width
}

/// The box that stands for a parallelogram between two vectors: of the same area, so that the boxes of neighbouring ones lie side by side, as bricks do,
/// where those around parallelograms would overlap. As wide as the first vector is, or as high as the second one, whichever leans less.
#[inline(always)]
fn boxed(s: Vec2, t: Vec2) -> Vec2 {
    let area = absolute(s.x * t.y - s.y * t.x);
    let (width, height) = (absolute(s.x), absolute(t.y));
    let (most_x, most_y) = (width + absolute(t.x), height + absolute(s.y));
    let upright = absolute(t.x) * height <= absolute(s.y) * width;
    let high = min(area / max(width, NARROWEST * NARROWEST), most_y);
    let wide = min(area / max(height, NARROWEST * NARROWEST), most_x);
    if upright { Vec2::new(width, high) } else { Vec2::new(wide, height) }
}

/// The texels of a map across and up.
#[derive(Clone, Copy)]
pub struct Target {
    /// Columns.
    pub columns: i32,
    /// Rows.
    pub rows: i32,
}

/// Spreads the flux of a box over a square of edge `edge` around each of its points: its differences, whose sums over rows and columns
/// ([`crate::sweep::integrate_landed`]) are the flux.
#[inline(always)]
fn spread_softly<S: Sums + ?Sized>(sums: &mut S, target: Target, (centre, size): (Vec2, Vec2), edge: f32, flux: Vec3) {
    let density = flux * (1.0 / (edge * edge));
    let mut corner = 0;
    while corner < 4 {
        let (right, above) = ((corner & 1) as f32, (corner >> 1) as f32);
        let sign = (1.0 - 2.0 * right) * (1.0 - 2.0 * above);
        // A difference belongs half a texel behind the square's edge: to the first texel that lies behind it.
        let at = Vec2::new(centre.x + (right - 0.5) * edge + 0.5, centre.y + (above - 0.5) * edge + 0.5);
        // What begins before the first texel counts from there on.
        let at = Vec2::new(max(at.x, 0.5 * size.x - 0.5), max(at.y, 0.5 * size.y - 0.5));
        spread::<S>(sums, target, (at, size), density * sign);
        corner += 1;
    }
}

/// Spreads `flux` over a box.
#[inline(always)]
fn spread<S: Sums + ?Sized>(sums: &mut S, target: Target, (centre, size): (Vec2, Vec2), flux: Vec3) {
    let (width, height) = (size.x, size.y);
    let (left, below) = (centre.x - 0.5 * width, centre.y - 0.5 * height);
    let first_x = floor_to_int(left + 0.5, 0.0, FAR);
    let last_x = floor_to_int(left + width + 0.5, -1.0, (target.columns - 1) as f32);
    let last_y = floor_to_int(below + height + 0.5, -1.0, (target.rows - 1) as f32);
    let mut j = floor_to_int(below + 0.5, 0.0, FAR);
    while j <= last_y {
        let part_y = share(j, below, height);
        let mut i = first_x;
        while i <= last_x {
            let part = share(i, left, width) * part_y;
            if part > 0.0 {
                let at = (j * target.columns + i) * landed::SIZE as i32;
                add(sums, at, quantise(flux.x * part, landed::SCALE));
                add(sums, at + 2, quantise(flux.y * part, landed::SCALE));
                add(sums, at + 4, quantise(flux.z * part, landed::SCALE));
            }
            i += 1;
        }
        j += 1;
    }
}

#[inline(always)]
fn count(what: bool) -> f32 {
    if what { 1.0 } else { 0.0 }
}

/// Scatters the light between corners a, b, c and d (b beside a, c above a, d above b): onto the texels of a map. Soft light spreads over a disc of
/// radius `blur`, in texels, around each point, as differences.
#[inline(always)]
pub fn scatter<S: Sums + ?Sized>(
    u: &SweepUniforms,
    sums: &mut S,
    target: Target,
    (a, b, c, d): (&Corner, &Corner, &Corner, &Corner),
    blur: f32,
) {
    let followed = count(!a.turned) + count(!b.turned) + count(!c.turned) + count(!d.turned);
    if followed > 0.0 {
        // Where some of the light turned back, the rest goes on where its nodes are.
        let (left, right) = (either(a, c), either(b, d));
        let a = instead(a, b, &left, &right);
        let b = instead(b, &a, &right, &left);
        let c = instead(c, d, &left, &right);
        let d = instead(d, &c, &right, &left);
        let w = &u.wavefront;
        let soft = w.softness > 0.0;
        let edge = max(SQUARE * blur, SHORTEST);
        // What is spread over a square need not be cut finer than half of it, or than a cell.
        let wide = if soft { clamp(0.5 * edge, w.map.texels, WIDEST_SOFT) } else { 1.0 };
        let most = if soft { MOST_SOFT_PARTS } else { MOST_PARTS };
        let across = parts(max(extent(b.at - a.at), extent(d.at - c.at)) / wide);
        let up = parts(max(extent(c.at - a.at), extent(d.at - b.at)) / wide);
        let factor = sqrt(min(1.0, most / (across * up)));
        let (across, up) = (fewer(across, factor), fewer(up, factor));
        let (step_s, step_t) = (1.0 / across as f32, 1.0 / up as f32);
        let share = step_s * step_t * (followed * 0.25);
        let mut q = 0;
        while q < up {
            let t = (q as f32 + 0.5) * step_t;
            let along_s =
                Vec2::new(lerp(b.at.x - a.at.x, d.at.x - c.at.x, t), lerp(b.at.y - a.at.y, d.at.y - c.at.y, t));
            let mut p = 0;
            while p < across {
                let s = (p as f32 + 0.5) * step_s;
                let along_t =
                    Vec2::new(lerp(c.at.x - a.at.x, d.at.x - b.at.x, s), lerp(c.at.y - a.at.y, d.at.y - b.at.y, s));
                let size = boxed(along_s * step_s, along_t * step_t);
                let centre =
                    Vec2::new(blend(a.at.x, b.at.x, c.at.x, d.at.x, s, t), blend(a.at.y, b.at.y, c.at.y, d.at.y, s, t));
                let flux = Vec3::new(
                    blend(a.flux.x, b.flux.x, c.flux.x, d.flux.x, s, t) * share,
                    blend(a.flux.y, b.flux.y, c.flux.y, d.flux.y, s, t) * share,
                    blend(a.flux.z, b.flux.z, c.flux.z, d.flux.z, s, t) * share,
                );
                if soft {
                    let size = Vec2::new(clamp(size.x, 1.0, WIDEST_SOFT), clamp(size.y, 1.0, WIDEST_SOFT));
                    // Variances add up: the part has some of that of the disc.
                    let part = 0.5 * (size.x + size.y);
                    let square = max(3.0 * blur * blur - part * part, SHORTEST * SHORTEST);
                    spread_softly::<S>(sums, target, (centre, size), sqrt(square), flux);
                } else {
                    let size = Vec2::new(clamp(size.x, NARROWEST, WIDEST), clamp(size.y, NARROWEST, WIDEST));
                    spread::<S>(sums, target, (centre, size), flux);
                }
                p += 1;
            }
            q += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{parts, share};

    #[test]
    fn shares_of_a_length_make_the_whole() {
        for (low, width) in [(-0.5, 1.0), (0.2, 0.7), (3.49, 1.4), (2.0, 1.0 / 1024.0)] {
            let sum: f32 = (-2..8).map(|i| share(i, low, width)).sum();
            assert!((sum - 1.0).abs() < 1e-4, "{low} {width}: {sum}");
        }
    }

    #[test]
    fn edges_are_cut_into_parts_of_a_texel() {
        assert_eq!([0.0, 0.5, 1.0, 1.0005, 1.1, 2.5, 1e9].map(parts), [1.0, 1.0, 1.0, 1.0, 2.0, 3.0, 128.0]);
    }
}
