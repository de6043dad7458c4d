//! Surfaces of revolution.

use super::super::shapes::smooth_curve_of;
use super::parts::Part;
use glam::{Vec2, Vec3};

/// Points on the unit circle from (1, 0) on, counterclockwise, `4 · 2^halvings` of them.
pub(super) fn circle(halvings: u32) -> Vec<Vec2> {
    let mut quarter = vec![Vec2::X, Vec2::Y];
    for _ in 0..halvings {
        let halved = quarter.windows(2).flat_map(|pair| [pair[0], (pair[0] + pair[1]).normalize()]);
        quarter = halved.chain([Vec2::Y]).collect();
    }
    quarter.pop();
    let turns: [fn(&Vec2) -> Vec2; 4] = [|p| *p, |p| Vec2::new(-p.y, p.x), |p| -*p, |p| Vec2::new(p.y, -p.x)];
    turns.iter().flat_map(|turn| quarter.iter().map(turn)).collect()
}

/// Straight pieces between two points of an outline: each bends the surface by little, and voxels show facets that are larger than they.
const PIECES: usize = 12;

/// The smooth outline through points (distance from the z axis, height).
pub(super) fn smooth_outline(points: &[[f32; 2]]) -> Vec<Vec2> {
    let through: Vec<Vec3> = points.iter().map(|&[radius, height]| Vec3::new(radius, height, 0.0)).collect();
    smooth_curve_of(&through, PIECES).into_iter().map(Vec3::truncate).collect()
}

/// The solid of revolution of an outline of points (distance from the z axis, height). The outline runs counterclockwise around the
/// inside, with the axis at its left; it begins and ends on the axis, or goes on from its last point to its first.
pub(super) fn revolve(outline: &[Vec2], halvings: u32) -> Part {
    let circle = circle(halvings);
    let mut positions = Vec::new();
    // A ring's first vertex; one vertex is the whole ring where it lies on the axis.
    let rings: Vec<(u32, bool)> = outline
        .iter()
        .map(|point| {
            let first = positions.len() as u32;
            let on_axis = point.x == 0.0;
            let around = if on_axis { &circle[..1] } else { &circle };
            positions.extend(around.iter().map(|turn| [turn.x * point.x, turn.y * point.x, point.y]));
            (first, on_axis)
        })
        .collect();
    let count = circle.len() as u32;
    let vertex = |(first, on_axis): (u32, bool), index: u32| if on_axis { first } else { first + index % count };
    let mut triangles = Vec::new();
    for (number, &ring) in rings.iter().enumerate() {
        let next = rings[(number + 1) % rings.len()];
        for index in 0..count {
            let [a, b] = [vertex(ring, index), vertex(ring, index + 1)];
            let [c, d] = [vertex(next, index + 1), vertex(next, index)];
            triangles.extend([[a, b, c], [a, c, d]].into_iter().filter(|[a, b, c]| a != b && b != c && c != a));
        }
    }
    Part { positions, triangles }
}

/// A ball around the origin.
pub(super) fn ball(radius: f32, halvings: u32) -> Part {
    let circle = circle(halvings);
    let half = circle.len() / 2;
    // The right half of the circle, from the lowest point to the highest.
    let outline: Vec<Vec2> = (0..=half)
        .map(|index| match index {
            0 => Vec2::new(0.0, -radius),
            _ if index == half => Vec2::new(0.0, radius),
            _ => radius * Vec2::new(circle[index].y, -circle[index].x),
        })
        .collect();
    revolve(&outline, halvings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_circle_is_round_and_even() {
        let circle = circle(4);
        assert_eq!(circle.len(), 64);
        for (index, point) in (0u32..).zip(&circle) {
            let angle = f64::from(index) / 64.0 * 2.0 * PI;
            assert!((point.as_dvec2() - glam::DVec2::new(libm::cos(angle), libm::sin(angle))).length() < 1e-6);
        }
    }

    #[test]
    fn a_ball_has_its_volume() {
        let ball = ball(1.0, 5).into_mesh("ball");
        // A polyhedron within the ball: 2 π² / (3 n²) is missing, about, of n rings and n / 2 turns each.
        assert!((ball.signed_volume() / (4.0 / 3.0 * PI) - 1.0).abs() < 2e-3, "{}", ball.signed_volume());
        assert!(ball.topology().is_closed());
    }

    #[test]
    fn a_closed_outline_makes_a_ring() {
        let outline = [[1.0, -0.1], [1.2, 0.0], [1.0, 0.1]].map(Vec2::from_array);
        let ring = revolve(&outline, 6).into_mesh("ring");
        // Pappus: area times the way of its centroid.
        let expected = 0.02 * 2.0 * PI * (1.0 + 0.2 / 3.0);
        assert!((ring.signed_volume() / expected - 1.0).abs() < 1e-3, "{}", ring.signed_volume());
        assert!(ring.topology().is_closed());
    }
}
