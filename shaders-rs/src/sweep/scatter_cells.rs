//! The light that refracted cells of the wavefront bring to the samples of a plane.
//!
//! A cell gives its light to the samples inside, by area; one too small for that, as in a focus, to the samples around it. A cell that is no convex
//! quadrilateral is two triangles. The thin light of cells that are stretched far goes to wide samples, of which there are sixteen times fewer.
//! [`super::cover_samples`] has found the samples of cells that have few. Cells that are less than half a sample from where unrefracted light is bring
//! nothing here: [`super::collect_light`] finds their light in their place.

use crate::abi::record::{course, cover, covered, sums};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::abi::wavefront::WIDE;
use crate::field::access::read;
use crate::field::sums::{Sums, add_both, quantise};
use crate::math::{absolute, floor_to_int, max, min};
use crate::sweep::light::bricks::{place, wide_place};
use crate::sweep::light::cell::{Cell, Corner, FAR, SMALLEST, cell, crossed};
use spirv_std::glam::{Vec2, Vec3};

/// The longest side of a shape's box that is scattered, in samples. The light of a longer one is so thin that it is hardly seen.
/// Besides, lavapipe ends the loops of eight invocations without a word after 65,535 rounds in all: 64 × 64 samples make 33,000.
const LONGEST: f32 = 64.0;
/// The longest side of the box of a cell, in samples, from which on it goes to wide samples, however narrow it is.
const LONG: f32 = 16.0;
/// The longest side of the box of a cell, in samples, from which on it goes to wide samples if it is wide, too.
const WIDE_FROM: f32 = 6.0;

/// Light, and the fluence times the difference of its direction.
#[derive(Clone, Copy)]
struct Brought {
    fluence: Vec3,
    aside: Vec2,
}

/// Light in units of the sums.
#[derive(Clone, Copy)]
struct Units {
    red: i32,
    green: i32,
    blue: i32,
    x: i32,
    y: i32,
}

/// The samples that light is brought to.
#[derive(Clone, Copy)]
struct Target {
    /// Whether they are the wide ones; places are then in wide samples.
    wide: bool,
    /// Edge of these samples, in samples.
    edge: f32,
}

/// A share of light in units.
#[inline(always)]
fn in_units(u: &SweepUniforms, light: &Brought, share: f32) -> Units {
    let (fluence, aside, units) = (light.fluence, light.aside, u.wavefront.units * share);
    Units {
        red: quantise(fluence.x, units),
        green: quantise(fluence.y, units),
        blue: quantise(fluence.z, units),
        x: quantise(aside.x, units),
        y: quantise(aside.y, units),
    }
}

/// Adds light to sample (i, j), if something looks there.
#[inline(always)]
fn add<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
    wide: bool,
    (i, j): (i32, i32),
    light: &Units,
) {
    let place = if wide { wide_place(&u.wavefront, i, j) } else { place(&u.wavefront, bricks, i, j) };
    if place >= 0 {
        let at = place * sums::SIZE as i32;
        let green = if mode::is_clear(chosen) { 0 } else { light.green };
        add_both(sums, at + sums::RED_AND_GREEN as i32, light.red, green);
        if !mode::is_clear(chosen) {
            add_both(sums, at + sums::BLUE as i32, light.blue, 0);
        }
        if u.specular > 0.0 {
            add_both(sums, at + sums::DIRECTION as i32, light.x, light.y);
        }
    }
}

/// Adds light to the four samples around a point.
#[inline(always)]
fn bring_around<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
    target: Target,
    at: Vec2,
    light: &Brought,
    share: f32,
) {
    let (i, j) = (floor_to_int(at.x, -FAR, FAR), floor_to_int(at.y, -FAR, FAR));
    let (x, y) = (at.x - i as f32, at.y - j as f32);
    let mut corner = 0;
    while corner < 4 {
        let (right, above) = (corner & 1, corner >> 1);
        let across = if right != 0 { x } else { 1.0 - x };
        let up = if above != 0 { y } else { 1.0 - y };
        let light = in_units(u, light, share * across * up / (target.edge * target.edge));
        add::<S>(u, chosen, (bricks, sums), target.wide, (i + right, j + above), &light);
        corner += 1;
    }
}

/// Adds light to the samples in the convex quadrilateral with these corners, one after the other around it; two of them may be the same.
#[inline(always)]
fn fill<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
    target: Target,
    corners: (Vec2, Vec2, Vec2, Vec2),
    light: &Brought,
    density: f32,
) {
    let light = in_units(u, light, density / (target.edge * target.edge));
    let (a, b, c, d) = corners;
    let low = min(min(a.y, b.y), min(c.y, d.y));
    let high = max(max(a.y, b.y), max(c.y, d.y));
    let mut j = floor_to_int(low, -FAR, FAR) + 1;
    let last = floor_to_int(high, -FAR, FAR);
    while j <= last {
        let y = j as f32;
        let range = crossed(a, b, y, (FAR, -FAR));
        let range = crossed(b, c, y, range);
        let range = crossed(c, d, y, range);
        let range = crossed(d, a, y, range);
        // A sample on an edge belongs to the shape on its right.
        let mut i = -floor_to_int(-range.0, -FAR, FAR);
        while (i as f32) < range.1 {
            add::<S>(u, chosen, (bricks, sums), target.wide, (i, j), &light);
            i += 1;
        }
        j += 1;
    }
}

/// Scatters the triangle between three nodes, which has half of a cell's light.
#[inline(always)]
fn triangle<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
    target: Target,
    (a, b, c): (&Corner, &Corner, &Corner),
) {
    let counts = |corner: &Corner| if corner.course == course::TURNED { 0.0 } else { 1.0 };
    let (in_a, in_b, in_c) = (counts(a), counts(b), counts(c));
    let followed = in_a + in_b + in_c;
    let fluence = a.fluence * in_a + b.fluence * in_b + c.fluence * in_c;
    let aside = a.fluence_aside() * in_a + b.fluence_aside() * in_b + c.fluence_aside() * in_c;
    let light = Brought { fluence: fluence * (1.0 / 6.0), aside: aside * (1.0 / 6.0) };
    let low = Vec2::new(min(min(a.at.x, b.at.x), c.at.x), min(min(a.at.y, b.at.y), c.at.y));
    let high = Vec2::new(max(max(a.at.x, b.at.x), c.at.x), max(max(a.at.y, b.at.y), c.at.y));
    let extent = max(high.x - low.x, high.y - low.y);
    let (ab, ac) = (b.at - a.at, c.at - a.at);
    let area = 0.5 * absolute(ab.x * ac.y - ab.y * ac.x);
    let whole = followed == 3.0;
    let longest = LONGEST / target.edge;
    if whole & (2.0 * area >= SMALLEST) & (extent <= longest) {
        fill::<S>(u, chosen, (bricks, sums), target, (a.at, b.at, c.at, c.at), &light, 1.0 / area);
    } else if whole & (extent > 2.0) & (extent <= longest) {
        // Long and thin: along the longest side.
        let (bc, size) = (c.at - b.at, |v: Vec2| absolute(v.x) + absolute(v.y));
        let from_b = size(bc) > max(size(ab), size(ac));
        let along = if from_b {
            bc
        } else if size(ab) > size(ac) {
            ab
        } else {
            ac
        };
        let from = if from_b { b.at } else { a.at };
        let count = floor_to_int(extent, 1.0, LONGEST) + 1;
        let step = 1.0 / count as f32;
        let mut part = 0;
        while part < count {
            let at = from + along * ((part as f32 + 0.5) * step);
            bring_around::<S>(u, chosen, (bricks, sums), target, at, &light, step);
            part += 1;
        }
    } else if (followed > 0.0) & (!whole | (extent <= 2.0)) {
        let sum = a.at * in_a + b.at * in_b + c.at * in_c;
        bring_around::<S>(u, chosen, (bricks, sums), target, sum * (1.0 / followed), &light, 1.0);
    }
}

/// The node with its place in samples that are `edge` samples wide.
#[inline(always)]
fn among(corner: &Corner, edge: f32) -> Corner {
    Corner { at: corner.at * (1.0 / edge), ..*corner }
}

/// Scatters a cell of which the samples inside are not known.
#[inline(always)]
fn scatter<S: Sums + ?Sized>(u: &SweepUniforms, chosen: u32, (bricks, sums): (&[u32], &mut S), cell: &Cell) {
    let (low, high) = cell.bounds();
    let extent = max(high.x - low.x, high.y - low.y);
    let wide = (extent > LONG) | ((extent > WIDE_FROM) & (cell.area() > 2.0 * extent));
    let edge = if wide { WIDE as f32 } else { 1.0 };
    let target = Target { wide, edge };
    let (a, b) = (among(&cell.a, edge), among(&cell.b, edge));
    let (c, d) = (among(&cell.c, edge), among(&cell.d, edge));
    let cell = Cell { a, b, c, d };
    if cell.is_convex() & (cell.area() >= SMALLEST) & (extent <= LONGEST) {
        let light = Brought { fluence: cell.fluence() * 0.25, aside: cell.fluence_aside() * 0.25 };
        fill::<S>(u, chosen, (bricks, sums), target, (a.at, b.at, d.at, c.at), &light, 1.0 / cell.area());
    } else {
        triangle::<S>(u, chosen, (bricks, sums), target, (&a, &b, &c));
        triangle::<S>(u, chosen, (bricks, sums), target, (&d, &b, &c));
    }
}

/// A component, which is a whole number, of record `at` out of `count`.
#[inline(always)]
fn whole(records: &[f32], count: i32, at: i32, component: usize) -> i32 {
    floor_to_int(read(records, component as i32 * count + at), -1_073_741_824.0, 1_073_741_824.0)
}

/// Scatters cell (x, y).
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    covered_in: &[f32],
    projected: &[f32],
    bricks: &[u32],
    sums: &mut S,
) {
    let w = &u.wavefront;
    let count = (w.cells.width * w.cells.height) as i32;
    let at = (y * w.cells.width + x) as i32;
    let samples = read(covered_in, covered::SAMPLES as i32 * count + at);
    if samples == cover::OTHERS {
        scatter::<S>(u, chosen, (bricks, sums), &cell(w, projected, x, y));
    } else if (samples != cover::NONE) & (samples < cover::OTHERS) {
        let light = Units {
            red: whole(covered_in, count, at, covered::FLUENCE),
            green: whole(covered_in, count, at, covered::FLUENCE + 1),
            blue: whole(covered_in, count, at, covered::FLUENCE + 2),
            x: whole(covered_in, count, at, covered::ASIDE_X),
            y: whole(covered_in, count, at, covered::ASIDE_Y),
        };
        let column = whole(covered_in, count, at, covered::COLUMN);
        let row = whole(covered_in, count, at, covered::ROW);
        let inside = floor_to_int(samples, 0.0, 15.0);
        let mut sample = 0;
        while sample < 4 {
            if (inside >> sample) & 1 != 0 {
                add::<S>(u, chosen, (bricks, sums), false, (column + (sample & 1), row + (sample >> 1)), &light);
            }
            sample += 1;
        }
    }
}
