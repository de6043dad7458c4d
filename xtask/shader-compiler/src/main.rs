//! Compiles the kernels to SPIR-V: `vitrum-shader-compiler [--check]`, run by `cargo xtask shaders`.
//!
//! 1. rust-gpu compiles `shaders-rs`, one module an entry point, unoptimised;
//! 2. [`exact`] pins the arithmetic;
//! 3. spirv-val checks the module, spirv-opt optimises it, spirv-val checks the result;
//! 4. `shaders-rs/spirv` gets the modules and the manifest. With `--check` nothing is written, and any byte that differs
//!    from what is committed is an error.

mod compile;
mod exact;
mod optimise;

use anyhow::{Context, Result, bail};
use std::collections::BTreeMap;
use std::path::Path;
use vitrum_kernels::kernel::{ALL, Access, Declaration, Element};
use vitrum_shader_manifest::{Manifest, Module, folder, sha256};

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

    let modules = build(root)?;
    let mut manifest = Manifest::of_tree(root)?;
    for (name, words) in &modules {
        let declaration = ALL
            .iter()
            .map(|kernel| &kernel.declaration)
            .find(|declaration| declaration.name == name)
            .with_context(|| format!("entry point {name} is not in the list of kernels"))?;
        let bytes: &[u8] = bytemuck::cast_slice(words);
        manifest.modules.insert(
            name.clone(),
            Module {
                file: format!("{name}.spv"),
                sha256: sha256(bytes),
                bytes: bytes.len(),
                bindings: describe(declaration),
            },
        );
    }
    if check { compare(root, &manifest, &modules) } else { write(root, &manifest, &modules) }
}

fn build(root: &Path) -> Result<BTreeMap<String, Vec<u32>>> {
    let mut modules = BTreeMap::new();
    for (name, path) in compile::compile(root)? {
        let bytes = std::fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
        let exact = exact::pin(&bytes).with_context(|| format!("{name}: pinning the arithmetic"))?;
        let words = optimise::optimise(&exact).with_context(|| name.clone())?;
        modules.insert(name, words);
    }
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
            };
            let element = match (binding.access, binding.element) {
                (Access::Uniform, _) => format!("{} bytes", declaration.uniform_bytes),
                (Access::Write | Access::Update, _) => format!("{} planes of f32", declaration.components),
                (Access::Add, _) => format!("{} words a texel", declaration.components),
                (Access::Read, Element::U32) => "u32".to_owned(),
                (Access::Read, Element::F32) => "f32".to_owned(),
            };
            format!("{} {access} {}: {element}", binding.binding, binding.name)
        })
        .collect()
}

fn write(root: &Path, manifest: &Manifest, modules: &BTreeMap<String, Vec<u32>>) -> Result<()> {
    let folder = folder(root);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).with_context(|| format!("{} cannot be emptied", folder.display()))?;
    }
    std::fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    for (name, words) in modules {
        let path = folder.join(format!("{name}.spv"));
        std::fs::write(&path, bytemuck::cast_slice::<u32, u8>(words))
            .with_context(|| format!("{} cannot be written", path.display()))?;
        println!("{name}: {} bytes", words.len() * 4);
    }
    std::fs::write(folder.join("manifest.json"), manifest.to_json()?)?;
    Ok(())
}

fn compare(root: &Path, manifest: &Manifest, modules: &BTreeMap<String, Vec<u32>>) -> Result<()> {
    let committed = Manifest::read(root)?;
    let mut differing = Vec::new();
    for (name, words) in modules {
        let path = folder(root).join(format!("{name}.spv"));
        let bytes = std::fs::read(&path).unwrap_or_default();
        if bytes != bytemuck::cast_slice::<u32, u8>(words) {
            differing.push(format!("{name}.spv: {} bytes committed, {} built", bytes.len(), words.len() * 4));
        }
    }
    if &committed != manifest {
        differing.push("manifest.json".to_owned());
    }
    if !differing.is_empty() {
        bail!(
            "the committed SPIR-V is not what the sources give; run `cargo xtask shaders` and commit the result:\n  {}",
            differing.join("\n  ")
        );
    }
    println!("{} modules are what the sources give", modules.len());
    Ok(())
}
