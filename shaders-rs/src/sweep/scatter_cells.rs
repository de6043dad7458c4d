//! The light that refracted cells of the wavefront bring to the samples of a plane.
//!
//! A cell between four nodes is two triangles. Each gives its light to the samples inside, by area; one too small for that, as in a focus, to the
//! samples around it. Cells that are less than half a sample from where unrefracted light is bring nothing here: [`super::collect_light`] finds their light
//! in their place.

use crate::abi::record::{course, sums};
use crate::abi::sweep::{SweepUniforms, mode};
use crate::abi::wavefront::{BRICK, Wavefront};
use crate::field::sums::{Sums, add, quantise};
use crate::math::{absolute, floor_to_int, max, min};
use crate::sweep::light::bricks::place;
use crate::sweep::light::cell::{Cell, Corner, cell, course_of};
use spirv_std::glam::{Vec2, Vec3};

/// Farther than any sample.
const FAR: f32 = 65536.0;
/// The least area of a triangle of which samples inside tell how much light it has, in samples.
const SMALLEST: f32 = 0.25;
/// The longest side of a triangle's box that is scattered, in samples. The light of a longer one is so thin that it is hardly seen. Besides, lavapipe ends the
/// loops of eight invocations without a word after 65,535 rounds in all: two triangles of 64 × 64 / 2 samples make 33,000.
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
    if (place >= 0) & (share > 0.0) {
        let at = place * sums::SIZE as i32;
        add(sums, at, quantise(light.fluence.x * share, sums::FLUX_SCALE));
        if !mode::is_clear(chosen) {
            add(sums, at + 2, quantise(light.fluence.y * share, sums::FLUX_SCALE));
            add(sums, at + 4, quantise(light.fluence.z * share, sums::FLUX_SCALE));
        }
        if u.specular > 0.0 {
            let channel = 2 * sums::DIRECTION_X as i32;
            add(sums, at + channel, quantise(light.aside.x * share, sums::DIRECTION_SCALE));
            add(sums, at + channel + 2, quantise(light.aside.y * share, sums::DIRECTION_SCALE));
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
    bring::<S>(u, chosen, (bricks, sums), (i, j), light, share * (1.0 - x) * (1.0 - y));
    bring::<S>(u, chosen, (bricks, sums), (i + 1, j), light, share * x * (1.0 - y));
    bring::<S>(u, chosen, (bricks, sums), (i, j + 1), light, share * (1.0 - x) * y);
    bring::<S>(u, chosen, (bricks, sums), (i + 1, j + 1), light, share * x * y);
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
    let of = |corner: &Corner, counted: f32| {
        corner.aside * ((corner.fluence.x + corner.fluence.y + corner.fluence.z) * (1.0 / 3.0) * counted)
    };
    let aside = of(a, in_a) + of(b, in_b) + of(c, in_c);
    let light = Brought { fluence: fluence * (1.0 / 6.0), aside: aside * (1.0 / 6.0) };
    let low = Vec2::new(min(min(a.at.x, b.at.x), c.at.x), min(min(a.at.y, b.at.y), c.at.y));
    let high = Vec2::new(max(max(a.at.x, b.at.x), c.at.x), max(max(a.at.y, b.at.y), c.at.y));
    let extent = max(high.x - low.x, high.y - low.y);
    let (ab, ac) = (b.at - a.at, c.at - a.at);
    let area = 0.5 * absolute(ab.x * ac.y - ab.y * ac.x);
    let whole = followed == 3.0;
    if whole & (area >= SMALLEST) & (extent <= LONGEST) {
        let density = 1.0 / area;
        let mut j = floor_to_int(low.y, -FAR, FAR) + 1;
        let last = floor_to_int(high.y, -FAR, FAR);
        while j <= last {
            let y = j as f32;
            let range = crossed(a.at, b.at, y, (FAR, -FAR));
            let range = crossed(b.at, c.at, y, range);
            let range = crossed(c.at, a.at, y, range);
            // A sample on an edge belongs to the triangle on its right.
            let mut i = -floor_to_int(-range.0, -FAR, FAR);
            while (i as f32) < range.1 {
                bring::<S>(u, chosen, (bricks, sums), (i, j), &light, density);
                i += 1;
            }
            j += 1;
        }
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
    let near = (right - left <= BRICK as i32) & (above - below <= BRICK as i32);
    let any = (place(w, bricks, left, below) >= 0)
        | (place(w, bricks, right, below) >= 0)
        | (place(w, bricks, left, above) >= 0)
        | (place(w, bricks, right, above) >= 0);
    any | !near
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
        let cell = cell(w, projected, x, y);
        let fluence = cell.fluence();
        let dark = max(max(fluence.x, fluence.y), fluence.z) <= 0.0;
        let Cell { a, b, c, d } = cell;
        let low =
            Vec2::new(min(min(a.at.x, b.at.x), min(c.at.x, d.at.x)), min(min(a.at.y, b.at.y), min(c.at.y, d.at.y)));
        let high =
            Vec2::new(max(max(a.at.x, b.at.x), max(c.at.x, d.at.x)), max(max(a.at.y, b.at.y), max(c.at.y, d.at.y)));
        if !dark & !cell.stays(x, y) & is_looked_at(w, bricks, low, high) {
            triangle::<S>(u, chosen, (bricks, sums), (&a, &b, &c));
            triangle::<S>(u, chosen, (bricks, sums), (&d, &b, &c));
        }
    }
}
