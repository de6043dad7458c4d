//! What host and kernels share: uniform blocks, record layouts and table layouts.

pub mod environment;
pub mod grid;
pub mod probe;
pub mod record;
pub mod shadow;
pub mod sweep;
pub mod tables;
pub mod vector;
pub mod voxelize;
pub mod voxels;

use spirv_std::glam::UVec4;

/// A uniform block that says over which invocations its pass runs.
pub trait Dispatched {
    /// The first column and row (`x`, `y`), and those before which it ends (`z`, `w`).
    fn window(&self) -> UVec4;
}
