//! Options for opening a graphics adapter.

/// Options for opening a graphics adapter.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct GpuOptions {
    /// A part of the adapter's name, interface or driver, in any case; the best adapter if absent.
    pub adapter: Option<String>,
    /// Whether naga translates the kernels even where the driver takes their SPIR-V as it is, as on Metal and Direct3D 12. Results are
    /// then equal within a tolerance, not to the last bit.
    pub translate_shaders: bool,
    /// Whether the device is opened with the limits that every adapter for WebGPU has (128 MiB a binding, 256 MiB a buffer, 8 storage
    /// buffers), and not with all that this one has.
    pub portable_limits: bool,
}

impl GpuOptions {
    /// The adapter whose name, interface or driver contains `adapter`, or the best.
    #[must_use]
    pub fn new(adapter: Option<&str>) -> Self {
        Self { adapter: adapter.map(str::to_owned), ..Self::default() }
    }
}
