//! Filters along the axes of a part of a volume: some of its slices.

use rayon::prelude::*;

/// Floats on a grid, x fastest, and the number of them along each axis.
pub(super) type Sizes = [usize; 3];

/// `to` gets `from`, filtered along one axis by weights that are the same on both sides of their middle; beyond the ends the last values go on.
pub(super) fn filter(from: &[f32], to: &mut [f32], sizes: Sizes, axis: usize, weights: &[f32]) {
    let [width, height, _] = sizes;
    let plane = width * height;
    let reach = weights.len() / 2;
    to.par_chunks_mut(plane).enumerate().for_each(|(z, to)| match axis {
        0 => to.chunks_mut(width).zip(from[z * plane..].chunks(width)).for_each(|(to, from)| row(from, to, weights)),
        1 => {
            let from = &from[z * plane..][..plane];
            for (y, to) in to.chunks_mut(width).enumerate() {
                to.fill(0.0);
                for (tap, &weight) in weights.iter().enumerate() {
                    let at = (y + tap).saturating_sub(reach).min(height - 1);
                    add(to, &from[at * width..][..width], weight);
                }
            }
        }
        _ => {
            to.fill(0.0);
            for (tap, &weight) in weights.iter().enumerate() {
                let at = (z + tap).saturating_sub(reach).min(sizes[2] - 1);
                add(to, &from[at * plane..][..plane], weight);
            }
        }
    });
}

fn row(from: &[f32], to: &mut [f32], weights: &[f32]) {
    let (last, reach) = (from.len() - 1, weights.len() / 2);
    to.fill(0.0);
    for (tap, &weight) in weights.iter().enumerate() {
        // The part that this tap reads within the row, and the ends beyond.
        let (before, after) = (reach.saturating_sub(tap).min(to.len()), tap.saturating_sub(reach).min(to.len()));
        let (ends, inner) = to.split_at_mut(before);
        ends.iter_mut().for_each(|value| *value += weight * from[0]);
        let (inner, beyond) = inner.split_at_mut(inner.len() - after.min(inner.len()));
        beyond.iter_mut().for_each(|value| *value += weight * from[last]);
        add(inner, &from[after.min(last)..], weight);
    }
}

fn add(to: &mut [f32], from: &[f32], weight: f32) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to += weight * from);
}

/// `values` filtered along all axes, each by its own weights, with the help of `other`, of the same length.
pub(super) fn filter_all(values: &mut Vec<f32>, other: &mut Vec<f32>, sizes: Sizes, weights: &[Vec<f32>; 3]) {
    for (axis, weights) in weights.iter().enumerate().filter(|(_, weights)| weights.len() > 1) {
        filter(values, other, sizes, axis, weights);
        std::mem::swap(values, other);
    }
}

/// Equal weights of the values up to `radius` away.
pub(super) fn mean(radius: usize) -> Vec<f32> {
    vec![1.0 / (2 * radius + 1) as f32; 2 * radius + 1]
}

/// The binomial weights of the values up to `radius` away: nearly a Gaussian, of variance `radius` / 2.
pub(super) fn binomial(radius: usize) -> Vec<f32> {
    let mut weights = vec![1.0_f32];
    for _ in 0..2 * radius {
        let sum = |index: usize| {
            let of = |index: Option<usize>| index.and_then(|index| weights.get(index)).copied().unwrap_or(0.0);
            0.5 * (of(Some(index)) + of(index.checked_sub(1)))
        };
        weights = (0..=weights.len()).map(sum).collect();
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_are_sums_with_ends_that_go_on() {
        let sizes = [5, 4, 3];
        let from: Vec<f32> = (0..60).map(|index| (index * index % 17) as f32).collect();
        for weights in [mean(1), mean(2), mean(6), binomial(1), binomial(2)] {
            assert!((weights.iter().sum::<f32>() - 1.0).abs() < 1e-6);
            for axis in 0..3 {
                let mut to = vec![9.0; 60];
                filter(&from, &mut to, sizes, axis, &weights);
                for (index, &made) in to.iter().enumerate() {
                    let at = [index % 5, index / 5 % 4, index / 20];
                    let sum = |(tap, weight): (usize, &f32)| {
                        let mut other = at;
                        let moved = at[axis] as i64 + tap as i64 - (weights.len() / 2) as i64;
                        other[axis] = moved.clamp(0, sizes[axis] as i64 - 1) as usize;
                        weight * from[other[0] + 5 * (other[1] + 4 * other[2])]
                    };
                    let expected: f32 = weights.iter().enumerate().map(sum).sum();
                    assert!((made - expected).abs() < 1e-4, "axis {axis}, {index}: {made}, expected {expected}");
                }
            }
        }
        assert_eq!(binomial(1), [0.25, 0.5, 0.25]);
    }
}
