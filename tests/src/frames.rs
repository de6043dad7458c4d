//! T2: every output of whole frames.

use vitrum::Frame;
use vitrum::backend::Backend;

use crate::Failure;
use crate::bounds;
use crate::case::Case;
use crate::raster;
use crate::run::Run;

/// Compares the frames of two backends, the CPU's first.
///
/// # Errors
/// If a backend fails, or evidence cannot be written.
pub fn compare(case: &Case, cpu: &mut dyn Backend, other: &mut dyn Backend, run: &mut Run) -> Result<(), Failure> {
    run.method(case.scene.method);
    let (reference, found) = (render(case, cpu)?, render(case, other)?);
    let bound = |shown| bounds::of_backend(other, shown);
    run.hold_all(("T2", &case.name), bound, &raster::of_frame(&reference), &raster::of_frame(&found))
}

/// The frame of a case.
///
/// # Errors
/// If the backend fails.
pub fn render(case: &Case, backend: &mut dyn Backend) -> Result<Frame, Failure> {
    Ok(vitrum::render_requested(&case.scene, &case.assets, case.request, backend, &mut |_| true)?)
}
