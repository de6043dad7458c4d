//! Arithmetic that gives the same bits on both backends.
//!
//! Everything is made of `+ − × ÷`, `sqrt`, comparisons and integers. Each function's error bound is against f64 over the
//! stated range and is tested.

mod arctangent;
mod exponential;
mod integer;
mod logarithm;
mod select;
mod vector;

pub use arctangent::{asin, atan2};
pub use exponential::exp;
pub use integer::{floor_to_int, half_to_f32, limit};
pub use logarithm::log2;
pub use select::{absolute, clamp, lerp, max, min, select, sqrt};
pub use vector::{absolute_vector, affine, cross, dot, length, normalize, select_vector, xyz};

/// π.
pub const PI: f32 = core::f32::consts::PI;
