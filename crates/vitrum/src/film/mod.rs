//! Finished frames: named outputs, and the statistics of how they were made.

mod accumulator;
mod background;
mod catcher;
mod frame;
mod metadata;
mod output;
mod refinement;
mod resolve;
mod statistics;

pub(crate) use accumulator::{Accumulator, Places};
pub use frame::Frame;
pub use output::Output;
pub(crate) use output::{PixelFilter, rgb, rgba, xyz};
pub(crate) use refinement::{Costly, Rendered};
pub(crate) use resolve::RayRecords;
pub use statistics::{FluxShares, Statistics};
