//! Modules of kernels on a device: SPIR-V passed through, or translated by naga.

use std::borrow::Cow;
use vitrum_kernels::kernel::WORKGROUP;
use vitrum_shaders::{ENTRY_POINT, spirv};
use wgpu::naga::compact::{KeepUnused, compact};
use wgpu::naga::front::spv;
use wgpu::{Device, ShaderModule};

/// A kernel's SPIR-V, which `vitrum_shaders::NAMES` must list.
fn module(kernel: &str) -> &'static [u8] {
    spirv(kernel).unwrap_or_default()
}

/// The module of a kernel, passed through to the driver. The device must allow that.
pub(super) fn passed_through(device: &Device, kernel: &str) -> ShaderModule {
    let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
        label: Some(kernel),
        entry_points: Cow::Owned(vec![wgpu::PassthroughShaderEntryPoint {
            name: Cow::Borrowed(ENTRY_POINT),
            workgroup_size: (WORKGROUP, WORKGROUP, 1),
        }]),
        spirv: Some(Cow::Owned(bytemuck::pod_collect_to_vec(module(kernel)))),
        ..Default::default()
    };
    // SAFETY: see `adapter::required`.
    unsafe { device.create_shader_module_passthrough(descriptor) }
}

/// The module of a kernel, which wgpu translates to the language of the device's interface; or the reason why it cannot.
///
/// wgpu would read SPIR-V by itself, but refuses most of the kernels' modules: rust-gpu leaves types behind that hold pointers, which
/// naga does not allow. Nothing uses these types, so that they go when the module is compacted (docs/adr/0017).
pub(super) fn translated(device: &Device, kernel: &str) -> Result<ShaderModule, String> {
    let options = spv::Options { adjust_coordinate_space: false, ..spv::Options::default() };
    let mut module = spv::parse_u8_slice(module(kernel), &options).map_err(|error| error.to_string())?;
    compact(&mut module, KeepUnused::No);
    Ok(device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(kernel),
        source: wgpu::ShaderSource::Naga(Cow::Owned(module)),
    }))
}
