//! Pipelines, made from the kernels' declarations.

use super::adapter::Opened;
use super::{module, workgroups};
use crate::backend::BackendError;
use vitrum_kernels::kernel::{Access, Binding, Declaration};
use vitrum_shaders::{ENTRY_POINT, NAMES};

/// A kernel on the device.
pub(super) struct Pipeline {
    pub(super) pipeline: wgpu::ComputePipeline,
    pub(super) layout: wgpu::BindGroupLayout,
}

fn layout_entry(binding: &Binding, uniform_bytes: usize) -> wgpu::BindGroupLayoutEntry {
    // The least size; of which dispatches have a part each, the start is given with the dispatch.
    let (bytes, has_dynamic_offset) = match binding.access {
        Access::Uniform => (uniform_bytes as u64, true),
        Access::Workgroups => (workgroups::BYTES, true),
        _ => (4, false),
    };
    let ty = match binding.access {
        // Not a uniform buffer: lavapipe compiles a kernel anew for every value of a uniform that decides a branch.
        Access::Uniform | Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
        Access::Write | Access::Update | Access::Add | Access::Workgroups => {
            wgpu::BufferBindingType::Storage { read_only: false }
        }
    };
    wgpu::BindGroupLayoutEntry {
        binding: binding.binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset, min_binding_size: wgpu::BufferSize::new(bytes) },
        count: None,
    }
}

impl Pipeline {
    /// Compiles a kernel for the device.
    pub(super) fn new(opened: &Opened, adapter: &str, declaration: &Declaration) -> Result<Self, BackendError> {
        let name = declaration.name;
        let unsupported = |reason: String| BackendError::Unsupported {
            adapter: adapter.to_owned(),
            what: format!("what kernel {name} needs: {reason}"),
        };
        if !NAMES.contains(&name) {
            let what = "has no module; run `cargo xtask shaders`".to_owned();
            return Err(BackendError::Misuse { kernel: name, what });
        }
        let device = &opened.device;
        let scope = device.push_error_scope(wgpu::ErrorFilter::Validation);
        let shader = if opened.passes_through {
            module::passed_through(device, name)
        } else {
            module::translated(device, name).map_err(unsupported)?
        };
        let entries: Vec<_> =
            declaration.bindings.iter().map(|binding| layout_entry(binding, declaration.uniform_bytes)).collect();
        let layout =
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(name), entries: &entries });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(name),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: Some(&pipeline_layout),
            module: &shader,
            entry_point: Some(ENTRY_POINT),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        match pollster::block_on(scope.pop()) {
            None => Ok(Self { pipeline, layout }),
            Some(error) => Err(unsupported(error.to_string())),
        }
    }
}
