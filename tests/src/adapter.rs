//! The graphics adapter that is held against the CPU.

use vitrum::backend::{Backend, BackendError, GpuBackend};

use crate::Failure;
use crate::bounds;
use crate::left_out;

/// What to do where there is no adapter.
const ADVICE: &str = "install a Vulkan driver (Mesa's runs on any processor; Debian: mesa-vulkan-drivers libvulkan1); \
                      `vitrum devices` lists what is found";

/// Opens the best adapter, or the best whose name, interface or driver contains `wanted`.
///
/// # Errors
/// If there is none, with advice; or if it fails.
pub fn open(wanted: Option<&str>) -> Result<GpuBackend, Failure> {
    GpuBackend::new(wanted).map_err(|error| match error {
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
    match GpuBackend::new(None) {
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
