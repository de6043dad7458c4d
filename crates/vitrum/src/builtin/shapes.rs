//! Signed distance functions, negative inside.

use glam::{Vec2, Vec3};

/// Share of a voxel that is inside, from its signed distance: 1 to 0 over a smooth edge of `width`.
pub(super) fn coverage(distance: f32, width: f32) -> f32 {
    1.0 - smoothstep(-0.5 * width, 0.5 * width, distance)
}

/// 0 up to `low`, 1 from `high` on, and a smooth cubic between; `low` may be the greater one.
pub(super) fn smoothstep(low: f32, high: f32, value: f32) -> f32 {
    let t = ((value - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The union of two shapes whose seam is rounded with the given radius.
pub(super) fn smooth_union(a: f32, b: f32, radius: f32) -> f32 {
    let overlap = (radius - (a - b).abs()).max(0.0) / radius;
    a.min(b) - overlap * overlap * radius * 0.25
}

/// `a` without `b`, with the seam rounded.
pub(super) fn smooth_difference(a: f32, b: f32, radius: f32) -> f32 {
    -smooth_union(-a, b, radius)
}

/// An axis-aligned ellipsoid; exact on its surface, close near it.
pub(super) fn ellipsoid(position: Vec3, centre: Vec3, radii: Vec3) -> f32 {
    let scaled = (position - centre) / radii;
    let length = scaled.length();
    let slope = (scaled / radii).length();
    if slope > 0.0 { length * (length - 1.0) / slope } else { -radii.min_element() }
}

/// A straight tube with round ends whose radius changes linearly from `start` to `end`.
pub(super) fn tube(position: Vec3, start: (Vec3, f32), end: (Vec3, f32)) -> f32 {
    let axis = end.0 - start.0;
    let along = ((position - start.0).dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
    (position - start.0 - axis * along).length() - (start.1 + (end.1 - start.1) * along)
}

/// A curve in the plane, closed by straight lines that do not count as its surface.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    points: Vec<Vec2>,
    /// The number of `points` that form the curve; the other points close it.
    curve: usize,
}

impl Outline {
    /// The smooth curve through `points`, closed from the last point over `corners` to the first.
    pub fn smooth(points: &[[f32; 2]], corners: &[[f32; 2]]) -> Self {
        let through: Vec<Vec3> = points.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect();
        let curve = smooth_curve(&through);
        let corners = corners.iter().copied().map(Vec2::from_array);
        Self { curve: curve.len(), points: curve.into_iter().map(Vec3::truncate).chain(corners).collect() }
    }

    /// Signed distance to the curve; the closing lines only decide on which side a point is.
    pub fn distance(&self, position: Vec2) -> f32 {
        let mut nearest = f32::INFINITY;
        let mut inside = false;
        for (index, &start) in self.points.iter().enumerate() {
            let end = self.points[(index + 1) % self.points.len()];
            let (edge, offset) = (end - start, position - start);
            if index + 1 < self.curve {
                let along = (offset.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
                nearest = nearest.min((offset - edge * along).length_squared());
            }
            let crosses = (start.y > position.y) != (end.y > position.y);
            if crosses && offset.x < edge.x * offset.y / edge.y {
                inside = !inside;
            }
        }
        if inside { -nearest.sqrt() } else { nearest.sqrt() }
    }
}

/// Straight pieces that [`smooth_curve`] puts between two points.
pub(super) const PIECES: usize = 6;

/// The smooth curve through points, [`PIECES`] straight pieces from each to the next.
pub(super) fn smooth_curve(points: &[Vec3]) -> Vec<Vec3> {
    smooth_curve_of(points, PIECES)
}

/// The smooth curve (Catmull–Rom) through points, `pieces` straight ones from each to the next.
pub(super) fn smooth_curve_of(points: &[Vec3], pieces: usize) -> Vec<Vec3> {
    let mut curve = Vec::with_capacity(points.len() * pieces);
    for (index, pair) in points.windows(2).enumerate() {
        let (start, end) = (pair[0], pair[1]);
        // Beyond its ends the curve goes on as the mirror image of its first and last piece.
        let before = if index == 0 { 2.0 * start - end } else { points[index - 1] };
        let after = points.get(index + 2).copied().unwrap_or(2.0 * end - start);
        curve.extend((0..pieces).map(|piece| catmull_rom([before, start, end, after], piece as f32 / pieces as f32)));
    }
    curve.extend(points.last());
    curve
}

/// The uniform Catmull–Rom spline from the second point (t = 0) to the third (t = 1).
fn catmull_rom([before, start, end, after]: [Vec3; 4], t: f32) -> Vec3 {
    let linear = end - before;
    let quadratic = 2.0 * before - 5.0 * start + 4.0 * end - after;
    let cubic = 3.0 * (start - end) + after - before;
    start + 0.5 * t * (linear + t * (quadratic + t * cubic))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_is_half_on_the_surface() {
        assert_eq!([-1.0, 0.0, 1.0].map(|distance| coverage(distance, 2.0)), [1.0, 0.5, 0.0]);
    }

    #[test]
    fn a_round_ellipsoid_is_a_sphere() {
        let centre = Vec3::new(1.0, 2.0, 3.0);
        for offset in [Vec3::X * 0.5, Vec3::ONE, Vec3::new(-3.0, 1.0, 0.2)] {
            let distance = ellipsoid(centre + offset, centre, Vec3::splat(0.8));
            assert!((distance - (offset.length() - 0.8)).abs() < 1e-6);
        }
        assert_eq!(ellipsoid(centre, centre, Vec3::new(0.5, 0.7, 0.9)), -0.5);
    }

    #[test]
    fn tubes_narrow_along_their_axis() {
        let (start, end) = ((Vec3::ZERO, 0.3), (Vec3::X * 2.0, 0.1));
        assert!((tube(Vec3::new(1.0, 1.0, 0.0), start, end) - 0.8).abs() < 1e-6);
        assert!((tube(Vec3::new(3.0, 0.0, 0.0), start, end) - 0.9).abs() < 1e-6);
    }

    #[test]
    fn smooth_unions_add_at_the_seam_only() {
        assert_eq!(smooth_union(0.3, 1.0, 0.2), 0.3);
        assert!(smooth_union(0.3, 0.3, 0.2) < 0.3);
        assert_eq!(smooth_difference(-0.3, 1.0, 0.2), -0.3);
        assert!(smooth_difference(-0.3, -0.2, 0.1) >= 0.2);
    }

    #[test]
    fn outlines_tell_inside_from_outside() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(Vec2::from_array);
        let outline = Outline { points: square.to_vec(), curve: 4 };
        assert_eq!(outline.distance(Vec2::new(1.5, 1.0)), -0.5);
        assert_eq!(outline.distance(Vec2::new(3.0, 1.0)), 1.0);
        // The closing side, x = 0, is not part of the curve.
        assert_eq!(outline.distance(Vec2::new(0.1, 1.0)), -1.0);
    }

    #[test]
    fn smooth_outlines_pass_through_their_points() {
        let points = [[0.0, 0.0], [1.0, 0.2], [1.2, 1.0], [0.5, 1.5]];
        let outline = Outline::smooth(&points, &[[0.0, 1.5]]);
        assert_eq!(outline.curve, 3 * PIECES + 1);
        assert!(outline.distance(Vec2::new(0.1, 1.4)) < -0.4);
        for point in points.map(Vec2::from_array) {
            assert!(outline.distance(point).abs() < 1e-6);
        }
    }
}
