//! Modules of kernels on a device in a browser, which takes WGSL alone.

use std::borrow::Cow;
use vitrum_shaders::wgsl;
use wgpu::{Device, ShaderModule};

/// The module of a kernel that `vitrum_shaders::NAMES` lists.
pub(super) fn passed_through(device: &Device, kernel: &str) -> ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(kernel),
        source: wgpu::ShaderSource::Wgsl(Cow::Borrowed(wgsl(kernel).unwrap_or_default())),
    })
}

/// The module of a kernel: the committed WGSL is the translation.
pub(super) fn translated(device: &Device, kernel: &str) -> Result<ShaderModule, String> {
    Ok(passed_through(device, kernel))
}
