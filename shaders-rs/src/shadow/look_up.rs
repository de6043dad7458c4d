//! Transmittance from the light to a point, from the transparent shadow map (Chang et al. 2010, §3, step 3).

use super::spread::stretch;
use crate::abi::shadow::row_words;
use crate::abi::voxels::{ShadowMap, VoxelsUniforms};
use crate::field::access::read_bytes;
use crate::math::{absolute, affine, dot, floor_to_int, max, min, select, sqrt, xyz};
use spirv_std::glam::Vec3;

/// The most columns that a filter reaches to either side: its loops stay well below what drivers end.
pub const MOST_COLUMNS: i32 = 16;

/// The scale below which a position is not in front of the light: all of the mesh is at larger ones.
const LEAST_SCALE: f32 = 1e-6;

/// A position in the shadow map, in its voxels.
#[derive(Clone, Copy)]
struct Place {
    along: f32,
    across: f32,
    up: f32,
    /// The width of a column there over that of a column where voxels are cubes.
    scale: f32,
}

/// The place of a position in the grid's voxels.
#[inline(always)]
fn place(map: &ShadowMap, position: Vec3) -> Place {
    let scale = affine(map.scale, position);
    let divisor = select(scale > LEAST_SCALE, scale, 1.0);
    Place {
        along: affine(map.row_x, position),
        across: affine(map.row_y, position) / divisor,
        up: affine(map.row_z, position) / divisor,
        scale,
    }
}

/// Transmittance at `along` voxels, 0 to 1, in the column whose row begins at word `row`.
#[inline(always)]
fn in_column(shadow: &[u32], row: i32, voxel: i32, share: f32) -> f32 {
    let pair = read_bytes(shadow, 4 * row + 2 * voxel);
    let (a, b) = ((pair & 0xffff) as i32 as f32, (pair >> 16) as i32 as f32);
    (a + (b - a) * share) * (1.0 / 65535.0)
}

/// Transmittance from the light to a position in the grid's voxels, linear RGB, 0 to 1 (Chang et al. 2010, §3): linear along the light, and across it the
/// mean of the columns around, weighted by a tent.
///
/// Transmittances are averaged, not optical depths: half of a shadow's edge is light. All light gets to what is in front of
/// or beside the shadow map.
#[inline(always)]
pub fn transmittance(u: &VoxelsUniforms, shadow: &[u32], position: Vec3) -> Vec3 {
    let (nx, ny, nz) = (u.shadow.size.x as i32, u.shadow.size.y as i32, u.shadow.size.z as i32);
    let channels = u.shadow.channels as i32;
    let Place { along, across, up, scale } = place(&u.shadow, position);
    let (across, up) = (across - 0.5, up - 0.5);
    let width = u.shadow.radius;
    let voxel = floor_to_int(along, 0.0, (nx - 1) as f32);
    let share = select(along < nx as f32, max(along - voxel as f32, 0.0), 1.0);
    let reach = MOST_COLUMNS as f32;
    let first = floor_to_int(across - width, -reach, ny as f32) + 1;
    let last = floor_to_int(across + width, -1.0, (ny - 1) as f32 + reach);
    let low = floor_to_int(up - width, -reach, nz as f32) + 1;
    let high = floor_to_int(up + width, -1.0, (nz - 1) as f32 + reach);
    let words = row_words(u.shadow.size.x) as i32;
    let plane = ny * nz * words;
    let mut sum = Vec3::new(0.0, 0.0, 0.0);
    let mut total = 0.0;
    let mut z = low;
    while z <= high {
        let vertical = width - absolute(z as f32 - up);
        let mut y = first;
        while y <= last {
            let weight = max(width - absolute(y as f32 - across), 0.0) * max(vertical, 0.0);
            let inside = (y >= 0) & (y < ny) & (z >= 0) & (z < nz);
            if inside {
                let row = (z * ny + y) * words;
                let red = in_column(shadow, row, voxel, share);
                sum.x += weight * red;
                if channels > 1 {
                    sum.y += weight * in_column(shadow, row + plane, voxel, share);
                    sum.z += weight * in_column(shadow, row + 2 * plane, voxel, share);
                } else {
                    sum.y += weight * red;
                    sum.z += weight * red;
                }
            } else {
                sum.x += weight;
                sum.y += weight;
                sum.z += weight;
            }
            total += weight;
            y += 1;
        }
        z += 1;
    }
    let lit = (channels == 0) | (total <= 0.0) | (scale <= LEAST_SCALE);
    let scale = 1.0 / select(lit, 1.0, total);
    Vec3::new(select(lit, 1.0, sum.x * scale), select(lit, 1.0, sum.y * scale), select(lit, 1.0, sum.z * scale))
}

/// How far above a surface to look, in the grid's voxels, so that the surface does not shade itself; `normal` is the unit normal of its plane, and
/// `cosine` that of the angle between it and the light.
///
/// The filter reads columns up to √2 · width away across the axis, and linearly between two faces along it, where a column that
/// crosses the surface within a voxel is darker from that voxel's front face on. A plane at an angle θ to the axis that is seen from w sin θ + l cos φ
/// above it, w the width of so many columns there, l the length of a column in a voxel and φ the angle to the light, lies a whole voxel or
/// more behind the point in each of these columns.
#[inline(always)]
pub fn bias(map: &ShadowMap, position: Vec3, normal: Vec3, cosine: f32) -> f32 {
    let Place { across, up, scale, .. } = place(map, position);
    let axial = -dot(normal, xyz(map.axis));
    let axial = min(max(axial, -axial), 1.0);
    let sine = sqrt(1.0 - axial * axial);
    let width = core::f32::consts::SQRT_2 * map.radius * sine;
    (width * scale + cosine * stretch(&map.spread, across, up)) * map.edge
}
