//! Streaming of volumes that are larger than the device's memory for them: pages, which are cubes of voxels, are loaded before the
//! planes that need them and make room for others behind them (ADR 9).
//!
//! [`residency`] finds out which pages are looked at on the way to which planes, [`schedule`] when they come and where they lie, and [`pool`]
//! writes them. All is known before the frame starts, so that nothing is read back.

mod pool;
mod residency;
mod schedule;

pub(super) use pool::pools;
pub(super) use residency::{Residency, Sampling, Swept};
