//! Built-in scenes as a user gets them, on a device that allows no more than every adapter for WebGPU does.

use std::path::Path;

use vitrum::backend::{BackendError, GpuOptions};
use vitrum::{Assets, Error, OutputRequest, Progress, Stage, builtin};
use vitrum_conformance::{Failure, adapter};

/// Frames are cancelled at the first pass: all their buffers are made by then, and the preparation of meshes has run.
#[test]
fn every_built_in_scene_fits_into_portable_buffers() -> Result<(), Failure> {
    let options = GpuOptions { portable_limits: true, ..GpuOptions::default() };
    let Some(mut gpu) = adapter::opened_for_test(&options) else { return Ok(()) };
    let mut failed = Vec::new();
    for (name, _) in builtin::names() {
        let scene = builtin::scene(name).expect("names are those of scenes");
        let assets = Assets::load(&scene, Path::new(""))?;
        let mut goes_on = |progress: Progress| progress.stage != Stage::Render;
        let frame = vitrum::render_requested(&scene, &assets, OutputRequest::default(), &mut gpu, &mut goes_on);
        match frame {
            Err(Error::Backend(BackendError::Cancelled)) => {}
            Ok(_) => failed.push(format!("{name} was not asked about its progress")),
            Err(error) => failed.push(format!("{name}: {error}")),
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    Ok(())
}
