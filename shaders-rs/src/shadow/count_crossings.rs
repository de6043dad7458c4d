//! Optical depth of opaque triangles in the shadow map: the number of triangles that the middle of each column of light crosses,
//! weighted by the triangles' optical depths (Chang et al. 2010, §3, step 2).
//!
//! That is the paper's “number of writing”: a rasteriser draws a triangle into a pixel if it covers its centre. A column that goes
//! through an edge of two triangles crosses one of them.

use crate::abi::record::absorption;
use crate::abi::shadow::{ShadowUniforms, caster};
use crate::field::access::{read, read_vector};
use crate::field::sums::{Sums, add, quantise};
use crate::math::{clamp, floor_to_int};
use crate::voxelize::columns::{columns_before, cross, depth};
use crate::voxelize::{Item, item_at};

/// Does item y · width + x: adds the triangle's optical depth to the voxels in which the middles of columns cross it.
#[inline(always)]
pub fn invoke<S: Sums + ?Sized>(
    x: u32,
    y: u32,
    u: &ShadowUniforms,
    _mode: u32,
    casters: &[f32],
    items: &[u32],
    depths: &mut S,
) {
    let Item { triangle, first, end } = item_at(y * u.dispatch.width + x, u.work, items);
    let at = triangle * caster::SIZE as i32;
    let (a, b, c) = (read_vector(casters, at), read_vector(casters, at + 3), read_vector(casters, at + 6));
    let weight = quantise(read(casters, at + caster::DEPTH as i32), absorption::SCALE);
    let length = u.width as i32 as f32;
    let most = u.height as i32 as f32;
    let channels = u.channels as i32;
    let mut layer = first;
    while layer < end {
        let line = cross(a, b, c, layer as f32 + 0.5);
        if line.crosses {
            let last = columns_before(line.high_y, 1.0, most);
            let mut column = columns_before(line.low_y, 1.0, most);
            while column < last {
                let x = clamp(depth(line.at(column as f32 + 0.5), length, u.divergence), 0.0, length);
                let voxel = floor_to_int(x, 0.0, length - 1.0);
                let row = (layer - u.first_layer as i32) * u.height as i32 + column;
                let place = row * u.width as i32 + voxel;
                let mut channel = 0;
                while channel < channels {
                    add(depths, (place * channels + channel) * absorption::SIZE as i32, weight);
                    channel += 1;
                }
                column += 1;
            }
        }
        layer += 1;
    }
}
