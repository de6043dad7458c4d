//! Options of reading.

use crate::error::Error;
use crate::raw_layout::RawLayout;
use crate::up::Up;
use crate::volume::Volume;

/// Choices about reading.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OpenOptions {
    /// Memory limit in bytes: for the decoded voxels; for the decompressed file and the mesh in it together; and for a file that must
    /// be unpacked or comes by standard input. `None` stands for the memory that is available.
    pub max_bytes: Option<u64>,
    /// Leaves the voxels in their file, of which parts are read when they are needed, whatever memory there is. It takes one uncompressed file
    /// with one number for each voxel; others are read whole. Files whose voxels need more memory than they may take stay there by themselves.
    pub paged: bool,
    /// Reads the file as voxels without a header, laid out like this, whatever it looks like.
    pub raw: Option<RawLayout>,
    /// Replaces the file's spacing; the middle of the grid stays where it is.
    pub spacing: Option<[f32; 3]>,
    /// The array to read of a file with several.
    pub array: Option<String>,
    /// The point in time to read of a file with several, counted from 0.
    pub time: Option<u32>,
    /// The point in time to read in seconds, in place of `time`: the nearest that the file states.
    pub seconds: Option<f64>,
    /// The world direction that is to point up; the volume is turned for it.
    pub up: Option<Up>,
}

impl OpenOptions {
    /// Applies the fields for a volume's place: its spacing and its up.
    ///
    /// # Errors
    ///
    /// Those of [`Volume::with_spacing`].
    pub fn place(&self, mut volume: Volume) -> Result<Volume, Error> {
        if let Some(spacing) = self.spacing {
            volume = volume.with_spacing(spacing)?;
        }
        Ok(match self.up {
            Some(up) => volume.turned(up),
            None => volume,
        })
    }
}

/// A part of a file that can be picked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// [`OpenOptions::array`].
    Array,
    /// [`OpenOptions::time`].
    Time,
}
