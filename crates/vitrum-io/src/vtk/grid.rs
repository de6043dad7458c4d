//! The grid of a legacy VTK file, once it is known which array is read.

use super::blocks::Block;
use super::fields::{Attributes, Fields};
use super::header::Header;
use crate::components::{self, Components};
use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::placement::{Placement, unoriented};
use crate::samples::{Endian, SampleType};
use crate::source::Assumptions;
use crate::stream;
use crate::tolerance;
use crate::volume::IDENTITY;

impl Fields {
    pub fn finish(
        mut self,
        report: Report,
        block: &Block,
        start: u64,
        (count, cells, count_line): Attributes,
        part: Option<&str>,
        options: &OpenOptions,
    ) -> Result<Header, Error> {
        let sample = block.sample(report)?;
        if !self.dataset {
            return Err(self.missing(report, "DATASET", "DATASET STRUCTURED_POINTS"));
        }
        let Some((points, line)) = self.dimensions else {
            return Err(self.missing(report, "DIMENSIONS", "DIMENSIONS 64 64 64"));
        };
        // A flat image has cells that are flat.
        let dimensions = points.map(|size| if cells && size > 1 { size - 1 } else { size });
        let at_line = Place::Line(line);
        if dimensions.contains(&0) {
            return Err(report.invalid(at_line, "DIMENSIONS without voxels", "give each axis a size of at least 1"));
        }
        let mut assumptions = Assumptions::default();
        // Colours of a table are bytes, or numbers up to 1 in text, of a keyword of their own.
        let colors = block.colors || sample == SampleType::U8 && (3..=4).contains(&block.components);
        let at = (report, Place::Line(block.line));
        let decoding = (sample, Endian::Big);
        let components =
            Components::of_array(at, &block.name, block.components, colors, decoding, part, &mut assumptions)?;
        let (.., voxel_size) = components::decoded_as(sample, Endian::Big, components);
        let data_bytes = stream::byte_count(dimensions, voxel_size)
            .map_err(|problem| report.invalid(at_line, problem, "correct DIMENSIONS"))?;
        let expected = data_bytes / voxel_size as u64;
        // An array of a FIELD has a count of its own.
        let (count, count_line) = if block.count == count { (count, count_line) } else { (block.count, block.line) };
        if count != expected {
            return Err(report.invalid(
                Place::Line(count_line),
                format!("{count} values for the {expected} voxels of DIMENSIONS"),
                "correct one of the two",
            ));
        }
        assumptions.extend(sample.rounding_note());
        let placement = self.placement(report, points, cells, options, &mut assumptions)?;
        let binary = self.binary;
        Ok(Header { binary, sample, components, dimensions, data_bytes, length: start, placement, assumptions })
    }

    fn placement(
        &mut self,
        report: Report,
        points: [u32; 3],
        cells: bool,
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Placement, Error> {
        let spacing = match self.spacing.take() {
            Some(stated) => {
                let spacing = tolerance::replaceable(stated, [1.0; 3], options)?;
                assumptions.note_origin("spacing", "`SPACING`");
                tolerance::steps(spacing, 1.0, options, assumptions)
            }
            None => {
                tolerance::note_unspaced(options, assumptions);
                [1.0; 3]
            }
        };
        assumptions.push(unoriented());
        if cells {
            assumptions.push("the values of the cells were taken at their centres".to_owned());
        }
        let first = |axis: usize| if cells && points[axis] > 1 { 0.5 * spacing[axis] } else { 0.0 };
        let origin = self.origin.map(|(origin, _)| [0, 1, 2].map(|axis| origin[axis] + first(axis)));
        let columns = [0, 1, 2].map(|axis| IDENTITY[axis].map(|unit| f64::from(unit) * spacing[axis]));
        let place = self.origin.map_or(Place::File, |(_, line)| Place::Line(line));
        Placement::mended(columns, origin, Orientation::Unknown, options, assumptions)
            .map_err(|problem| report.invalid(place, problem, "correct SPACING or ORIGIN"))
    }
}
