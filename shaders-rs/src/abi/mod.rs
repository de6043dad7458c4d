//! What host and kernels share: uniform blocks, record layouts and table layouts.

pub mod ambient;
pub mod beams;
pub mod camera;
pub mod clip;
pub mod dispatch;
pub mod environment;
pub mod format;
pub mod grid;
pub mod light;
pub mod probe;
pub mod receivers;
pub mod record;
pub mod shadow;
pub mod sweep;
pub mod tables;
pub mod vector;
pub mod voxelize;
pub mod voxels;
pub mod wavefront;

pub use dispatch::Dispatched;
