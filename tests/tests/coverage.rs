//! T1's cases together run every kernel, and those that specialise in every mode.

use std::collections::BTreeSet;

use vitrum::backend::CpuBackend;
use vitrum_conformance::{Failure, kernels};
use vitrum_kernels::abi::{sweep::mode, voxels};
use vitrum_kernels::glam::UVec4;
use vitrum_kernels::kernel::ALL;

#[test]
fn every_kernel_in_every_mode_is_compared() -> Result<(), Failure> {
    let mut backend = CpuBackend::new(Some(1))?;
    let mut seen = BTreeSet::new();
    for case in kernels::cases(16, 16)? {
        let frame = kernels::prepare(&case, &mut backend)?;
        for pass in &frame.passes().passes {
            // Every uniform block begins with width, height and mode.
            let dispatch: UVec4 = bytemuck::pod_read_unaligned(&pass.uniforms[..size_of::<UVec4>()]);
            seen.insert((pass.kernel.declaration.name, dispatch.z));
        }
    }
    let names: BTreeSet<&str> = seen.iter().map(|&(name, _)| name).collect();
    // The probe is T0's: `functions` runs it. Voxels and shadow maps are made before frames: `tests/voxelize/backends.rs` and
    // `tests/shadow/backends.rs` compare what they come to.
    let elsewhere = |name: &str| ["probe_", "voxelize_", "shadow_"].iter().any(|prefix| name.starts_with(prefix));
    let listed = ALL.iter().map(|kernel| kernel.declaration.name).filter(|name| !elsewhere(name));
    assert_eq!(names, listed.collect());
    let modes = |prefix: &str| -> BTreeSet<u32> {
        seen.iter().filter(|(name, _)| name.starts_with(prefix)).map(|&(_, mode)| mode).collect()
    };
    let mut all = BTreeSet::from([mode::STRAIGHT, mode::CENTRAL, mode::CHAIN]);
    assert_eq!(modes("sweep_advance_sheet"), all);
    all.extend([mode::CLEAR_STRAIGHT, mode::CLEAR_CENTRAL]);
    assert_eq!(modes("sweep_refract_light"), all);
    all.insert(mode::UNSHADED);
    assert_eq!(modes("sweep_propagate_rays"), all);
    for carrier in ["sweep_filter_light", "sweep_gather_light"] {
        assert_eq!(modes(carrier), BTreeSet::from([mode::STRAIGHT, mode::CLEAR_STRAIGHT]), "{carrier}");
    }
    let both = BTreeSet::from([voxels::mode::TWO_SURFACES, voxels::mode::MULTI_SURFACE]);
    for kernel in ["voxels_march", "voxels_march_paper", "voxels_seek"] {
        assert_eq!(modes(kernel), both, "{kernel}");
    }
    assert_eq!(modes("voxels_resolve"), BTreeSet::from([voxels::seen::ENVIRONMENT, voxels::seen::SURFACES]));
    Ok(())
}
