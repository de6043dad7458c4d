//! Surface caustics: light of beams on the diffuse surface at the end of a viewing ray's present straight piece. The beams that end there are found in a
//! tree ([`super::tree`]).

use super::density::{depth_within, optical_depth};
use super::medium::transmittance;
use super::see::{level_of, piece_of};
use super::shade::{Ending, SAME, ending};
use super::store_beam::beam_of;
use super::trapezoid::filtered;
use super::tree::{Node, Tree};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Pencil, Sight, bundle, pencil, sight};
use crate::kernel::record;
use crate::math::{PI, absolute, cross, dot, max, min};
use crate::voxels::shade::{facing, share};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

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
    let (low, high) = (of(bundle::END_LOW), of(bundle::END_HIGH));
    let x = (point.x >= low.x - margin) & (point.x <= high.x + margin);
    let y = (point.y >= low.y - margin) & (point.y <= high.y + margin);
    let z = (point.z >= low.z - margin) & (point.z <= high.z + margin);
    (low.x <= high.x) & x & y & z
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
    // Across the beam the surface is nearer or farther by as much.
    let deep = 0.5 * (absolute(dot(first, d)) + absolute(dot(second, d)));
    if (s < -SAME) | (absolute(s - beam.reach) > deep + SAME) {
        return none;
    }
    let area = dot(cross(first, second), n);
    let wide = absolute(area);
    if wide < 1e-12 {
        return none;
    }
    let offset = end.point.position - (beam.position + d * s);
    // Coordinates across the beam, in texels.
    let across = |v: Vec3| (dot(cross(v, second), n) / area, dot(cross(first, v), n) / area);
    let (x, y) = across(offset);
    let (pixel_u, pixel_v) = (across(pencil.position_u), across(pencil.position_v));
    let width_x = max(max(absolute(pixel_u.0), absolute(pixel_v.0)), 1e-3);
    let width_y = max(max(absolute(pixel_u.1), absolute(pixel_v.1)), 1e-3);
    if (absolute(x) > 0.5 * (1.0 + width_x)) | (absolute(y) > 0.5 * (1.0 + width_y)) {
        return none;
    }
    let density = filtered(x, 1.0, 1e-4, width_x) * filtered(y, 1.0, 1e-4, width_y) / wide;
    let fog = depth_within(&u.medium, materials, beam.position, d, 0.0, min(s, beam.length));
    // At most four times as much as on the plane, where normals between corners lean to the light.
    let cosine = max(absolute(facing_light), 0.25 * absolute(dot(end.point.normal, d)));
    let strength = share(&end.point, facing(&end.point, direction), direction, d) / cosine;
    beam.flux * transmittance(&u.medium, fog) * (density * strength * (1.0 / PI))
}

/// What the pixel sees, with the light of beams on the surface.
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
    let texels = (u.lattice.count * u.lattice.count) as i32;
    let mut light = Vec3::new(0.0, 0.0, 0.0);
    // Round 0 has the shadow, which the search for light finds sharper.
    let mut round = 1;
    while round <= u.limits.last {
        let first = (round * u.limits.pitch) as i32;
        let tree = Tree::of_round(u, round);
        let mut node = tree.first();
        while tree.holds(node) {
            let met = ends_at(bundles, &tree, node, end.point.position, SAME);
            if met & (node.level > 0) {
                node = node.below();
            } else {
                if met {
                    let (column, row) = node.place();
                    let beam = beam_of(beams, first, (row * u.lattice.count + column) as i32, texels);
                    light += shining(u, &beam, &end, d, &at_end, materials);
                }
                node = node.behind(tree.root);
            }
        }
        round += 1;
    }
    let dimmed = transmittance(&u.medium, optical_depth(&u.medium, materials, piece.from, d, 0.0, piece.far));
    seen.radiance += light * end.point.color * dimmed * piece.weight;
    seen.store()
}
