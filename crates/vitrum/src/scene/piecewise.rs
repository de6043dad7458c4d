//! Piecewise linear functions.

/// The points of a piecewise linear function around `x`, sorted by `place`, and the share of the way from the first to the second; at a step, those behind
/// it. Beyond the ends both are the end. `None` without points.
pub(crate) fn around<P>(points: &[P], x: f32, place: impl Fn(&P) -> f32) -> Option<(&P, &P, f32)> {
    let after = points.partition_point(|point| place(point) <= x);
    let before = after.checked_sub(1).and_then(|before| points.get(before));
    match (before, points.get(after)) {
        (Some(before), Some(next)) => Some((before, next, (x - place(before)) / (place(next) - place(before)))),
        (before, next) => before.or(next).map(|end| (end, end, 0.0)),
    }
}
