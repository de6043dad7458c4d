//! Compiles the kernels to SPIR-V and WGSL: `vitrum-shader-compiler [--check]`, run by `cargo xtask shaders`.
//!
//! 1. rust-gpu compiles `shaders-rs`, one module an entry point, unoptimised;
//! 2. [`exact`] pins the arithmetic;
//! 3. spirv-val checks the module, spirv-opt optimises it, spirv-val checks the result;
//! 4. naga translates it to WGSL;
//! 5. `crates/vitrum-shaders` gets the modules, the list of their names and the manifest. With `--check` nothing is written, and any
//!    byte that differs from what is committed is an error.

mod compile;
mod exact;
mod optimise;
mod output;

use anyhow::{Context, Result, bail};
use output::Output;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use vitrum_kernels::kernel::{ALL, Access, Declaration, Element};
use vitrum_shader_manifest::{File, Manifest, Module};
use vitrum_shader_translation::Translation;

fn main() -> Result<()> {
    let check = match std::env::args().skip(1).collect::<Vec<_>>().as_slice() {
        [] => false,
        [flag] if flag == "--check" => true,
        other => bail!("expected nothing or --check, got {other:?}"),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .context("this crate lies two folders below the workspace")?;

    let mut manifest = Manifest::of_tree(root)?;
    let mut files = BTreeMap::new();
    for (name, words) in build(root)? {
        let declaration = ALL
            .iter()
            .map(|kernel| &kernel.declaration)
            .find(|declaration| declaration.name == name)
            .with_context(|| format!("entry point {name} is not in the list of kernels"))?;
        let spirv = bytemuck::cast_slice::<u32, u8>(&words).to_vec();
        let translation = Translation::of_spirv(&spirv).with_context(|| name.clone())?;
        let wgsl = translation.wgsl().with_context(|| name.clone())?.into_bytes();
        let module = Module {
            spirv: File::new(format!("spirv/{name}.spv"), &spirv),
            wgsl: File::new(format!("wgsl/{name}.wgsl"), &wgsl),
            bindings: describe(declaration),
        };
        files.insert(module.spirv.path.clone(), spirv);
        files.insert(module.wgsl.path.clone(), wgsl);
        manifest.modules.insert(name, module);
    }
    let output = Output::new(root, &manifest, files)?;
    if check { output.compare() } else { output.write() }
}

fn build(root: &Path) -> Result<BTreeMap<String, Vec<u32>>> {
    let module = |(name, path): (String, PathBuf)| {
        let bytes = std::fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
        let exact = exact::pin(&bytes).with_context(|| format!("{name}: pinning the arithmetic"))?;
        let words = optimise::optimise(&exact).with_context(|| name.clone())?;
        Ok((name, words))
    };
    let modules = compile::compile(root)?.into_par_iter().map(module).collect::<Result<BTreeMap<_, _>>>()?;
    for kernel in ALL {
        let name = kernel.declaration.name;
        if !modules.contains_key(name) {
            bail!("kernel {name} has no entry point in what rust-gpu made");
        }
    }
    Ok(modules)
}

fn describe(declaration: &Declaration) -> Vec<String> {
    declaration
        .bindings
        .iter()
        .map(|binding| {
            let access = match binding.access {
                Access::Uniform => "uniform",
                Access::Read => "read",
                Access::Write => "write",
                Access::Add => "add",
                Access::Update => "update",
                Access::Workgroups => "raise",
            };
            let element = match (binding.access, binding.element) {
                (Access::Uniform, _) => format!("{} bytes", declaration.uniform_bytes),
                (Access::Write | Access::Update, _) => format!("{} planes of f32", declaration.components),
                (Access::Add, _) => format!("{} words a texel", declaration.components),
                (Access::Workgroups, _) => "3 words".to_owned(),
                (Access::Read, Element::U32) => "u32".to_owned(),
                (Access::Read, Element::F32) => "f32".to_owned(),
            };
            format!("{} {access} {}: {element}", binding.binding, binding.name)
        })
        .collect()
}
