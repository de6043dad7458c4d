//! The plane sweep's kernels (Magnus & Bruckner 2017, Algorithm 1), one file a kernel.
//!
//! For every plane: [`filter_light`] where light is soft, [`trace_light`], [`gather_light`], [`refract_light`] within the volume,
//! [`concentrate_light`], and, once the planes are in front of the eye, [`propagate_rays`], which reads the light of the plane
//! behind.
//! [`initialize_light`] and [`initialize_rays`] come first, [`resolve`] last.

pub mod concentrate_light;
pub mod filter_light;
pub mod gather_light;
pub mod initialize_light;
pub mod initialize_rays;
pub mod propagate_rays;
pub mod refract_light;
pub mod resolve;
pub mod trace_light;
