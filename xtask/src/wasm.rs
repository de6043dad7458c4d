//! `cargo xtask ci`, step `wasm`: the renderer compiles for browsers.

use crate::command::{cargo, run};
use crate::failure::Failure;
use crate::steps::Completion;
use crate::toolchain;

const TARGET: &str = "wasm32-unknown-unknown";

/// Type-checks the renderer for WebAssembly, with WebGPU.
pub fn check() -> Result<Completion, Failure> {
    if !toolchain::has_target(TARGET) {
        return Ok(Completion::LeftOut(format!("target {TARGET} is not installed, and rustup could not fetch it")));
    }
    run(&mut cargo(["check", "--release", "--target", TARGET, "--package", "vitrum"]))?;
    Ok(Completion::Whole)
}
