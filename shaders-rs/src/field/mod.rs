//! Reading fields: voxels, transfer function tables, the light grid; adding to sums.

pub mod access;
pub mod bodies;
pub mod colors;
pub mod empty;
pub mod stencil;
pub mod sums;
pub mod tables;
pub mod voxels;
