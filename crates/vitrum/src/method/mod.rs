//! Methods: what becomes of a scene, or of a mesh, before a backend sees it.

mod brick_distances;
pub(crate) mod mesh_volumes;
pub mod sweep;
mod twist;
mod view;
pub mod voxelize;
pub mod voxels;
