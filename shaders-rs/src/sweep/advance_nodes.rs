//! The wavefront's nodes from the plane behind to this one: attenuation and refraction as of a light texel ([`super::refract_light`]), but
//! forward, each node from where it is (sweep §4.2, Eqs. 9 and 10).

use crate::abi::format::VoxelFormat;
use crate::abi::record::{Node, node as record, node_status as status};
use crate::abi::sweep::{SweepUniforms, flag, mode};
use crate::field::colors::extinction_between;
use crate::field::stencil::{front_of, scalar, voxel_coordinates};
use crate::field::tables::{attenuation, attenuation_of_particles};
use crate::math::{length, lerp, max, min, select, select_vector};
use crate::optics::composite::{layer, layer_of_particles};
use crate::optics::isosurfaces::transmittance;
use crate::optics::medium::{medium, share_inside};
use crate::optics::receiver::{first_between, free_steps};
use crate::sweep::bodies::{is_met, may_be_met};
use crate::sweep::border::{Crossing, MARGIN, Volumes, border_ior, cross, is_far_inside, is_inside, meet, share_ahead};
use crate::sweep::clip::keep;
use crate::sweep::empty::{step_is_empty, steps_are_empty};
use crate::sweep::isosurfaces::are_looked_for;
use crate::sweep::light::wavefront::point_at;
use crate::sweep::turn::turn;
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The node's light has turned back, has met a receiver, or is gone.
    pub const ENDED: u32 = 0;
    /// It crosses empty space, meets no receiver, and its record stays as it is.
    pub const EMPTY: u32 = 1;
    /// It may be attenuated and bent, far inside the border of the space in which the volume bends.
    pub const FULL: u32 = 3;
    /// Its segment, or the one behind it, may be outside in part, or it meets a receiver, or perhaps a body or an isosurface.
    pub const BORDER: u32 = 7;
}

/// Light of which less than this share is left is gone.
const DARK: f32 = 1e-6;

/// The ends of the step from plane to plane.
#[inline(always)]
fn ends(u: &SweepUniforms, node: &Node) -> (Vec3, Vec3) {
    let from = point_at(node, u.step.behind);
    let sigma = u.step.distance / node.direction.z;
    (from, Vec3::new(from.x + node.direction.x * sigma, from.y + node.direction.y * sigma, u.step.ahead))
}

/// The level that a node needs.
#[inline(always)]
pub fn level<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    before: [f32; record::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
) -> u32 {
    let node = Node::load(&before);
    let (from, to) = ends(u, &node);
    let met = first_between(&u.receivers, from, to).hit;
    let passes = !met & !may_be_met::<V>(u, occupancy, from, to) & (u.flags & flag::ISOSURFACES == 0);
    let within = is_far_inside::<V>(u, chosen, from, to, MARGIN) & passes;
    let crossing = if within { level::FULL } else { level::BORDER };
    let in_empty = if met { level::BORDER } else { level::EMPTY };
    let needed = if step_is_empty::<V>(u, occupancy, from, to) { in_empty } else { crossing };
    if node.status == status::ACTIVE { needed } else { level::ENDED }
}

/// How many planes behind the next one a node at level `EMPTY` will be at that level for certain, if it is so on the first `known` of them;
/// without end if that is all planes there are.
#[inline(always)]
pub fn until<V: VoxelFormat>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    _mode: u32,
    before: [f32; record::SIZE],
    _voxels: &[u32],
    _ior_voxels: &[u32],
    occupancy: &[u32],
    _tables: &[u32],
    known: f32,
) -> f32 {
    let node = Node::load(&before);
    let (from, to) = ends(u, &node);
    let step = to - from;
    let empty = known + steps_are_empty::<V>(u, occupancy, from + step * known, to + step * known);
    let free = min(min(empty, free_steps(&u.receivers, from, to)), u.step.alike);
    select((node.status == status::ACTIVE) & (free < u.step.alike), free, f32::MAX)
}

/// The node one plane further.
#[inline(always)]
pub fn invoke<V: VoxelFormat, const LEVEL: u32>(
    _x: u32,
    _y: u32,
    u: &SweepUniforms,
    chosen: u32,
    before: [f32; record::SIZE],
    voxels: &[u32],
    ior_voxels: &[u32],
    _occupancy: &[u32],
    tables: &[u32],
) -> [f32; record::SIZE] {
    let node = Node::load(&before);
    let v = node.direction;
    let (from, to) = ends(u, &node);
    let voxel_from = voxel_coordinates(&u.grid, from);
    let mut met = false;
    let mut crossing = Crossing::none(u, to, v, length(to - from));
    if LEVEL >= level::BORDER {
        met = first_between(&u.receivers, from, to).hit;
        if mode::bends(chosen) {
            let meeting = meet::<V>(u, from, to);
            let began_inside = is_inside(&meeting, node.inside != 0.0);
            // Light that begins inside: |v| = η from there on.
            let begins = began_inside & (u.step.behind == u.wavefront.first_depth);
            let eta = border_ior::<V>(u, voxels, ior_voxels, tables, from);
            let way = (from, to, v * select(begins, eta, 1.0));
            crossing = cross::<V>(u, Volumes { voxels, ior_voxels, tables }, way, &meeting, began_inside);
        } else {
            crossing.path *= share_inside(&u.grid, voxel_from, voxel_coordinates(&u.grid, to));
        }
    }
    let (to, arriving) = (crossing.to, crossing.direction);
    let voxel_to = voxel_coordinates(&u.grid, to);
    let ior_to = voxel_coordinates(&u.ior_grid, to);
    let here = medium::<V>((&u.grid, &u.ior_grid), chosen, voxels, ior_voxels, tables, voxel_to, ior_to);
    let scalar_from = scalar::<V>(voxels, &u.grid, voxel_from);
    let front = front_of(&u.grid, scalar_from, here.scalar);
    let kept = keep(u, from, to);
    let path = crossing.path * u.step.inverse_reference_length;
    let extinction = extinction_between::<V>(ior_voxels, &u.grid, voxel_from, voxel_to);
    let layer = if mode::is_clear(chosen) {
        let attenuation = attenuation_of_particles(tables, front, here.scalar).thinned::<V>(extinction);
        layer_of_particles(&attenuation, path * kept.particles.length())
    } else {
        let attenuation = attenuation(tables, front, here.scalar).thinned::<V>(extinction);
        layer(&attenuation, path * kept.particles.length(), path * kept.medium.length())
    };

    let mut out = arriving;
    let mut turned = false;
    if mode::bends(chosen) {
        let ahead = if LEVEL >= level::BORDER { share_ahead::<V>(u, to, arriving) } else { 0.5 };
        let bends = kept.refraction * select(crossing.inside, 1.0, 0.0);
        let kicked = turn(u, arriving, &here, bends, crossing.sigma, ahead);
        turned = kicked.turned | crossing.turned;
        out = select_vector(crossing.turned, arriving, kicked.direction);
    }
    let bent = crossing.bent | (out.x != v.x) | (out.y != v.y) | (out.z != v.z);
    let mut clear = layer.clear;
    if LEVEL >= level::BORDER && are_looked_for(u) {
        // To the point, and to the bit, at which the next step begins: no isosurface passes in between.
        let end = select_vector(bent, to, point_at(&node, u.step.ahead));
        let back = scalar::<V>(voxels, &u.grid, voxel_coordinates(&u.grid, end));
        let front = front_of(&u.grid, scalar_from, back);
        let inside = crossing.path > 0.0;
        clear *= select(inside, transmittance(tables, front, back, kept.particles), 1.0);
    }
    if LEVEL >= level::BORDER && V::BODIES {
        clear = select(is_met::<V>(u, ior_voxels, from, to), 0.0, clear);
    }
    let left = node.flux * (layer.medium * clear);
    let mean = (left.x + left.y + left.z) * (1.0 / 3.0);
    let loss = (node.flux.x + node.flux.y + node.flux.z) * (1.0 / 3.0) - mean;
    // Only where some is absorbed: in empty space a node stays as it is, and blurred light may be as faint there.
    let absorbs = (left.x != node.flux.x) | (left.y != node.flux.y) | (left.z != node.flux.z);
    let dark = absorbs & (max(max(left.x, left.y), left.z) < DARK);
    // Up to a receiver light flies on as it is.
    let moves = bent & !met;
    // Where light is blurred, some may come back.
    let fate = select(dark & (u.wavefront.blur == 0.0), status::DARK, select(turned, status::TURNED, status::ACTIVE));
    let absorbed_at = node.absorbed_at + loss * lerp(from.z, to.z, 0.5);
    let after = Node {
        position: select_vector(moves, to, node.position),
        direction: select_vector(moves, out, v),
        flux: select_vector(dark, Vec3::new(0.0, 0.0, 0.0), left),
        inside: select(crossing.inside, 1.0, 0.0),
        bent: select(moves, 1.0, node.bent),
        status: select(met, status::LANDED, fate),
        absorbed_at,
        left_at: select(moves & (node.bent == 0.0), absorbed_at + mean * to.z, node.left_at),
    };
    after.store()
}
