//! Refractive volume rendering: one kernel source in Rust, on the GPU and on the CPU.
//!
//! The way data flows: [`vitrum_io::open`] reads a volume, a [`scene::Scene`] says how it is shown, [`render`] prepares
//! tables and buffers, hands a list of passes to a [`backend::Backend`] and returns a [`Frame`].

#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

pub mod backend;
mod blend;
pub mod builtin;
mod frame;
mod inputs;
mod mesh_frame;
pub mod method;
pub mod preset;
mod render;
pub mod scene;
mod session;
pub mod spectrum;

pub use frame::{Frame, Output, Statistics};
pub use inputs::{Inputs, load_mesh, load_volume};
pub use render::{Error, Progress, Wanted, check, render, render_wanted};
pub use session::{Fallback, Session};
pub use vitrum_io as io;
pub use vitrum_io::suggest;
