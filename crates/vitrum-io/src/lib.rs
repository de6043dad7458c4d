//! Files in and out of Vitrum: scalar volumes (NRRD, NIfTI, MetaImage, NumPy, VTK, TIFF stacks, DICOM, headerless voxels),
//! triangle meshes (OBJ, PLY, STL, glTF) and pictures (PNG, OpenEXR, Radiance HDR, JPEG, TIFF).
//!
//! Files come from anywhere, so nothing in them is believed before it is checked: sizes are held
//! against the bytes that are there and the memory that may be used before anything is allocated,
//! and a wrong file ends in an [`Error`] that names the place and the remedy, never in a panic.
//! Pictures are written beside their path and renamed onto it, so a path never holds half of one.
//!
//! Volumes, meshes and pictures are read from paths ([`open`], [`open_mesh`], [`read_picture`]) and from bytes in memory
//! ([`open_bytes`], [`open_mesh_bytes`], [`read_picture_bytes`]); pictures are written to paths ([`write_picture`]) and
//! into memory ([`encode_picture`]).
//!
//! Each format is a feature of the crate, all of them on by default; a file of a format that a build leaves out is told by
//! [`Error::LeftOut`].
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
// Code that formats share is partly unused where some of them are left out.
#![cfg_attr(not(feature = "default"), allow(dead_code, unused_imports, unused_macros))]

mod arrays;
mod atomic_write;
mod common_range;
mod components;
mod detached;
#[cfg(feature = "dicom")]
mod dicom;
mod edit;
mod error;
mod fields;
mod filter;
mod folder;
mod formats;
pub mod image;
mod input;
mod labels;
mod memory;
pub mod mesh;
#[cfg(feature = "metaimage")]
mod metaimage;
mod moments;
#[cfg(feature = "nifti")]
mod nifti;
#[cfg(feature = "nrrd")]
mod nrrd;
#[cfg(feature = "numpy")]
mod numpy;
mod options;
mod orientation;
mod packing;
mod paged;
mod physical_values;
mod placement;
mod planes;
#[cfg(feature = "raw")]
mod raw;
mod raw_layout;
mod reader;
mod registry;
mod samples;
mod setting;
mod shared;
mod source;
#[cfg(feature = "tiff")]
mod stack;
mod storage;
mod stored;
mod stream;
pub mod suggest;
mod temporary;
mod text;
mod time;
mod tolerance;
#[cfg(feature = "transfer")]
pub mod transfer;
mod up;
mod volume;
mod volume_file;
mod voxels;
#[cfg(feature = "vti")]
mod vti;
#[cfg(feature = "vtk")]
mod vtk;

pub use atomic_write::{Staged, check_text_writable, stage_text, write_text};
pub use error::{Error, Found, Place};
pub use formats::{Format, MESH_FORMATS, PICTURE_FORMATS, VOLUME_FORMATS};
#[cfg(all(feature = "animations", not(target_family = "wasm")))]
pub use image::Animation;
pub use image::{
    Channel, Layer, Picture, PictureFormat, WriteOptions, check_holds_lengths, check_holds_vectors, check_writable,
    encode_picture, linear_to_srgb, read_picture, read_picture_bytes, read_picture_with, srgb_to_linear,
    stage_picture_with, write_picture, write_picture_with,
};
pub use input::{Input, STANDARD_INPUT};
pub use labels::{Label, Labels};
pub use memory::require_memory;
pub use mesh::{Material, Mesh, MeshReader, Topology, mesh_readers, open_mesh, open_mesh_bytes};
pub use moments::Moments;
#[cfg(feature = "nrrd")]
pub use nrrd::{Lattice, Samples, check_nrrd_writable, write_nrrd};
pub use options::{OpenOptions, Part};
pub use orientation::Orientation;
pub use packing::Packing;
pub use paged::{BrickRanges, Paged, VoxelSource, brick_shift};
pub use raw_layout::RawLayout;
pub use reader::VolumeReader;
pub use registry::{is_mesh, open, open_bytes, readers};
pub use setting::Setting;
pub use shared::Shared;
pub use source::{Assumption, Assumptions, Fact, Source};
pub use temporary::remove_unfinished;
pub use up::Up;
pub use volume::Volume;
pub use volume_file::{check_volume_writable, write_volume};
pub use voxels::{Voxels, Words};
