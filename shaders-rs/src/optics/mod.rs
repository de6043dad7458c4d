//! Optics: ray steps, media, clipping, reflection, receivers.

pub mod clip;
pub mod composite;
pub mod environment;
pub mod medium;
pub mod receiver;
pub mod specular;
pub mod step;
