//! NIfTI-1 and -2, the format of neuroimaging: a binary header and the data in one file, often
//! packed as a whole, or in two.

mod components;
mod header;
mod layout;
mod orientation;
mod pair;

use std::io::Read;

use self::header::Header;
use self::layout::FIRST;
use crate::components::{Components, decoded_as, fill, stored_bytes};
use crate::error::{Error, Place, Report};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::labels::Labels;
use crate::memory;
use crate::options::{OpenOptions, Part};
use crate::packing::Packing;
use crate::paged::Contiguous;
use crate::planes;
use crate::reader::VolumeReader;
use crate::samples::{SampleType, VoxelBuffer, read_up_to};
use crate::source::{Assumptions, Source};
use crate::stored::Stored;
use crate::stream;
use crate::time::Times;
use crate::volume::Volume;

/// The reader of `.nii` files and of pairs of `.hdr` and `.img`, each perhaps packed.
pub(crate) struct Nifti;

impl VolumeReader for Nifti {
    fn format(&self) -> &'static Format {
        &formats::NIFTI
    }

    fn recognises(&self, input: &Input) -> bool {
        header::kind(&input.head).is_some()
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn unpacks(&self) -> bool {
        true
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let kind = header::kind(&input.head).ok_or_else(|| refusal(report, &input.head))?;
        let mut reader = input.unpacked()?;
        let mut bytes = vec![0; kind.layout.length];
        let (found, outcome) = read_up_to(&mut reader, &mut bytes);
        outcome.map_err(|error| stream::damaged(report, found as u64, bytes.len() as u64, error))?;
        if found < bytes.len() {
            return Err(report.invalid(
                Place::Byte(found as u64),
                format!("the header ends here, and has {} bytes", bytes.len()),
                "get the whole file",
            ));
        }
        let header = Header::parse(&bytes, kind, report)?;
        let mut assumptions = Assumptions::default();
        let placement = orientation::placement(&header, report, options, &mut assumptions)?;
        let scaling = scaling(&header, report)?;
        let components = components::choose(&header, scaling, report, options, &mut assumptions)?;
        assumptions.extend(header.sample.rounding_note());
        const LABEL: i32 = 1002;
        if header.intent == LABEL {
            assumptions.set_labels(Labels { by: "header's intent".to_owned(), list: Vec::new() });
        }
        let (voxels, packing) = if kind.pair {
            let image = pair::image(input, kind)?;
            let image = Input::new(&image, options)?;
            let data = Data { input: &image, reader: image.unpacked()?, position: 0 };
            (data.read(&header, components, options, &mut assumptions)?, image.packing)
        } else {
            let data = Data { input, reader, position: found as u64 };
            (data.read(&header, components, options, &mut assumptions)?, input.packing)
        };
        let name = input.name.clone();
        // Of several numbers one is made of the mapped ones.
        let [slope, intercept] = if components.is_some() { [1.0, 0.0] } else { scaling };
        let mut volume = Volume::of_slope(name, header.dimensions, placement.spacing, voxels, slope)?;
        placement.apply(&mut volume);
        let (sample, ..) = decoded_as(header.sample, header.endian, components);
        // Signed integers are stored shifted by their offset, which the slope then scales.
        let offset = slope * sample.value_offset() + intercept;
        if slope != 1.0 || offset != 0.0 {
            volume = volume.with_value_mapping(slope, offset)?;
        }
        Ok(volume.with_source(Source {
            format: kind.layout.name,
            sample_type: Components::named(components, header.sample),
            encoding: format!("{}, {}", packing.name(), header.endian.name()),
            assumptions,
        }))
    }
}

/// Why a file that came here by its extension is not read.
fn refusal(report: Report, head: &[u8]) -> Error {
    if pair::is_image(report.file) {
        return report.unsupported(
            Place::File,
            "this is the data of a NIfTI pair, which says nothing about itself",
            "open its header, the .hdr file beside it",
        );
    }
    if pair::is_header(report.file)
        && [348_i32.to_le_bytes(), 348_i32.to_be_bytes()].iter().any(|size| head.starts_with(size))
    {
        return report.unsupported(
            Place::Byte(FIRST.magic as u64),
            "this is the header of an ANALYZE 7.5 pair or damaged: a NIfTI-1 pair has `ni1` here",
            "convert it to NIfTI, for example by nibabel",
        );
    }
    report.invalid(
        Place::Byte(0),
        "this does not start with a NIfTI header: 348 in either byte order and `n+1` at byte 344, or \
         540 and `n+2` at byte 4",
        "check that the file is whole, and that its extension is right",
    )
}

/// The file with the samples, which is the header's or another.
struct Data<'a> {
    input: &'a Input<'a>,
    reader: Box<dyn Read + 'a>,
    /// Bytes of it that were read.
    position: u64,
}

impl Data<'_> {
    fn read(
        mut self,
        header: &Header,
        components: Option<Components>,
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Stored, Error> {
        let Input { name, length, packing, .. } = self.input;
        let report = Report::new(name);
        let sizes = |index: usize| Place::Byte(header.layout.dim(index) as u64);
        // Numbers side by side make one voxel, those of planes one each.
        let beside = components.filter(|_| header.channels > 1);
        let (sample, endian, size) = decoded_as(header.sample, header.endian, beside);
        let bytes = stream::data_bytes_of(report, sizes(1), header.dimensions, size)?;
        let times = Times::choose(report, sizes(4), header.times, &header.clock(), options, assumptions)?;
        let (before, plane) = times.spans(report, sizes(4), bytes)?;
        let planes = Times { count: header.planes, chosen: 0 };
        let (_, all) = planes.spans(report, sizes(5), plane)?;
        let count = bytes / size as u64;
        let start = header.data_start;
        if *packing == Packing::Plain {
            let there = length.saturating_sub(start);
            stream::check_length(report, all, start, there)?;
            if there > all {
                let unread = there - all;
                assumptions.push(format!("{unread} bytes behind the last voxel were left unread"));
            }
        } else {
            stream::check_ratio(report, start + all, *length, packing.ratio())?;
        }
        let (dimensions, from) = (header.dimensions, start.saturating_add(before));
        let data = Contiguous { storage: self.input.storage(), name, start: from, dimensions, sample, endian };
        if *packing == Packing::Plain
            && components.is_none()
            && let Some(paged) = data.open(options)?
        {
            return Ok(paged);
        }
        let stored = if components.is_some() { SampleType::F32 } else { sample };
        memory::check(report, count * stored_bytes(stored, components), options.max_bytes)?;
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        // Extensions lie between the header and the data.
        stream::skip(report, &mut self.reader, start.saturating_sub(self.position))?;
        if let (Some(components), None) = (components, beside) {
            return planes::read(report, &mut self.reader, count, components, (before, plane - before - bytes));
        }
        let mut voxels = VoxelBuffer::reserve(report, sample, endian, count)?;
        stream::skip(report, &mut self.reader, before)?;
        fill(report, &mut voxels, &mut self.reader, count, size, beside)?;
        if *packing != Packing::Plain && times.is_last() {
            stream::refuse_surplus(report, &mut self.reader, bytes)?;
        }
        Ok(voxels.into_voxels())
    }
}

/// Slope and intercept: physical values are `slope * sample + intercept`. A slope of 0 means that there is none.
fn scaling(header: &Header, report: Report) -> Result<[f32; 2], Error> {
    let (slope, intercept) = match (header.slope, header.intercept) {
        (0.0, _) => (1.0, 0.0),
        // Some writers leave NaN for "none".
        (slope, _) if slope.is_nan() => (1.0, 0.0),
        given => given,
    };
    if !(slope.is_finite() && intercept.is_finite()) {
        return Err(report.invalid(
            Place::Byte(header.layout.slope as u64),
            format!("scl_slope is {slope} and scl_inter {intercept}, not finite numbers"),
            "correct the header",
        ));
    }
    Ok([slope, intercept])
}
