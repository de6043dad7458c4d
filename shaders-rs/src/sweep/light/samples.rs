//! The light at a sample of a plane: of the cell that unrefracted light would bring there, and of refracted cells.

use crate::abi::record::sums;
use crate::abi::sweep::{SweepUniforms, mode};
use crate::field::sums::sum;
use crate::math::{max, select, select_vector};
use crate::sweep::light::bricks::{place, sample};
use crate::sweep::light::offset::pack_difference;
use crate::sweep::light::wavefront::{flux, is_cell_straight};
use spirv_std::glam::Vec3;

/// Light around a sample.
#[derive(Clone, Copy)]
pub struct Sample {
    /// Fluence over that of unoccluded light.
    pub share: Vec3,
    /// The direction's difference from the direction of unrefracted light, as [`crate::sweep::light::offset`] packs it.
    pub direction: f32,
}

const UNOCCLUDED: Vec3 = Vec3::new(1.0, 1.0, 1.0);

/// Light of the cell in whose place sample (x, y) is, if nothing has refracted it.
#[inline(always)]
fn unrefracted(u: &SweepUniforms, nodes: &[f32], x: i32, y: i32, bends: bool) -> Vec3 {
    let w = &u.wavefront;
    let (columns, rows) = (w.cells.width as i32, w.cells.height as i32);
    if bends {
        let inside = (x >= 0) & (x < columns) & (y >= 0) & (y < rows);
        let (i, j) = if inside { (x as u32, y as u32) } else { (0, 0) };
        let mean = (flux(w, nodes, i, j) + flux(w, nodes, i + 1, j))
            + (flux(w, nodes, i, j + 1) + flux(w, nodes, i + 1, j + 1));
        let straight = is_cell_straight(w, nodes, i, j);
        let there = mean * select(straight, 0.25, 0.0);
        select_vector(inside, there, UNOCCLUDED)
    } else {
        let inside = (x >= 0) & (x <= columns) & (y >= 0) & (y <= rows);
        let (i, j) = if inside { (x as u32, y as u32) } else { (0, 0) };
        select_vector(inside, flux(w, nodes, i, j), UNOCCLUDED)
    }
}

/// The light at sample `index` of the bricks in the plane's list.
#[inline(always)]
pub fn light(u: &SweepUniforms, chosen: u32, sums_in: &[u32], nodes: &[f32], bricks: &[u32], index: u32) -> Sample {
    let w = &u.wavefront;
    let (x, y) = sample(w, bricks, index);
    let bends = mode::bends(chosen);
    let unrefracted = unrefracted(u, nodes, x, y, bends);
    if bends {
        let place = place(w, bricks, x, y);
        let base = place * sums::SIZE as i32;
        let counts = select(place >= 0, 1.0, 0.0);
        let change = |channel: usize, scale: f32| sum(sums_in, base + 2 * channel as i32) * (counts / scale);
        let brought = Vec3::new(
            change(sums::FLUX, sums::FLUX_SCALE),
            change(sums::FLUX + 1, sums::FLUX_SCALE),
            change(sums::FLUX + 2, sums::FLUX_SCALE),
        );
        let share = unrefracted + brought;
        let weight = (share.x + share.y + share.z) * (1.0 / 3.0);
        // Less than a few units of flux tell no direction.
        let inverse = select(weight > 1e-6, 1.0 / max(weight, 1e-6), 0.0);
        let across = change(sums::DIRECTION_X, sums::DIRECTION_SCALE) * inverse;
        let up = change(sums::DIRECTION_X + 1, sums::DIRECTION_SCALE) * inverse;
        Sample { share, direction: pack_difference(across, up) }
    } else {
        Sample { share: unrefracted, direction: pack_difference(0.0, 0.0) }
    }
}
