//! Projections of beams: where in the picture a beam is.

use super::drawn::Drawn;
use super::store_beam::{beam_of, has_flux};
use crate::abi::beams::{BeamsUniforms, estimator};
use crate::abi::record::{Beam, Projection, projection};
use crate::math::{absolute, clamp, dot, max, min, select, select_vector, xyz};
use spirv_std::glam::Vec3;

/// Depth in front of the eye from which on a beam is projected, in voxels.
const NEAR: f32 = 1e-3;
/// Farther columns than any picture has.
const BEYOND: f32 = 1e6;

/// An end of a beam along the major axis.
#[derive(Clone, Copy)]
pub struct End {
    /// The place of the middle.
    pub major: f32,
    /// How much farther its edges reach than its middle, at most.
    pub reach: f32,
}

/// Projects the point of a beam `along` it.
#[inline(always)]
pub fn end(u: &BeamsUniforms, beam: &Beam, drawn: &Drawn, along: f32) -> End {
    let offset = beam.position + beam.direction * along - xyz(u.eye);
    let depth = max(dot(xyz(u.away), offset), NEAR);
    let inverse = select(u.camera.orthographic != 0, 1.0, 1.0 / depth);
    let (width, height) = (u.picture.width as i32 as f32, u.picture.height as i32 as f32);
    let column = (dot(xyz(u.right), offset) * inverse / u.camera.half_width + 1.0) * (0.5 * width) - 0.5;
    let row = (1.0 - dot(xyz(u.up), offset) * inverse / u.camera.half_height) * (0.5 * height) - 0.5;
    let (column, row) = (clamp(column, -BEYOND, BEYOND), clamp(row, -BEYOND, BEYOND));
    let (major, minor) = (select(drawn.steep, row, column), select(drawn.steep, column, row));
    let section = drawn.section_at(major, minor);
    let slope = absolute(drawn.middle.major) / drawn.filter;
    // Across the beam its end is a line at right angles to it where the eye is far away; near the eye the line is curved, and reaches farther.
    End { major, reach: min(2.0 * drawn.half_width(&section, 1.0) * slope, BEYOND) + 1.0 }
}

/// The part of a beam in front of the eye: distances along it.
#[inline(always)]
pub fn in_front(u: &BeamsUniforms, beam: &Beam) -> (f32, f32) {
    let depth = dot(xyz(u.away), beam.position - xyz(u.eye)) - NEAR;
    let speed = dot(xyz(u.away), beam.direction);
    if u.camera.orthographic != 0 {
        (0.0, beam.length)
    } else {
        let crossing = -depth / select(speed == 0.0, 1e-30, speed);
        let low = select(speed > 0.0, max(crossing, 0.0), 0.0);
        let high = select(speed < 0.0, min(crossing, beam.length), beam.length);
        (low, select((speed == 0.0) & (depth < 0.0), -1.0, high))
    }
}

/// The projection of the beam of texel (x, y); one without columns if it does not show.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &BeamsUniforms, _mode: u32, beams: &[f32]) -> [f32; projection::SIZE] {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let first = (u.limits.round * u.limits.pitch) as i32;
    let number = (y * u.dispatch.width + x) as i32;
    let mut beam = beam_of(beams, first, number, count);
    if u.limits.estimator != estimator::BEAMS {
        let none = Vec3::new(0.0, 0.0, 0.0);
        beam = Beam { position_u: none, position_v: none, direction_u: none, direction_v: none, ..beam };
    }
    let drawn = Drawn::new(u, &beam);
    let (low, high) = in_front(u, &beam);
    let (a, b) = (end(u, &beam, &drawn, low), end(u, &beam, &drawn, high));
    let backwards = b.major < a.major;
    let begin = min(a.major - a.reach, b.major - b.reach);
    let end = max(a.major + a.reach, b.major + b.reach);
    // A ray of light that goes through the eye is a point in the picture.
    let shows = has_flux(beams, first, number, count) & (drawn.filter > 0.0) & (high > low);
    // A beam without flux has no place either, and its edge functions may be any numbers.
    let none = Vec3::new(0.0, 0.0, 0.0);
    Projection {
        steep: select(shows & drawn.steep, 1.0, 0.0),
        middle: select_vector(shows, drawn.middle.vector(), none),
        change_u: select_vector(shows, drawn.change_u.vector(), none),
        change_v: select_vector(shows, drawn.change_v.vector(), none),
        begin: select(shows, begin, 0.0),
        end: select(shows, end, -1.0),
        inner_begin: select(shows, select(backwards, b.major + b.reach, a.major + a.reach), 0.0),
        inner_end: select(shows, select(backwards, a.major - a.reach, b.major - b.reach), 0.0),
    }
    .store()
}
