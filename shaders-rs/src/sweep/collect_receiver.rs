//! The light on the texels of a receiver's map.

use crate::abi::record::{Received, landed, received};
use crate::abi::sweep::SweepUniforms;
use crate::field::sums::sum;
use crate::math::{floor_to_int, max, select, select_vector};
use crate::sweep::light::placed::{cone_of, density};
use crate::sweep::light::receiver_map::texel;
use crate::sweep::light::wavefront::{flux, is_cell_straight};
use spirv_std::glam::Vec3;

/// The light on texel (x, y): of the cell that unrefracted light brings there, and of refracted cells. Of the light of a point or spot its difference from
/// unoccluded light, which falls too fast, and ends at the edge of a cone, for texels.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32, landed: &[u32], nodes: &[f32]) -> [f32; received::SIZE] {
    let w = &u.wavefront;
    let (at, area) = texel(w, x, y);
    let (columns, rows) = (w.cells.width as i32 as f32, w.cells.height as i32 as f32);
    let inside = (at.x >= 0.0) & (at.x <= columns) & (at.y >= 0.0) & (at.y <= rows);
    let (i, j) = (floor_to_int(at.x, 0.0, columns - 1.0), floor_to_int(at.y, 0.0, rows - 1.0));
    let (s, t) = (at.x - i as f32, at.y - j as f32);
    let (i, j) = (i as u32, j as u32);
    let below = flux(w, nodes, i, j) * (1.0 - s) + flux(w, nodes, i + 1, j) * s;
    let above = flux(w, nodes, i, j + 1) * (1.0 - s) + flux(w, nodes, i + 1, j + 1) * s;
    let there = (below * (1.0 - t) + above * t) * select(is_cell_straight(w, nodes, i, j), 1.0, 0.0);
    // Of soft light all that was lost is among the sums.
    let crisp = w.softness == 0.0;
    let cone = cone_of(w, at.x, at.y);
    let unrefracted = select_vector(inside & crisp, there, Vec3::new(1.0, 1.0, 1.0)) * cone;
    let base = ((y * u.dispatch.width + x) * landed::SIZE as u32) as i32;
    let inverse = 1.0 / (area * landed::SCALE * density(w, at.x, at.y));
    let brought = Vec3::new(sum(landed, base), sum(landed, base + 2), sum(landed, base + 4)) * inverse;
    let share = unrefracted + brought;
    // Rounding must not leave a texel darker than black.
    let share = Vec3::new(max(share.x, 0.0), max(share.y, 0.0), max(share.z, 0.0));
    let open = select(w.spherical != 0, cone, 0.0);
    Received { share: share - Vec3::new(open, open, open) }.store()
}
