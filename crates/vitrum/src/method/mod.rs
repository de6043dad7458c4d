//! Methods: what becomes of a scene, or of a mesh, before a backend sees it.

mod brick_distances;
pub mod sweep;
pub mod voxelize;
pub mod voxels;
