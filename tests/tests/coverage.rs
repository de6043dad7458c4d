//! T1's cases together run every kernel, and those that specialise in every mode.

use std::collections::BTreeSet;

use vitrum::backend::CpuBackend;
use vitrum::method::sweep::Sweep;
use vitrum_conformance::{Failure, kernels};
use vitrum_kernels::abi::sweep::{SweepUniforms, mode};
use vitrum_kernels::kernel::ALL;

#[test]
fn every_kernel_in_every_mode_is_compared() -> Result<(), Failure> {
    let mut backend = CpuBackend::new(Some(1))?;
    let mut seen = BTreeSet::new();
    for case in kernels::cases(16, 16)? {
        let sweep = Sweep::prepare(&case.scene, &case.inputs, &mut backend)?;
        for pass in &sweep.passes.passes {
            let uniforms: SweepUniforms = bytemuck::pod_read_unaligned(&pass.uniforms);
            seen.insert((pass.kernel.declaration.name, uniforms.dispatch.z));
        }
        sweep.free(&mut backend);
    }
    let names: BTreeSet<&str> = seen.iter().map(|&(name, _)| name).collect();
    // The probe is T0's: `functions` runs it. Voxels are no scene: `tests/voxelize/backends.rs` compares what they come to.
    let elsewhere = |name: &str| name.starts_with("probe_") || name.starts_with("voxelize_");
    let listed = ALL.iter().map(|kernel| kernel.declaration.name).filter(|name| !elsewhere(name));
    assert_eq!(names, listed.collect());
    let modes = |prefix: &str| -> BTreeSet<u32> {
        seen.iter().filter(|(name, _)| name.starts_with(prefix)).map(|&(_, mode)| mode).collect()
    };
    let mut all = BTreeSet::from([mode::STRAIGHT, mode::CENTRAL, mode::CHAIN]);
    for reader in ["sweep_refract_light", "sweep_advance_sheet"] {
        assert_eq!(modes(reader), all, "{reader}");
    }
    all.insert(mode::UNSHADED);
    assert_eq!(modes("sweep_propagate_rays"), all);
    Ok(())
}
