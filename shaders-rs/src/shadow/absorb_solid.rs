//! Absorption of clear bodies in the shadow map: absorption coefficient times the length of the column in each voxel that is inside, as an
//! optical depth (not in Chang et al. 2010, §3, which counts triangles alone).

use crate::abi::record::absorption;
use crate::abi::shadow::ShadowUniforms;
use crate::field::access::read;
use crate::field::sums::{Sums, add, quantise};
use crate::math::{floor_to_int, min};
use crate::shadow::spread::stretch;

/// Does row y · width + x. `changes` has by how much the body's winding changes from voxel to voxel, in units (see
/// [`crate::voxelize::cross_columns`]). A row whose winding does not end at 0 goes through a hole of the surface, which does not say
/// what is inside there: nothing is.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(x: u32, y: u32, u: &ShadowUniforms, _mode: u32, changes: &[u32], depths: &mut S) {
    let row = y * u.dispatch.width + x;
    if row < u.work {
        let length = u.width as i32;
        let base = row as i32 * (length + 1);
        let mut total = 0u32;
        let mut i = 0;
        while i <= length {
            total = total.wrapping_add(read(changes, base + i));
            i += 1;
        }
        if total == 0 {
            let (rows, line) = (u.height as i32 as f32, row as i32 as f32);
            // A half keeps the quotient away from whole numbers.
            let layer = floor_to_int((line + 0.5) / rows, 0.0, u.layers as i32 as f32);
            let y = row as i32 - layer * u.height as i32;
            let z = layer + u.first_layer as i32;
            let length_of_voxel = stretch(&u.spread, y as f32 + 0.5, z as f32 + 0.5);
            let part = 1.0 / (1u32 << u.winding_units) as f32;
            let channels = u.channels as i32;
            let mut winding = 0u32;
            let mut voxel = 0;
            while voxel < length {
                winding = winding.wrapping_add(read(changes, base + voxel));
                let signed = winding as i32;
                if signed != 0 {
                    let size = if signed < 0 { -signed } else { signed };
                    let inside = min(size as f32 * part, 1.0) * length_of_voxel;
                    let at = (row as i32 * length + voxel) * channels * absorption::SIZE as i32;
                    add(depths, at, quantise(u.absorption.x * inside, absorption::SCALE));
                    if channels > 1 {
                        add(depths, at + 2, quantise(u.absorption.y * inside, absorption::SCALE));
                        add(depths, at + 4, quantise(u.absorption.z * inside, absorption::SCALE));
                    }
                }
                voxel += 1;
            }
        }
    }
}
