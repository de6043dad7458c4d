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
