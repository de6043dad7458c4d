//! `cargo xtask shaders`: compiles the kernels to SPIR-V and WGSL.

use vitrum_shader_manifest::{Manifest, ManifestError, TOOLCHAIN};

use crate::command::{self, cargo};
use crate::failure::Failure;
use crate::toolchain;

/// Compile the kernels to SPIR-V and WGSL and write `crates/vitrum-shaders`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Write nothing; fail if what is committed is not what the sources give.
    #[arg(long)]
    check: bool,
}

/// The package that compiles the kernels. Its dependencies build SPIRV-Tools, which takes minutes, so it is left out
/// wherever the whole workspace is built, and always built alike (alone, for release) so that it is built once.
pub const COMPILER: &str = "vitrum-shader-compiler";

/// Bytes of a stack of rust-gpu's compiler.
const STACK: &str = "1073741824";

/// Runs the task.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.check { check() } else { compile(&[]) }
}

/// Holds the committed modules against the sources.
///
/// Stale hashes fail at once. Current ones are not enough, since a hand could have edited module and manifest, so the
/// kernels are compiled again and compared byte by byte, except where the toolchain cannot be fetched.
pub fn check() -> Result<(), Failure> {
    let stale = stale().map_err(|error| Failure::check(error.to_string()))?;
    if !stale.is_empty() {
        let reasons = stale.join("\n  ");
        return Err(Failure::check(format!("the committed modules are stale; run `cargo xtask shaders`\n  {reasons}")));
    }
    if toolchain::is_available() {
        return compile(&["--", "--check"]);
    }
    eprintln!("\n!! WARNING: {TOOLCHAIN} is not installed, and rustup could not fetch it.");
    eprintln!("!! The kernels were NOT compiled again: only the hashes in the manifest are known to be right.\n");
    Ok(())
}

/// The differences between the tree and the manifest of the committed modules.
fn stale() -> Result<Vec<String>, ManifestError> {
    let root = command::root();
    Manifest::read(&root)?.stale(&root)
}

/// Runs the shader compiler. Its first run also builds rust-gpu's code generator, 10 to 20 minutes on two cores, which
/// stays in the user's cache folder.
fn compile(arguments: &[&str]) -> Result<(), Failure> {
    // The compiler reads the kernels' declarations and runs none of them: optimising them takes ten minutes of a core.
    let declarations = ["--config", "profile.release.package.vitrum-kernels.opt-level=0"];
    let mut command = cargo(["run", "--release", "--package", COMPILER]);
    // rust-gpu goes through a kernel's control flow by recursion, deeper than the 8 MiB of a thread in the largest kernels.
    command::run(command.args(declarations).args(arguments).env("RUST_MIN_STACK", STACK))
}
