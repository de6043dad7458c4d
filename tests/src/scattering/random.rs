//! Random numbers and directions.

use std::f64::consts::{PI, TAU};
use vitrum_kernels::glam::DVec3;

/// Random numbers: the generator SplitMix64 (Steele, Lea and Flood 2014).
#[derive(Debug, Clone)]
pub struct Random(u64);

/// A bijection of 64 bits that leaves no pattern (David Stafford's variant 13 of the finalizer of MurmurHash3).
fn mixed(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

impl Random {
    /// The numbers of a seed and a batch. Two batches start at places of the generator's one sequence that have nothing
    /// to do with each other.
    #[must_use]
    pub fn new(seed: u64, batch: u64) -> Self {
        Self(mixed(mixed(seed ^ 0x6a09_e667_f3bc_c909).wrapping_add(batch)))
    }

    /// A number of [0, 1).
    pub fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        (mixed(self.0) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Whether something of a probability happens.
    pub fn happens(&mut self, probability: f64) -> bool {
        self.share() < probability
    }

    /// A number of the exponential distribution of mean 1.
    pub fn exponential(&mut self) -> f64 {
        -(1.0 - self.share()).ln()
    }

    /// A unit vector at a random azimuth around a unit vector, by the cosine of the angle between them.
    pub fn around(&mut self, axis: DVec3, cosine: f64) -> DVec3 {
        let (right, up) = axis.any_orthonormal_pair();
        let (sin, cos) = (TAU * self.share()).sin_cos();
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        (axis * cosine + (right * cos + up * sin) * sine).normalize()
    }

    /// A unit vector around another, at angles between 0 and π that are equally likely: its density in solid angle is 1
    /// / (2 π² sin θ).
    pub fn at_equal_angles(&mut self, axis: DVec3) -> DVec3 {
        let cosine = (PI * self.share()).cos();
        self.around(axis, cosine)
    }
}
