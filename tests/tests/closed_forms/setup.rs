//! What the closed forms share, and the backends that they are tried on.

use vitrum::backend::{Backend, Choice, open};
pub use vitrum_conformance::closed_forms::{cube, end, light_on_planes, refracting, render, straight_on};

/// Both backends; the GPU's is left out, loudly, where there is none and none is required.
pub fn backends() -> Vec<Box<dyn Backend>> {
    let mut all = vec![open(Choice::Cpu, None, None).expect("the CPU backend opens")];
    match open(Choice::Gpu, None, None) {
        Ok(gpu) => all.push(gpu),
        Err(error) if std::env::var_os("VITRUM_REQUIRE_GPU").is_some() => {
            panic!("VITRUM_REQUIRE_GPU is set, but there is no GPU backend: {error}")
        }
        Err(error) => println!("[left out] 1 backend: {error}"),
    }
    all
}
