//! Finished frames: named outputs, and the statistics of how they were made.

mod frame;
mod output;
mod resolve;
mod statistics;

pub use frame::Frame;
pub use output::Output;
pub(crate) use resolve::{Pixel, Rays, rgb, rgba, xyz};
pub use statistics::Statistics;
