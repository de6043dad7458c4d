//! Unoccluded light of a point or a spot, in the wavefront's own frame: the inverse square of the distance, and a spot's cone.
//!
//! A wavefront from a point has its nodes at equal distances of tangents. A cell around an axis that is at an angle θ to the frame's has cos³ θ of the flux
//! of one around the frame's axis. All this is 1 where light comes from far away.

use crate::abi::wavefront::Wavefront;
use crate::math::{clamp, dot, length, max, select, sqrt, xyz};
use spirv_std::glam::Vec3;

/// The least squared distance from a light, in world units: nothing is as near.
const NEAREST: f32 = 1e-12;

/// The way from the source to a point, if the wavefront is spherical.
#[inline(always)]
pub fn way(w: &Wavefront, at: Vec3) -> Vec3 {
    at - xyz(w.source)
}

/// Radiance of unoccluded light at a point over that at a distance of 1, without a spot's cone.
#[inline(always)]
pub fn strength(w: &Wavefront, at: Vec3) -> f32 {
    if w.spherical != 0 {
        let way = way(w, at);
        1.0 / max(dot(way, way), NEAREST)
    } else {
        1.0
    }
}

/// The share of a spot's light along `way`.
#[inline(always)]
fn in_cone(w: &Wavefront, way: Vec3) -> f32 {
    let axis = xyz(w.cone.axis);
    let along = dot(axis, way);
    let tangent = length(way - axis * along) / max(along, 1e-20);
    let inside = clamp((w.cone.tangent - tangent) * w.cone.slope, 0.0, 1.0);
    let share = select(along > 0.0, inside * inside * (3.0 - 2.0 * inside), 0.0);
    select(w.cone.slope > 0.0, share, 1.0)
}

/// The share of a spot's light that goes towards a point.
#[inline(always)]
pub fn cone(w: &Wavefront, at: Vec3) -> f32 {
    if w.spherical != 0 { in_cone(w, way(w, at)) } else { 1.0 }
}

/// The tangents of unrefracted light with coordinates (x, y), in cells, as a way to depth 1.
#[inline(always)]
fn towards(w: &Wavefront, x: f32, y: f32) -> Vec3 {
    Vec3::new(w.corner_x + x * w.cell, w.corner_y + y * w.cell, 1.0)
}

/// The share of a spot's light that has coordinates (x, y), in cells.
#[inline(always)]
pub fn cone_of(w: &Wavefront, x: f32, y: f32) -> f32 {
    if w.spherical != 0 { in_cone(w, towards(w, x, y)) } else { 1.0 }
}

/// Flux of a cell around coordinates (x, y), in cells, over that of a cell around the frame's axis, without a spot's cone.
#[inline(always)]
pub fn density(w: &Wavefront, x: f32, y: f32) -> f32 {
    if w.spherical != 0 {
        let towards = towards(w, x, y);
        let cosine = 1.0 / sqrt(dot(towards, towards));
        cosine * cosine * cosine
    } else {
        1.0
    }
}

/// Flux of cell (x, y) over that of a cell around the frame's axis, without a spot's cone: the mean of its corners.
#[inline(always)]
pub fn density_of_cell(w: &Wavefront, x: f32, y: f32) -> f32 {
    let below = density(w, x, y) + density(w, x + 1.0, y);
    let above = density(w, x, y + 1.0) + density(w, x + 1.0, y + 1.0);
    (below + above) * 0.25
}

/// What a cell around node (x, y) has of the flux that one around the frame's axis would have.
#[inline(always)]
pub fn weight(w: &Wavefront, x: u32, y: u32) -> f32 {
    let (x, y) = (x as i32 as f32, y as i32 as f32);
    density(w, x, y) * cone_of(w, x, y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::abi::vector;
    use crate::abi::wavefront::SpotCone;

    #[test]
    fn light_from_far_away_is_the_same_everywhere() {
        let w = Wavefront { corner_x: 3.0, cell: 0.5, ..Wavefront::default() };
        let at = Vec3::new(1.0, 2.0, 3.0);
        assert_eq!([strength(&w, at), cone(&w, at), weight(&w, 3, 4), density_of_cell(&w, 1.0, 2.0)], [1.0; 4]);
    }

    #[test]
    fn light_of_a_point_falls_with_the_square_of_the_distance_and_its_flux_by_the_cube_of_the_cosine() {
        let source = vector::Vec3::new(0.0, 0.0, -2.0);
        let w = Wavefront { spherical: 1, source, cell: 0.5, ..Wavefront::default() };
        assert!((strength(&w, Vec3::new(2.0, 1.0, 0.0)) - 1.0 / 9.0).abs() < 1e-7);
        assert_eq!(cone(&w, Vec3::new(9.0, 1.0, 0.0)), 1.0);
        // At 45° and along the axis.
        assert!((weight(&w, 2, 0) - 0.5 * 0.5f32.sqrt()).abs() < 1e-6 && weight(&w, 0, 0) == 1.0);
    }

    #[test]
    fn a_cone_fades_linearly_in_tangents_and_smoothly() {
        let cone = SpotCone { axis: vector::Vec3::new(0.0, 0.0, 1.0), tangent: 1.0, slope: 2.0 };
        let w = Wavefront { spherical: 1, cone, ..Wavefront::default() };
        let found = [0.0, 0.5, 0.75, 1.0, 2.0].map(|x| super::cone(&w, Vec3::new(0.0, 3.0 * x, 3.0)));
        for (found, expected) in found.into_iter().zip([1.0, 1.0, 0.5, 0.0, 0.0]) {
            assert!((found - expected).abs() < 1e-6, "{found} for {expected}");
        }
        assert_eq!(super::cone(&w, Vec3::new(0.0, 0.0, -1.0)), 0.0);
    }
}
