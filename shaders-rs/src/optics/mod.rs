//! Optics: ray steps, media, clipping, reflection, receivers, light sources.

pub mod ambient;
pub mod clip;
pub mod composite;
pub mod diffuse;
pub mod environment;
pub mod isosurfaces;
pub mod light_source;
pub mod medium;
pub mod receiver;
pub mod span;
pub mod specular;
pub mod step;
