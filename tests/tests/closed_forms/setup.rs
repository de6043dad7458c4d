//! What the closed forms share, and the backends that they are tried on.

use vitrum::backend::Backend;
use vitrum_conformance::adapter;
pub use vitrum_conformance::closed_forms::{
    cube, end, light_on_planes, refracting, render, render_with_light, straight_on,
};

/// Both backends; the CPU's alone where there is no adapter and none is required.
pub fn backends() -> Vec<Box<dyn Backend>> {
    adapter::backends_for_test().expect("the CPU backend opens")
}
