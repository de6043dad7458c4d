//! Refractive volume rendering: one kernel source in Rust, on the GPU and on the CPU.
//!
//! The way data flows: [`vitrum_io::open`] reads a volume, a [`scene::Scene`] says how it is shown, a [`Renderer`] prepares tables and
//! buffers, hands a list of passes to a [`backend::Backend`] and returns a [`Frame`].

#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

mod assets;
pub mod backend;
#[cfg(feature = "builtin")]
pub mod builtin;
mod error;
mod film;
mod meshes;
pub mod method;
pub mod preset;
mod renderer;
mod request;
pub mod scene;
mod subject;
mod unrenderable;

pub use assets::{Assets, load_volume};
pub use error::Error;
pub use film::{Frame, Output, Statistics};
pub use meshes::{load_mesh, load_meshes};
pub use method::sweep::spectrum;
pub use renderer::{Fallback, Renderer, check, frame, render, render_requested};
pub use request::{OutputRequest, Progress, Stage};
pub use subject::{Subject, Volumes};
pub use unrenderable::Unrenderable;
pub use vitrum_io as io;
pub use vitrum_io::suggest;
