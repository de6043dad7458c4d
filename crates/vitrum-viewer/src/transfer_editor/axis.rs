//! The axis of values: where each stands, and round numbers along it.

/// An axis from a first to a last value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// The values at its ends, in ascending order.
    pub range: [f32; 2],
}

impl Axis {
    /// An axis over a range, which is widened where it is none.
    #[must_use]
    pub fn over([low, high]: [f32; 2]) -> Self {
        let is_one = low < high && low.is_finite() && high.is_finite() && (high - low).is_finite();
        let (low, high) = if is_one { (low, high) } else { (if low.is_finite() { low } else { 0.0 }, low) };
        let least = (low.abs() * 1e-4).max(f32::MIN_POSITIVE * 1e6);
        Self { range: [low, if high - low >= least { high } else { low + least.max(1.0) }] }
    }

    /// The share of the way from the first value to the last.
    #[must_use]
    pub fn share(self, value: f32) -> f32 {
        let [low, high] = self.range.map(f64::from);
        ((f64::from(value) - low) / (high - low)) as f32
    }

    /// The value at a share of the way.
    #[must_use]
    pub fn value(self, share: f32) -> f32 {
        let [low, high] = self.range.map(f64::from);
        (low + f64::from(share) * (high - low)) as f32
    }

    /// The axis with the value at `share` where it was, and `factor` times as much of the rest in sight.
    #[must_use]
    pub fn zoomed(self, share: f32, factor: f32) -> Self {
        let (middle, [low, high]) = (self.value(share), self.range);
        Self::over([middle - (middle - low) * factor, middle + (high - middle) * factor])
    }

    /// Round values along it, at most `most`.
    #[must_use]
    pub fn ticks(self, most: usize) -> Vec<f32> {
        let [low, high] = self.range.map(f64::from);
        let least = (high - low) / most.max(1) as f64;
        let power = libm::pow(10.0, libm::log10(least).floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power).into_iter().find(|step| *step >= least);
        let step = step.unwrap_or(10.0 * power);
        let first = (low / step).ceil();
        let count = ((high / step).floor() - first + 1.0).max(0.0) as usize;
        (0..count.min(most + 1)).map(|index| ((first + index as f64) * step) as f32).collect()
    }
}

/// A value with about five digits, without a sign in front of 0.
#[must_use]
pub fn number(value: f32) -> String {
    let value = f64::from(value);
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        1e-4..1e7 => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(Axis::over([-1024.0, 3071.0]).ticks(5), [-1000.0, 0.0, 1000.0, 2000.0, 3000.0]);
        assert_eq!(Axis::over([0.0, 1.0]).ticks(6), [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        for range in [[0.0, 255.0], [1e-6, 3e-6], [-7.0, -7.0], [0.0, 1e30], [f32::NAN, 1.0], [3.0, f32::INFINITY]] {
            let axis = Axis::over(range);
            let ticks = axis.ticks(6);
            assert!(
                (1..=7).contains(&ticks.len()) && ticks.iter().all(|tick| tick.is_finite()),
                "{range:?}: {ticks:?}"
            );
        }
    }

    #[test]
    fn shares_and_values_are_each_others_inverse() {
        let axis = Axis::over([-1024.0, 3071.0]);
        for share in [0.0, 0.25, 1.0] {
            assert!((axis.share(axis.value(share)) - share).abs() < 1e-6);
        }
        let zoomed = axis.zoomed(0.25, 0.5);
        assert!((zoomed.share(axis.value(0.25)) - 0.25).abs() < 1e-4);
        assert!((zoomed.range[1] - zoomed.range[0] - 0.5 * 4095.0).abs() < 0.1);
    }
}
