//! Comparison of pictures and of buffers, made to be used as a check.
//!
//! [`compare`] measures two pictures, [`compare_buffers`] two slices of values; both give a [`Comparison`], and a
//! [`Bound`] turns that into a [`Verdict`]. [`difference_picture`] shows where two pictures differ.
//!
//! Nothing here passes by accident:
//! - a NaN differs from everything, also from another NaN, and makes every difference infinite;
//! - pictures of different size, and pictures without pixels, are an error and not a result;
//! - a bound on a quantity that was not measured is breached;
//! - `tests/must_fail.rs` plants one difference for each quantity that a bound can name, and expects the breach.
//!
//! ```
//! use vitrum_compare::{Bound, compare};
//!
//! let one = [[0.25, 0.5, 1.0]; 4];
//! let mut other = one;
//! other[2][1] += 0.125;
//! let comparison = compare(&one, &other, 2, 2)?;
//! assert_eq!(comparison.max_abs, 0.125);
//! assert_eq!(comparison.worst_pixel(), Some((0, 1)));
//! assert!(!Bound::BitEqual.check(&comparison).passed());
//! # Ok::<(), vitrum_compare::CompareError>(())
//! ```

#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

mod bound;
mod comparison;
mod difference;
mod error;
mod flip;
mod ulp;

pub use bound::{Bound, Breach, Quantity, Tolerance, Verdict};
pub use comparison::{Comparison, compare, compare_buffers};
pub use difference::{Difference, difference_picture};
pub use error::CompareError;
pub use ulp::{UlpHistogram, ulp_distance};
