//! Light of beams on the present straight piece of a viewing ray: what the medium scatters into the ray behind the first surface, where the pictures
//! of beams are not straight, and surface caustics where the piece ends at a diffuse surface (gathered through the tree over beams).

use super::medium::{inside, phase, transmittance};
use super::see::{level_of, piece_of};
use super::shade::{Ending, ending};
use super::store_beam::beam_of;
use super::tree::{Node, ROW, place_in, rows, top, vector};
use super::trapezoid::filtered;
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Beam, Pencil, Sight, bundle, pencil, sight};
use crate::kernel::record;
use crate::math::{PI, absolute, cross, dot, length, max, min, select, select_vector, xyz};
use crate::voxels::ray::{reciprocal, slab};
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

/// The tree of a round.
#[derive(Clone, Copy)]
struct Tree {
    /// The level of its root.
    root: u32,
    /// The first float of its records.
    first: u32,
    /// The number of its records.
    count: u32,
}

/// Whether a line comes near any beam of a node, as far as boxes tell. The edge function w · ((P − O) × d) of a beam that begins at P must be within what it
/// changes over the boxes of positions and directions.
#[inline(always)]
fn comes_near(bundles: &[f32], tree: &Tree, node: Node, line: &Line) -> bool {
    let at = place_in(tree.root, node);
    let of = |component: usize| vector(bundles, tree.first, tree.count, at, component);
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
        let changes = dot(sizes(by_position), position_half)
            + dot(sizes(by_direction), direction_half)
            + length(position_half) * length(direction_half);
        // The pixel's own width, as if the eye were as far away as the beams.
        let pixel = line.width + line.opening * (length(offset) + length(position_half));
        absolute(edge) <= changes + pixel
    } else {
        false
    }
}

#[inline(always)]
fn sizes(v: Vec3) -> Vec3 {
    Vec3::new(absolute(v.x), absolute(v.y), absolute(v.z))
}

/// Whether the box of the ends of a node's beams holds a point, or comes near it.
#[inline(always)]
fn ends_at(bundles: &[f32], tree: &Tree, node: Node, point: Vec3, margin: f32) -> bool {
    let at = place_in(tree.root, node);
    let of = |component: usize| vector(bundles, tree.first, tree.count, at, component);
    let (low, high) = (of(bundle::END_LOW), of(bundle::END_HIGH));
    let x = (point.x >= low.x - margin) & (point.x <= high.x + margin);
    let y = (point.y >= low.y - margin) & (point.y <= high.y + margin);
    let z = (point.z >= low.z - margin) & (point.z <= high.z + margin);
    (low.x <= high.x) & x & y & z
}

/// Radiance that a beam scatters into a line, RGB, dimmed from the line's beginning in the medium on.
#[inline(always)]
fn scattered(u: &BeamsUniforms, beam: &Beam, line: &Line, pencil: &Pencil) -> Vec3 {
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
    let (along_view, along_light, cosine) = (dot(offset, w), dot(offset, d), dot(w, d));
    let normal = cross(w, d);
    let inverse = 1.0 / max(dot(normal, normal), 1e-9);
    let t = (along_view - cosine * along_light) * inverse;
    let s = (cosine * along_view - along_light) * inverse;
    let meets = (s >= 0.0) & (s < beam.length) & (t > line.near) & (t < line.far);
    let dimmed = transmittance(&u.medium, s + (t - line.near));
    let strength = phase(&u.medium, -cosine) * filtered(edge, first, second, filter);
    select_vector(meets, beam.flux * dimmed * xyz(u.medium.scattering) * strength, none)
}

/// Irradiance over π of a point of a surface by a beam, RGB, times the share of it that the point sends back.
#[inline(always)]
fn shining(u: &BeamsUniforms, beam: &Beam, end: &Ending, direction: Vec3, pencil: &Pencil) -> Vec3 {
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
    if (s < -end.tolerance) | (absolute(s - beam.reach) > deep + end.tolerance) {
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
    let fog = min(s, beam.length);
    // At most four times as much as on the plane, where normals between corners lean to the light.
    let cosine = max(absolute(facing_light), 0.25 * absolute(dot(end.point.normal, d)));
    let strength = share(&end.point, facing(&end.point, direction), direction, d) / cosine;
    beam.flux * transmittance(&u.medium, fog) * (density * strength * (1.0 / PI))
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
    corners: &[f32],
    looks: &[f32],
    materials: &[f32],
) -> [f32; sight::SIZE] {
    let mut seen = Sight::load(&before);
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let piece = piece_of(x, y, u, &pencil);
    let fog = inside(&u.medium, piece.from, pencil.direction, 0.0, piece.far);
    let d = pencil.direction;
    let line = Line {
        from: piece.from,
        direction: d,
        inverse: Vec3::new(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z)),
        near: fog.enters,
        far: fog.leaves,
        width: 0.5 * (length(pencil.position_u) + length(pencil.position_v)),
        opening: 0.5 * (length(pencil.direction_u) + length(pencil.direction_v)),
    };
    // The first piece's beams are drawn.
    let looks_through = (pencil.bounces > 0) & (fog.leaves > fog.enters);
    let end = ending(u, &pencil, &piece, corners, looks, materials);
    let texels = (u.lattice.count * u.lattice.count) as i32;
    let root = top(u.lattice.count);
    let mut caustics = Vec3::new(0.0, 0.0, 0.0);
    let mut shadow = Vec3::new(0.0, 0.0, 0.0);
    let mut surface = Vec3::new(0.0, 0.0, 0.0);
    let mut at_end = pencil;
    at_end.set_spread(pencil.spread().moved(pencil.distance).on_plane(d, end.point.plane));
    let mut round = 0;
    while round <= u.limits.last {
        let first = (round * u.limits.pitch) as i32;
        let tree = Tree { root, first: round * u.limits.bundle_pitch, count: rows(root) * ROW };
        let is_shadow = round == 0;
        let mut walk = 0;
        while walk < 2 {
            // First along the piece, then at its end. A node behind the root ends a walk.
            let along = walk == 0;
            let wanted = if along { looks_through } else { end.is_diffuse & !is_shadow };
            let mut node = Node { level: root, number: if wanted { 0 } else { 1 } };
            while (node.level < root) | (node.number == 0) {
                let met = if along {
                    comes_near(bundles, &tree, node, &line)
                } else {
                    ends_at(bundles, &tree, node, end.point.position, end.tolerance)
                };
                if met & (node.level > 0) {
                    node = node.below();
                } else {
                    if met {
                        let (column, row) = node.place();
                        let beam = beam_of(beams, first, (row * u.lattice.count + column) as i32, texels);
                        if along {
                            let light = scattered(u, &beam, &line, &pencil);
                            caustics += light * select(is_shadow, 0.0, 1.0);
                            shadow += light * select(is_shadow, 1.0, 0.0);
                        } else {
                            surface += shining(u, &beam, &end, d, &at_end);
                        }
                    }
                    node = node.behind(root);
                }
            }
            walk += 1;
        }
        round += 1;
    }
    seen.caustics += caustics * piece.weight;
    seen.shadow += shadow * piece.weight;
    let dimmed = transmittance(&u.medium, fog.leaves - fog.enters);
    seen.radiance += surface * end.point.color * dimmed * piece.weight;
    seen.store()
}
