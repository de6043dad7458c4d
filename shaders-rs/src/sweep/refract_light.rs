//! What the volume does to the light on its way to this plane: attenuation by (1 − α) · m, and refraction (sweep §4.2, Eqs. 9
//! and 10, Algorithm 1, lines 14 to 18).

use crate::abi::format::VoxelFormat;
use crate::abi::record::{Light, light as record, trace as traced};
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::access::{read, read_inside};
use crate::field::colors::extinction_between;
use crate::field::stencil::{front_of, scalar, voxel_coordinates};
use crate::field::tables::{attenuation, attenuation_of_particles};
use crate::kernel::skip::{Reach, Same};
use crate::math::{absolute, length, max, min, select, select_vector, xyz};
use crate::optics::composite::{layer, layer_of_particles};
use crate::optics::isosurfaces::transmittance;
use crate::optics::medium::{medium, share_inside};
use crate::sweep::bodies::{is_met, may_be_met};
use crate::sweep::border::{
    MARGIN, bending_grid, border_ior, is_far_inside, is_inside_by, meet, settle, share_ahead, step_on,
};
use crate::sweep::clip::keep;
use crate::sweep::empty::{step_is_empty, steps_are_empty};
use crate::sweep::isosurfaces::are_looked_for;
use crate::sweep::light::look_up::{holds, texel_position};
use crate::sweep::light::unoccluded;
use crate::sweep::turn::turn;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The light crosses empty space: its record stays as it is.
    pub const EMPTY: u32 = 1;
    /// The light may be attenuated and bent, well inside the grid.
    pub const FULL: u32 = 3;
    /// Its segment may be outside in part, or meet a body, or cross an isosurface.
    pub const BORDER: u32 = 7;
}

/// The texel's segment: from where its light comes, `way` texels before it, to where it is.
#[inline(always)]
fn ends(u: &SweepUniforms, x: u32, y: u32, way: (f32, f32)) -> (Vec3, Vec3) {
    let (x, y) = (x as i32 as f32, y as i32 as f32);
    (texel_position(u, x - way.0, y - way.1, u.step.behind), texel_position(u, x, y, u.step.ahead))
}

/// The farthest distance from the border at which light is settled, in voxels: bricks that are farther inside may be skipped.
const FARTHEST: f32 = 1.0;

/// The distance from the border, in voxels, within which the light that arrives is a mixture: of that of texels on both sides of the border.
#[inline(always)]
fn mixed_within<V: VoxelFormat>(u: &SweepUniforms) -> f32 {
    min(1.5 * u.light_grid.texel * length(xyz(bending_grid::<V>(u).row_x.factors)), FARTHEST)
}

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level<V: VoxelFormat>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    arrived: [f32; record::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    trace: &[f32],
) -> u32 {
    if !holds(u, trace, traced::SIZE) {
        return level::BORDER;
    }
    let base = (y * u.light_grid.width) as i32;
    let texels = (u.light_grid.width * u.light_grid.height) as i32;
    // SAFETY: (x, y) lies in the grid, and the grid in the buffer.
    let way = unsafe { (read_inside(trace, base, x), read_inside(trace, texels + base, x)) };
    let (from, to) = ends(u, x, y, way);
    let margin = max(MARGIN, mixed_within::<V>(u) + 1.0 / 64.0);
    // The light's own direction need not be that of the way on which the wavefront brings it.
    let next = step_on(u, to, Light::load(&arrived).direction);
    let within =
        is_far_inside::<V>(u, chosen, from, to, margin) & (!mode::bends(chosen) | is_inside_by::<V>(u, next, margin));
    let passes = !may_be_met::<V>(u, occupancy, from, to) & (u.flags & flag::ISOSURFACES == 0);
    let crossing = if within & passes { level::FULL } else { level::BORDER };
    if step_is_empty::<V>(u, occupancy, from, to) { level::EMPTY } else { crossing }
}

/// Unoccluded light stays as it is as long as nothing is in its way: see [`until`].
#[inline(always)]
pub fn same(u: &SweepUniforms) -> Option<Same<{ record::SIZE }>> {
    Some(Same { record: unoccluded::light(u), reach: Reach::OWN })
}

/// How many planes behind the next one unoccluded light on texel (x, y) that is at level `EMPTY` has nothing in its way, if they are as
/// far apart: that or fewer.
#[inline(always)]
pub fn until<V: VoxelFormat>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    _arrived: [f32; record::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    _trace: &[f32],
    _known: f32,
) -> f32 {
    let (from, to) = ends(u, x, y, (0.0, 0.0));
    steps_are_empty::<V>(u, occupancy, from, to)
}

/// The light `arrived` at texel (x, y), after the segment behind it.
#[inline(always)]
pub fn invoke<V: VoxelFormat, const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    chosen: u32,
    arrived: [f32; record::SIZE],
    voxels: &[u32],
    ior_voxels: &[u32],
    _occupancy: &[u32],
    tables: &[u32],
    trace: &[f32],
) -> [f32; record::SIZE] {
    let arrived = Light::load(&arrived);
    let v = arrived.direction;
    let at = (y * u.light_grid.width + x) as i32;
    let texels = (u.light_grid.width * u.light_grid.height) as i32;
    let (from, to) = ends(u, x, y, (read(trace, at), read(trace, texels + at)));
    let (voxel_from, voxel_to) = (voxel_coordinates(&u.grid, from), voxel_coordinates(&u.grid, to));
    let here = medium::<V>(
        (&u.grid, &u.ior_grid),
        chosen,
        voxels,
        ior_voxels,
        tables,
        voxel_to,
        voxel_coordinates(&u.ior_grid, to),
    );
    let front = front_of(&u.grid, scalar::<V>(voxels, &u.grid, voxel_from), here.scalar);
    let kept = keep(u, from, to);
    let inside = if LEVEL >= level::BORDER { share_inside(&u.grid, voxel_from, voxel_to) } else { 1.0 };
    let path = length(to - from) * inside * u.step.inverse_reference_length;
    let extinction = extinction_between::<V>(ior_voxels, &u.grid, voxel_from, voxel_to);
    let layer = if mode::is_clear(chosen) {
        let attenuation = attenuation_of_particles(tables, front, here.scalar).thinned::<V>(extinction);
        layer_of_particles(&attenuation, path * kept.particles.length())
    } else {
        let attenuation = attenuation(tables, front, here.scalar).thinned::<V>(extinction);
        layer(&attenuation, path * kept.particles.length(), path * kept.medium.length())
    };
    let mut clear = layer.clear;
    if LEVEL >= level::BORDER && are_looked_for(u) {
        clear *= select(inside > 0.0, transmittance(tables, front, here.scalar, kept.particles), 1.0);
    }
    if LEVEL >= level::BORDER && V::BODIES {
        clear = select(is_met::<V>(u, ior_voxels, from, to), 0.0, clear);
    }

    let mut out = v;
    let mut lost = 1.0;
    if mode::bends(chosen) {
        let mut arriving = v;
        let (mut behind, mut ahead) = (1.0, 0.5);
        let mut reflected = false;
        if LEVEL >= level::BORDER {
            let meeting = meet::<V>(u, from, to);
            let (inside, ends_inside) = (meeting.distance < 0.0, meeting.end < 0.0);
            let crosses = inside != ends_inside;
            let (share, face) = if inside { (meeting.leaves, meeting.left) } else { (meeting.enters, meeting.entered) };
            let mixed = crosses | (absolute(meeting.distance) < mixed_within::<V>(u));
            let at = from + (to - from) * select(crosses, share, 0.0);
            let eta = border_ior::<V>(u, voxels, ior_voxels, tables, at);
            let normal = select_vector(crosses, face, meeting.nearest);
            let (settled, total) = settle(v, normal, select(ends_inside, eta, 1.0), crosses);
            let changes = mixed & (eta != 1.0);
            arriving = select_vector(changes, settled, v);
            reflected = changes & (total | (crosses & (arriving.z <= 0.0)));
            behind = select(crosses & ends_inside, 2.0 * (1.0 - share), 1.0);
            ahead = share_ahead::<V>(u, to, arriving);
        }
        let sigma = u.step.distance / max(arriving.z, 1e-6) * behind;
        let turn = turn(u, arriving, &here, kept.refraction, sigma, ahead);
        // Light that turns back is lost to the sweep; its texel keeps the direction it had.
        let turned = turn.turned | reflected;
        lost = select(turned, 0.0, 1.0);
        out = select_vector(turned, v, turn.direction);
    }
    let flux = arrived.flux * (layer.medium * (clear * lost));
    Light { flux, direction: out, ..arrived }.store()
}
