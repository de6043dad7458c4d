//! Files in and out of Vitrum: scalar volumes (NRRD, NIfTI, MetaImage, NumPy, VTK, TIFF stacks, DICOM, headerless voxels),
//! triangle meshes (OBJ, PLY, STL, glTF) and pictures (PNG, OpenEXR, Radiance HDR, JPEG, TIFF).
//!
//! Files come from anywhere, so nothing in them is believed before it is checked: sizes are held
//! against the bytes that are there and the memory that may be used before anything is allocated,
//! and a wrong file ends in an [`Error`] that names the place and the remedy, never in a panic.
//! Pictures are written beside their path and renamed onto it, so a path never holds half of one.
//!
//! ```no_run
//! use std::path::Path;
//! use vitrum_io::{OpenOptions, Picture, open, write_picture};
//!
//! let volume = open(Path::new("head.nrrd"), &OpenOptions::default())?;
//! println!("{:?} voxels from {} to {}", volume.dimensions, volume.range[0], volume.range[1]);
//! let gray = Picture::gray(2, 1, vec![0.0, 0.5]);
//! write_picture(Path::new("gray.png"), &gray, &[])?;
//! # Ok::<(), vitrum_io::Error>(())
//! ```

#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

mod arrays;
mod beside;
mod data_file;
mod dicom;
mod error;
mod fields;
pub mod image;
mod input;
mod memory;
pub mod mesh;
mod metaimage;
mod nifti;
mod nrrd;
mod numpy;
mod open;
mod orientation;
mod packing;
mod placement;
mod raw;
mod samples;
mod shared;
mod stack;
mod stream;
pub mod suggest;
mod temporary;
mod text;
mod time;
mod up;
mod volume;
mod volume_file;
mod voxels;
mod vti;
mod vtk;

pub use beside::{check_text_writable, write_text};
pub use error::{Error, Place};
pub use image::{
    Animation, Channel, Layer, Picture, WriteOptions, check_holds_vectors, check_writable, linear_to_srgb,
    read_picture, read_picture_with, srgb_to_linear, write_picture, write_picture_with,
};
pub use input::{Input, STANDARD_INPUT};
pub use memory::require_memory;
pub use mesh::{Material, Mesh, MeshReader, Topology, is_mesh, mesh_readers, open_mesh};
pub use nrrd::{Lattice, Samples, check_nrrd_writable, write_nrrd};
pub use open::{OpenOptions, Part, VolumeReader, open, readers};
pub use orientation::Orientation;
pub use packing::Packing;
pub use raw::RawLayout;
pub use shared::Shared;
pub use temporary::remove_unfinished;
pub use up::Up;
pub use volume::{Source, Volume};
pub use volume_file::{check_volume_writable, write_volume};
pub use voxels::{Voxels, Words};
