//! Convex hulls in a plane.

use glam::DVec2;

/// The corners of the convex hull of `points`, one after the other around it (Andrew 1979, the monotone chain).
pub(super) fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut corners = chain(points.iter());
    let back = chain(points.iter().rev());
    // Each ends where the other begins.
    corners.pop();
    corners.extend(&back[..back.len() - 1]);
    corners
}

/// One chain of the convex hull (Andrew's monotone chain): the points at which the outline never turns clockwise.
fn chain<'a>(points: impl Iterator<Item = &'a DVec2>) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for &point in points {
        while let [.., before, last] = kept[..]
            && (last - before).perp_dot(point - last) <= 0.0
        {
            kept.pop();
        }
        kept.push(point);
    }
    kept
}

/// The least and the greatest y of a convex polygon between two x; `None` if the polygon has no point there.
pub(super) fn extent(corners: &[DVec2], [near, far]: [f64; 2]) -> Option<[f64; 2]> {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let ends = edges.flat_map(|(&from, &to)| {
        let [enters, leaves] = if to.x == from.x {
            [0.0, 1.0]
        } else {
            let [a, b] = [near, far].map(|x| (x - from.x) / (to.x - from.x));
            [a.min(b).max(0.0), a.max(b).min(1.0)]
        };
        let outside = from.x.max(to.x) < near || from.x.min(to.x) > far || enters > leaves;
        let ends = if outside { [None, None] } else { [Some(enters), Some(leaves)] };
        ends.map(|end| end.map(|at| from.lerp(to, at).y))
    });
    ends.flatten().fold(None, |extent, y| {
        let [low, high] = extent.unwrap_or([y, y]);
        Some([low.min(y), high.max(y)])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hulls_have_all_points_inside_and_their_corners_among_them() {
        // Points on a grid, many of them on the hull's edges.
        let points: Vec<DVec2> = (0..200)
            .map(|i| DVec2::new(f64::from(i * 37 % 23), f64::from(i * 53 % 19)) * 0.5)
            .filter(|point| (point - DVec2::splat(5.0)).length() < 4.3)
            .collect();
        let corners = hull(points.clone());
        assert!(corners.len() > 4 && corners.iter().all(|corner| points.contains(corner)));
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            assert!(points.iter().all(|&point| (to - from).perp_dot(point - from) >= 0.0));
        }
        // The extent of a polygon between two x, by all pairs of its points.
        for [near, far] in [[0.0, 1.0], [2.3, 2.4], [5.0, 5.0], [8.9, 20.0], [-3.0, -1.0]] {
            let mut found: Option<[f64; 2]> = None;
            for (&a, &b) in points.iter().flat_map(|a| points.iter().map(move |b| (a, b))) {
                for y in extent(&[a, b], [near, far]).into_iter().flatten() {
                    let [low, high] = found.unwrap_or([y, y]);
                    found = Some([low.min(y), high.max(y)]);
                }
            }
            let close = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < 1e-9 && (a[1] - b[1]).abs() < 1e-9;
            match (extent(&corners, [near, far]), found) {
                (Some(extent), Some(found)) => assert!(close(extent, found), "{near} to {far}: {extent:?}, {found:?}"),
                (extent, found) => assert_eq!(extent, found),
            }
        }
    }

    #[test]
    fn few_points_are_their_own_hull() {
        assert_eq!(hull(vec![]), []);
        let [a, b] = [DVec2::new(1.0, 2.0), DVec2::new(3.0, 4.0)];
        assert_eq!(hull(vec![a, a]), [a]);
        assert_eq!(extent(&hull(vec![a]), [0.0, 2.0]), Some([2.0, 2.0]));
        assert_eq!(extent(&hull(vec![b, a]), [2.0, 5.0]), Some([3.0, 4.0]));
        // In a row: the ends alone.
        assert_eq!(hull(vec![b, a, a.midpoint(b)]), [a, b]);
    }
}
