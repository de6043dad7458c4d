//! Light of beams on the present straight piece of a viewing ray: what the medium scatters into the ray behind the first surface, where the pictures
//! of beams are not straight, and surface caustics where the piece ends at a diffuse surface (gathered through the tree over beams).

use super::medium::{inside, phase, transmittance};
use super::see::{level_of, piece_of};
use super::shade::{Ending, ending};
use super::store_beam::beam_of;
use super::tree::{Bounds, Node, bounds_of, top};
use super::trapezoid::filtered;
use crate::abi::beams::{BeamsUniforms, ENDS, PIECES, TREES};
use crate::abi::record::{Beam, Pencil, Sight, pencil, sight};
use crate::kernel::record;
use crate::math::{PI, absolute, cross, dot, max, min, select, select_vector, xyz};
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
    _bounds: &[f32],
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
}

/// Whether a line comes through a box.
#[inline(always)]
fn comes_through(line: &Line, bounds: &Bounds) -> bool {
    let (enters, leaves) = slab(line.from, line.inverse, bounds.low, bounds.high);
    (bounds.low.x <= bounds.high.x) & (max(enters, line.near) <= min(leaves, line.far))
}

/// Whether a box holds a point, or comes near it.
#[inline(always)]
fn holds(bounds: &Bounds, point: Vec3, margin: f32) -> bool {
    let (low, high) = (bounds.low, bounds.high);
    let x = (point.x >= low.x - margin) & (point.x <= high.x + margin);
    let y = (point.y >= low.y - margin) & (point.y <= high.y + margin);
    let z = (point.z >= low.z - margin) & (point.z <= high.z + margin);
    (low.x <= high.x) & x & y & z
}

/// Radiance that a beam's piece scatters into a line, RGB, dimmed from the line's beginning in the medium on.
#[inline(always)]
fn scattered(u: &BeamsUniforms, beam: &Beam, piece: u32, line: &Line, pencil: &Pencil) -> Vec3 {
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
    let length = beam.length * (1.0 / PIECES as f32);
    let within = (s >= length * piece as f32) & (s < length * (piece + 1) as f32);
    let meets = within & (t > line.near) & (t < line.far);
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
    bounds: &[f32],
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
        let is_shadow = round == 0;
        let mut tree = if looks_through { 0 } else { ENDS };
        while tree < TREES {
            // A node behind the root ends the walk.
            let outside = (tree == ENDS) & (!end.is_diffuse | is_shadow);
            let mut node = Node { level: root, number: if outside { 1 } else { 0 } };
            while (node.level < root) | (node.number == 0) {
                let around = bounds_of(u, bounds, round, tree, root, node);
                let met = if tree == ENDS {
                    holds(&around, end.point.position, end.tolerance)
                } else {
                    comes_through(&line, &around)
                };
                if met & (node.level > 0) {
                    node = node.below();
                } else {
                    if met {
                        let (column, row) = node.place();
                        let beam = beam_of(beams, first, (row * u.lattice.count + column) as i32, texels);
                        if tree == ENDS {
                            surface += shining(u, &beam, &end, d, &at_end);
                        } else {
                            let light = scattered(u, &beam, tree, &line, &pencil);
                            caustics += light * select(is_shadow, 0.0, 1.0);
                            shadow += light * select(is_shadow, 1.0, 0.0);
                        }
                    }
                    node = node.behind(root);
                }
            }
            tree += 1;
        }
        round += 1;
    }
    seen.caustics += caustics * piece.weight;
    seen.shadow += shadow * piece.weight;
    let dimmed = transmittance(&u.medium, fog.leaves - fog.enters);
    seen.radiance += surface * end.point.color * dimmed * piece.weight;
    seen.store()
}
