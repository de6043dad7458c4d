//! `cargo xtask ci`, step `wasm`: the renderer compiles for browsers.

use crate::command::{cargo, run};
use crate::failure::Failure;
use crate::steps::Completion;
use crate::toolchain;

const TARGET: &str = "wasm32-unknown-unknown";

/// Type-checks the renderer for WebAssembly: alone, and with WebGPU, files and built-in scenes. Threads need a compiler that is not stable.
pub fn check() -> Result<Completion, Failure> {
    if !toolchain::has_target(TARGET) {
        return Ok(Completion::LeftOut(format!("target {TARGET} is not installed, and rustup could not fetch it")));
    }
    let check = ["check", "--release", "--target", TARGET, "--package", "vitrum", "--no-default-features"];
    run(&mut cargo(check))?;
    run(cargo(check).args(["--features", "builtin,gpu,io"]))?;
    Ok(Completion::Whole)
}
