//! Toolchains of rustup: the nightly that compiles the kernels to SPIR-V, and further targets of the stable one.

use std::process::Stdio;

use vitrum_shader_manifest::TOOLCHAIN;

use crate::command::{program, run};

const COMPONENTS: [&str; 3] = ["rust-src", "rustc-dev", "llvm-tools"];

/// Whether the toolchain is installed; fetches it through rustup if it is not.
pub fn is_available() -> bool {
    is_installed() || {
        let mut command = program("rustup");
        command.args(["toolchain", "install", TOOLCHAIN, "--profile", "minimal"]);
        command.args(COMPONENTS.iter().flat_map(|component| ["--component", component]));
        run(&mut command).is_ok() && is_installed()
    }
}

fn is_installed() -> bool {
    let mut command = program("rustup");
    command.args(["component", "list", "--installed", "--toolchain", TOOLCHAIN]).stderr(Stdio::null());
    command.output().is_ok_and(|output| {
        let installed = String::from_utf8_lossy(&output.stdout);
        output.status.success() && COMPONENTS.iter().all(|component| installed.contains(component))
    })
}

/// Whether the stable toolchain compiles for `target`; installs the target through rustup if it is missing.
pub fn has_target(target: &str) -> bool {
    let is_installed = || {
        let mut command = program("rustup");
        command.args(["target", "list", "--installed"]).stderr(Stdio::null());
        command.output().is_ok_and(|output| String::from_utf8_lossy(&output.stdout).lines().any(|line| line == target))
    };
    is_installed() || (run(program("rustup").args(["target", "add", target])).is_ok() && is_installed())
}
