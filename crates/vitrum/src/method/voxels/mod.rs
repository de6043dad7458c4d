//! Rays through a mesh of clear materials (Chang et al. 2010, §4): through its voxels, or for comparison through its triangles.
//!
//! [`Uploaded::new`] turns a mesh into what rays run through; [`Rays::prepare`] lists the passes of a frame; [`Rays::run`] hands them
//! to the backend; [`Rays::film`] reads what came out.

pub(in crate::method) mod bodies;
mod bricks;
mod distances;
mod fields;
mod normals;
mod passes;
pub(in crate::method) mod solids;
mod tree;
mod uniforms;

pub use bodies::{Body, bodies};
pub use passes::{Rays, Uploaded};
