//! Means of random samples, and how sure they are.

use super::Random;
use rayon::prelude::*;

/// Batches into which samples are dealt out. The standard error of their mean is itself sure to 1 / √(2 · 63), which is
/// 9 %.
pub(super) const BATCHES: u64 = 64;

/// A mean and its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimate {
    /// The mean.
    pub mean: f64,
    /// The standard error of the mean.
    pub error: f64,
}

impl Estimate {
    /// The mean of batches that are equally large.
    pub(super) fn of(batches: impl Iterator<Item = f64> + Clone) -> Self {
        let (count, sum) = batches.clone().fold((0.0, 0.0), |(count, sum), value| (count + 1.0, sum + value));
        let mean = sum / count;
        let squares: f64 = batches.map(|value| (value - mean) * (value - mean)).sum();
        Self { mean, error: (squares / (count - 1.0) / count).sqrt() }
    }

    /// The difference from a number that is sure, in standard errors.
    #[must_use]
    pub fn off(self, from: f64) -> f64 {
        (self.mean - from) / self.error
    }

    /// The difference from an estimate that is independent of this one, in standard errors of the difference.
    #[must_use]
    pub fn off_from(self, other: Self) -> f64 {
        (self.mean - other.mean) / self.error.hypot(other.error)
    }
}

/// Light by how often it was scattered.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Orders {
    /// Scattered once.
    pub once: Estimate,
    /// Scattered twice or more often.
    pub more: Estimate,
}

/// What each batch of a seed gives, in an order that does not depend on the number of threads.
pub(super) fn batches<Part: Send>(seed: u64, batch: impl Fn(&mut Random) -> Part + Sync) -> Vec<Part> {
    (0..BATCHES).into_par_iter().map(|number| batch(&mut Random::new(seed, number))).collect()
}
