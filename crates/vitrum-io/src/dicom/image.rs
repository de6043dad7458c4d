//! The image files of a series, their frames, and the slices that these are.

use std::path::PathBuf;

use glam::DVec3;

use crate::input::file_name;
use crate::samples::SampleType;

/// The stored values from Pixel Padding Value to Pixel Padding Range Limit, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Padding {
    pub low: i64,
    pub high: i64,
}

/// Layout of a pixel's bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pixels {
    /// By the bits that are allocated and the sign.
    pub sample: SampleType,
    /// Bits that hold the number, at most those of the sample.
    pub stored: u32,
    /// The lowest of them.
    pub low_bit: u32,
}

/// A frame's place and value mapping.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Frame {
    /// Of the centre of the first pixel, in mm, towards the patient's left, posterior, superior.
    pub position: Option<[f64; 3]>,
    /// The directions of a row and of a column.
    pub orientation: Option<[f64; 6]>,
    /// Slope and intercept.
    pub rescale: [f64; 2],
}

/// A file of one or more frames, all of one size and type.
#[derive(Debug)]
pub(super) struct File {
    /// Its path, or the name that its bytes were given under.
    pub path: PathBuf,
    pub name: String,
    /// Its size in bytes.
    pub length: u64,
    pub series: String,
    /// For people, such as `MR, T1 sagittal`.
    pub description: String,
    pub syntax: String,
    pub columns: u32,
    pub rows: u32,
    pub pixels: Pixels,
    pub padding: Option<Padding>,
    pub inverted: bool,
    /// Between rows and between columns, in mm.
    pub spacing: Option<[f64; 2]>,
    /// Between slices, in mm, where positions do not tell.
    pub step: Option<f64>,
    pub frames: Vec<Frame>,
}

/// One slice of a volume: a frame of a file.
#[derive(Debug, Clone)]
pub(super) struct Slice<'a> {
    pub file: &'a File,
    /// Which file of the series, and which frame of it.
    pub index: [usize; 2],
    pub position: Option<[f64; 3]>,
    pub orientation: Option<[f64; 6]>,
    pub rescale: [f64; 2],
}

impl File {
    /// Its name without the folder, for messages about another of the same series.
    pub fn short_name(&self) -> String {
        file_name(&self.path)
    }

    /// Such as `256 x 256 int16`.
    pub fn describe(&self) -> String {
        format!("{} x {} {}", self.columns, self.rows, self.pixels.sample.name())
    }
}

/// The direction from slice to slice, by those of a row and a column.
pub(super) fn normal([a, b, c, d, e, f]: [f64; 6]) -> [f64; 3] {
    DVec3::new(a, b, c).cross(DVec3::new(d, e, f)).to_array()
}
