//! Writing `.npy`: one array, little-endian.

use std::path::Path;

use crate::atomic_write::write_whole;
use crate::error::{Error, Report};
use crate::physical_values::{sample_type, write_values};
use crate::samples::SampleType;
use crate::volume::Volume;

/// Writes a volume's physical values as an array of the shape (z, y, x) to `path`, whole or not at all.
pub(crate) fn write_npy(report: Report, path: &Path, volume: &Volume) -> Result<(), Error> {
    let kind = match sample_type(volume) {
        SampleType::U8 => "|u1",
        SampleType::I8 => "|i1",
        SampleType::U16 => "<u2",
        SampleType::I16 => "<i2",
        _ => "<f4",
    };
    let [x, y, z] = volume.dimensions;
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({z}, {y}, {x}), }}");
    // The data starts at a multiple of 64, behind 10 bytes, the header and a line end.
    let padding = (10 + header.len() + 1).next_multiple_of(64) - 10 - header.len() - 1;
    write_whole(report, path, |sink| {
        sink.write_all(b"\x93NUMPY\x01\x00")?;
        // Three sizes of at most 10 digits keep it far below 65536.
        sink.write_all(&((header.len() + padding + 1) as u16).to_le_bytes())?;
        writeln!(sink, "{header}{:padding$}", "")?;
        write_values(sink, volume)
    })
}
