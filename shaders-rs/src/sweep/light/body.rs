//! The light on opaque bodies within the volume.
//!
//! Light that is carried is known at samples, some of which are inside a body, where none is. It is looked up in front of the body's surface and nearer to its
//! source, and attenuated by the matter from there on.

use super::matter::{NEARER, behind};
use crate::abi::format::VoxelFormat;
use crate::abi::sweep::SweepUniforms;
use crate::field::stencil::{scalar, voxel_coordinates};
use crate::math::{length, max};
use crate::sweep::light::carried::light_at;
use crate::sweep::light::look_up::Light;
use crate::sweep::light::wavefront::{edge, from_frame, in_frame, unrefracted_direction};
use spirv_std::glam::Vec3;

/// The light on a body's surface at a point of the view frame where the unit normal is `normal`; its flux is the radiance of light that has the same fluence.
#[inline(always)]
pub fn light_on_body<V: VoxelFormat>(
    u: &SweepUniforms,
    chosen: u32,
    (voxels, tables, light): (&[u32], &[u32], &[u32]),
    at: Vec3,
    normal: Vec3,
) -> Light {
    let w = &u.wavefront;
    let inside = in_frame(w, at);
    let apart = max(1.0 / w.inverse_step, edge(w, inside.z)) * NEARER;
    let towards = from_frame(w, unrefracted_direction(w, inside));
    let far = at + normal * apart - towards * apart;
    let middle = far + (at - far) * 0.5;
    let scalar_at = scalar::<V>(voxels, &u.grid, voxel_coordinates(&u.grid, at));
    let half = length(at - middle);
    let near = behind::<V>(u, chosen, (voxels, tables), middle, (at, scalar_at), (half, 1.0));
    let beyond = behind::<V>(u, chosen, (voxels, tables), far, (middle, near.scalar), (half, 1.0));
    let found = light_at(u, light, far, chosen);
    let left = (near.medium * beyond.medium) * (near.clear * beyond.clear);
    Light { flux: found.flux * left, direction: found.direction }
}
