//! Rays through meshes against closed forms, on both backends.

mod ball;
mod caustics;
mod contact;
mod dispersion;
mod faces;
mod footprint;
mod furnace;
mod mirror;
mod slab;
mod sweep;
mod watertight;
mod zoom;

use vitrum::backend::{Backend, CpuBackend};
use vitrum_conformance::{Failure, adapter};

/// Calls `check` with each backend. Kernels write the same bits on both; the test's conclusions from them are checked on both all the
/// same.
fn on_both(check: impl Fn(&mut dyn Backend) -> Result<(), Failure>) -> Result<(), Failure> {
    check(&mut CpuBackend::new(None)?)?;
    adapter::for_test().map_or(Ok(()), |mut gpu| check(&mut gpu))
}
