//! Samples that are written as NRRD.

use std::io::Write;

use crate::physical_values::{sample_type, write_values};
use crate::samples::SampleType;
use crate::volume::Volume;

/// Samples of a grid, x fastest; the components of a vector lie next to each other.
#[derive(Debug, Clone, Copy)]
pub enum Samples<'a> {
    /// One byte a voxel.
    U8(&'a [u8]),
    /// One float a voxel.
    F32(&'a [f32]),
    /// Vectors, one a voxel, which keep their components when the grid is turned.
    Colors(&'a [[f32; 3]]),
    /// A vector a voxel, which turns with the grid.
    Vectors(&'a [[f32; 3]]),
    /// A volume's physical values, of the smallest type that holds them: see [`crate::write_volume`].
    Volume(&'a Volume),
}

impl Samples<'_> {
    pub(super) fn count(self) -> usize {
        match self {
            Self::U8(samples) => samples.len(),
            Self::F32(samples) => samples.len(),
            Self::Colors(samples) | Self::Vectors(samples) => samples.len(),
            Self::Volume(volume) => volume.voxel_count(),
        }
    }

    /// Names in NRRD: the type, and the kind of the components if a sample has several.
    pub(super) fn names(self) -> (&'static str, Option<&'static str>) {
        match self {
            Self::U8(_) => ("uint8", None),
            Self::F32(_) => ("float", None),
            Self::Colors(_) => ("float", Some("RGB-color")),
            Self::Vectors(_) => ("float", Some("3-vector")),
            Self::Volume(volume) => match sample_type(volume) {
                SampleType::F32 => ("float", None),
                sample => (sample.name(), None),
            },
        }
    }

    /// Writes the samples, little-endian.
    pub(super) fn write(self, to: &mut dyn Write) -> std::io::Result<()> {
        let floats = |samples: &[f32], to: &mut dyn Write| {
            // A piece at a time, so that the bytes do not take as much memory as the samples again.
            samples.chunks(1 << 16).try_for_each(|piece| {
                let bytes: Vec<u8> = piece.iter().flat_map(|sample| sample.to_le_bytes()).collect();
                to.write_all(&bytes)
            })
        };
        match self {
            Self::U8(samples) => to.write_all(samples),
            Self::F32(samples) => floats(samples, to),
            Self::Colors(samples) | Self::Vectors(samples) => floats(samples.as_flattened(), to),
            Self::Volume(volume) => write_values(to, volume),
        }
    }
}
