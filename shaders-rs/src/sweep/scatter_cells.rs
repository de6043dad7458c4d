//! The light that refracted cells of the wavefront bring to the samples of a plane.
//!
//! A cell gives its light to the samples inside, by area; one too small for that, as in a focus, to the samples around it. A cell that is no convex
//! quadrilateral is two triangles. Cells that are less than half a sample from where unrefracted light is bring nothing here:
//! [`super::collect_light`] finds their light in their place.

use crate::abi::record::{course, sums};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::abi::wavefront::Wavefront;
use crate::field::sums::{Sums, add_both, quantise};
use crate::math::{absolute, floor_to_int, max, min};
use crate::sweep::light::bricks::place;
use crate::sweep::light::cell::{Cell, Corner, cell, course_of, place_of};
use spirv_std::glam::{Vec2, Vec3};

/// Farther than any sample.
const FAR: f32 = 65536.0;
/// The least area of a shape of which the samples inside tell how much light it has, in samples.
const SMALLEST: f32 = 0.25;
/// The longest side of a shape's box that is scattered, in samples. The light of a longer one is so thin that it is hardly seen. Besides, lavapipe ends the
/// loops of eight invocations without a word after 65,535 rounds in all: 64 × 64 samples make 33,000.
const LONGEST: f32 = 64.0;

/// Light, and the fluence times the difference of its direction.
#[derive(Clone, Copy)]
struct Brought {
    fluence: Vec3,
    aside: Vec2,
}

/// Adds a share of light to sample (i, j), if something looks there.
#[inline(always)]
fn bring<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
    (i, j): (i32, i32),
    light: &Brought,
    share: f32,
) {
    let place = place(&u.wavefront, bricks, i, j);
    let units = u.wavefront.units * share;
    if (place >= 0) & (units > 0.0) {
        let at = place * sums::SIZE as i32;
        let red = quantise(light.fluence.x, units);
        let green = if mode::is_clear(chosen) { 0 } else { quantise(light.fluence.y, units) };
        add_both(sums, at + sums::RED_AND_GREEN as i32, red, green);
        if !mode::is_clear(chosen) {
            add_both(sums, at + sums::BLUE as i32, quantise(light.fluence.z, units), 0);
        }
        if u.specular > 0.0 {
            let (x, y) = (quantise(light.aside.x, units), quantise(light.aside.y, units));
            add_both(sums, at + sums::DIRECTION as i32, x, y);
        }
    }
}

/// Adds light to the four samples around a point.
#[inline(always)]
fn bring_around<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
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
        bring::<S>(u, chosen, (bricks, sums), (i + right, j + above), light, share * across * up);
        corner += 1;
    }
}

/// Where an edge crosses the line at height `y`: widens the range of places on that line.
#[inline(always)]
fn crossed(p: Vec2, q: Vec2, y: f32, range: (f32, f32)) -> (f32, f32) {
    if (p.y <= y) != (q.y <= y) {
        let x = p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y));
        (min(range.0, x), max(range.1, x))
    } else {
        range
    }
}

/// Adds light to the samples in the convex quadrilateral with these corners, one after the other around it; two of them may be the same.
#[inline(always)]
fn fill<S: Sums + ?Sized>(
    u: &SweepUniforms,
    chosen: u32,
    (bricks, sums): (&[u32], &mut S),
    corners: (Vec2, Vec2, Vec2, Vec2),
    light: &Brought,
    density: f32,
) {
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
            bring::<S>(u, chosen, (bricks, sums), (i, j), light, density);
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
    if whole & (area >= SMALLEST) & (extent <= LONGEST) {
        fill::<S>(u, chosen, (bricks, sums), (a.at, b.at, c.at, c.at), &light, 1.0 / area);
    } else if whole & (extent > 2.0) & (extent <= LONGEST) {
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
            bring_around::<S>(u, chosen, (bricks, sums), at, &light, step);
            part += 1;
        }
    } else if (followed > 0.0) & (!whole | (extent <= 2.0)) {
        let sum = a.at * in_a + b.at * in_b + c.at * in_c;
        bring_around::<S>(u, chosen, (bricks, sums), sum * (1.0 / followed), &light, 1.0);
    }
}

/// Whether something may look at samples between two places: surely if they are far apart.
#[inline(always)]
fn is_looked_at(w: &Wavefront, bricks: &[u32], low: Vec2, high: Vec2) -> bool {
    let (left, right) = (floor_to_int(low.x, -FAR, FAR), floor_to_int(high.x, -FAR, FAR) + 1);
    let (below, above) = (floor_to_int(low.y, -FAR, FAR), floor_to_int(high.y, -FAR, FAR) + 1);
    let together = (left >> 3 == right >> 3) & (below >> 3 == above >> 3);
    let near = (right - left <= 8) & (above - below <= 8);
    if together {
        place(w, bricks, left, below) >= 0
    } else {
        !near
            | (place(w, bricks, left, below) >= 0)
            | (place(w, bricks, right, below) >= 0)
            | (place(w, bricks, left, above) >= 0)
            | (place(w, bricks, right, above) >= 0)
    }
}

/// Scatters cell (x, y).
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    projected: &[f32],
    bricks: &[u32],
    sums: &mut S,
) {
    let w = &u.wavefront;
    let courses = (course_of(w, projected, x, y) + course_of(w, projected, x + 1, y))
        + (course_of(w, projected, x, y + 1) + course_of(w, projected, x + 1, y + 1));
    if courses > 0.0 {
        let (a, b) = (place_of(w, projected, x, y), place_of(w, projected, x + 1, y));
        let (c, d) = (place_of(w, projected, x, y + 1), place_of(w, projected, x + 1, y + 1));
        let low = Vec2::new(min(min(a.x, b.x), min(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y)));
        let high = Vec2::new(max(max(a.x, b.x), max(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)));
        if is_looked_at(w, bricks, low, high) {
            let cell = cell(w, projected, x, y);
            let fluence = cell.fluence();
            let dark = max(max(fluence.x, fluence.y), fluence.z) <= 0.0;
            let extent = max(high.x - low.x, high.y - low.y);
            if dark | cell.stays(x, y) {
                // Nothing to bring.
            } else if cell.is_convex() & (cell.area() >= 2.0 * SMALLEST) & (extent <= LONGEST) {
                let light = Brought { fluence: fluence * 0.25, aside: cell.fluence_aside() * 0.25 };
                fill::<S>(u, chosen, (bricks, sums), (a, b, d, c), &light, 1.0 / cell.area());
            } else {
                let Cell { a, b, c, d } = cell;
                triangle::<S>(u, chosen, (bricks, sums), (&a, &b, &c));
                triangle::<S>(u, chosen, (bricks, sums), (&d, &b, &c));
            }
        }
    }
}
