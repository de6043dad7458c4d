//! Refractive volume rendering: one kernel source in Rust, on the GPU and on the CPU.
//!
//! The way data flows: [`vitrum_io::open`] reads a volume, a [`scene::Scene`] says how it is shown, [`render`] prepares
//! tables and buffers, hands a list of passes to a [`backend::Backend`] and returns a [`Frame`].

#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

pub mod backend;
pub mod builtin;
mod error;
mod film;
mod inputs;
mod meshes;
pub mod method;
pub mod preset;
mod render;
mod request;
pub mod scene;
mod session;

pub use error::Error;
pub use film::{Frame, Output, Statistics};
pub use inputs::{Inputs, load_volume};
pub use meshes::{load_mesh, load_meshes};
pub use method::sweep::spectrum;
pub use render::{check, render, render_wanted};
pub use request::{Progress, Wanted};
pub use session::{Fallback, Session};
pub use vitrum_io as io;
pub use vitrum_io::suggest;
