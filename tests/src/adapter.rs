//! The graphics adapter that is held against the CPU.

use vitrum::backend::{BackendError, GpuBackend};

use crate::Failure;
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
