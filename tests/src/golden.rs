//! T3: frames against committed pictures.
//!
//! A golden picture is the colour of a small built-in scene, as the CPU made it with the baseline instruction set when a
//! person last looked and said that it is right.

use std::fs;
use std::path::{Path, PathBuf};

use vitrum::backend::CpuBackend;
use vitrum::scene::MethodName;
use vitrum::{Frame, builtin};
use vitrum_compare::Bound;
use vitrum_io::{Picture, read_picture, write_picture};
use vitrum_kernels::kernel::InstructionSet;

use crate::Failure;
use crate::bounds;
use crate::case::Case;
use crate::frames;
use crate::raster::{self, Raster};
use crate::run::Run;

/// Pixels along each side.
const EDGE: u32 = 48;
/// Voxels along a volume's longest edge.
const RESOLUTION: u32 = 48;

/// The folder of the committed golden pictures.
#[must_use]
pub fn folder() -> PathBuf {
    crate::root().join("tests/golden")
}

/// The scenes that have a golden picture: all but the variants.
#[must_use]
pub fn scenes() -> Vec<&'static str> {
    builtin::names().iter().map(|&(name, _)| name).filter(|name| !name.contains('/')).collect()
}

/// The case that a scene's golden picture shows.
///
/// # Errors
/// If there is no such scene.
pub fn case(scene: &str) -> Result<Case, Failure> {
    Case::builtin(scene, EDGE, Some(RESOLUTION), &[])
}

/// Compares a scene with its golden picture in `folder`, on the CPU with each instruction set that this machine has.
///
/// # Errors
/// If the golden picture is missing, or evidence cannot be written.
pub fn compare(folder: &Path, scene: &str, run: &mut Run) -> Result<(), Failure> {
    let case = case(scene)?;
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        let frame = frames::render(&case, &mut CpuBackend::with_instruction_set(None, set)?)?;
        hold(folder, scene, &format!("{set:?}"), &frame, run)?;
    }
    Ok(())
}

/// Holds a frame's colour to the golden picture of `scene` in `folder`; `maker` says what made the frame.
///
/// # Errors
/// If the golden picture is missing or has another size, or evidence cannot be written.
pub fn hold(folder: &Path, scene: &str, maker: &str, frame: &Frame, run: &mut Run) -> Result<(), Failure> {
    let path = path(folder, scene);
    if !path.exists() {
        let missing = format!("{} is missing: look at the scene, then run `cargo xtask diff --bless`", path.display());
        return Err(Failure::Setup(missing));
    }
    let rasters = |picture: &Picture| -> Vec<(String, Raster)> {
        rasters(picture).into_iter().map(|(item, raster)| (format!("{item}, {maker}"), raster)).collect()
    };
    run.method(builtin::scene(scene).map_or(MethodName::Sweep, |scene| scene.method));
    run.hold_all(("T3", scene), bounds::of_golden, &rasters(&read_picture(&path)?), &rasters(&picture(frame)))
}

/// Makes a scene's golden picture anew; whether that changed it.
///
/// # Errors
/// If it cannot be rendered or written.
pub fn bless(folder: &Path, scene: &str) -> Result<bool, Failure> {
    let path = path(folder, scene);
    let mut backend = CpuBackend::with_instruction_set(None, InstructionSet::Baseline)?;
    let made = picture(&frames::render(&case(scene)?, &mut backend)?);
    if path.exists() && is_equal(&read_picture(&path)?, &made) {
        return Ok(false);
    }
    fs::create_dir_all(folder).map_err(|error| Failure::Output { path: folder.to_owned(), error })?;
    let shown = format!("builtin:{scene}, {EDGE} x {EDGE} pixels, resolution {RESOLUTION}, baseline CPU");
    write_picture(&path, &made, &[("golden picture".to_owned(), shown)])?;
    Ok(true)
}

fn path(folder: &Path, scene: &str) -> PathBuf {
    folder.join(format!("{scene}.exr"))
}

/// A frame's colour and coverage.
fn picture(frame: &Frame) -> Picture {
    frame.aov("color").expect("every frame has a colour")
}

fn is_equal(one: &Picture, other: &Picture) -> bool {
    let (one, other) = (rasters(one), rasters(other));
    let equal = |(one, other): (&(String, Raster), &(String, Raster))| {
        one.0 == other.0 && one.1.compare(&other.1).is_ok_and(|found| Bound::BitEqual.check(&found).passed())
    };
    one.len() == other.len() && one.iter().zip(&other).all(equal)
}

fn rasters(picture: &Picture) -> Vec<(String, Raster)> {
    picture.layers.iter().flat_map(|layer| raster::of_layer(layer, [picture.width, picture.height])).collect()
}
