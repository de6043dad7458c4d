//! Choosing a backend.

use super::{Backend, BackendError, CpuBackend, GpuOptions};
use serde::Serialize;
use vitrum_kernels::kernel::InstructionSet;

/// The choice of a backend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Choice {
    /// A hardware GPU if the machine has one, else the CPU. A software Vulkan driver does not count as a GPU.
    #[default]
    Auto,
    /// The CPU.
    Cpu,
    /// A graphics adapter, a software one if there is no other.
    Gpu,
}

/// A device on which kernels can run.
#[derive(Debug, Clone, Serialize)]
pub struct DeviceInfo {
    /// Name of the device.
    pub name: String,
    /// `cpu` or `gpu`: what `--backend` takes.
    pub backend: &'static str,
    /// `DiscreteGpu`, `IntegratedGpu`, `Cpu` …
    pub kind: String,
    /// Interface and driver.
    pub driver: String,
    /// The most bytes one buffer may have.
    pub largest_buffer: u64,
    /// Whether SPIR-V reaches the driver unchanged, which bit-equal results need; else shaders are translated.
    pub passes_through: bool,
    /// Whether `auto` takes it.
    pub chosen_by_auto: bool,
}

/// All devices on which kernels can run, the best graphics adapter first, the CPU last.
pub fn devices() -> Vec<DeviceInfo> {
    let mut found = graphics::devices();
    // `auto` takes the first hardware adapter only.
    let mut taken = false;
    for device in &mut found {
        device.chosen_by_auto &= !taken;
        taken |= device.chosen_by_auto;
    }
    found.push(DeviceInfo {
        name: "CPU".to_owned(),
        backend: "cpu",
        kind: "Cpu".to_owned(),
        driver: format!("native, {:?}", InstructionSet::best()),
        largest_buffer: (i32::MAX as u64) * 4,
        passes_through: true,
        chosen_by_auto: !taken,
    });
    found
}

/// Opens a backend. Where `options` name an adapter, even `auto` takes a software one. `threads` is how many threads the kernels have on the CPU, and the work of the host beside either backend; all processors if `None`.
///
/// # Errors
/// [`BackendError::NoAdapter`] and [`BackendError::Unsupported`] where a graphics adapter is asked for and none can be used,
/// [`BackendError::Threads`] where the threads cannot be started.
pub fn open(choice: Choice, options: &GpuOptions, threads: Option<usize>) -> Result<Box<dyn Backend>, BackendError> {
    if choice != Choice::Cpu {
        let wanted = choice == Choice::Gpu || options.adapter.is_some();
        if let Some(backend) = graphics::open(options, wanted, threads)? {
            return Ok(backend);
        }
    }
    Ok(Box::new(CpuBackend::new(threads)?))
}

/// Graphics adapters.
#[cfg(feature = "gpu")]
mod graphics {
    use super::super::gpu::{adapters, describe, is_hardware, takes_spirv};
    use super::super::{Backend, BackendError, GpuBackend, GpuOptions};
    use super::DeviceInfo;

    pub(super) fn devices() -> Vec<DeviceInfo> {
        let device = |adapter: &wgpu::Adapter| {
            let info = adapter.get_info();
            DeviceInfo {
                name: info.name.clone(),
                backend: "gpu",
                kind: format!("{:?}", info.device_type),
                driver: describe(&info),
                largest_buffer: adapter.limits().max_storage_buffer_binding_size.min(adapter.limits().max_buffer_size),
                passes_through: takes_spirv(adapter),
                chosen_by_auto: is_hardware(&info),
            }
        };
        adapters().iter().map(device).collect()
    }

    /// Opens the adapter `wanted`, or the best hardware adapter.
    pub(super) fn open(
        options: &GpuOptions,
        wanted: bool,
        threads: Option<usize>,
    ) -> Result<Option<Box<dyn Backend>>, BackendError> {
        // Once: each time drivers are loaded, and some of them speak.
        let found = adapters();
        if !wanted && !found.iter().any(|found| is_hardware(&found.get_info())) {
            return Ok(None);
        }
        let backend = GpuBackend::among(found, options)?;
        Ok(Some(match threads {
            Some(threads) => Box::new(backend.with_threads(threads)?),
            None => Box::new(backend),
        }))
    }
}

/// The place of graphics adapters in a build without them.
#[cfg(not(feature = "gpu"))]
mod graphics {
    use super::super::{Backend, BackendError, GpuOptions};
    use super::DeviceInfo;

    pub(super) fn devices() -> Vec<DeviceInfo> {
        Vec::new()
    }

    pub(super) fn open(
        _options: &GpuOptions,
        wanted: bool,
        _threads: Option<usize>,
    ) -> Result<Option<Box<dyn Backend>>, BackendError> {
        if !wanted {
            return Ok(None);
        }
        let reason = "this build has no GPU backend (feature `gpu`)".to_owned();
        Err(BackendError::NoAdapter { reason })
    }
}
