//! Voxels of several numbers: colours side by side, and vectors in planes.

use super::header::Header;
use crate::components::{self, Components};
use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::source::Assumptions;

/// The codes of colours among the meanings of values.
const COLORS: [i32; 2] = [2003, 2004];

/// What is made of the numbers of a voxel, where it has several. Vectors are taken with `slope` and `intercept`; colours have none.
pub(super) fn choose(
    header: &Header,
    [slope, intercept]: [f32; 2],
    report: Report,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<Option<Components>, Error> {
    let asked = options.array.as_deref();
    if header.channels * header.planes == 1 {
        return components::refuse(report, "NIfTI", asked).map(|()| None);
    }
    let colors = header.channels > 1 || COLORS.contains(&header.intent);
    let place = Place::Byte(if header.channels > 1 { header.layout.datatype } else { header.layout.dim(5) } as u64);
    let decoding = (header.sample, header.endian);
    let count = header.channels.max(header.planes);
    let components = Components::choose((report, place), count, colors, decoding, asked, assumptions)?;
    Ok(Some(if header.channels > 1 { components } else { components.mapped(slope, intercept) }))
}
