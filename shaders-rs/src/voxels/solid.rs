//! Fields of materials: the smoothed coverage of each voxel's neighbourhood by a body, whose level ½ is the surface. Each field is
//! stored in the box where it is not 0. The paper's “low pass filter” (Chang et al. 2010, §4.1.1), which it suggests and leaves open.

use crate::abi::voxels::{AIR, VoxelsUniforms, field};
use crate::field::access::{read, read_bytes};
use crate::math::floor_to_int;
use spirv_std::glam::Vec3;

/// The level of the surface, ½, as 16-bit integers have it.
pub const LEVEL: f32 = 32767.5;

/// Two neighbours along x of a field, `t` of the way from the first to the second.
#[inline(always)]
fn along_row(fields: &[u32], sample: i32, t: f32) -> f32 {
    let pair = read_bytes(fields, 2 * sample);
    let (a, b) = ((pair & 0xffff) as i32 as f32, (pair >> 16) as i32 as f32);
    a + (b - a) * t
}

/// Along one axis, the number of sample `at` in a field's box `bounds` (see [`field::BOX`]), and whether the next one is in it, too.
#[inline(always)]
fn in_box(bounds: u32, at: i32) -> (i32, bool) {
    let inside = at - (bounds & 0xffff) as i32;
    (inside, (inside >= 0) & (inside + 1 < (bounds >> 16) as i32))
}

/// The field of material `number` at a position in voxels, 0 to 65535, linear between voxels' centres.
#[inline(always)]
pub fn value(u: &VoxelsUniforms, fields: &[u32], number: i32, position: Vec3) -> f32 {
    let (nx, ny, nz) = (u.size.x as i32, u.size.y as i32, u.size.z as i32);
    let q = Vec3::new(position.x - 0.5, position.y - 0.5, position.z - 0.5);
    let x = floor_to_int(q.x, 0.0, (nx - 2) as f32);
    let y = floor_to_int(q.y, 0.0, (ny - 2) as f32);
    let z = floor_to_int(q.z, 0.0, (nz - 2) as f32);
    let entry = number * field::SIZE as i32;
    let bounds = entry + field::BOX as i32;
    let (along_x, along_y, along_z) = (read(fields, bounds), read(fields, bounds + 1), read(fields, bounds + 2));
    let (box_x, inside_x) = in_box(along_x, x);
    let (box_y, inside_y) = in_box(along_y, y);
    let (box_z, inside_z) = in_box(along_z, z);
    if inside_x & inside_y & inside_z {
        let row = (along_x >> 16) as i32;
        let layer = (along_y >> 16) as i32 * row;
        let at = read(fields, entry + field::FIRST as i32) as i32 + box_z * layer + box_y * row + box_x;
        let (fx, fy, fz) = (q.x - x as f32, q.y - y as f32, q.z - z as f32);
        let (a, b) = (along_row(fields, at, fx), along_row(fields, at + row, fx));
        let (c, d) = (along_row(fields, at + layer, fx), along_row(fields, at + layer + row, fx));
        let (low, high) = (a + (b - a) * fy, c + (d - c) * fy);
        low + (high - low) * fz
    } else {
        0.0
    }
}

/// The number of the material at a position: the lowest one, where bodies overlap.
#[inline(always)]
pub fn medium(u: &VoxelsUniforms, fields: &[u32], position: Vec3) -> i32 {
    let mut found = AIR;
    let mut number = u.materials as i32 - 1;
    while number >= 0 {
        if value(u, fields, number, position) > LEVEL {
            found = number;
        }
        number -= 1;
    }
    found
}
