//! Polygons into triangles, with no vertex left out, so that neighbours stay joined.

use glam::DVec3;

/// Most corners of a polygon that is not convex: ears are looked for in quadratic time at best.
pub(super) const MOST_CORNERS: usize = 1024;

/// Appends the triangles of a polygon of at least 3 corners, in its sense of rotation, as indices of corners.
///
/// `Some(false)` where the polygon crosses itself, so that its triangles overlap; `None`, and nothing appended, where
/// it is neither convex nor small.
pub(super) fn triangulate(points: &[[f64; 3]], triangles: &mut Vec<[usize; 3]>) -> Option<bool> {
    let flat = flatten(points);
    let fan = |triangles: &mut Vec<[usize; 3]>| triangles.extend((2..points.len()).map(|last| [0, last - 1, last]));
    let Some(flat) = flat else {
        // A polygon without area has no inside.
        fan(triangles);
        return Some(true);
    };
    if (2..flat.len()).all(|last| cross(flat[0], flat[last - 1], flat[last]) > 0.0) {
        fan(triangles);
        return Some(true);
    }
    (flat.len() <= MOST_CORNERS).then(|| clip_ears(&flat, triangles))
}

/// The polygon seen along the axis that shows most of its area, counterclockwise; `None` where it has no area.
fn flatten(points: &[[f64; 3]]) -> Option<Vec<[f64; 2]>> {
    // Newell's normal, about the first corner, for the digits' sake.
    let from_first = |point: [f64; 3]| DVec3::from(point) - DVec3::from(points[0]);
    let mut normal = DVec3::ZERO;
    for (index, &point) in points.iter().enumerate() {
        normal += from_first(point).cross(from_first(points[(index + 1) % points.len()]));
    }
    let axis = (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))?;
    let (u, v) = if normal[axis] > 0.0 { ((axis + 1) % 3, (axis + 2) % 3) } else { ((axis + 2) % 3, (axis + 1) % 3) };
    (normal[axis] != 0.0).then(|| points.iter().map(|point| [point[u], point[v]]).collect())
}

/// Twice the signed area.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether an ear was there at each step.
fn clip_ears(points: &[[f64; 2]], triangles: &mut Vec<[usize; 3]>) -> bool {
    let mut left: Vec<usize> = (0..points.len()).collect();
    let mut simple = true;
    let mut start = 0;
    while left.len() > 3 {
        let count = left.len();
        let around = |tip: usize| [left[(tip + count - 1) % count], left[tip % count], left[(tip + 1) % count]];
        let ear = (start..start + count).find(|&tip| is_ear(points, &left, around(tip)));
        simple &= ear.is_some();
        let tip = ear.unwrap_or(start) % count;
        triangles.push(around(tip));
        left.remove(tip);
        // Going on behind the ear spreads the triangles instead of making a fan of slivers.
        start = tip;
    }
    triangles.push([left[0], left[1], left[2]]);
    simple && cross(points[left[0]], points[left[1]], points[left[2]]) > 0.0
}

/// Whether a triangle of neighbours is convex and holds no other corner, not even on its edges.
fn is_ear(points: &[[f64; 2]], left: &[usize], ear: [usize; 3]) -> bool {
    let [a, b, c] = ear.map(|corner| points[corner]);
    let holds = |point: [f64; 2]| {
        // Several corners at one place are no obstacle to each other.
        ![a, b, c].contains(&point)
            && cross(a, b, point) >= 0.0
            && cross(b, c, point) >= 0.0
            && cross(c, a, point) >= 0.0
    };
    cross(a, b, c) > 0.0 && !left.iter().any(|&other| !ear.contains(&other) && holds(points[other]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum of the triangles' areas, each of which has to be above 0.
    fn area(polygon: &[[f64; 3]]) -> f64 {
        let mut triangles = Vec::new();
        assert_eq!(triangulate(polygon, &mut triangles), Some(true));
        assert_eq!(triangles.len(), polygon.len() - 2);
        let areas = triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|corner| [polygon[corner][0], polygon[corner][1]]);
            cross(a, b, c) / 2.0
        });
        areas.inspect(|area| assert!(*area > 0.0, "{triangles:?}")).sum()
    }

    #[test]
    fn polygons_keep_their_area_and_every_corner() {
        assert_eq!(area(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]]), 2.0);
        // An arrow, whose notch is each corner once.
        let arrow = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 1.0, 0.0], [-2.0, 2.0, 0.0]];
        for turn in 0..4 {
            let mut arrow = arrow;
            arrow.rotate_left(turn);
            assert_eq!(area(&arrow), 2.0, "{turn}");
        }
        // Corners on straight edges.
        let straight = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [1.0, 1.0, 0.0]];
        for turn in 0..5 {
            let mut straight = straight;
            straight.rotate_left(turn);
            assert_eq!(area(&straight), 2.0, "{turn}");
        }
        // A comb.
        let teeth = (0..20).map(|tooth| [f64::from(tooth), f64::from(tooth % 2 * 5 + 1), 0.0]);
        let comb: Vec<_> = [[19.0, 0.0, 0.0], [0.0, 0.0, 0.0]].into_iter().chain(teeth).rev().collect();
        assert_eq!(area(&comb), 19.0 * 3.5);
    }

    #[test]
    fn polygons_without_an_inside_are_told() {
        let bow_tie = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.5, 0.0]];
        assert_eq!(triangulate(&bow_tie, &mut Vec::new()), Some(false));
        let line = [[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]];
        let mut triangles = Vec::new();
        assert_eq!(triangulate(&line, &mut triangles), Some(true));
        assert_eq!(triangles.len(), 2);
        let star = (0..2000).map(|corner| {
            let radius = f64::from(1 + corner % 2);
            let angle = f64::from(corner) * std::f64::consts::TAU / 2000.0;
            [radius * libm::cos(angle), radius * libm::sin(angle), 0.0]
        });
        assert_eq!(triangulate(&star.collect::<Vec<_>>(), &mut Vec::new()), None);
    }
}
