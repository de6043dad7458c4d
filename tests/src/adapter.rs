//! The graphics adapter that is held against the CPU.

use vitrum::backend::{Backend, BackendError, CpuBackend, GpuBackend, GpuOptions};

use crate::Failure;
use crate::bounds;
use crate::left_out;

/// Advice for a machine without an adapter.
const ADVICE: &str = "install a Vulkan driver (Mesa's runs on any processor; Debian: mesa-vulkan-drivers libvulkan1); \
                      `vitrum devices` lists what is found";

/// Opens the adapter that `options` say, in the way they say.
///
/// # Errors
/// If there is none, with advice; or if it fails.
pub fn open(options: &GpuOptions) -> Result<GpuBackend, Failure> {
    GpuBackend::open(options).map_err(|error| match error {
        BackendError::NoAdapter { .. } => Failure::Setup(format!("{error}; {ADVICE}")),
        other => other.into(),
    })
}

/// The best adapter, for a test. Where there is none this says so on stdout, and the test is left out.
///
/// # Panics
/// If there is none and `VITRUM_REQUIRE_GPU` is set, so that a machine that should have one notices; or if it fails.
#[must_use]
pub fn for_test() -> Option<GpuBackend> {
    opened_for_test(&GpuOptions::default())
}

/// The CPU, and the best adapter where there is one.
///
/// # Errors
/// If the CPU backend does not open.
///
/// # Panics
/// As [`for_test`].
pub fn backends_for_test() -> Result<Vec<Box<dyn Backend>>, Failure> {
    let gpu = for_test().map(|gpu| Box::new(gpu) as Box<dyn Backend>);
    Ok([Box::new(CpuBackend::new(None)?) as Box<dyn Backend>].into_iter().chain(gpu).collect())
}

/// As [`for_test`], with shaders translated by naga, as Metal and Direct3D 12 need them, on a device with the limits that every adapter
/// for WebGPU has.
///
/// # Panics
/// As [`for_test`].
#[must_use]
pub fn portable_for_test() -> Option<GpuBackend> {
    opened_for_test(&GpuOptions { translate_shaders: true, portable_limits: true, ..GpuOptions::default() })
}

/// As [`for_test`], opened as `options` say.
///
/// # Panics
/// As [`for_test`].
#[must_use]
pub fn opened_for_test(options: &GpuOptions) -> Option<GpuBackend> {
    match GpuBackend::open(options) {
        Ok(backend) => Some(backend),
        Err(error @ BackendError::NoAdapter { .. }) => {
            let required = left_out::is_required("VITRUM_REQUIRE_GPU");
            assert!(!required, "{error}, and VITRUM_REQUIRE_GPU is set; {ADVICE}");
            left_out::say(&error.to_string());
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// As [`for_test`], but only an adapter that is held to the last bit: on others a difference of rounding is no mistake.
///
/// # Panics
/// As [`for_test`].
#[must_use]
pub fn exact_for_test() -> Option<GpuBackend> {
    let backend = for_test()?;
    let is_exact = bounds::is_exact(&backend);
    if !is_exact {
        left_out::say(&format!("{} is not held to the last bit", backend.adapter()));
    }
    is_exact.then_some(backend)
}
