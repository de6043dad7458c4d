//! Reading fields: voxels, transfer function tables, the light grid; adding to sums.

pub mod access;
pub mod empty;
pub mod light;
pub mod light_around;
pub mod offset;
pub mod sheet;
pub mod slopes;
pub mod stencil;
pub mod sums;
pub mod tables;
pub mod unoccluded;
pub mod voxels;
