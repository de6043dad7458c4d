//! Volumes that are larger than the device's memory for them: cubes of voxels, pages, come before the planes that need them and make
//! room for others behind them (ADR 9).
//!
//! [`needs`] finds out which pages are looked at on the way to which planes, [`schedule`] when they come and where they lie, and [`pool`]
//! writes them. All is known before the frame starts, so that nothing is read back.

mod needs;
mod pool;
mod schedule;

pub(super) use needs::{Needs, Sampling};
pub(super) use pool::pools;
