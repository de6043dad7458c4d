//! Refractive volume rendering: one kernel source in Rust, on the GPU and on the CPU.
//!
//! The way data flows: [`vitrum_io::open`] reads a volume, a [`scene::Scene`] says how it is shown, a [`Renderer`] prepares tables and
//! buffers, hands a list of passes to a [`backend::Backend`] and returns a [`Frame`].
//!
//! ```
//! use vitrum::io::{Volume, Voxels};
//! use vitrum::{OutputRequest, Renderer, backend::CpuBackend, preset, scene::Scene};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let voxels: Vec<u8> = (0..32u32.pow(3)).map(|index| (index / 128) as u8).collect();
//! let volume = Volume::new("a ramp", [32; 3], [1.0; 3], Voxels::from(voxels))?;
//! let mut scene = Scene::default();
//! (scene.film.width, scene.film.height) = (64, 64);
//! preset::apply("haze", &volume, &mut scene)?;
//! let mut renderer = Renderer::new(Box::new(CpuBackend::new(None)?), volume);
//! let frame = renderer.render(&scene, OutputRequest::default(), &mut |_| true)?;
//! assert_eq!(frame.to_srgb8().len(), 64 * 64 * 4);
//! # Ok(())
//! # }
//! ```
//!
//! The examples of this package show files, meshes, named outputs, both backends, and a kernel by itself.

#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

mod assets;
pub mod backend;
#[cfg(feature = "builtin")]
pub mod builtin;
pub mod composition;
mod course;
mod error;
mod film;
mod framing;
mod ground_alone;
mod meshes;
pub mod method;
mod moving_meshes;
mod parts;
pub mod preset;
mod renderer;
mod request;
pub mod scene;
mod shown;
mod subject;
mod unrenderable;

pub use assets::{Assets, load_volume};
pub use error::Error;
pub use film::{Frame, Output, Statistics};
pub use framing::{framed, framed_all_round};
pub use meshes::{load_mesh, load_meshes};
pub use method::spectrum;
pub use moving_meshes::MovingMeshes;
pub use renderer::{Fallback, Renderer, check, frame, render, render_requested};
pub use request::{Layers, OutputRequest, Progress, Stage};
pub use subject::{Subject, Volumes};
pub use unrenderable::Unrenderable;
pub use vitrum_io as io;
pub use vitrum_io::suggest;
