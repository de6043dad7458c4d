//! One array: its header, and the samples behind it.

use std::io::Read;

use super::header::Header;
use crate::error::{Error, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::placement::unoriented;
use crate::samples::VoxelBuffer;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions, Source};
use crate::stream;
use crate::time::{Clock, Times};
use crate::volume::Volume;

/// Reads an array of `length` bytes, its header included, which were unpacked from `packing`; the volume, and how many bytes
/// of other points in time and of nothing that is known are left behind its voxels.
pub(super) fn read(
    reader: &mut dyn Read,
    length: u64,
    packing: &str,
    report: Report,
    options: &OpenOptions,
) -> Result<(Volume, u64), Error> {
    let header = Header::read(reader, length, report)?;
    let size = header.sample.size();
    let bytes = stream::data_bytes(report, header.dictionary, header.dimensions, header.sample)?;
    let count = bytes / size as u64;
    let mut assumptions = assumptions(&header, options.spacing.is_some());
    let times = Times::choose(report, header.dictionary, header.times, &Clock::Unknown, options, &mut assumptions)?;
    let (before, all) = times.spans(report, header.dictionary, bytes)?;
    let there = length.saturating_sub(header.data_start);
    stream::check_length(report, all, header.data_start, there)?;
    if there > all {
        assumptions.push(format!("{} bytes behind the last voxel were left unread", there - all));
    }
    memory::check(report, count * header.sample.stored_size() as u64, options.max_bytes)?;
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let mut voxels = VoxelBuffer::reserve(report, header.sample, header.endian, count)?;
    stream::skip(report, reader, before)?;
    stream::fill(report, &mut voxels, reader, count, size)?;
    let name = report.file.to_owned();
    let volume = Volume::of_samples(name, header.dimensions, [1.0; 3], voxels.into_voxels(), header.sample)?;
    let volume = volume.with_source(Source {
        format: "",
        sample_type: header.sample_name().to_owned(),
        encoding: header.sample.coding(packing, header.endian),
        assumptions,
    });
    Ok((volume, there - before - bytes))
}

fn assumptions(header: &Header, spacing_given: bool) -> Assumptions {
    let fastest = if header.fortran_order { "first, as the array is in Fortran order," } else { "last" };
    let mut notes = Assumptions::default();
    notes.push(format!(
        "the array's index that changes fastest, the {fastest} was taken for x, the slowest for {}",
        if header.times > 1 { "time" } else { "z" }
    ));
    if !spacing_given {
        let fact = "an array has no spacings: 1 was taken along each axis";
        notes.push(Assumption::replaceable(fact, Setting::Spacing, ""));
    }
    notes.push(unoriented());
    notes.extend(header.sample.rounding_note());
    notes
}
