//! What the closed forms share, and the backends that they are tried on.

use vitrum::backend::{Backend, CpuBackend};
use vitrum_conformance::adapter;
pub use vitrum_conformance::closed_forms::{cube, end, light_on_planes, refracting, render, straight_on};

/// Both backends; the CPU's alone where there is no adapter and none is required.
pub fn backends() -> Vec<Box<dyn Backend>> {
    let cpu: Box<dyn Backend> = Box::new(CpuBackend::new(None).expect("the CPU backend opens"));
    let gpu = adapter::for_test().map(|gpu| Box::new(gpu) as Box<dyn Backend>);
    [cpu].into_iter().chain(gpu).collect()
}
