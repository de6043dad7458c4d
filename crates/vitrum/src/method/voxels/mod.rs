//! Rays through a mesh (Chang et al. 2010): through the voxels of clear materials (§4), or for comparison through their triangles, to
//! opaque triangles and receivers in the light that the mesh lets through (§3).
//!
//! [`Uploaded::new`] turns a mesh into what rays run through and the shadow that it casts; [`Rays::prepare`] lists the passes of a
//! frame; [`Rays::run`] hands them to the backend; [`Rays::film`] reads what came out.

pub(in crate::method) mod bodies;
mod bricks;
mod cropped;
mod distances;
mod fields;
mod looks;
mod normals;
mod passes;
mod shadow;
pub(in crate::method) mod solids;
mod tree;
mod uniforms;
mod uploaded;

pub use bodies::{Body, bodies};
pub use passes::Rays;
pub use uploaded::Uploaded;
