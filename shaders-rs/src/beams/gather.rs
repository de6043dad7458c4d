//! Light of beams behind the first surface of a viewing ray: what the medium scatters into the ray's present straight piece. The pictures of beams are
//! not straight there, and the beams near the ray are found in a tree ([`super::tree`]).

use super::bend::mean;
use super::density::{density_at, depth_within};
use super::medium::{inside, phase, transmittance};
use super::nearest::Nearest;
use super::see::{LEAST, level_of, piece_of};
use super::store_beam::beam_of;
use super::trapezoid::filtered;
use super::tree::{Node, Tree, lanes};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Pencil, Sight, bundle, pencil, sight};
use crate::kernel::record;
use crate::math::{absolute, absolute_vector, cross, dot, length, max, min, select, xyz};
use crate::voxels::ray::reciprocal;
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
    /// 1 over the speeds along the axes at which the upper edge of the pixel's cone rises, and its lower edge.
    inverse_upper: Vec3,
    inverse_lower: Vec3,
    near: f32,
    far: f32,
    /// Half the width of the pixel's pencil where the piece begins, in voxels.
    width: f32,
    /// Half the angle by which it opens, radians.
    opening: f32,
}

/// A part of a line.
#[derive(Clone, Copy)]
struct Part {
    enters: f32,
    leaves: f32,
}

impl Part {
    /// The part of it on which a function that is 0 at the line's beginning, and rises by 1 / `inverse` along it, is at least `least`.
    #[inline(always)]
    fn above(self, inverse: f32, least: f32) -> Self {
        let at = least * inverse;
        let rises = inverse > 0.0;
        Self {
            enters: select(rises, max(self.enters, at), self.enters),
            leaves: select(rises, self.leaves, min(self.leaves, at)),
        }
    }
}

/// Boxes around the beams of a node.
struct Bounds {
    low: Vec3,
    high: Vec3,
    position: Vec3,
    position_half: Vec3,
    direction: Vec3,
    direction_half: Vec3,
}

impl Bounds {
    /// The bounds of a node.
    #[inline(always)]
    fn of_node(bundles: &[f32], tree: &Tree, node: Node) -> Self {
        let of = |component: usize| tree.vector(bundles, node, component);
        Self {
            low: of(bundle::LOW),
            high: of(bundle::HIGH),
            position: of(bundle::POSITION),
            position_half: of(bundle::POSITION_HALF),
            direction: of(bundle::DIRECTION),
            direction_half: of(bundle::DIRECTION_HALF),
        }
    }

    /// The bounds of a texel, by its lane in a node of the lowest level, for all of which there are records.
    #[inline(always)]
    fn of_lane(bundles: &[f32], tree: &Tree, node: Node, lane: u32) -> Self {
        // SAFETY: there are records for all lanes, and all components are those of a record.
        let of = |component: usize| unsafe { tree.vector_of_lane(bundles, node, lane, component) };
        Self {
            low: of(bundle::LOW),
            high: of(bundle::HIGH),
            position: of(bundle::POSITION),
            position_half: of(bundle::POSITION_HALF),
            direction: of(bundle::DIRECTION),
            direction_half: of(bundle::DIRECTION_HALF),
        }
    }

    /// Whether a line comes into the box of the beams, or passes it within the pixel's own width.
    #[inline(always)]
    fn is_reached(&self, line: &Line) -> bool {
        let width = Vec3::new(line.width, line.width, line.width);
        let (low, high) = (self.low - line.from - width, self.high - line.from + width);
        let (upper, lower) = (line.inverse_upper, line.inverse_lower);
        let part = Part { enters: line.near, leaves: line.far };
        let part = part.above(upper.x, low.x).above(-lower.x, -high.x);
        let part = part.above(upper.y, low.y).above(-lower.y, -high.y);
        let part = part.above(upper.z, low.z).above(-lower.z, -high.z);
        (self.low.x <= self.high.x) & (part.enters <= part.leaves)
    }

    /// Whether a line comes near any of the beams, as far as boxes tell. The edge function w · ((P − O) × d) of a beam that begins at P must be within what it
    /// changes over the boxes of positions and directions.
    #[inline(always)]
    fn comes_near(&self, line: &Line) -> bool {
        let (position_half, direction_half) = (self.position_half, self.direction_half);
        let offset = self.position - line.from;
        let by_position = cross(self.direction, line.direction);
        let by_direction = cross(line.direction, offset);
        let edge = dot(offset, by_position);
        let changes = dot(absolute_vector(by_position), position_half)
            + dot(absolute_vector(by_direction), direction_half)
            + length(position_half) * length(direction_half);
        // The pixel's own width, as if the eye were as far away as the beams.
        let pixel = line.width + line.opening * (length(offset) + length(position_half));
        absolute(edge) <= changes + pixel
    }
}

/// Whether a line comes near any beam of a node.
#[inline(always)]
fn comes_near(bundles: &[f32], tree: &Tree, node: Node, line: &Line) -> bool {
    let bounds = Bounds::of_node(bundles, tree, node);
    if bounds.is_reached(line) { bounds.comes_near(line) } else { false }
}

/// A bit for each texel of a node of the tree's lowest level whose beam a line comes near.
#[inline(always)]
fn near_beams(u: &BeamsUniforms, bundles: &[f32], tree: &Tree, node: Node, line: &Line) -> u32 {
    let mut near = 0;
    let lanes = if tree.has_lanes(bundles, node) { lanes() } else { 0 };
    let mut lane = 0;
    while lane < lanes {
        let bounds = Bounds::of_lane(bundles, tree, node, lane);
        let is_texel = tree.texel(node, lane, u.lattice.count).is_texel;
        let is_near = is_texel & bounds.is_reached(line) & bounds.comes_near(line);
        near |= (is_near as u32) << lane;
        lane += 1;
    }
    near
}

/// Of the beams of a node of the tree's lowest level that a line comes near, by their bits, those that it meets: each of the others would be looked at alone.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
fn met_beams(
    u: &BeamsUniforms,
    beams: &[f32],
    first: i32,
    (tree, node): (&Tree, Node),
    line: &Line,
    pencil: &Pencil,
) -> u32 {
    let count = (u.lattice.count * u.lattice.count) as i32;
    let mut met = 0;
    let lanes = lanes();
    let mut lane = 0;
    while lane < lanes {
        let beam = beam_of(beams, first, tree.texel(node, lane, u.lattice.count).number, count);
        met |= (Crossing::new(&beam, line, pencil).is_met as u32) << lane;
        lane += 1;
    }
    met
}

/// A line's place in a beam.
struct Crossing {
    /// Whether the pixel of the line sees any of the beam.
    is_met: bool,
    edge: f32,
    /// Widths of the beam's cross-section across the line.
    first: f32,
    second: f32,
    /// Width of the pixel.
    filter: f32,
    nearest: Nearest,
}

impl Crossing {
    #[inline(always)]
    fn new(beam: &Beam, line: &Line, pencil: &Pencil) -> Self {
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
        let nearest = Nearest::new(offset, w, d);
        let Nearest { t, s, .. } = nearest;
        let meets = (s >= 0.0) & (s < beam.length) & (t > line.near) & (t < line.far);
        let is_met = (absolute(edge) <= 0.5 * (first + second + filter)) & meets;
        Self { is_met, edge, first, second, filter, nearest }
    }
}

/// Radiance that a beam scatters into a line, RGB, dimmed from the line's beginning in the medium on.
#[inline(always)]
fn scattered(u: &BeamsUniforms, beam: &Beam, line: &Line, pencil: &Pencil, materials: &[f32]) -> Vec3 {
    let (w, d) = (line.direction, beam.direction);
    let Crossing { is_met, edge, first, second, filter, nearest } = Crossing::new(beam, line, pencil);
    if !is_met {
        return Vec3::new(0.0, 0.0, 0.0);
    }
    let Nearest { t, s, cosine } = nearest;
    let medium = &u.medium;
    let before = depth_within(medium, materials, beam.position, d, 0.0, s);
    let behind = depth_within(medium, materials, line.from, w, line.near, t);
    let dense = if medium.nodes == 0 { 1.0 } else { density_at(medium, materials, line.from + w * t) };
    let dimmed = transmittance(medium, before + behind);
    let strength = phase(medium, materials, -cosine) * filtered(edge, first, second, filter) * dense;
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
    let opening = 0.5 * (length(pencil.direction_u) + length(pencil.direction_v));
    let line = Line {
        from: piece.from,
        direction: d,
        inverse_upper: Vec3::new(reciprocal(d.x + opening), reciprocal(d.y + opening), reciprocal(d.z + opening)),
        inverse_lower: Vec3::new(reciprocal(d.x - opening), reciprocal(d.y - opening), reciprocal(d.z - opening)),
        near: fog.enters,
        far: fog.leaves,
        width: 0.5 * (length(pencil.position_u) + length(pencil.position_v)),
        opening,
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
            let met = comes_near(bundles, &tree, node, &line);
            if met & (node.level > tree.lowest()) {
                node = node.below();
            } else {
                let near = if met { near_beams(u, bundles, &tree, node, &line) } else { 0 };
                #[cfg(not(target_arch = "spirv"))]
                let near = if near == 0 { 0 } else { near & met_beams(u, beams, first, (&tree, node), &line, &pencil) };
                let mut lane = 0;
                while near >> lane != 0 {
                    if (near >> lane) & 1 != 0 {
                        let texel = tree.texel(node, lane, u.lattice.count);
                        let beam = beam_of(beams, first, texel.number, texels);
                        let light = scattered(u, &beam, &line, &pencil, materials);
                        caustics += light * select(is_shadow, 0.0, 1.0);
                        shadow += light * select(is_shadow, 1.0, 0.0);
                    }
                    lane += 1;
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
