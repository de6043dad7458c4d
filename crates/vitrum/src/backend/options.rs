//! Which graphics adapter is opened, and how.

/// Which graphics adapter is opened, and how.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct GpuOptions {
    /// A part of the adapter's name, interface or driver, in any case; the best adapter if absent.
    pub adapter: Option<String>,
    /// Whether kernels are translated by naga even where the driver would take their SPIR-V as it is: the course that Metal and
    /// Direct3D 12 always take. Results are then equal within a tolerance, not to the last bit.
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
