//! The points of a function, whatever it is of.

/// A point of a function: a scalar, and what the function is there. A number stands in the first component alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Scalar value.
    pub value: f32,
    /// Opacity, index of refraction, or linear RGB.
    pub level: [f32; 3],
}

/// The nearest value to `value` that leaves the point between its neighbours, with no more than two points at a value.
pub fn between_neighbours(spots: &[Spot], index: usize, value: f32) -> Option<f32> {
    let at = |index: Option<usize>| index.and_then(|index| spots.get(index)).map(|spot| spot.value);
    let own = at(Some(index))?;
    let value = if value.is_finite() { value } else { own };
    let (before, second_before) = (at(index.checked_sub(1)), at(index.checked_sub(2)));
    let (after, second_after) = (at(Some(index + 1)), at(Some(index + 2)));
    let least = before.map(|before| if second_before == Some(before) { before.next_up() } else { before });
    let most = after.map(|after| if second_after == Some(after) { after.next_down() } else { after });
    Some(value.min(most.unwrap_or(f32::MAX)).max(least.unwrap_or(f32::MIN)))
}

/// What a piecewise linear function through `spots` is at a value; `None` where there are no points.
#[must_use]
pub fn at(spots: &[Spot], value: f32) -> Option<[f32; 3]> {
    let index = spots.partition_point(|spot| spot.value <= value);
    let before = index.checked_sub(1).and_then(|index| spots.get(index));
    match (before, spots.get(index)) {
        (Some(before), Some(after)) => {
            let t = (value - before.value) / (after.value - before.value);
            Some(std::array::from_fn(|i| before.level[i] + (after.level[i] - before.level[i]) * t))
        }
        (before, after) => before.or(after).map(|spot| spot.level),
    }
}
