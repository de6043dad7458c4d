//! One array: its header, and the samples behind it.

use std::io::Read;

use super::header::{Header, Wanted};
use crate::components::{self, Components};
use crate::error::{Error, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::paged::Contiguous;
use crate::placement::unoriented;
use crate::planes;
use crate::samples::{SampleType, VoxelBuffer};
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions, Source};
use crate::storage::Storage;
use crate::stream;
use crate::time::{Clock, Times};
use crate::volume::Volume;

/// Reads an array of `length` bytes, its header included, which were unpacked from `packing`, or lie in `storage` as they are; the volume, and how many bytes
/// of other points in time and of nothing that is known are left behind its voxels.
pub(super) fn read(
    reader: &mut dyn Read,
    length: u64,
    packing: &str,
    part: Option<&str>,
    report: Report,
    options: &OpenOptions,
    storage: Option<Storage>,
) -> Result<(Volume, u64), Error> {
    let header = Header::read(reader, length, wanted(part, options), report)?;
    let place = header.dictionary;
    let mut assumptions = assumptions(&header, options.spacing.is_some());
    let components = components(&header, part, report, &mut assumptions)?;
    // The last index of Fortran order changes slowest: components lie in planes, then.
    let beside = components.filter(|_| !header.fortran_order);
    let (sample, endian, size) = components::decoded_as(header.sample, header.endian, beside);
    let bytes = stream::data_bytes_of(report, place, header.dimensions, size)?;
    let count = bytes / size as u64;
    let times = Times::choose(report, place, header.times, &Clock::Unknown, options, &mut assumptions)?;
    let (before, plane) = times.spans(report, place, bytes)?;
    let planes = Times { count: if beside.is_none() { header.components } else { 1 }, chosen: 0 };
    let (_, all) = planes.spans(report, place, plane)?;
    let there = length.saturating_sub(header.data_start);
    stream::check_length(report, all, header.data_start, there)?;
    if there > all {
        assumptions.push(format!("{} bytes behind the last voxel were left unread", there - all));
    }
    let stored = if components.is_some() { SampleType::F32 } else { sample };
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let contiguous = storage.filter(|_| components.is_none()).map(|storage| {
        let start = header.data_start.saturating_add(before);
        Contiguous { storage, name: report.file, start, dimensions: header.dimensions, sample, endian }
    });
    let paged = contiguous.map(|data| data.open(options)).transpose()?.flatten();
    if paged.is_none() {
        memory::check(report, count as u64 * components::stored_bytes(stored, components), options.max_bytes)?;
    }
    let (voxels, left) = match (components, paged) {
        (_, Some(paged)) => (paged, there - before - bytes),
        (Some(components), None) if beside.is_none() => {
            let voxels = planes::read(report, reader, count, components, (before, plane - before - bytes))?;
            let unread = (planes.count - components.needed() as u64) * plane;
            (voxels, there - all + unread + plane - before - bytes)
        }
        _ => {
            let mut voxels = VoxelBuffer::reserve(report, sample, endian, count)?;
            stream::skip(report, reader, before)?;
            components::fill(report, &mut voxels, reader, count, size, beside)?;
            (voxels.into_voxels(), there - before - bytes)
        }
    };
    let name = report.file.to_owned();
    let volume = Volume::of_samples(name, header.dimensions, [1.0; 3], voxels, stored)?;
    let numbers = if header.components > 1 { format!("{} x ", header.components) } else { String::new() };
    let volume = volume.with_source(Source {
        format: "",
        sample_type: format!("{numbers}{}", header.sample_name()),
        encoding: header.sample.coding(packing, header.endian),
        assumptions,
    });
    Ok((volume, left))
}

/// What the user says that tells a last axis of components from others.
pub(super) fn wanted<'a>(part: Option<&'a str>, options: &OpenOptions) -> Wanted<'a> {
    Wanted { part, time: options.time.is_some() || options.seconds.is_some() }
}

/// What is made of the numbers of a voxel, where it has several.
fn components(
    header: &Header,
    part: Option<&str>,
    report: Report,
    assumptions: &mut Assumptions,
) -> Result<Option<Components>, Error> {
    if header.components == 1 {
        return components::refuse(report, "NumPy", part).map(|()| None);
    }
    let colors = header.sample == SampleType::U8 && (3..=4).contains(&header.components);
    let decoding = (header.sample, header.endian);
    let at = (report, header.dictionary);
    Components::choose(at, header.components, colors, decoding, part, assumptions).map(Some)
}

fn assumptions(header: &Header, spacing_given: bool) -> Assumptions {
    let fastest = match header.components {
        _ if header.fortran_order => "first, as the array is in Fortran order,",
        1 => "last",
        _ => "last but one, as the last has the components,",
    };
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
