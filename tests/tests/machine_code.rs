//! The machine code of the sweep's kernels on x86-64: vector code for sixteen lanes with AVX-512, for eight with AVX2, and no loop that
//! may panic. Without it pictures stay right and take several times as long, which no other test would see.
//!
//! The test reads its own machine code; it needs an optimised build, as `cargo xtask test` makes.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use std::hint::black_box;
use std::{env, fs};

use iced_x86::{Decoder, DecoderOptions, FlowControl, Instruction, Mnemonic, Register};
use object::{
    File, Object as _, ObjectSection as _, ObjectSymbol as _, ObjectSymbolTable as _, RelocationTarget, Symbol,
};
use vitrum_kernels::kernel::ALL;

/// The kernels that run for every plane, and the least ratio of instructions on whole vectors to those on one float, with AVX-512 and
/// with AVX2.
///
/// Bodies are vector code without scalar remainders: a body that falls back to scalar code lowers the ratio. Bounds are a tenth below the
/// ratios found with Rust 1.95, and half of them where there is next to no scalar code. The first that a kernel's name begins with
/// counts.
const LEAST: [(&str, [f64; 2]); 15] = [
    // Scalar code finds out for each beam and block which pixels are drawn. Without scattered reads AVX2 has no vector code for pixels.
    ("beams_scatter_beam", [20.0, 0.06]),
    ("sweep_filter_light", [40.0, 25.0]),
    // Bodies within the volume, their surfaces and light beside them, are looked for in loops, whose code stays scalar.
    ("sweep_refract_light_u16_with_bodies", [1.7, 0.14]),
    ("sweep_advance_nodes_u16_with_bodies", [1.03, 0.35]),
    ("sweep_propagate_rays_u16_with_bodies", [0.16, 0.18]),
    ("sweep_trace_light", [15.0, 4.7]),
    // What is the same for nine sources of light is set up by scalar code.
    ("sweep_gather_light", [40.0, 19.0]),
    ("sweep_refract_light", [12.6, 2.2]),
    ("sweep_concentrate_light", [20.0, 20.0]),
    // With AVX2, which has no scattered reads that pay, the bodies of voxels in pages stay scalar code.
    ("sweep_advance_nodes", [25.8, 1.0]),
    // With AVX2 the bodies at the border and at receivers stay scalar code, and of some formats those that look at light between eight samples.
    // Of volumes of floats one body or two stay scalar code with AVX-512, too: rays that may meet a receiver, an isosurface or the border look at an
    // isosurface's gradient there, and LLVM takes no body that reads so much from words of their own.
    ("sweep_propagate_rays_f32_with_ior_paged", [3.3, 0.76]),
    ("sweep_propagate_rays_f32_with_ior", [3.5, 1.07]),
    ("sweep_propagate_rays_f32_paged", [6.4, 0.79]),
    ("sweep_propagate_rays_f32", [8.8, 0.91]),
    ("sweep_propagate_rays", [51.0, 0.91]),
];

/// Whether a register holds all lanes of a vector.
type IsWhole = fn(Register) -> bool;

/// The builds, and how their functions are named.
const BUILDS: [(&str, IsWhole); 2] = [("avx512", Register::is_zmm), ("avx2", Register::is_ymm)];

/// The instructions of a function, counted by kind.
#[derive(Debug, Default)]
struct Contents {
    /// Arithmetic on whole vectors.
    wide: u32,
    /// Arithmetic on one float.
    scalar: u32,
    /// Functions that are called.
    calls: Vec<String>,
}

fn contents(file: &File, symbol: &Symbol, is_whole: IsWhole) -> Contents {
    use Mnemonic::{
        Vaddps, Vaddss, Vdivps, Vdivss, Vmaxps, Vmaxss, Vminps, Vminss, Vmulps, Vmulss, Vsqrtps, Vsqrtss, Vsubps,
        Vsubss,
    };
    let section = file.section_by_index(symbol.section_index().expect("functions lie in a section")).unwrap();
    let code = section.data_range(symbol.address(), symbol.size()).unwrap().unwrap_or_default();
    let mut contents = Contents::default();
    for instruction in Decoder::with_ip(64, code, symbol.address(), DecoderOptions::NONE) {
        match instruction.mnemonic() {
            Vaddps | Vsubps | Vmulps | Vdivps | Vsqrtps | Vminps | Vmaxps => {
                contents.wide += u32::from(is_whole(instruction.op0_register()));
            }
            Vaddss | Vsubss | Vmulss | Vdivss | Vsqrtss | Vminss | Vmaxss => contents.scalar += 1,
            _ => {}
        }
        if matches!(instruction.flow_control(), FlowControl::Call | FlowControl::IndirectCall) {
            contents.calls.push(callee(file, &instruction));
        }
    }
    contents
}

/// The name of the called function; empty if the program has no symbol for it.
fn callee(file: &File, call: &Instruction) -> String {
    let at = |address: u64| {
        let called = file.symbols().find(|symbol| symbol.address() == address && symbol.size() > 0);
        called.map_or(String::new(), |symbol| name(&symbol))
    };
    if call.flow_control() == FlowControl::Call {
        return at(call.near_branch_target());
    }
    // Others are called through a table that the loader fills.
    let slot = call.ip_rel_memory_address();
    let entry = file.dynamic_relocations().into_iter().flatten().find(|&(address, _)| address == slot);
    let Some((_, entry)) = entry else { return String::new() };
    let RelocationTarget::Symbol(index) = entry.target() else { return at(entry.addend() as u64) };
    let symbol = file.dynamic_symbol_table().and_then(|table| table.symbol_by_index(index).ok());
    symbol.map_or(String::new(), |symbol| name(&symbol))
}

fn name(symbol: &Symbol) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol.name().unwrap_or("")))
}

#[test]
fn kernels_are_vector_code_whose_loops_do_not_panic() {
    if cfg!(debug_assertions) {
        println!("a build with debug assertions panics where they do not hold: nothing to see here");
        return;
    }
    // Else the linker leaves the kernels out.
    black_box(ALL);
    let bytes = fs::read(env::current_exe().unwrap()).unwrap();
    let file = File::parse(&*bytes).unwrap();
    let functions: Vec<(String, Symbol)> = file.symbols().map(|symbol| (name(&symbol), symbol)).collect();
    let mut lower = Vec::new();
    for kernel in ALL.iter().map(|kernel| kernel.declaration.name) {
        let Some((_, least)) = LEAST.into_iter().find(|(prefix, _)| kernel.starts_with(prefix)) else { continue };
        for ((build, is_whole), least) in BUILDS.into_iter().zip(least) {
            let path = format!("kernel::list::{kernel}::{build}");
            let found = functions.iter().find(|(name, _)| name.ends_with(&path));
            let (_, symbol) = found.unwrap_or_else(|| panic!("no function {path}: was it inlined?"));
            lower.extend(check(&path, &contents(&file, symbol, is_whole), least));
        }
    }
    assert!(lower.is_empty(), "{}", lower.join("\n"));
}

/// A sentence if the ratio of vector code to scalar code is below `least`.
fn check(path: &str, contents: &Contents, least: f64) -> Option<String> {
    let Contents { wide, scalar, calls } = contents;
    let ratio = f64::from(*wide) / f64::from(*scalar);
    println!("{path}: {ratio:.2}");
    // The copies of the rest of a row and the look-ups of marks are not inlined, all else is. Before the loops a chunk without room
    // for its records and a mode that is not in the list panic, each once.
    let ours = ["lanes::copy_some", "skip::Marks::around"];
    let expected = |name: &str| ours.iter().any(|end| name.ends_with(end)) || ["memcpy", "memset"].contains(&name);
    let (panics, others): (Vec<_>, Vec<_>) =
        calls.iter().filter(|name| !expected(name)).partition(|name| name.starts_with("core::panicking::panic"));
    assert!(panics.len() <= 2, "{path} panics in {} places", panics.len());
    assert!(others.is_empty(), "{path} calls {others:?}");
    (ratio < least).then(|| format!("{path}: {wide} wide and {scalar} scalar operations: {ratio:.2} below {least}"))
}
