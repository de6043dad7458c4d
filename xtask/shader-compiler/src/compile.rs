//! Step 1: rust-gpu.

use anyhow::{Context, Result};
use cargo_gpu_install::install::Install;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use vitrum_shader_manifest::TARGET;

/// The features of `shaders-rs` that select entry points, compiled one after the other: all at once, rust-gpu took 22 GB of memory.
const PARTS: [&str; 3] = ["kernels-without-voxels", "kernels-of-integers", "kernels-of-floats"];

/// Compiles `shaders-rs`; the path of each entry point's module.
///
/// The first run builds rust-gpu's compiler, which takes 10 to 20 minutes on two cores and is kept in the user's cache. The
/// pinned nightly is installed through rustup if it is missing.
pub fn compile(root: &Path) -> Result<BTreeMap<String, PathBuf>> {
    let shaders = root.join("shaders-rs");
    let mut install = Install::from_shader_crate(shaders.clone());
    install.auto_install_rust_toolchain = true;
    let backend =
        install.run().context("rust-gpu's compiler could not be installed (it needs rustup and the pinned nightly)")?;
    let mut modules = BTreeMap::new();
    for part in PARTS {
        let mut builder = backend.to_spirv_builder(&shaders, TARGET);
        builder.build_script.defaults = false;
        builder.multimodule = true;
        builder.extra_args = vec!["--no-spirv-opt".to_owned()];
        let built = builder
            .shader_crate_features([part.to_owned()])
            .build()
            .with_context(|| format!("rust-gpu could not compile the {part}"))?;
        let entry_points = built.module.unwrap_multi().iter();
        modules.extend(
            entry_points.map(|(name, path)| (name.rsplit("::").next().unwrap_or(name).to_owned(), path.clone())),
        );
    }
    Ok(modules)
}
