//! Finding an adapter and opening its device.

use super::GpuOptions;
use crate::backend::BackendError;
use std::sync::{Arc, Mutex};

/// What the driver reported while nobody was waiting for it.
pub(super) type Failure = Arc<Mutex<Option<String>>>;

/// All adapters of the platform's native interfaces, best first.
pub(crate) fn adapters() -> Vec<wgpu::Adapter> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12,
        // Numbers of workgroups in buffers are not checked by the device, which would take a dispatch more for each: kernels write there
        // nothing but the numbers of a dispatch that the host has listed, or 0 is left.
        flags: wgpu::InstanceFlags::from_env_or_default() - wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let mut found = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    found.sort_by_key(|adapter| rank(&adapter.get_info()));
    found
}

/// Whether an adapter is a graphics processor rather than a driver that runs on the CPU.
pub(crate) fn is_hardware(info: &wgpu::AdapterInfo) -> bool {
    info.device_type != wgpu::DeviceType::Cpu
}

/// Best first: discrete, integrated, virtual, other, software.
fn rank(info: &wgpu::AdapterInfo) -> u32 {
    match info.device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    }
}

/// Whether an adapter's driver takes SPIR-V as it is.
pub(crate) fn takes_spirv(adapter: &wgpu::Adapter) -> bool {
    adapter.features().contains(wgpu::Features::PASSTHROUGH_SHADERS)
        && adapter.get_info().backend == wgpu::Backend::Vulkan
}

/// The adapter's own words: name, interface, driver.
pub(crate) fn describe(info: &wgpu::AdapterInfo) -> String {
    let driver = [info.driver.as_str(), info.driver_info.as_str()]
        .into_iter()
        .filter(|text| !text.is_empty())
        .collect::<Vec<_>>()
        .join(" ");
    format!("{} ({:?}, {driver})", info.name, info.backend)
}

/// The first of `found`, best first, whose description contains `wanted` (any case).
pub(super) fn choose(mut found: Vec<wgpu::Adapter>, wanted: Option<&str>) -> Result<wgpu::Adapter, BackendError> {
    let names: Vec<String> = found.iter().map(|adapter| describe(&adapter.get_info())).collect();
    let lowered = wanted.unwrap_or("").to_lowercase();
    let index = names.iter().position(|name| name.to_lowercase().contains(&lowered));
    index.map(|index| found.swap_remove(index)).ok_or_else(|| {
        let reason = if names.is_empty() {
            "no Vulkan, Metal or DX12 driver was found".to_owned()
        } else {
            format!("no adapter is called '{}'; there are: {}", wanted.unwrap_or(""), names.join(", "))
        };
        BackendError::NoAdapter { reason }
    })
}

/// An open device.
pub(super) struct Opened {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    pub(super) failure: Failure,
    /// Whether SPIR-V goes to the driver as it is.
    pub(super) passes_through: bool,
    /// The adapter's name, interface and driver, and whether shaders are translated.
    pub(super) description: String,
}

/// The features and limits that an adapter's device is asked for.
pub(super) fn required(adapter: &wgpu::Adapter, options: &GpuOptions) -> wgpu::DeviceDescriptor<'static> {
    let pass_through = takes_spirv(adapter) && !options.translate_shaders;
    let pass_through = if pass_through { wgpu::Features::PASSTHROUGH_SHADERS } else { wgpu::Features::empty() };
    // Clocks where there are some.
    let clocks = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES;
    let clocks = if adapter.features().contains(clocks) { clocks } else { wgpu::Features::empty() };
    wgpu::DeviceDescriptor {
        label: Some("vitrum"),
        required_features: pass_through | clocks,
        required_limits: if options.portable_limits { wgpu::Limits::default() } else { adapter.limits() },
        // SAFETY: pass-through hands the driver a module that wgpu did not check. Only the committed modules are passed; spirv-val
        // has checked them, their bindings come from the declarations they were compiled from, and all their accesses are
        // limited to the buffers.
        experimental_features: unsafe { wgpu::ExperimentalFeatures::enabled() },
        ..Default::default()
    }
}

/// Opens an adapter's device.
pub(super) fn open(adapter: &wgpu::Adapter, options: &GpuOptions) -> Result<Opened, BackendError> {
    let info = adapter.get_info();
    let (device, queue) = pollster::block_on(adapter.request_device(&required(adapter, options)))
        .map_err(|error| BackendError::Unsupported { adapter: describe(&info), what: error.to_string() })?;
    let failure = Failure::default();
    let lost = Arc::clone(&failure);
    device.set_device_lost_callback(move |reason, message| {
        if reason != wgpu::DeviceLostReason::Destroyed {
            note(&lost, format!("device lost: {message}"));
        }
    });
    let uncaptured = Arc::clone(&failure);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| note(&uncaptured, error.to_string())));
    Ok(Opened { failure, ..adopt(device, queue, &info) })
}

/// A device that somebody else opened, and whose failures are told to its owner.
pub(super) fn adopt(device: wgpu::Device, queue: wgpu::Queue, info: &wgpu::AdapterInfo) -> Opened {
    let passes_through =
        device.features().contains(wgpu::Features::PASSTHROUGH_SHADERS) && info.backend == wgpu::Backend::Vulkan;
    let description = match describe(info).strip_suffix(')') {
        Some(open) if !passes_through => format!("{open}; shaders translated)"),
        _ => describe(info),
    };
    Opened { device, queue, failure: Failure::default(), passes_through, description }
}

/// Keeps the first failure.
fn note(failure: &Failure, message: String) {
    let mut slot = failure.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    slot.get_or_insert(message);
}
