//! Light of beams behind the first surface of a viewing ray: what the medium scatters into the ray's present straight piece. The pictures of beams are
//! not straight there, and the beams near the ray are found in a tree ([`super::tree`]).

use super::bend::mean;
use super::density::{density_at, depth_within};
use super::medium::{inside, phase, transmittance};
use super::nearest::Nearest;
use super::see::{LEAST, level_of, piece_of};
use super::store_beam::beam_of;
use super::trapezoid::filtered;
use super::tree::{Node, Tree};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Pencil, Sight, beam, bundle, pencil, sight};
use crate::field::access::read;
use crate::kernel::record;
use crate::math::{absolute, absolute_vector, cross, dot, length, max, min, select, xyz};
use crate::voxels::ray::{reciprocal, slab};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// The level of work: whether the ray has come to a new piece in this round, behind a surface.
#[inline(always)]
pub fn level(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    _before: [f32; sight::SIZE],
    pencils: &[f32],
    _beams: &[f32],
    _bundles: &[f32],
    _materials: &[f32],
) -> u32 {
    level_of(x, y, u, pencils)
}

/// A piece of a viewing ray in the medium.
#[derive(Clone, Copy)]
struct Line {
    from: Vec3,
    direction: Vec3,
    inverse: Vec3,
    near: f32,
    far: f32,
    /// Half the width of the pixel's pencil where the piece begins, in voxels.
    width: f32,
    /// Half the angle by which it opens, radians.
    opening: f32,
}

/// Whether a line comes near any beam of a node, as far as boxes tell. The edge function w · ((P − O) × d) of a beam that begins at P must be within what it
/// changes over the boxes of positions and directions.
#[inline(always)]
fn comes_near(bundles: &[f32], tree: &Tree, node: Node, line: &Line) -> bool {
    let of = |component: usize| tree.vector(bundles, node, component);
    let (low, high) = (of(bundle::LOW), of(bundle::HIGH));
    let (enters, leaves) = slab(line.from, line.inverse, low, high);
    let reached = (low.x <= high.x) & (max(enters, line.near) <= min(leaves, line.far));
    if reached {
        let (position, position_half) = (of(bundle::POSITION), of(bundle::POSITION_HALF));
        let (direction, direction_half) = (of(bundle::DIRECTION), of(bundle::DIRECTION_HALF));
        let offset = position - line.from;
        let by_position = cross(direction, line.direction);
        let by_direction = cross(line.direction, offset);
        let edge = dot(offset, by_position);
        let changes = dot(absolute_vector(by_position), position_half)
            + dot(absolute_vector(by_direction), direction_half)
            + length(position_half) * length(direction_half);
        // The pixel's own width, as if the eye were as far away as the beams.
        let pixel = line.width + line.opening * (length(offset) + length(position_half));
        absolute(edge) <= changes + pixel
    } else {
        false
    }
}

/// Whether a line comes near beam number `number` of `count`: as for a node, by a sphere and a cone around the beam.
#[inline(always)]
fn comes_near_beam(beams: &[f32], first: i32, number: i32, count: i32, line: &Line) -> bool {
    let component = |component: usize| read(beams, first + component as i32 * count + number);
    let vector = |at: usize| Vec3::new(component(at), component(at + 1), component(at + 2));
    let (position, direction) = (vector(beam::POSITION), vector(beam::DIRECTION));
    let offset = position - line.from;
    let edge = dot(line.direction, cross(offset, direction));
    let far = length(offset);
    let radius = component(beam::RADIUS) + line.width;
    absolute(edge) <= radius + (component(beam::OPENING) + line.opening) * far
}

/// Radiance that a beam scatters into a line, RGB, dimmed from the line's beginning in the medium on.
#[inline(always)]
fn scattered(u: &BeamsUniforms, beam: &Beam, line: &Line, pencil: &Pencil, materials: &[f32]) -> Vec3 {
    let offset = beam.position - line.from;
    let (w, d) = (line.direction, beam.direction);
    let moment = cross(offset, d);
    let edge = dot(w, moment);
    let change = |position: Vec3, direction: Vec3| dot(w, cross(position, d) + cross(offset, direction));
    let first = absolute(change(beam.position_u, beam.direction_u));
    let second = absolute(change(beam.position_v, beam.direction_v));
    // The change of the edge function from pixel to pixel.
    let moved = |position: Vec3, direction: Vec3| dot(direction, moment) - dot(w, cross(position, d));
    let filter = max(
        absolute(moved(pencil.position_u, pencil.direction_u)),
        absolute(moved(pencil.position_v, pencil.direction_v)),
    );
    let filter = max(filter, 1e-12);
    let none = Vec3::new(0.0, 0.0, 0.0);
    if absolute(edge) > 0.5 * (first + second + filter) {
        return none;
    }
    let Nearest { t, s, cosine } = Nearest::new(offset, w, d);
    let meets = (s >= 0.0) & (s < beam.length) & (t > line.near) & (t < line.far);
    if !meets {
        return none;
    }
    let medium = &u.medium;
    let before = depth_within(medium, materials, beam.position, d, 0.0, s);
    let behind = depth_within(medium, materials, line.from, w, line.near, t);
    let dense = if medium.nodes == 0 { 1.0 } else { density_at(medium, materials, line.from + w * t) };
    let dimmed = transmittance(medium, before + behind);
    let strength = phase(medium, -cosine) * filtered(edge, first, second, filter) * dense;
    beam.flux * dimmed * xyz(u.medium.scattering) * strength
}

/// What the pixel sees, with the light of beams on the piece.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; sight::SIZE],
    pencils: &[f32],
    beams: &[f32],
    bundles: &[f32],
    materials: &[f32],
) -> [f32; sight::SIZE] {
    let mut seen = Sight::load(&before);
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let piece = piece_of(x, y, u, &pencil);
    let d = pencil.direction;
    let fog = inside(&u.medium, piece.from, d, 0.0, piece.far);
    // The first piece's beams are drawn.
    if (pencil.bounces == 0) | (fog.leaves <= fog.enters) | (mean(piece.weight) < LEAST) {
        return before;
    }
    let line = Line {
        from: piece.from,
        direction: d,
        inverse: Vec3::new(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z)),
        near: fog.enters,
        far: fog.leaves,
        width: 0.5 * (length(pencil.position_u) + length(pencil.position_v)),
        opening: 0.5 * (length(pencil.direction_u) + length(pencil.direction_v)),
    };
    let texels = (u.lattice.count * u.lattice.count) as i32;
    let mut caustics = Vec3::new(0.0, 0.0, 0.0);
    let mut shadow = Vec3::new(0.0, 0.0, 0.0);
    let mut round = 0;
    while round <= u.limits.last {
        let first = (round * u.limits.pitch) as i32;
        let tree = Tree::of_round(u, round);
        let is_shadow = round == 0;
        let mut node = tree.first();
        while tree.holds(node) {
            let (column, row) = node.place();
            let there = (column < u.lattice.count) & (row < u.lattice.count);
            let number = if there { (row * u.lattice.count + column) as i32 } else { 0 };
            let met = if node.level > 0 {
                comes_near(bundles, &tree, node, &line)
            } else {
                there & comes_near_beam(beams, first, number, texels, &line)
            };
            if met & (node.level > 0) {
                node = node.below();
            } else {
                if met {
                    let light = scattered(u, &beam_of(beams, first, number, texels), &line, &pencil, materials);
                    caustics += light * select(is_shadow, 0.0, 1.0);
                    shadow += light * select(is_shadow, 1.0, 0.0);
                }
                node = node.behind(tree.root);
            }
        }
        round += 1;
    }
    seen.caustics += caustics * piece.weight;
    seen.shadow += shadow * piece.weight;
    seen.store()
}
