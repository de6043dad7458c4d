//! What a sheet brings to the texels of a plane, and what it takes from them.
//!
//! A cell between four nodes carries the light of one texel of the first plane, wherever it is: stretched, folded, collapsed in a
//! focus. It is cut into parts no wider than a texel, each of which shares its flux among the texels under it by area. So flux
//! is conserved whatever becomes of the cell, and any number of cells may cross a texel.
//!
//! A cell that nothing has bent or dimmed adds nothing. The others take their light, and its slope, from where it would have been.

use crate::abi::record::{sheet, sums};
use crate::abi::sweep::SweepUniforms;
use crate::field::access::read;
use crate::field::sums::{Sums, add, quantise};
use crate::math::{absolute, clamp, floor_to_int, lerp, max, min, select, sqrt};
use crate::sweep::light::sheet::{rows, source};
use spirv_std::glam::{Vec2, Vec3};

/// The most parts of a cell; one that needs more has wider ones.
const MOST_PARTS: f32 = 64.0;
/// The narrowest part, in texels.
const NARROWEST: f32 = 1.0 / 1024.0;
/// The widest part, in texels. A cell stretched over more than a thousand texels leaves gaps between its parts: its light is so
/// thin that it is hardly seen, and a few such cells would take most of the time. Besides, lavapipe ends the loops of eight
/// invocations without a word after 65,535 rounds in all: 64 parts of 5 · 5 texels make 15,000.
const WIDEST: f32 = 4.0;
/// Farther than any texel.
const FAR: f32 = 65536.0;

/// A node: where it is, in texels relative to the grid, and what it carries.
#[derive(Clone, Copy)]
struct Node {
    at: Vec2,
    unrefracted: Vec2,
    slope: Vec2,
    flux: Vec3,
    turned: bool,
}

/// The slope of a direction against the depth axis.
#[inline(always)]
fn slope(x: f32, y: f32, z: f32) -> Vec2 {
    let inverse = 1.0 / max(z, 1e-6);
    Vec2::new(x * inverse, y * inverse)
}

#[inline(always)]
fn node(u: &SweepUniforms, sheets: &[f32], x: u32, y: u32, row: u32) -> Node {
    let count = (u.light_grid.width + 1) * rows(u) * sheet_count(u);
    let index = row * (u.light_grid.width + 1) + x;
    let component = |c: usize| read(sheets, (c as u32 * count + index) as i32);
    let pair = |x: usize, y: usize| Vec2::new(component(x), component(y));
    let corner = Vec2::new(x as i32 as f32 - 0.5, y as i32 as f32 - 0.5);
    let v = |axis: usize| component(sheet::DIRECTION + axis);
    Node {
        at: corner + pair(sheet::DISPLACEMENT_X, sheet::DISPLACEMENT_Y),
        unrefracted: corner + pair(sheet::UNREFRACTED_X, sheet::UNREFRACTED_Y),
        slope: slope(v(0), v(1), v(2)),
        flux: Vec3::new(component(sheet::FLUX), component(sheet::FLUX + 1), component(sheet::FLUX + 2)),
        turned: component(sheet::TURNED) != 0.0,
    }
}

/// Sheets that the dispatch is over.
#[inline(always)]
fn sheet_count(u: &SweepUniforms) -> u32 {
    u.dispatch.height / u.light_grid.height
}

/// Whether nothing has happened to a node.
#[inline(always)]
fn is_undisturbed(u: &SweepUniforms, n: &Node) -> bool {
    let whole = u.sheet_share;
    (n.at.x == n.unrefracted.x)
        & (n.at.y == n.unrefracted.y)
        & (n.flux.x == whole)
        & (n.flux.y == whole)
        & (n.flux.z == whole)
}

#[inline(always)]
fn count(what: bool) -> f32 {
    select(what, 1.0, 0.0)
}

/// The first of two nodes that did not turn back; the second if both did.
#[inline(always)]
fn either(first: &Node, second: &Node) -> Node {
    if first.turned { *second } else { *first }
}

/// A node, or where it turned back the first of three others that did not.
#[inline(always)]
fn instead(node: &Node, first: &Node, second: &Node, third: &Node) -> Node {
    let others = either(first, &either(second, third));
    either(node, &others)
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

/// Spreads `flux`, and its change of slope, over a box.
#[inline(always)]
fn spread<S: Sums + ?Sized>(u: &SweepUniforms, sums: &mut S, centre: Vec2, size: Vec2, flux: Vec3, change: Vec2) {
    let (columns, lines) = (u.light_grid.width as i32, u.light_grid.height as i32);
    let (width, height) = (clamp(size.x, NARROWEST, WIDEST), clamp(size.y, NARROWEST, WIDEST));
    let (left, below) = (centre.x - 0.5 * width, centre.y - 0.5 * height);
    let weight = (flux.x + flux.y + flux.z) * (1.0 / 3.0);
    let first_x = floor_to_int(left + 0.5, 0.0, FAR);
    let last_x = floor_to_int(left + width + 0.5, -1.0, (columns - 1) as f32);
    let last_y = floor_to_int(below + height + 0.5, -1.0, (lines - 1) as f32);
    let mut j = floor_to_int(below + 0.5, 0.0, FAR);
    while j <= last_y {
        let part_y = share(j, below, height);
        let mut i = first_x;
        while i <= last_x {
            let part = share(i, left, width) * part_y;
            if part > 0.0 {
                let at = (j * columns + i) * sums::SIZE as i32;
                add(sums, at + 2 * sums::FLUX as i32, quantise(flux.x * part, sums::FLUX_SCALE));
                add(sums, at + 2 * (sums::FLUX as i32 + 1), quantise(flux.y * part, sums::FLUX_SCALE));
                add(sums, at + 2 * (sums::FLUX as i32 + 2), quantise(flux.z * part, sums::FLUX_SCALE));
                add(sums, at + 2 * sums::SLOPE_X as i32, quantise(weight * part * change.x, sums::SLOPE_SCALE));
                add(sums, at + 2 * (sums::SLOPE_X as i32 + 1), quantise(weight * part * change.y, sums::SLOPE_SCALE));
            }
            i += 1;
        }
        j += 1;
    }
}

/// Scatters cell (x, y mod texel rows) of sheet y / texel rows.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    sheets: &[f32],
    sources: &[f32],
    sums: &mut S,
) {
    let number = y / u.light_grid.height;
    let line = y - number * u.light_grid.height;
    let row = number * rows(u) + line;
    let a = node(u, sheets, x, line, row);
    let b = node(u, sheets, x + 1, line, row);
    let c = node(u, sheets, x, line + 1, row + 1);
    let d = node(u, sheets, x + 1, line + 1, row + 1);
    let disturbed = !(is_undisturbed(u, &a) & is_undisturbed(u, &b) & is_undisturbed(u, &c) & is_undisturbed(u, &d));
    let start = slope(u.light.direction.x, u.light.direction.y, u.light.direction.z);
    if disturbed {
        let whole = u.sheet_share;
        let home = (a.unrefracted + b.unrefracted + c.unrefracted + d.unrefracted) * 0.25;
        let v = source(u, sources, row);
        let taken = Vec3::new(-whole, -whole, -whole);
        spread(u, sums, home, Vec2::new(1.0, 1.0), taken, slope(v.x, v.y, v.z) - start);
    }
    let followed = count(!a.turned) + count(!b.turned) + count(!c.turned) + count(!d.turned);
    if disturbed & (followed > 0.0) {
        // Where some of the light turned back, the rest goes on where its nodes are.
        let (left, right) = (either(&a, &c), either(&b, &d));
        let a = instead(&a, &b, &left, &right);
        let b = instead(&b, &a, &right, &left);
        let c = instead(&c, &d, &left, &right);
        let d = instead(&d, &c, &right, &left);
        let across = parts(max(extent(b.at - a.at), extent(d.at - c.at)));
        let up = parts(max(extent(c.at - a.at), extent(d.at - b.at)));
        let factor = sqrt(min(1.0, MOST_PARTS / (across * up)));
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
                let size = Vec2::new(
                    absolute(along_s.x) * step_s + absolute(along_t.x) * step_t,
                    absolute(along_s.y) * step_s + absolute(along_t.y) * step_t,
                );
                let centre =
                    Vec2::new(blend(a.at.x, b.at.x, c.at.x, d.at.x, s, t), blend(a.at.y, b.at.y, c.at.y, d.at.y, s, t));
                let flux = Vec3::new(
                    blend(a.flux.x, b.flux.x, c.flux.x, d.flux.x, s, t) * share,
                    blend(a.flux.y, b.flux.y, c.flux.y, d.flux.y, s, t) * share,
                    blend(a.flux.z, b.flux.z, c.flux.z, d.flux.z, s, t) * share,
                );
                let slope = Vec2::new(
                    blend(a.slope.x, b.slope.x, c.slope.x, d.slope.x, s, t),
                    blend(a.slope.y, b.slope.y, c.slope.y, d.slope.y, s, t),
                );
                spread(u, sums, centre, size, flux, slope - start);
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
        assert_eq!([0.0, 0.5, 1.0, 1.0005, 1.1, 2.5, 1e9].map(parts), [1.0, 1.0, 1.0, 1.0, 2.0, 3.0, 64.0]);
    }
}
