//! NumPy's `.npy`: one array with a small header.
//!
//! The format: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

mod header;
mod literal;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use self::header::{Header, MAGIC};
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::open::{Input, OpenOptions, VolumeReader};
use crate::samples::VoxelBuffer;
use crate::stream;
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

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        if input.gzipped {
            return Err(report.unsupported(
                Place::File,
                "a .npy file compressed as a whole",
                "decompress it by `gunzip`",
            ));
        }
        let mut reader = BufReader::new(File::open(input.path).map_err(|error| report.unreadable(error))?);
        let header = Header::read(&mut reader, input.length, report)?;
        let size = header.sample.size();
        let bytes = stream::data_bytes(report, header.dictionary, header.dimensions, header.sample)?;
        let count = bytes / size as u64;
        let there = input.length.saturating_sub(header.data_start);
        stream::check_length(report, bytes, header.data_start, there)?;
        memory::check(report, count * header.sample.stored_size() as u64, options.max_bytes)?;
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let mut voxels = VoxelBuffer::reserve(report, header.sample, header.endian, count)?;
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
            assumptions: assumptions(&header, there - bytes),
        };
        Ok(volume)
    }
}

fn assumptions(header: &Header, unread: u64) -> Vec<String> {
    let fastest = if header.fortran_order { "first, as the array is in Fortran order," } else { "last" };
    let mut notes = vec![
        format!("the array's index that changes fastest, the {fastest} was taken for x, the slowest for z"),
        "an array has no spacings: 1 was taken along each axis".to_owned(),
    ];
    notes.extend(header.sample.rounding_note());
    if unread > 0 {
        notes.push(format!("{unread} bytes behind the last voxel were left unread"));
    }
    notes
}
