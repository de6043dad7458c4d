//! Reading fields: voxels, transfer function tables, the light grid.

pub mod access;
pub mod empty;
pub mod light;
pub mod light_around;
pub mod slopes;
pub mod stencil;
pub mod tables;
pub mod voxels;
