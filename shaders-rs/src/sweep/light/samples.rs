//! The light at a sample of a plane: of the cell in whose place it is, and of cells that were scattered.

use crate::abi::record::sums;
use crate::abi::sweep::{SweepUniforms, mode};
use crate::field::sums::both;
use crate::math::{max, select, select_vector};
use crate::sweep::light::bricks::{place, sample};
use crate::sweep::light::cell::cell;
use crate::sweep::light::offset::pack_difference;
use crate::sweep::light::wavefront::flux;
use spirv_std::glam::{Vec2, Vec3};

/// Light around a sample.
#[derive(Clone, Copy)]
pub struct Sample {
    /// Fluence over that of unoccluded light.
    pub share: Vec3,
    /// The direction's difference from the direction of unrefracted light, as [`crate::sweep::light::offset`] packs it.
    pub direction: f32,
}

/// Where light is unoccluded.
const UNOCCLUDED: Vec3 = Vec3::new(1.0, 1.0, 1.0);

#[inline(always)]
fn mean(color: Vec3) -> f32 {
    (color.x + color.y + color.z) * (1.0 / 3.0)
}

/// Light of the cell in whose place sample (x, y) is, if it stays there, and the fluence times the difference of its direction.
#[inline(always)]
fn of_cell(u: &SweepUniforms, projected: &[f32], x: i32, y: i32) -> (Vec3, Vec2) {
    let w = &u.wavefront;
    let inside = (x >= 0) & (x < w.cells.width as i32) & (y >= 0) & (y < w.cells.height as i32);
    let (i, j) = if inside { (x as u32, y as u32) } else { (0, 0) };
    let cell = cell(w, projected, i, j);
    // Exactly 1 where nothing bends light, whatever rounding makes of the area.
    let area = select(cell.is_straight(), 1.0, max(cell.area(), 0.25));
    let counts = select(cell.stays(i, j), 0.25 / area, 0.0);
    let open = select(inside, counts, 0.0);
    (select_vector(inside, cell.fluence() * counts, UNOCCLUDED), cell.fluence_aside() * open)
}

/// Light of the node in whose place sample (x, y) is, where nothing bends it.
#[inline(always)]
fn of_node(u: &SweepUniforms, nodes: &[f32], x: i32, y: i32) -> Vec3 {
    let w = &u.wavefront;
    let inside = (x >= 0) & (x <= w.cells.width as i32) & (y >= 0) & (y <= w.cells.height as i32);
    let (i, j) = if inside { (x as u32, y as u32) } else { (0, 0) };
    select_vector(inside, flux(w, nodes, i, j), UNOCCLUDED)
}

/// The light at sample `index` of the bricks in the plane's list. `nodes` are the wavefront's where nothing bends it, else the projected ones.
#[inline(always)]
pub fn light(u: &SweepUniforms, chosen: u32, sums_in: &[u32], nodes: &[f32], bricks: &[u32], index: u32) -> Sample {
    let w = &u.wavefront;
    let (x, y) = sample(w, bricks, index);
    if mode::bends(chosen) {
        let (there, its_aside) = of_cell(u, nodes, x, y);
        let place = place(w, bricks, x, y);
        let base = place * sums::SIZE as i32;
        let unit = select(place >= 0, 1.0, 0.0) / w.units;
        let (red, green) = both(sums_in, base + sums::RED_AND_GREEN as i32);
        let (x, y) = both(sums_in, base + sums::DIRECTION as i32);
        let brought = if mode::is_clear(chosen) {
            Vec3::new(red, red, red)
        } else {
            Vec3::new(red, green, both(sums_in, base + sums::BLUE as i32).0)
        };
        let share = there + brought * unit;
        let weight = mean(share);
        // Less than a few units of light tell no direction.
        let inverse = select(weight > 1e-4, 1.0 / max(weight, 1e-4), 0.0);
        let across = (its_aside.x + x * unit) * inverse;
        let up = (its_aside.y + y * unit) * inverse;
        Sample { share, direction: pack_difference(across, up) }
    } else {
        Sample { share: of_node(u, nodes, x, y), direction: pack_difference(0.0, 0.0) }
    }
}
