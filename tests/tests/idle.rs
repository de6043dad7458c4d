//! Passes without work are left out on either backend, and the host is not asked which ones: nothing is read in the middle of a frame.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use vitrum::backend::{Backend, CpuBackend, Pass, PassList, ReadBack as _, WhileBusy};
use vitrum::method::Tools;
use vitrum::method::voxels::{Rays, UploadedMesh};
use vitrum_conformance::altered::Altered;
use vitrum_conformance::case::Case;
use vitrum_conformance::{Failure, adapter, kernels};
use vitrum_kernels::abi::record::{fate, mirror, path};

/// Pixels along each side.
const EDGE: u32 = 40;
/// Voxels along a mesh's longest edge.
const RESOLUTION: u32 = 32;

fn prepare(case: &Case, backend: &mut dyn Backend) -> Result<Rays, Failure> {
    let Case { scene, assets, .. } = case;
    let uploaded = UploadedMesh::new(scene, assets, &mut Tools { backend: &mut *backend, progress: &mut |_| true })?;
    Ok(Rays::prepare(scene, assets, &uploaded, backend)?)
}

/// The CPU, the best adapter, and the same with shaders translated and no more than portable limits.
fn backends() -> Result<Vec<Box<dyn Backend>>, Failure> {
    let adapters = [adapter::for_test(), adapter::portable_for_test()];
    let adapters = adapters.into_iter().flatten().map(|gpu| Box::new(gpu) as Box<dyn Backend>);
    Ok([Box::new(CpuBackend::new(None)?) as Box<dyn Backend>].into_iter().chain(adapters).collect())
}

#[test]
fn nothing_is_read_while_a_frame_of_a_mesh_runs() -> Result<(), Failure> {
    let Some(gpu) = adapter::for_test() else { return Ok(()) };
    let reads = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&reads);
    let mut gpu = Altered::reading(gpu, move |_| {
        count.fetch_add(1, Ordering::Relaxed);
    });
    for case in kernels::meshes(EDGE, RESOLUTION)? {
        let rays = prepare(&case, &mut gpu)?;
        let before = reads.load(Ordering::Relaxed);
        rays.run(&mut gpu, &mut |_| true)?;
        let after = reads.load(Ordering::Relaxed);
        assert_eq!(after - before, 0, "{}: buffers were read", case.name);
        rays.film(&mut gpu)?;
        assert_eq!(reads.load(Ordering::Relaxed) - after, 1, "{}: reads are not counted", case.name);
    }
    Ok(())
}

/// A pass without work is followed by passes that would set all rays back to where they start, if they ran.
#[test]
fn passes_behind_one_without_work_run_no_workgroups() -> Result<(), Failure> {
    let cases = kernels::meshes(EDGE, RESOLUTION)?;
    for name in ["mesh ball", "mesh ball paper", "mesh ball exact"] {
        let case = cases.iter().find(|case| case.name == name).expect("it is listed");
        for mut backend in backends()? {
            let backend = backend.as_mut();
            let about = format!("{name} on {}", backend.adapter());
            let rays = prepare(case, backend)?;
            let (initialize, march) = (&rays.passes.passes[0], &rays.passes.passes[1]);
            let mut after = |status: f32, marches: usize, depends: bool| -> Result<Vec<f32>, Failure> {
                let records = march.output().expect("it updates").clone();
                let count = EDGE as usize * EDGE as usize;
                backend.write(&records, count * path::SIZE, &mut |words| {
                    words.fill(0);
                    words[path::STATUS * count..][..count].fill(status.to_bits());
                })?;
                let passes: Vec<Pass> = (0..marches).map(|_| march.clone()).chain([initialize.clone()]).collect();
                let names = |pass: &Pass| pass.kernel.declaration.name;
                let part = WhileBusy { kernel: names(march), passes: passes.iter().map(names).collect(), until: None };
                let while_busy = if depends { vec![part] } else { Vec::new() };
                backend.run(&PassList { passes, while_busy, ..PassList::default() }, &mut |_| true)?;
                Ok(backend.read_all(&records)?)
            };
            let started = after(fate::ACTIVE, 1, false)?;
            assert!(started.iter().any(|&component| component != 0.0), "{about}: rays start nowhere");
            assert!(
                after(fate::LEFT, 1, false)? == started,
                "{about}: passes were left out that do not depend on others"
            );
            for marches in [1, 2, 3] {
                let ended = after(fate::LEFT, marches, true)?;
                let statuses = &ended[path::STATUS * EDGE as usize * EDGE as usize..];
                assert!(
                    statuses.starts_with(&[fate::LEFT]),
                    "{about}: rays were set back behind {marches} idle passes"
                );
                assert!(!ended.iter().any(|&component| component != 0.0 && component != fate::LEFT), "{about}");
            }
            assert!(after(fate::ACTIVE, 1, true)? == started, "{about}: a pass with work was taken to be idle");
        }
    }
    Ok(())
}

/// Whether a kernel that reports work has some left in the records that it is about to update.
fn has_work(pass: &Pass, records: &[f32]) -> bool {
    let count = pass.width as usize * pass.height as usize;
    let component = |number: usize| records[number * count..][..count].iter();
    if pass.kernel.declaration.components == mirror::SIZE {
        component(mirror::STAGE).any(|&stage| stage != mirror::stage::FOUND)
    } else {
        component(path::STATUS).any(|&status| status == fate::ACTIVE || status == fate::SEEKS)
    }
}

/// How many passes of each kernel a frame needs: those before the first without work, and that one. The CPU runs them one by one.
fn needed(case: &Case) -> Result<BTreeMap<&'static str, u32>, Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let rays = prepare(case, &mut cpu)?;
    let (mut count, mut idle) = (BTreeMap::new(), Vec::new());
    for (number, pass) in rays.passes.passes.iter().enumerate() {
        let name = pass.kernel.declaration.name;
        for part in rays.passes.while_busy.iter().filter(|part| part.until == Some(name)) {
            idle.retain(|kernel| *kernel != part.kernel);
        }
        let parts = rays.passes.while_busy.iter().filter(|part| idle.contains(&part.kernel));
        if parts.flat_map(|part| &part.passes).any(|other| *other == name) {
            continue;
        }
        if pass.kernel.declaration.reports_work() {
            let records: Vec<f32> = cpu.read_all(pass.output().expect("it updates"))?;
            idle.extend((!has_work(pass, &records)).then_some(name));
        }
        cpu.run(&rays.passes.part(number, number + 1), &mut |_| true)?;
        *count.entry(name).or_default() += 1;
    }
    Ok(count)
}

#[test]
fn a_gpu_runs_the_passes_that_a_frame_needs() -> Result<(), Failure> {
    let Some(mut gpu) = adapter::for_test() else { return Ok(()) };
    let mut left_out = 0;
    for case in kernels::meshes(EDGE, RESOLUTION)? {
        let rays = prepare(&case, &mut gpu)?;
        gpu.take_kernel_times();
        rays.run(&mut gpu, &mut |_| true)?;
        let times = gpu.take_kernel_times();
        let expected = needed(&case)?;
        // Some devices have no clock.
        if !times.is_empty() {
            let found: BTreeMap<&str, u32> = times.iter().map(|time| (time.kernel, time.passes)).collect();
            assert_eq!(found, expected, "{}", case.name);
        }
        left_out += rays.passes.passes.len() - expected.values().map(|&passes| passes as usize).sum::<usize>();
    }
    assert!(left_out > 100, "{left_out} passes were left out, so that nothing is shown");
    Ok(())
}
