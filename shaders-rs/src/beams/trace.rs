//! Pencils of light, and of viewing rays, through the triangles of meshes: from surface to surface along all ways on which a worthwhile part of
//! the flux goes (Hu et al. 2010, §5.1; the tree of ways: Whitted 1980).
//!
//! At each surface light is refracted and reflected. A pencil first takes the stronger one everywhere; then all ways with one turn, on which it takes the
//! weaker one once; then those with two turns, and so on, as long as there is a way with a worthwhile part of the flux. Each way starts at the
//! source, and the state of the search is two sets of bits: `turns`, and in `pending` the surfaces at which a turn is still to be tried. A
//! pencil pauses at the beginning of each straight piece in air that no way had before, where other kernels take it.

use super::bend::{facet_for, mean};
use super::density::optical_depth;
use super::emission::{self, Start};
use super::facet::Facet;
use super::medium::transmittance;
use super::viewing;
use crate::abi::beams::{BeamsUniforms, rays};
use crate::abi::light::kind;
use crate::abi::receivers::ahead;
use crate::abi::record::pencil::{SIZE, stage};
use crate::abi::record::{Path, Pencil};
use crate::abi::voxels::{AIR, STEPS};
use crate::math::{max, min, xyz};
use crate::optics::receiver::{FAR, first_ahead};
use crate::voxels::contact::{Contact, beyond, is_opaque, material_of};
use crate::voxels::ray::{CONTACT, attenuation, level, reciprocal, slab};
use crate::voxels::surface::ior;
use crate::voxels::trace_triangles::lowest;
use crate::voxels::tree;
use spirv_std::glam::Vec3;

/// The level of work of a pencil: whether it is to be followed in this round.
#[inline(always)]
pub fn level_of(u: &BeamsUniforms, before: &[f32; SIZE]) -> u32 {
    let pencil = Pencil::load(before);
    let waits = (pencil.stage == stage::PAUSED) & (pencil.pieces > u.limits.round as i32);
    if (pencil.stage == stage::DONE) | waits { level::ENDED } else { level::WORK }
}

/// The source's end of the ray of texel or pixel (x, y).
#[inline(always)]
fn start(x: u32, y: u32, u: &BeamsUniforms, mode: u32) -> Start {
    if mode == rays::LIGHT { emission::start(u, x as i32, y as i32) } else { viewing::start(u, x as i32, y as i32) }
}

/// The pencil at the beginning of a way: before it enters the box of all surfaces.
#[inline(always)]
fn begin(x: u32, y: u32, u: &BeamsUniforms, mode: u32, pencil: &mut Pencil, nodes: &[f32], materials: &[f32]) {
    let Start { position, direction, spread } = start(x, y, u, mode);
    let inverse = Vec3::new(reciprocal(direction.x), reciprocal(direction.y), reciprocal(direction.z));
    let (enters, leaves) = slab(position, inverse, xyz(u.low), xyz(u.high));
    // A distant light comes from any distance behind its plane.
    let endless = (mode == rays::LIGHT) & (u.light.kind == kind::DISTANT);
    let source = if endless { -FAR } else { 0.0 };
    let enters = max(enters, source);
    // A receiver in front of the box hides it.
    let receiver = first_ahead(&u.receivers, position, direction, CONTACT);
    let misses = (leaves <= enters) | ((mode == rays::VIEW) & (receiver.distance <= enters));
    let near = if misses { 0.0 } else { enters };
    pencil.position = position + direction * near;
    pencil.direction = direction;
    pencil.set_spread(spread.moved(near));
    pencil.transmittance = Vec3::new(1.0, 1.0, 1.0);
    pencil.media = 0;
    pencil.bounces = 0;
    pencil.stage = stage::UNDER_WAY;
    look_ahead(u, pencil, 0.0);
    // The fog between the source and the box.
    let fog = optical_depth(&u.medium, materials, position, direction, source, near);
    pencil.extinguished += pencil.attenuate(transmittance(&u.medium, fog));
    if misses {
        pencil.node = tree::count(nodes);
        // A light that meets no body has no beam.
        if mode == rays::LIGHT {
            pencil.stage = stage::DONE;
        }
    }
}

/// Looks for the receiver ahead; triangles behind the distance `start` are still to be looked for.
#[inline(always)]
fn look_ahead(u: &BeamsUniforms, pencil: &mut Pencil, start: f32) {
    pencil.start = start;
    pencil.enters = 0;
    pencil.leaves = 0;
    let receiver = first_ahead(&u.receivers, pencil.position, pencil.direction, CONTACT);
    pencil.node = 0;
    pencil.triangle = receiver.which;
    pencil.distance = receiver.distance;
}

/// The number of the highest bit that is set; `bits` must not be 0.
#[inline(always)]
fn highest_bit(bits: i32) -> i32 {
    ((bits as f32).to_bits() >> 23) as i32 - 127
}

/// Ends a way, and begins the next one: the one that turns where the last weaker way waits, else the first of those with one turn more.
#[inline(always)]
fn end(x: u32, y: u32, u: &BeamsUniforms, mode: u32, pencil: &mut Pencil, nodes: &[f32], materials: &[f32]) {
    if (pencil.pending == 0) & (pencil.deeper == 0) {
        pencil.stage = stage::DONE;
        return;
    }
    if pencil.pending == 0 {
        pencil.level += 1;
        pencil.deeper = 0;
        pencil.turns = 0;
        pencil.decided = 0;
    } else {
        let number = highest_bit(pencil.pending);
        let below = (1 << number) - 1;
        pencil.turns = (pencil.turns & below) | (1 << number);
        pencil.pending &= below;
        pencil.decided = number + 1;
    }
    begin(x, y, u, mode, pencil, nodes, materials);
}

/// The pencil after some nodes; `mode` is one of [`rays`].
#[inline(always)]
pub fn follow(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    mode: u32,
    before: [f32; SIZE],
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) -> [f32; SIZE] {
    let mut pencil = Pencil::load(&before);
    if pencil.stage == stage::NEW {
        begin(x, y, u, mode, &mut pencil, nodes, materials);
    }
    let count = tree::count(nodes);
    let mut paused = pencil.stage == stage::PAUSED;
    if paused {
        pencil.stage = stage::UNDER_WAY;
    }
    let mut step = 0;
    while (step < 4 * STEPS) & (pencil.stage == stage::UNDER_WAY) {
        step += 1;
        if pencil.node < count {
            visit(&mut pencil, u, nodes, corners, materials);
        } else {
            let from = lowest(pencil.media);
            if (from == AIR) & pencil.is_new() & !paused {
                pencil.stage = stage::PAUSED;
                pencil.pieces += 1;
            } else {
                paused = false;
                arrive(x, y, u, mode, &mut pencil, from, nodes, corners, materials);
            }
        }
    }
    pencil.store()
}

/// Visits the next node of the tree.
#[inline(always)]
fn visit(pencil: &mut Pencil, u: &BeamsUniforms, nodes: &[f32], corners: &[f32], materials: &[f32]) {
    let mut ray = Path::straight(pencil.position, pencil.direction);
    ray.node = pencil.node;
    ray.triangle = pencil.triangle;
    ray.distance = pencil.distance;
    ray.last_normal = Vec3::new(pencil.enters as f32, pencil.leaves as f32, pencil.start);
    ray.since = pencil.end;
    let mut contact = Contact::load(&ray, corners);
    contact.visit(&mut ray, pencil.media, u.limits.same_distance, nodes, corners, materials);
    pencil.node = ray.node;
    pencil.triangle = ray.triangle;
    pencil.distance = ray.distance;
    pencil.enters = contact.enters;
    pencil.leaves = contact.leaves;
    pencil.end = contact.end;
}

/// Takes the pencil to the end of its straight piece, and around the surface there.
#[inline(always)]
fn arrive(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    mode: u32,
    pencil: &mut Pencil,
    from: i32,
    nodes: &[f32],
    corners: &[f32],
    materials: &[f32],
) {
    let met = pencil.triangle >= 0;
    let way = max(pencil.distance - pencil.start, 0.0);
    let material = material_of(if met { pencil.triangle } else { 0 }, corners);
    let opaque = met & is_opaque(material, materials);
    let beyond = beyond(pencil.media, pencil.enters, pencil.leaves);
    let to = lowest(beyond);
    if from == AIR {
        let fog = optical_depth(&u.medium, materials, pencil.position, pencil.direction, 0.0, pencil.distance);
        pencil.extinguished += pencil.attenuate(transmittance(&u.medium, fog));
    } else {
        // Through the rest of a body whose surface has a hole, no light is taken to get.
        pencil.absorbed += pencil.attenuate(attenuation(from, min(way, 1e6), materials));
    }
    if !met | (opaque & (ior(material, materials) == 0.0)) {
        let left = if pencil.is_new() { mean(pencil.transmittance) } else { 0.0 };
        if pencil.triangle == ahead::NOTHING {
            pencil.escaped += left;
        } else {
            pencil.received += left;
        }
        end(x, y, u, mode, pencil, nodes, materials);
        return;
    }
    if !opaque & (from == to) {
        // Surfaces within a material that lies above theirs are not seen, and the way goes straight on.
        pencil.media = beyond;
        let behind = max(pencil.end, f32::MIN_POSITIVE);
        look_ahead(u, pencil, behind);
        return;
    }
    pencil.position += pencil.direction * pencil.distance;
    let facet = Facet::new(corners, pencil.triangle, pencil.position);
    let (index, other) = if opaque { (1.0, 1.0) } else { (ior(from, materials), ior(to, materials)) };
    let facet = facet_for(facet, pencil.direction, index, other);
    let spread = pencil.spread().moved(pencil.distance).on_plane(pencil.direction, facet.plane);
    pencil.set_spread(spread);
    if opaque {
        pencil.reflect(&facet, material, materials);
    } else {
        let threshold = if mode == rays::LIGHT { u.limits.threshold } else { u.limits.view_threshold };
        if pencil.cross(threshold, &facet, from, to, materials) {
            pencil.media = beyond;
        }
    }
    look_ahead(u, pencil, 0.0);
    if pencil.bounces > u.limits.bounces as i32 {
        pencil.lost += if pencil.is_new() { mean(pencil.transmittance) } else { 0.0 };
        end(x, y, u, mode, pencil, nodes, materials);
    }
}
