//! DICOM: the slices of a series, each a file, or the frames of one.
//!
//! The standard: <https://www.dicomstandard.org/current>.

mod attributes;
mod codecs;
mod distances;
mod envelope;
mod facts;
mod files;
mod grid;
mod header;
mod image;
mod lengths;
mod padding;
mod pixels;
mod rle;
mod search;
mod syntax;
mod times;

use std::path::Path;

use self::files::Series;
use self::grid::Grid;
use self::image::Slice;
use crate::error::{Error, Place, Report};
use crate::folder::has_tiff;
use crate::formats::{self, Format};
use crate::input::Input;
use crate::memory;
use crate::options::{OpenOptions, Part};
use crate::reader::VolumeReader;
use crate::samples::{Endian, SampleType, VoxelBuffer};
use crate::source::{Assumptions, Source};
use crate::stream;
use crate::volume::Volume;

/// The reader of `.dcm` files and of folders of them.
pub(crate) struct Dicom;

impl VolumeReader for Dicom {
    fn format(&self) -> &'static Format {
        &formats::DICOM
    }

    fn recognises(&self, input: &Input) -> bool {
        // Files in a folder come before files in the folders below it.
        let holds = |path: &Path| search::has_dicom(path) || !has_tiff(path) && search::has_dicom_below(path);
        search::is_dicom(&input.head) || input.folder().is_some_and(holds)
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut assumptions = Assumptions::default();
        let mut series = Series::find(input, &mut assumptions)?;
        series.leave_out_unlike(&mut assumptions);
        let first = series.check_alike()?;
        let slices: Vec<Slice> = times::choose(report, series.slices(), options, &mut assumptions)?;
        let grid = Grid::new(report, &slices, options, &mut assumptions)?;
        facts::tell(&slices, options, &mut assumptions);
        let uniform = slices.iter().all(|slice| slice.rescale == slices[0].rescale);
        let sample = if uniform { first.pixels.sample } else { SampleType::F32 };
        if !uniform {
            assumptions
                .push("the slices have rescale slopes of their own: their values were stored as float32".to_owned());
        }
        let dimensions = [first.columns, first.rows, u32::try_from(slices.len()).unwrap_or(u32::MAX)];
        let bytes = stream::data_bytes(report, Place::File, dimensions, sample)?;
        let count = bytes / sample.size() as u64;
        let largest = series.files.iter().map(|file| file.length).max().unwrap_or(0);
        let doubled = if grid.uneven() { 2 } else { 1 };
        // Memory of the decoders for a pixel of a compressed slice, with some room.
        let decoding = if series.files.iter().all(|file| syntax::is_raw(&file.syntax)) { 0 } else { 24 };
        let decoding = u64::from(first.columns) * u64::from(first.rows) * decoding;
        let needed = count.saturating_mul(doubled * sample.stored_size() as u64);
        let needed = needed.saturating_add(largest).saturating_add(decoding);
        memory::check(report, needed, options.max_bytes)?;
        let capacity = usize::try_from(count).unwrap_or(usize::MAX);
        let mut voxels = VoxelBuffer::reserve(report, sample, Endian::Little, capacity)?;
        let ordered = grid.order(&slices);
        pixels::read(input, &series, &ordered, uniform, &mut voxels)?;
        let mut voxels = voxels.into_voxels().voxels;
        assumptions.extend(padding::replace(&ordered, uniform, &mut voxels));
        let voxels = grid.resample(report, voxels, dimensions)?;
        assumptions.extend(sample.rounding_note());
        assumptions.extend(grid.placement.shear_note());
        let mut volume = grid.placement.volume(&input.name, dimensions, voxels, sample)?;
        if uniform {
            let [slope, intercept] = slices[0].rescale.map(|value| value as f32);
            let offset = slope * sample.value_offset() + intercept;
            if slope != 1.0 || offset != 0.0 {
                volume = volume.with_value_mapping(slope, offset)?;
            }
        }
        let stored = first.pixels.sample.name().to_owned();
        let encoding = syntax::name(&first.syntax);
        Ok(volume.with_source(Source { format: self.format().name, sample_type: stored, encoding, assumptions }))
    }
}
