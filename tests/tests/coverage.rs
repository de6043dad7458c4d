//! T1's cases together run every kernel, and those that specialise in every mode.

use std::collections::BTreeSet;

use vitrum::backend::CpuBackend;
use vitrum_conformance::{Failure, kernels};
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::sweep::receiver;
use vitrum_kernels::kernel::ALL;

#[test]
fn every_kernel_in_every_mode_is_compared() -> Result<(), Failure> {
    let mut backend = CpuBackend::new(Some(1))?;
    let mut seen = BTreeSet::new();
    for case in kernels::cases(16, 16)? {
        let frame = kernels::prepare(&case, &mut backend)?;
        for pass in &frame.passes().passes {
            // Every uniform block begins with it.
            let dispatch: Dispatch = bytemuck::pod_read_unaligned(&pass.uniforms[..size_of::<Dispatch>()]);
            seen.insert((pass.kernel.declaration.name, dispatch.mode));
        }
    }
    // No frame has the passes that show the light on a wavefront's plane: tests of closed forms run them, on both backends.
    seen.insert(("sweep_land_cells", receiver::OBSERVED));
    let names: BTreeSet<&str> = seen.iter().map(|&(name, _)| name).collect();
    // The probe is T0's: `functions` runs it. Voxels and shadow maps are made before frames: `tests/voxelize/backends.rs` and
    // `tests/shadow/backends.rs` compare what they come to.
    // Rays through streamed volumes end where they turn: no list of passes follows them. Projections show values, and no bodies.
    let elsewhere = |name: &str| {
        ["probe_", "voxelize_", "shadow_"].iter().any(|prefix| name.starts_with(prefix))
            || name.starts_with("sweep_follow_rays") && name.ends_with("_paged")
            || name == "sweep_project_rays_u16_with_bodies"
    };
    let listed = ALL.iter().map(|kernel| kernel.declaration.name).filter(|name| !elsewhere(name));
    assert_eq!(names, listed.collect());
    // A family's kernels differ in how voxels are read, and its modes in what is made of them: together they are run in all.
    let seen_modes = |family: &str| -> BTreeSet<u32> {
        let members = ALL.iter().map(|kernel| &kernel.declaration).filter(|declaration| declaration.family == family);
        let names: BTreeSet<&str> = members.map(|declaration| declaration.name).collect();
        seen.iter().filter(|(name, _)| names.contains(name)).map(|&(_, mode)| mode).collect()
    };
    for declaration in ALL.iter().map(|kernel| &kernel.declaration).filter(|declaration| !elsewhere(declaration.name)) {
        let declared = declaration.modes.iter().copied().collect();
        assert_eq!(seen_modes(declaration.family), declared, "modes of {}", declaration.family);
    }
    Ok(())
}
