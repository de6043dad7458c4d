//! Records: what a kernel returns for one index. Component `c` of record `i` out of `n` lies at `c·n + i` (planar).

#[macro_use]
mod declare;
mod beams;
mod results;
mod sweep;
mod voxels;
mod words;

pub use beams::*;
pub use results::*;
pub use sweep::*;
pub use voxels::*;
pub use words::*;
