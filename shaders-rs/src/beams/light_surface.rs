//! Surface caustics: light of beams on the diffuse surface at the end of a viewing ray's present straight piece. The beams that end there are found in a
//! tree ([`super::tree`]).

use super::density::{depth_within, optical_depth};
use super::medium::transmittance;
use super::see::{level_of, piece_of};
use super::shade::{Ending, SAME, ending};
use super::store_beam::beam_of;
use super::trapezoid::filtered;
use super::tree::{Node, Tree, lanes};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Pencil, Sight, bundle, pencil, sight};
use crate::kernel::record;
use crate::math::{PI, absolute, cross, dot, length, max, min, select_vector};
use crate::voxels::shade::{facing, share};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// The least sine of the angle between the edges of a cross-section in whose coordinates it is filtered.
const WELL_SHAPED: f32 = 0.5;
/// The least width of a pixel's filter, over that of the cross-section.
const NARROW: f32 = 1e-3;

/// The level of work: whether the ray has come to a new piece in this round.
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
    _corners: &[f32],
    _looks: &[f32],
    _materials: &[f32],
) -> u32 {
    level_of(x, y, u, pencils)
}

/// Whether the box of the ends of a node's beams holds a point, or comes near it.
#[inline(always)]
fn ends_at(bundles: &[f32], tree: &Tree, node: Node, point: Vec3, margin: f32) -> bool {
    let of = |component: usize| tree.vector(bundles, node, component);
    is_near(of(bundle::END_LOW), of(bundle::END_HIGH), point, margin)
}

/// Whether a box holds a point, or comes near it.
#[inline(always)]
fn is_near(low: Vec3, high: Vec3, point: Vec3, margin: f32) -> bool {
    let x = (point.x >= low.x - margin) & (point.x <= high.x + margin);
    let y = (point.y >= low.y - margin) & (point.y <= high.y + margin);
    let z = (point.z >= low.z - margin) & (point.z <= high.z + margin);
    (low.x <= high.x) & x & y & z
}

/// A bit for each texel of a node of the tree's lowest level whose beam may end at a point.
#[inline(always)]
fn ending_at(u: &BeamsUniforms, bundles: &[f32], tree: &Tree, node: Node, point: Vec3, margin: f32) -> u32 {
    let mut near = 0;
    let lanes = if tree.has_lanes(bundles, node) { lanes() } else { 0 };
    let mut lane = 0;
    while lane < lanes {
        // SAFETY: there are records for all lanes, and both components are those of a record.
        let of = |component: usize| unsafe { tree.vector_of_lane(bundles, node, lane, component) };
        let is_near = is_near(of(bundle::END_LOW), of(bundle::END_HIGH), point, margin);
        let is_texel = tree.texel(node, lane, u.lattice.count).is_texel;
        near |= ((is_texel & is_near) as u32) << lane;
        lane += 1;
    }
    near
}

/// A parallelogram on a surface, and coordinates in it, along its two edges.
#[derive(Clone, Copy)]
struct Frame {
    normal: Vec3,
    first: Vec3,
    second: Vec3,
    /// 1 / area, with the sign of the edges' orientation.
    inverse: f32,
}

impl Frame {
    #[inline(always)]
    fn new(normal: Vec3, first: Vec3, second: Vec3) -> Self {
        Self { normal, first, second, inverse: 1.0 / dot(cross(first, second), normal) }
    }

    /// The coordinates of a vector on the surface.
    #[inline(always)]
    fn of(&self, v: Vec3) -> (f32, f32) {
        let along = dot(cross(v, self.second), self.normal) * self.inverse;
        (along, dot(cross(self.first, v), self.normal) * self.inverse)
    }
}

/// The density of a beam's flux on a surface, averaged over a pixel: the cross-section on the surface, a parallelogram with the edges `first` and `second`
/// around 0, filtered by the pixel's own around `offset`, whose edges are `u` and `v`.
#[inline(always)]
fn density(n: Vec3, first: Vec3, second: Vec3, offset: Vec3, u: Vec3, v: Vec3) -> f32 {
    let (length_first, length_second) = (length(first), length(second));
    let pixel = Frame::new(n, u, v);
    let ((first_x, first_y), (second_x, second_y)) = (pixel.of(first), pixel.of(second));
    let (across_x, across_y) = (absolute(first_x) + absolute(second_x), absolute(first_y) + absolute(second_y));
    if (across_x < 1.0) & (across_y < 1.0) {
        // Smaller than a pixel: the shares of neighbouring pixels add up to 1.
        let (x, y) = pixel.of(offset);
        let shares = filtered(x, absolute(first_x), absolute(second_x), 1.0)
            * filtered(y, absolute(first_y), absolute(second_y), 1.0);
        return shares * absolute(pixel.inverse);
    }
    let texel = Frame::new(n, first, second);
    if absolute(dot(cross(first, second), n)) > WELL_SHAPED * length_first * length_second {
        // Coordinates in texels, in which the cross-section is a square: those of neighbours meet without a gap.
        let ((x, y), (u_x, u_y), (v_x, v_y)) = (texel.of(offset), texel.of(u), texel.of(v));
        let width_x = max(max(absolute(u_x), absolute(v_x)), NARROW);
        let width_y = max(max(absolute(u_y), absolute(v_y)), NARROW);
        filtered(x, 1.0, 0.0, width_x) * filtered(y, 1.0, 0.0, width_y) * absolute(texel.inverse)
    } else {
        // At a caustic's edge the cross-section is a thin line: along it and across.
        let is_first = length_first >= length_second;
        let (long, other) = (select_vector(is_first, first, second), select_vector(is_first, second, first));
        let size = length(long);
        let along = long * (1.0 / max(size, 1e-30));
        let across = cross(n, along);
        let width_x = max(max(absolute(dot(u, along)), absolute(dot(v, along))), NARROW * size);
        let width_y = max(max(absolute(dot(u, across)), absolute(dot(v, across))), NARROW * size);
        filtered(dot(offset, along), size, absolute(dot(other, along)), width_x)
            * filtered(dot(offset, across), absolute(dot(other, across)), 0.0, width_y)
    }
}

/// Irradiance over π of a point of a surface by a beam, RGB, times the share of it that the point sends back.
#[inline(always)]
fn shining(u: &BeamsUniforms, beam: &Beam, end: &Ending, direction: Vec3, pencil: &Pencil, materials: &[f32]) -> Vec3 {
    let none = Vec3::new(0.0, 0.0, 0.0);
    let n = end.point.plane;
    let d = beam.direction;
    let facing_light = dot(n, d);
    if absolute(facing_light) < 1e-6 {
        return none;
    }
    let inverse = 1.0 / facing_light;
    let s = dot(n, end.point.position - beam.position) * inverse;
    let on_plane = |v: Vec3| v - d * (dot(n, v) * inverse);
    let first = on_plane(beam.position_u + beam.direction_u * s);
    let second = on_plane(beam.position_v + beam.direction_v * s);
    let (u_edge, v_edge) = (pencil.position_u, pencil.position_v);
    // Across the beam and the pixel the surface is nearer or farther by as much.
    let deep = 0.5 * (absolute(dot(first, d)) + absolute(dot(second, d)))
        + absolute(dot(u_edge, d))
        + absolute(dot(v_edge, d));
    if (s < -SAME - deep) | (absolute(s - beam.reach) > deep + SAME) {
        return none;
    }
    let offset = end.point.position - (beam.position + d * s);
    let density = density(n, first, second, offset, u_edge, v_edge);
    if density <= 0.0 {
        return none;
    }
    let fog = depth_within(&u.medium, materials, beam.position, d, 0.0, min(s, beam.length));
    // At most four times as much as on the plane, where normals between corners lean to the light.
    let cosine = max(absolute(facing_light), 0.25 * absolute(dot(end.point.normal, d)));
    let strength = share(&end.point, facing(&end.point, direction), direction, d) / cosine;
    beam.flux * transmittance(&u.medium, fog) * (density * strength * (1.0 / PI))
}

/// What the pixel sees, with the light of a round's beams on the surface.
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
    corners: &[f32],
    looks: &[f32],
    materials: &[f32],
) -> [f32; sight::SIZE] {
    let mut seen = Sight::load(&before);
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let piece = piece_of(x, y, u, &pencil);
    let d = pencil.direction;
    let end = ending(u, &pencil, &piece, corners, looks, materials);
    if !end.is_diffuse {
        return before;
    }
    let mut at_end = pencil;
    at_end.set_spread(pencil.spread().moved(pencil.distance).on_plane(d, end.point.plane));
    // A beam shines on the pixel where any of the pixel is in its cross-section.
    let margin = SAME + 0.5 * (length(at_end.position_u) + length(at_end.position_v));
    let texels = (u.lattice.count * u.lattice.count) as i32;
    let mut light = Vec3::new(0.0, 0.0, 0.0);
    let first = (u.limits.lit * u.limits.pitch) as i32;
    let tree = Tree::of_round(u, u.limits.lit);
    let mut node = tree.first();
    while tree.holds(node) {
        let met = ends_at(bundles, &tree, node, end.point.position, margin);
        if met & (node.level > tree.lowest()) {
            node = node.below();
        } else {
            let near = if met { ending_at(u, bundles, &tree, node, end.point.position, margin) } else { 0 };
            let mut lane = 0;
            while near >> lane != 0 {
                if (near >> lane) & 1 != 0 {
                    let beam = beam_of(beams, first, tree.texel(node, lane, u.lattice.count).number, texels);
                    light += shining(u, &beam, &end, d, &at_end, materials);
                }
                lane += 1;
            }
            node = node.behind(tree.root);
        }
    }
    // No beam of most rounds shines on most points.
    if (light.x + light.y) + light.z <= 0.0 {
        return before;
    }
    let dimmed = transmittance(&u.medium, optical_depth(&u.medium, materials, piece.from, d, 0.0, piece.far));
    seen.radiance += light * end.point.color * dimmed * piece.weight;
    seen.store()
}
