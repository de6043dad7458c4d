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

/// A transparent shadow map in a buffer of several: its first word, and its channels.
#[derive(Clone, Copy)]
struct Stored {
    first: i32,
    channels: i32,
}

/// Transmittance at `depth` voxels along the light, 0 to 1, in the column whose row begins at word `row`: linear between the faces of voxels.
#[inline(always)]
fn in_column(map: &ShadowMap, shadow: &[u32], row: i32, depth: f32) -> f32 {
    let length = map.size.x as i32 as f32;
    let voxel = floor_to_int(depth, 0.0, length - 1.0);
    let share = select(depth < length, max(depth - voxel as f32, 0.0), 1.0);
    let pair = read_bytes(shadow, 4 * row + 2 * voxel);
    let (a, b) = ((pair & 0xffff) as i32 as f32, (pair >> 16) as i32 as f32);
    (a + (b - a) * share) * (1.0 / 65535.0)
}

/// Half the width of a tent over the radius of a disc of the same variance: w²/6 and r²/4 along each axis.
const TENT: f32 = 1.224_744_9;
/// Columns to either side, evenly over the source's disc, in which the casters of a soft shadow are looked for.
const SEARCHED: i32 = 3;
/// Halvings of a column's length by which its caster is found: columns have at most 2¹⁰ voxels.
const HALVINGS: i32 = 10;
/// Loss of light that counts, over all light: less is rounding.
const LEAST_LOSS: f32 = 1e-4;

/// The depth in a column `aside` columns away from a point at the depth `along` up to which casters hide a part of the source from the point: those behind
/// it are beside the cone from the point to the source's disc. In the columns that the filter of a crisp shadow reads, all that is in front of the point.
#[inline(always)]
fn up_to(map: &ShadowMap, along: f32, aside: f32) -> f32 {
    let beyond = max(aside - core::f32::consts::SQRT_2 * map.radius, 0.0);
    along - select(map.softness > 0.0, beyond / max(TENT * map.softness, 1e-6), 0.0)
}

/// Half the width of the filter for a point: that of a crisp light, and what the disc of a soft one covers at the casters' mean distance, as its variance
/// (percentage-closer soft shadows, Fernando 2005).
#[inline(always)]
fn width(map: &ShadowMap, stored: Stored, shadow: &[u32], along: f32, across: f32, up: f32) -> f32 {
    let (ny, nz) = (map.size.y as i32, map.size.z as i32);
    let words = row_words(map.size.x) as i32;
    let most = MOST_COLUMNS as f32;
    let step = min(map.softness * max(along, 0.0), most - 1.0) * (1.0 / SEARCHED as f32);
    let (mut lost, mut weighted) = (0.0, 0.0);
    let (mut i, mut j) = (-SEARCHED, -SEARCHED);
    while j <= SEARCHED {
        let (aside, above) = (i as f32 * step, j as f32 * step);
        let y = floor_to_int(across + aside + 0.5, -1.0, ny as f32);
        let z = floor_to_int(up + above + 0.5, -1.0, nz as f32);
        let inside = (y >= 0) & (y < ny) & (z >= 0) & (z < nz);
        let row = stored.first + (if inside { z * ny + y } else { 0 }) * words;
        let depth = up_to(map, along, sqrt(aside * aside + above * above));
        let loss = select(inside, 1.0 - in_column(map, shadow, row, depth), 0.0);
        if loss > LEAST_LOSS {
            let (mut before, mut behind) = (0.0, max(depth, 0.0));
            let mut halving = 0;
            while halving < HALVINGS {
                let middle = 0.5 * (before + behind);
                let lit = in_column(map, shadow, row, middle) > 1.0 - 0.5 * loss;
                before = select(lit, middle, before);
                behind = select(lit, behind, middle);
                halving += 1;
            }
            lost += loss;
            weighted += loss * behind;
        }
        let last = i == SEARCHED;
        i = if last { -SEARCHED } else { i + 1 };
        j += last as i32;
    }
    let distance = select(lost > 0.0, max(along - weighted / max(lost, LEAST_LOSS), 0.0), 0.0);
    let disc = TENT * map.softness * distance;
    min(sqrt(map.radius * map.radius + disc * disc), most)
}

/// Transmittance from the light to a position in the grid's voxels, linear RGB, 0 to 1 (Chang et al. 2010, §3): linear along the light, and across it the
/// mean of the columns around, weighted by a tent; of a soft light one as wide as its penumbra.
///
/// Transmittances are averaged, not optical depths: half of a shadow's edge is light. All light gets to what is in front of
/// or beside the shadow map.
#[inline(always)]
fn looked_up(map: &ShadowMap, stored: Stored, shadow: &[u32], position: Vec3) -> Vec3 {
    let (ny, nz) = (map.size.y as i32, map.size.z as i32);
    let channels = stored.channels;
    let Place { along, across, up, scale } = place(map, position);
    let (across, up) = (across - 0.5, up - 0.5);
    let soft = (map.softness > 0.0) & (channels > 0);
    let width = if soft { width(map, stored, shadow, along, across, up) } else { map.radius };
    let reach = MOST_COLUMNS as f32;
    let first = floor_to_int(across - width, -reach, ny as f32) + 1;
    let last = floor_to_int(across + width, -1.0, (ny - 1) as f32 + reach);
    let low = floor_to_int(up - width, -reach, nz as f32) + 1;
    let high = floor_to_int(up + width, -1.0, (nz - 1) as f32 + reach);
    let words = row_words(map.size.x) as i32;
    let plane = ny * nz * words;
    let mut sum = Vec3::new(0.0, 0.0, 0.0);
    let mut total = 0.0;
    let mut z = low;
    while z <= high {
        let above = z as f32 - up;
        let vertical = width - absolute(above);
        let mut y = first;
        while y <= last {
            let aside = y as f32 - across;
            let weight = max(width - absolute(aside), 0.0) * max(vertical, 0.0);
            let inside = (y >= 0) & (y < ny) & (z >= 0) & (z < nz);
            if inside {
                let row = stored.first + (z * ny + y) * words;
                let depth = up_to(map, along, sqrt(aside * aside + above * above));
                let red = in_column(map, shadow, row, depth);
                sum.x += weight * red;
                if channels > 1 {
                    sum.y += weight * in_column(map, shadow, row + plane, depth);
                    sum.z += weight * in_column(map, shadow, row + 2 * plane, depth);
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

/// Transmittance from the light to a position in the grid's voxels, linear RGB, 0 to 1, through all bodies.
#[inline(always)]
pub fn transmittance(u: &VoxelsUniforms, shadow: &[u32], position: Vec3) -> Vec3 {
    let stored = Stored { first: u.shadow.first as i32, channels: u.shadow.channels as i32 };
    looked_up(&u.shadow, stored, shadow, position)
}

/// As [`transmittance`], through opaque bodies alone.
#[inline(always)]
pub fn behind_opaque(u: &VoxelsUniforms, shadow: &[u32], position: Vec3) -> Vec3 {
    let stored = Stored { first: u.shadow.first_opaque as i32, channels: u.shadow.opaque_channels as i32 };
    looked_up(&u.shadow, stored, shadow, position)
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
