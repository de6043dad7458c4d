//! NIfTI-1, the format of neuroimaging: a binary header and the data in one file, often gzipped.

mod header;
mod orientation;

use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

use flate2::bufread::MultiGzDecoder;

use self::header::{Header, Kind};
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::open::{Input, OpenOptions, VolumeReader};
use crate::samples::{VoxelBuffer, read_up_to};
use crate::stream;
use crate::volume::{Source, Volume};
use crate::voxels::Voxels;

/// The reader of `.nii` and `.nii.gz` files.
pub(crate) struct Nifti;

impl VolumeReader for Nifti {
    fn name(&self) -> &'static str {
        "NIfTI-1"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".nii", ".nii.gz"]
    }

    fn recognises(&self, head: &[u8], _path: &Path) -> bool {
        header::kind(head).is_some()
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let endian = match header::kind(&input.head) {
            Some(Kind::Single(endian)) => endian,
            kind => return Err(refusal(report, kind)),
        };
        let file = BufReader::new(File::open(input.path).map_err(|error| report.unreadable(error))?);
        let mut reader: Box<dyn Read> =
            if input.gzipped { Box::new(MultiGzDecoder::new(file)) } else { Box::new(file) };
        let mut bytes = [0; header::LENGTH];
        let (found, outcome) = read_up_to(&mut reader, &mut bytes);
        outcome.map_err(|error| stream::damaged(report, found as u64, header::LENGTH as u64, error))?;
        let header = Header::parse(&bytes, endian, report)?;
        let mut assumptions = Vec::new();
        let placement = orientation::placement(&header, report, &mut assumptions)?;
        assumptions.extend(header.sample.rounding_note());
        let voxels = read_data(&header, input, &mut reader, options, &mut assumptions)?;
        let name = input.name.clone();
        let mut volume = Volume::new(name, header.dimensions, placement.spacing, voxels)?;
        placement.apply(&mut volume);
        let volume = apply_scaling(volume, &header)?;
        let packing = if input.gzipped { "gzip" } else { "raw" };
        Ok(Volume {
            source: Source {
                format: self.name(),
                sample_type: header.sample.name().to_owned(),
                encoding: format!("{packing}, {}", endian.name()),
                assumptions,
            },
            ..volume
        })
    }
}

/// Why a file that came here by its content or its extension is not read.
fn refusal(report: Report, kind: Option<Kind>) -> Error {
    match kind {
        Some(Kind::Second) => report.unsupported(
            Place::Byte(4),
            "this is NIfTI-2, and only NIfTI-1 is read",
            "convert it, for example by `nifti_tool -convert2dtype` or nibabel's Nifti1Image",
        ),
        Some(Kind::Pair) => report.unsupported(
            Place::Byte(344),
            "this is the header of a NIfTI pair, with its data in an .img file",
            "convert it to a single .nii file, for example by `fslchfiletype NIFTI FILE`",
        ),
        _ => report.invalid(
            Place::Byte(0),
            "this does not start with a NIfTI-1 header: 348 in either byte order, and `n+1` at \
             byte 344",
            "check that the file is whole, and that its extension is right",
        ),
    }
}

fn read_data(
    header: &Header,
    input: &Input,
    reader: &mut dyn Read,
    options: &OpenOptions,
    assumptions: &mut Vec<String>,
) -> Result<Voxels, Error> {
    let report = Report::new(&input.name);
    let size = header.sample.size() as u64;
    // At most 32767 to the third power times 8: far below the limits of u64.
    let count: u64 = header.dimensions.into_iter().map(u64::from).product();
    let start = header.data_start;
    if input.gzipped {
        stream::check_deflate(report, start + count * size, input.length)?;
    } else {
        let there = input.length.saturating_sub(start);
        stream::check_length(report, count * size, start, there)?;
        if there > count * size {
            let unread = there - count * size;
            assumptions.push(format!("{unread} bytes behind the last voxel were left unread"));
        }
    }
    memory::check(report, count * header.sample.stored_size() as u64, options.max_bytes)?;
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let mut voxels = VoxelBuffer::reserve(report, header.sample, header.endian, count)?;
    // Extensions lie between the header and the data. A stream that ends in them has no data, and
    // is told so below.
    let extensions = start - header::LENGTH as u64;
    io::copy(&mut reader.take(extensions), &mut io::sink())
        .map_err(|error| stream::damaged(report, header::LENGTH as u64, start, error))?;
    stream::fill(report, &mut voxels, reader, count, size as usize)?;
    if input.gzipped {
        stream::refuse_surplus(report, reader, count as u64 * size)?;
    }
    Ok(voxels.into_voxels())
}

/// Physical values are `slope * sample + intercept`; a slope of 0 means that there is none.
fn apply_scaling(volume: Volume, header: &Header) -> Result<Volume, Error> {
    let (slope, intercept) = match (header.slope, header.intercept) {
        (0.0, _) => (1.0, 0.0),
        // Some writers leave NaN for "none".
        (slope, _) if slope.is_nan() => (1.0, 0.0),
        given => given,
    };
    if !(slope.is_finite() && intercept.is_finite()) {
        return Err(Report::new(&volume.name).invalid(
            Place::Byte(112),
            format!("scl_slope is {slope} and scl_inter {intercept}, not finite numbers"),
            "correct the header",
        ));
    }
    // Signed integers are stored shifted by their offset, which the slope then scales.
    let offset = slope * header.sample.value_offset() + intercept;
    if slope == 1.0 && offset == 0.0 {
        return Ok(volume);
    }
    volume.with_value_mapping(slope, offset)
}
