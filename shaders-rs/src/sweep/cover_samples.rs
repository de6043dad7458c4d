//! The samples inside each refracted cell of the wavefront, as long as a cell is so small that they are among four, and the light that it brings to each of
//! them.
//!
//! [`super::scatter_cells`] then only adds it up. Nearly all cells are such cells, and a processor finds the samples of many cells at once.

use crate::abi::record::{Covered, cover, covered as record};
use crate::abi::sweep::SweepUniforms;
use crate::abi::wavefront::{BRICK, Wavefront};
use crate::field::sums::quantise;
use crate::math::{floor_to_int, max, select, select_vector};
use crate::sweep::light::bricks::place;
use crate::sweep::light::cell::{FAR, SMALLEST, cell, crossed_by};
use spirv_std::glam::{Vec2, Vec3};

/// Whether something may look at samples between two places: surely if they are far apart.
#[inline(always)]
fn is_looked_at(w: &Wavefront, bricks: &[u32], low: Vec2, high: Vec2) -> bool {
    let (left, right) = (floor_to_int(low.x, -FAR, FAR), floor_to_int(high.x, -FAR, FAR) + 1);
    let (below, above) = (floor_to_int(low.y, -FAR, FAR), floor_to_int(high.y, -FAR, FAR) + 1);
    let near = (right - left <= BRICK as i32) & (above - below <= BRICK as i32);
    !near
        | (place(w, bricks, left, below) >= 0)
        | (place(w, bricks, right, below) >= 0)
        | (place(w, bricks, left, above) >= 0)
        | (place(w, bricks, right, above) >= 0)
}

/// The weight of a sample at `x` if it is in the range: one on an edge belongs to the shape on its right.
#[inline(always)]
fn weight(range: (f32, f32), x: f32, weight: f32) -> f32 {
    select((range.0 <= x) & (x < range.1), weight, 0.0)
}

/// Light in units of 1 / `scale`, a whole number.
#[inline(always)]
fn whole(light: f32, scale: f32) -> f32 {
    quantise(light, scale) as f32
}

/// How much of the kernel an invocation needs.
pub mod level {
    /// Nothing looks at the cell's light.
    pub const UNSEEN: u32 = 1;
    /// Nothing has bent it.
    pub const STRAIGHT: u32 = 3;
    /// The cell may bring light to any samples.
    pub const WORK: u32 = 7;
}

/// The level that cell (x, y) needs.
#[inline(always)]
pub fn level(x: u32, y: u32, u: &SweepUniforms, _mode: u32, projected: &[f32], bricks: &[u32]) -> u32 {
    let cell = cell(&u.wavefront, projected, x, y);
    let (low, high) = cell.bounds();
    let needed = if cell.is_straight() { level::STRAIGHT } else { level::WORK };
    if is_looked_at(&u.wavefront, bricks, low, high) { needed } else { level::UNSEEN }
}

/// The samples inside cell (x, y).
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    projected: &[f32],
    bricks: &[u32],
) -> [f32; record::SIZE] {
    if LEVEL == level::UNSEEN {
        return [cover::NONE; record::SIZE];
    }
    let w = &u.wavefront;
    let cell = cell(w, projected, x, y);
    let (low, high) = cell.bounds();
    let mut fluence = cell.fluence() * 0.25;
    let dark = max(max(fluence.x, fluence.y), fluence.z) <= 0.0;
    // A record is the same at all levels that are enough for it.
    let brings = !dark & is_looked_at(w, bricks, low, high);
    let nothing = Vec3::new(0.0, 0.0, 0.0);
    fluence = select_vector(brings, fluence, nothing);
    let aside = cell.fluence_aside() * 0.25;
    let aside = Vec2::new(select(brings, aside.x, 0.0), select(brings, aside.y, 0.0));
    let straight = cell.is_straight();
    // Exactly 1 where nothing bends light, whatever rounding makes of the area.
    let area = select(straight, 1.0, cell.area());
    let stays = straight | cell.stays(x, y);
    let density = 1.0 / max(area, SMALLEST);
    let mut covered = Covered {
        samples: select(brings & stays, cover::STAYS, cover::NONE),
        column: 0.0,
        row: 0.0,
        fluence: fluence * density,
        aside_x: aside.x * density,
        aside_y: aside.y * density,
    };
    if LEVEL == level::WORK {
        let (column, row) = (floor_to_int(low.x, -FAR, FAR) + 1, floor_to_int(low.y, -FAR, FAR) + 1);
        let few = (floor_to_int(high.x, -FAR, FAR) <= column + 1) & (floor_to_int(high.y, -FAR, FAR) <= row + 1);
        let few = few & cell.is_convex() & (area >= SMALLEST);
        let (left, right) = (column as f32, (column + 1) as f32);
        let (first, second) = (crossed_by(&cell, row as f32), crossed_by(&cell, (row + 1) as f32));
        let samples = (weight(first, left, cover::FIRST) + weight(first, right, cover::BESIDE))
            + (weight(second, left, cover::ABOVE) + weight(second, right, cover::ACROSS));
        let units = w.units * density;
        covered = Covered {
            samples: select(brings & !stays, select(few, samples, cover::OTHERS), covered.samples),
            column: select(brings & !stays, left, 0.0),
            row: select(brings & !stays, row as f32, 0.0),
            fluence: Vec3::new(
                select(stays, covered.fluence.x, whole(fluence.x, units)),
                select(stays, covered.fluence.y, whole(fluence.y, units)),
                select(stays, covered.fluence.z, whole(fluence.z, units)),
            ),
            aside_x: select(stays, covered.aside_x, whole(aside.x, units)),
            aside_y: select(stays, covered.aside_y, whole(aside.y, units)),
        };
    }
    covered.store()
}
