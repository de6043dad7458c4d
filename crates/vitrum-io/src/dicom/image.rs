//! The image files of a series, their frames, and the slices that these are.

use std::path::PathBuf;

use dicom_object::Tag;
use glam::DVec3;

use super::attributes;
use crate::input::file_name;
use crate::samples::SampleType;
use crate::source::Fact;

/// The stored values from Pixel Padding Value to Pixel Padding Range Limit, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Padding {
    pub low: i64,
    pub high: i64,
}

/// Layout of a pixel's bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pixels {
    /// Type of a sample, by the allocated bits and the sign.
    pub sample: SampleType,
    /// Stored bits of a number, at most the bits of a sample.
    pub stored: u32,
    /// The lowest of them.
    pub low_bit: u32,
}

/// A frame's place and value mapping.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Frame {
    /// Centre of the first pixel in mm: towards the patient's left, posterior, superior.
    pub position: Option<[f64; 3]>,
    /// The directions of a row and of a column.
    pub orientation: Option<[f64; 6]>,
    /// Slope and intercept.
    pub rescale: [f64; 2],
    /// The attributes that may tell points in time apart, as in [`TIMES`].
    pub times: [Option<f64>; TIMES.len()],
}

/// Attributes that tell points in time apart, those that say so first, and their names for people.
pub(super) const TIMES: [(Tag, &str); 7] = [
    (attributes::TEMPORAL_POSITION, "temporal positions"),
    (attributes::TRIGGER_TIME, "trigger times"),
    (attributes::ECHO_TIME, "echo times"),
    (attributes::ACQUISITION_NUMBER, "acquisition numbers"),
    (attributes::ACQUISITION_TIME, "acquisition times"),
    (attributes::CONTENT_TIME, "content times"),
    (attributes::INSTANCE_NUMBER, "instance numbers"),
];

/// A file of one or more frames, all of one size and type.
#[derive(Debug)]
pub(super) struct File {
    /// Path of the file, or the name under which its bytes were given.
    pub path: PathBuf,
    pub name: String,
    /// Size of the file in bytes.
    pub length: u64,
    pub series: String,
    /// The identifier of the image itself; may be empty.
    pub instance: String,
    /// Description for people, such as `MR, T1 sagittal`.
    pub description: String,
    pub syntax: String,
    pub columns: u32,
    pub rows: u32,
    pub pixels: Pixels,
    pub padding: Option<Padding>,
    pub inverted: bool,
    /// Whether values are indices of colours.
    pub palette: bool,
    /// The element of the pixels.
    pub data: Tag,
    /// Whether pixels of 32 bits come as words of 16, the upper one first.
    pub swapped: bool,
    /// Distance between rows and between columns, in mm.
    pub spacing: Option<[f64; 2]>,
    /// Distance between slices in mm, for files without positions.
    pub step: Option<f64>,
    pub frames: Vec<Frame>,
    /// What a radiologist asks first.
    pub facts: Vec<Fact>,
}

/// One slice of a volume: a frame of a file.
#[derive(Debug, Clone)]
pub(super) struct Slice<'a> {
    pub file: &'a File,
    /// Index of the file in the series, and of the frame in the file.
    pub index: [usize; 2],
    pub position: Option<[f64; 3]>,
    pub orientation: Option<[f64; 6]>,
    pub rescale: [f64; 2],
    /// As [`Frame::times`].
    pub times: [Option<f64>; TIMES.len()],
}

impl File {
    /// Name without the folder, for messages about another file of the same series.
    pub fn short_name(&self) -> String {
        file_name(&self.path)
    }

    /// All that slices of a volume share.
    pub fn kind(&self) -> String {
        let Pixels { stored, low_bit, .. } = self.pixels;
        format!("{} {stored} {low_bit} {}", self.describe(), self.data)
    }

    /// Size and type of a frame, such as `256 x 256 int16`.
    pub fn describe(&self) -> String {
        format!("{} x {} {}", self.columns, self.rows, self.pixels.sample.name())
    }
}

/// Unit normal of a slice: the cross product of the directions of a row and of a column.
pub(super) fn normal([a, b, c, d, e, f]: [f64; 6]) -> [f64; 3] {
    DVec3::new(a, b, c).cross(DVec3::new(d, e, f)).to_array()
}
