//! Light from the plane behind to this one (sweep §4.2, Algorithm 1, lines 9 to 18).

use crate::abi::record::light as record;
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::access::read;
use crate::field::empty::is_empty;
use crate::field::light::{light, texel_position};
use crate::field::stencil::{scalar, voxel_coordinates};
use crate::field::tables::attenuation;
use crate::math::{absolute, length, max, min, select, sqrt};
use crate::optics::clip::keep;
use crate::optics::composite::layer;
use crate::optics::medium::{medium, share_inside};
use crate::optics::step::{kick, kick_euler};
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The light crosses empty space.
    pub const EMPTY: u32 = 1;
    /// The light may be attenuated and bent.
    pub const FULL: u32 = 2;
}

/// A back-traced point, in texels.
#[inline(always)]
fn origin(u: &SweepUniforms, trace: &[f32], x: i32, y: i32) -> (f32, f32) {
    let at = y * u.size.z as i32 + x;
    let texels = (u.size.z * u.size.w) as i32;
    (read(trace, at), read(trace, texels + at))
}

/// The texel's segment: from where its light comes to where it is.
#[inline(always)]
fn ends(u: &SweepUniforms, trace: &[f32], x: u32, y: u32) -> (Vec3, Vec3) {
    let (from_x, from_y) = origin(u, trace, x as i32, y as i32);
    (texel_position(u, from_x, from_y, u.plane.x), texel_position(u, x as i32 as f32, y as i32 as f32, u.plane.y))
}

#[inline(always)]
fn empty<const SECOND: bool>(u: &SweepUniforms, occupancy: &[u32], from: Vec3, to: Vec3) -> bool {
    let shown = is_empty(occupancy, &u.grid, voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let bending = !SECOND
        || is_empty(occupancy, &u.ior_grid, voxel_coordinates(&u.ior_grid, from), voxel_coordinates(&u.ior_grid, to));
    shown & bending & (u.dispatch.w & flag::SKIP_EMPTY != 0)
}

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level<const FORMAT: u32, const SECOND: bool>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    _light: &[f32],
    trace: &[f32],
) -> u32 {
    let (from, to) = ends(u, trace, x, y);
    if empty::<SECOND>(u, occupancy, from, to) { level::EMPTY } else { level::FULL }
}

/// The mean of two differences, limited to twice the smaller one and 0 where the signs differ: the mean where a map is
/// smooth, almost nothing where it jumps (van Leer's monotonised central limiter).
#[inline(always)]
fn limited(a: f32, b: f32) -> f32 {
    let mean = 0.5 * (a + b);
    let most = 2.0 * min(absolute(a), absolute(b));
    let size = min(absolute(mean), most);
    select(a * b > 0.0, select(mean < 0.0, -size, size), 0.0)
}

/// A derivative's deviation from no refraction, from the differences to both sides: limited where it makes light brighter.
#[inline(always)]
fn deviation(a: f32, b: f32) -> f32 {
    let mean = 0.5 * (a + b);
    select(mean > 0.0, limited(a, b), mean)
}

/// Eq. 12 with S from the neighbours' back-traced points: how much denser the light is here than where it comes from.
///
/// Where refracted light meets unrefracted light the back trace jumps, and a difference across the jump is no derivative: it
/// would multiply the light anew on every plane. So the differences to both sides are limited; where the map is smooth they
/// agree.
#[inline(always)]
fn intensity(u: &SweepUniforms, trace: &[f32], x: u32, y: u32) -> f32 {
    let (x, y) = (x as i32, y as i32);
    let last_x = u.size.z as i32 - 1;
    let last_y = u.size.w as i32 - 1;
    let left = if x > 0 { x - 1 } else { 0 };
    let right = if x < last_x { x + 1 } else { last_x };
    let below = if y > 0 { y - 1 } else { 0 };
    let above = if y < last_y { y + 1 } else { last_y };
    let (cx, cy) = origin(u, trace, x, y);
    let (lx, ly) = origin(u, trace, left, y);
    let (rx, ry) = origin(u, trace, right, y);
    let (bx, by) = origin(u, trace, x, below);
    let (ax, ay) = origin(u, trace, x, above);
    // Deviations from the identity; at the grid's border a side is missing and counts as undisturbed.
    let dx_x = 1.0 + deviation((cx - lx) - (x - left) as f32, (rx - cx) - (right - x) as f32);
    let dx_y = limited(cy - ly, ry - cy);
    let dy_x = limited(cx - bx, ax - cx);
    let dy_y = 1.0 + deviation((cy - by) - (y - below) as f32, (ay - cy) - (above - y) as f32);
    let jacobian = absolute(dx_x * dy_y - dx_y * dy_x);
    // Eq. 13: wrong by √(1 + s²) for a sheared map.
    let paper = sqrt(dx_x * dx_x + dx_y * dx_y) * sqrt(dy_x * dy_x + dy_y * dy_y);
    let flags = u.dispatch.w;
    select(flags & flag::NO_INTENSITY != 0, 1.0, select(flags & flag::PAPER_INTENSITY != 0, paper, jacobian))
}

/// The light at texel (x, y) of this plane.
///
/// What is stored is the irradiance E = L cos θ of the plane. Flux through the plane, E dS, is then conserved by the factor of
/// areas alone (Eqs. 11 and 12).
#[inline(always)]
pub fn invoke<const FORMAT: u32, const SECOND: bool, const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    voxels: &[u32],
    ior_voxels: &[u32],
    occupancy: &[u32],
    tables: &[u32],
    behind: &[f32],
    trace: &[f32],
) -> [f32; record::SIZE] {
    let (from_x, from_y) = origin(u, trace, x as i32, y as i32);
    let arriving = light(u, behind, from_x, from_y);
    let denser = intensity(u, trace, x, y);
    let flux = arriving.flux * denser;
    let v = arriving.direction;
    if LEVEL == level::EMPTY {
        return [flux.x, flux.y, flux.z, v.x, v.y, v.z];
    }

    let (from, to) = ends(u, trace, x, y);
    let skipped = empty::<SECOND>(u, occupancy, from, to);
    let (voxel_from, voxel_to) = (voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let here = medium::<FORMAT, SECOND>(
        (&u.grid, &u.ior_grid),
        chosen,
        voxels,
        ior_voxels,
        tables,
        voxel_to,
        voxel_coordinates(&u.ior_grid, to),
    );
    let front = scalar::<FORMAT>(voxels, &u.grid, voxel_from);
    let kept = keep(u, from, to);
    let path = length(to - from) * share_inside(&u.grid, voxel_from, voxel_to) * u.plane.w;
    let layer = layer(&attenuation(tables, front, here.scalar), path * kept.particles, path * kept.medium);

    let mut out = v;
    let mut lost = 1.0;
    if chosen != mode::STRAIGHT {
        let keeps = select(skipped, 0.0, kept.refraction);
        let limit = u.shading.z;
        let sigma = u.plane.z / max(v.z, 1e-6);
        let symplectic = kick(v, here.acceleration * keeps, sigma, u.plane.z, limit);
        let euler = kick_euler(v, here.ior_gradient * keeps, u.plane.z, limit);
        let use_euler = u.dispatch.w & flag::EULER != 0;
        let turned = if use_euler { euler.turned } else { symplectic.turned };
        let kicked = Vec3::new(
            select(use_euler, euler.direction.x, symplectic.direction.x),
            select(use_euler, euler.direction.y, symplectic.direction.y),
            select(use_euler, euler.direction.z, symplectic.direction.z),
        );
        // Light that turns back is lost to the sweep; its texel keeps the direction it had.
        lost = select(turned, 0.0, 1.0);
        out = Vec3::new(select(turned, v.x, kicked.x), select(turned, v.y, kicked.y), select(turned, v.z, kicked.z));
    }
    let through = layer.medium * (layer.clear * lost);
    let attenuated = flux * through;
    [
        select(skipped, flux.x, attenuated.x),
        select(skipped, flux.y, attenuated.y),
        select(skipped, flux.z, attenuated.z),
        select(skipped, v.x, out.x),
        select(skipped, v.y, out.y),
        select(skipped, v.z, out.z),
    ]
}
