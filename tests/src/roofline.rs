//! How far kernels are from what the machine can do: time over the larger of two floors, the fewest bytes at the speed of a copy
//! and the arithmetic at the speed of the vector units (Williams et al. 2009, "Roofline").

use std::hint::black_box;
use std::thread;
use std::time::Instant;

use vitrum::backend::{CpuBackend, Pass};
use vitrum::method::sweep::Sweep;
use vitrum_io::Voxels;
use vitrum_kernels::kernel::{Access, InstructionSet};

use crate::Failure;
use crate::case::Case;
use crate::frames::render;
use crate::table;

/// The limits of a machine: bytes and operations a second.
#[derive(Debug, Clone, Copy)]
pub struct Ceilings {
    /// Bytes a second, read and written, of a copy by all threads.
    pub bytes: f64,
    /// Additions and multiplications of floats a second, by all threads.
    pub operations: f64,
}

/// Floats of each half of a copy: beyond any cache.
const COPIED: usize = 1 << 26;
/// Rounds of the arithmetic.
const ROUNDS: u32 = 1 << 24;

impl Ceilings {
    /// Measures both with `threads` threads; the best of three.
    #[must_use]
    pub fn measure(threads: usize) -> Self {
        let best = |run: &dyn Fn() -> f64| (0..3).map(|_| run()).fold(0.0, f64::max);
        Self { bytes: best(&|| copy(threads)), operations: best(&|| arithmetic(threads)) }
    }
}

/// Bytes a second.
fn copy(threads: usize) -> f64 {
    let source = vec![1.0f32; COPIED];
    let mut target = vec![0.0f32; COPIED];
    let part = COPIED.div_ceil(threads);
    let mut seconds = 0.0;
    // The first time maps the memory.
    for _ in 0..2 {
        let started = Instant::now();
        thread::scope(|scope| {
            for (target, source) in target.chunks_mut(part).zip(source.chunks(part)) {
                scope.spawn(|| target.copy_from_slice(source));
            }
        });
        seconds = started.elapsed().as_secs_f64();
        black_box(&target);
    }
    8.0 * COPIED as f64 / seconds
}

/// Sixteen lanes of a number.
type Lanes = [f32; 16];
/// Numbers at work: enough for the latency of two instructions.
type Accumulators = [Lanes; 8];

/// Multiplies and adds; kernels never fuse the two.
#[inline(always)]
fn work(sums: Accumulators, factor: f32) -> Accumulators {
    let next = |mut lanes: Lanes| {
        for lane in &mut lanes {
            *lane = *lane * factor + 1.0;
        }
        lanes
    };
    let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h] = sums;
    for _ in 0..ROUNDS {
        (a, b, c, d) = (next(a), next(b), next(c), next(d));
        (e, f, g, h) = (next(e), next(f), next(g), next(h));
    }
    [a, b, c, d, e, f, g, h]
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl")]
fn work_in_avx512(sums: Accumulators, factor: f32) -> Accumulators {
    work(sums, factor)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn work_in_avx2(sums: Accumulators, factor: f32) -> Accumulators {
    work(sums, factor)
}

fn work_in(set: InstructionSet, sums: Accumulators, factor: f32) -> Accumulators {
    match set {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: only sets that the machine has get here.
        InstructionSet::Avx512 => unsafe { work_in_avx512(sums, factor) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: as above.
        InstructionSet::Avx2 => unsafe { work_in_avx2(sums, factor) },
        _ => work(sums, factor),
    }
}

/// Operations a second.
fn arithmetic(threads: usize) -> f64 {
    let set = InstructionSet::best();
    let started = Instant::now();
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| black_box(work_in(set, black_box([[0.5; 16]; 8]), black_box(0.25))));
        }
    });
    let operations = 2.0 * 16.0 * 8.0 * f64::from(ROUNDS) * threads as f64;
    operations / started.elapsed().as_secs_f64()
}

/// Float instructions of a kernel's module, all modes together. Kernels have no loops but in those that scatter cells.
fn operations(kernel: &str) -> Result<u64, Failure> {
    let bytes = vitrum_shaders::spirv(kernel).ok_or_else(|| Failure::Setup(format!("{kernel} has no module")))?;
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
    let (mut at, mut count) = (5, 0);
    while at < words.len() {
        // OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv; OpExtInst, which are roots, roundings, extremes; comparisons.
        count += u64::from(matches!(words[at] & 0xffff, 127 | 129 | 131 | 133 | 136 | 12 | 180..=191));
        at += (words[at] >> 16).max(1) as usize;
    }
    Ok(count)
}

/// The fewest bytes that a pass moves: each record that it writes, and each record that it reads, once. Tables stay in a cache.
fn bytes(pass: &Pass, before: &[Pass], voxel_bytes: f64) -> f64 {
    let invocations = pass.invocations() as f64;
    let declaration = &pass.kernel.declaration;
    let own = declaration.components as f64 * 4.0 * invocations;
    let bindings = declaration.buffers().iter().zip(&pass.buffers);
    let read = bindings.map(|(binding, buffer)| match (binding.access, binding.name) {
        (Access::Write | Access::Add, _) => own,
        (Access::Update, _) => 2.0 * own,
        // A voxel an invocation.
        (_, "voxels" | "ior_voxels") => voxel_bytes * invocations,
        // Records that another kernel has written there.
        _ => before.iter().rfind(|other| other.output() == Some(buffer)).map_or(0.0, |other| {
            let alike = (other.width, other.height) == (pass.width, pass.height);
            let records = if alike { invocations } else { other.invocations() as f64 };
            records * other.kernel.declaration.components as f64 * 4.0
        }),
    });
    read.sum()
}

const HEADER: [&str; 9] =
    ["kernel", "passes", "ms", "share", "ns/invocation", "bytes/invocation", "operations", "floor ms", "time/floor"];

/// The table of a case on the CPU.
///
/// # Errors
/// If the backend fails, or a module cannot be read.
pub fn markdown(case: &Case, backend: &mut CpuBackend, ceilings: Ceilings) -> Result<String, Failure> {
    let prepared = Sweep::prepare(&case.scene, &case.assets, case.request, backend)?;
    let voxel_bytes = match &case.volume().voxels {
        Voxels::U8(_) => 1.0,
        Voxels::U16(_) => 2.0,
        Voxels::F32(_) => 4.0,
    };
    render(case, backend)?;
    let times = render(case, backend)?.statistics.kernels;
    let whole: f64 = times.iter().map(|time| time.ms).sum();
    let passes = &prepared.passes.passes;
    let mut rows = Vec::new();
    for time in &times {
        let of_kernel = passes.iter().enumerate().filter(|(_, pass)| pass.kernel.declaration.name == time.kernel);
        let invocations: f64 = of_kernel.clone().map(|(_, pass)| pass.invocations() as f64).sum();
        let moved: f64 = of_kernel.map(|(number, pass)| bytes(pass, &passes[..number], voxel_bytes)).sum();
        let operations = operations(time.kernel)?;
        let floor = (moved / ceilings.bytes).max(operations as f64 * invocations / ceilings.operations) * 1e3;
        rows.push([
            time.kernel.to_owned(),
            time.passes.to_string(),
            format!("{:.1}", time.ms),
            format!("{:.0} %", 100.0 * time.ms / whole),
            format!("{:.2}", time.ms * 1e6 / invocations),
            format!("{:.0}", moved / invocations),
            operations.to_string(),
            format!("{floor:.1}"),
            format!("{:.1}", time.ms / floor),
        ]);
    }
    drop(prepared);
    Ok(table::aligned(HEADER.map(str::to_owned), rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kernel_of_a_frame_has_a_row() {
        let case = Case::builtin("ball", 24, Some(16), &["sweep.light=texels"]).unwrap();
        let mut backend = CpuBackend::new(Some(1)).unwrap();
        let table = markdown(&case, &mut backend, Ceilings { bytes: 1e10, operations: 1e11 }).unwrap();
        for kernel in ["sweep_propagate_rays_u16", "sweep_gather_light", "sweep_refract_light_u16", "sweep_resolve"] {
            assert!(table.contains(kernel), "{table}");
        }
    }

    #[test]
    fn a_pass_moves_at_least_its_records() {
        let case = Case::builtin("ball", 24, Some(16), &["sweep.light=texels"]).unwrap();
        let mut backend = CpuBackend::new(Some(1)).unwrap();
        let sweep = Sweep::prepare(&case.scene, &case.assets, case.request, &mut backend).unwrap();
        let rays = sweep.passes.passes.iter().find(|pass| pass.kernel.declaration.name.contains("propagate")).unwrap();
        // 23 floats read and written, a voxel; besides, the irradiance of 4 floats a texel.
        let texels = f64::from(sweep.light_grid.size[0] * sweep.light_grid.size[1]);
        let expected = 24.0 * 24.0 * (2.0 * 92.0 + 2.0 * 2.0) + texels * 16.0;
        assert!((bytes(rays, &sweep.passes.passes, 2.0) - expected).abs() < 1e-6);
    }
}
