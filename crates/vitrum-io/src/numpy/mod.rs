//! NumPy's `.npy`: one array with a small header.
//!
//! The format: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

mod header;
mod literal;

use std::path::Path;

use self::header::{Header, MAGIC};
use crate::error::{Error, Report};
use crate::input::Input;
use crate::memory;
use crate::open::{OpenOptions, Part, VolumeReader};
use crate::placement::UNORIENTED;
use crate::samples::VoxelBuffer;
use crate::stream;
use crate::time::Times;
use crate::volume::{Source, Volume};

/// The reader of `.npy` files.
pub(crate) struct Numpy;

impl VolumeReader for Numpy {
    fn name(&self) -> &'static str {
        "NumPy"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &[".npy"]
    }

    fn recognises(&self, head: &[u8], _path: &Path) -> bool {
        head.starts_with(MAGIC)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut reader = input.open()?;
        let header = Header::read(&mut reader, input.length, report)?;
        let size = header.sample.size();
        let bytes = stream::data_bytes(report, header.dictionary, header.dimensions, header.sample)?;
        let count = bytes / size as u64;
        let mut assumptions = assumptions(&header, options.spacing.is_some());
        let times = Times::choose(report, header.dictionary, header.times, options, &mut assumptions)?;
        let (before, all) = times.spans(report, header.dictionary, bytes)?;
        let there = input.length.saturating_sub(header.data_start);
        stream::check_length(report, all, header.data_start, there)?;
        if there > all {
            assumptions.push(format!("{} bytes behind the last voxel were left unread", there - all));
        }
        memory::check(report, count * header.sample.stored_size() as u64, options.max_bytes)?;
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let mut voxels = VoxelBuffer::reserve(report, header.sample, header.endian, count)?;
        stream::skip(report, &mut reader, before)?;
        stream::fill(report, &mut voxels, &mut reader, count, size)?;
        let name = input.name.clone();
        let mut volume = Volume::of_samples(name, header.dimensions, [1.0; 3], voxels.into_voxels(), header.sample)?;
        volume.source = Source {
            format: self.name(),
            sample_type: header.sample_name().to_owned(),
            encoding: match size {
                1 => "raw".to_owned(),
                _ => format!("raw, {}", header.endian.name()),
            },
            assumptions,
        };
        Ok(volume)
    }
}

fn assumptions(header: &Header, spacing_given: bool) -> Vec<String> {
    let fastest = if header.fortran_order { "first, as the array is in Fortran order," } else { "last" };
    let mut notes = vec![format!(
        "the array's index that changes fastest, the {fastest} was taken for x, the slowest for {}",
        if header.times > 1 { "time" } else { "z" }
    )];
    if !spacing_given {
        notes.push("an array has no spacings: 1 was taken along each axis".to_owned());
    }
    notes.push(UNORIENTED.to_owned());
    notes.extend(header.sample.rounding_note());
    notes
}
