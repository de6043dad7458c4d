//! Filters along the axes of a volume, one after another: weights of the old values for each of the new ones.

/// For each new value along an axis the old ones that it is made of, with their weights, whose sum is 1.
pub(crate) struct Taps(Vec<Vec<(usize, f32)>>);

impl Taps {
    /// `to` values at distances of `step` old ones, around the same middle: the mean of the line through the old values over a box that
    /// makes the new ones' resolution `step`, exact for what is linear; for a `step` up to 1 the line itself.
    pub fn linear(from: usize, to: usize, step: f64) -> Self {
        let width = libm::sqrt((step * step - 1.0).max(0.0));
        // The integral of the hat function up to `x`.
        let integral = |x: f64| match x {
            x if x <= -1.0 => 0.0,
            x if x <= 0.0 => 0.5 * (x + 1.0) * (x + 1.0),
            x if x <= 1.0 => 1.0 - 0.5 * (1.0 - x) * (1.0 - x),
            _ => 1.0,
        };
        let weight = |distance: f64| {
            if width > 1e-3 {
                (integral(distance + 0.5 * width) - integral(distance - 0.5 * width)) / width
            } else {
                (1.0 - distance.abs()).max(0.0)
            }
        };
        Self::around(from, to, step, 0.5 * width + 1.0, weight)
    }

    /// As [`Self::linear`], with the nearest of the old values.
    pub fn nearest(from: usize, to: usize, step: f64) -> Self {
        let nearest = |index| (clamped(centre(from, to, step, index).round() as i64, from), 1.0);
        Self((0..to).map(|index| vec![nearest(index)]).collect())
    }

    /// As many values, blurred by a Gaussian.
    pub fn gaussian(size: usize, sigma: f64) -> Self {
        // Beyond four standard deviations there is less than 1e-4 of a Gaussian.
        Self::around(size, size, 1.0, libm::ceil(4.0 * sigma), |offset| {
            libm::exp(-0.5 * (offset / sigma) * (offset / sigma))
        })
    }

    /// Weights by the offset from the place of the new value, up to `radius` away; beyond the ends the last values go on.
    fn around(from: usize, to: usize, step: f64, radius: f64, weight: impl Fn(f64) -> f64) -> Self {
        let taps = |index| {
            let place = centre(from, to, step, index);
            let mut taps: Vec<(usize, f64)> = Vec::new();
            for old in libm::ceil(place - radius) as i64..=libm::floor(place + radius) as i64 {
                let weight = weight(old as f64 - place);
                let old = clamped(old, from);
                match taps.last_mut() {
                    Some((last, sum)) if *last == old => *sum += weight,
                    _ => taps.push((old, weight)),
                }
            }
            let sum: f64 = taps.iter().map(|(_, weight)| weight).sum();
            taps.into_iter()
                .filter(|(_, weight)| *weight != 0.0)
                .map(|(old, weight)| (old, (weight / sum) as f32))
                .collect()
        };
        Self((0..to).map(taps).collect())
    }
}

/// The place of a new value among the old ones.
fn centre(from: usize, to: usize, step: f64, index: usize) -> f64 {
    0.5 * (from as f64 - 1.0) + (index as f64 - 0.5 * (to as f64 - 1.0)) * step
}

fn clamped(index: i64, size: usize) -> usize {
    index.clamp(0, size as i64 - 1) as usize
}

/// The values, filtered along each of the axes, x fastest.
pub(crate) fn filtered(mut values: Vec<f32>, mut sizes: [usize; 3], taps: &[Taps; 3]) -> Vec<f32> {
    for (axis, Taps(taps)) in taps.iter().enumerate() {
        // Values that lie beside each other and are filtered alike.
        let inner: usize = sizes[..axis].iter().product();
        let outer: usize = sizes[axis + 1..].iter().product();
        let mut result = vec![0.0; inner * taps.len() * outer];
        for (new, old) in result.chunks_exact_mut(inner * taps.len()).zip(values.chunks_exact(inner * sizes[axis])) {
            for (new, taps) in new.chunks_exact_mut(inner).zip(taps) {
                for &(index, weight) in taps {
                    let old = &old[index * inner..(index + 1) * inner];
                    new.iter_mut().zip(old).for_each(|(new, old)| *new += weight * old);
                }
            }
        }
        sizes[axis] = taps.len();
        values = result;
    }
    values
}
