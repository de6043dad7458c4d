//! Writing a volume as NRRD or NumPy, so that other programs can read what Vitrum has read.

use std::io::{self, Write};
use std::path::Path;

use crate::beside::{create_beside, write_whole};
use crate::error::{Error, Place, Report};
use crate::input::display_name;
use crate::nrrd::{Lattice, Samples, write_nrrd};
use crate::samples::SampleType;
use crate::volume::Volume;
use crate::voxels::Voxels;

type Encode = fn(Report, &Path, &Volume) -> Result<(), Error>;

/// Writes a volume's physical values in the format that the extension of `path` names.
///
/// | Extension | What is written |
/// |---|---|
/// | `.nrrd` | gzip, with spacing, origin and axes; the space is right-anterior-superior for a patient, 3D-right-handed for another world, and not named where [`Volume::orientation`] is unknown |
/// | `.npy` | an array of the shape (z, y, x), without its place in the world |
///
/// Values are whole numbers of the smallest type of 8 or 16 bits that holds all of them where they were stored as whole
/// numbers, and float32 otherwise. The file appears at `path` whole or not at all.
///
/// # Errors
///
/// [`Error::Unsupported`] where the extension is unknown, [`Error::Write`] where the operating system fails.
pub fn write_volume(path: &Path, volume: &Volume) -> Result<(), Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    encoder(report, path)?(report, path, volume)
}

/// Whether [`write_volume`] could write to `path` now.
///
/// # Errors
///
/// Those of [`write_volume`].
pub fn check_volume_writable(path: &Path) -> Result<(), Error> {
    let name = display_name(path);
    let report = Report::new(&name);
    encoder(report, path)?;
    create_beside(report, path).map(drop)
}

fn encoder(report: Report, path: &Path) -> Result<Encode, Error> {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    match extension.as_str() {
        "nrrd" => Ok(nrrd),
        "npy" => Ok(npy),
        other => Err(report.unsupported(
            Place::File,
            format!("`.{other}` is no volume format that is written"),
            "use one of .nrrd, .npy",
        )),
    }
}

/// The smallest type that holds the physical values exactly.
pub(crate) fn sample_type(volume: &Volume) -> SampleType {
    let whole = volume.value_scale.fract() == 0.0 && volume.value_offset.fract() == 0.0;
    if !whole || matches!(volume.voxels, Voxels::F32(_)) {
        return SampleType::F32;
    }
    let [low, high] = volume.range;
    let fits = |least: f32, most: f32| low >= least && high <= most;
    // A volume that was stored in 16 bits stays there, so that a series of them has one type.
    let small = matches!(volume.voxels, Voxels::U8(_));
    match () {
        () if small && fits(0.0, 255.0) => SampleType::U8,
        () if small && fits(-128.0, 127.0) => SampleType::I8,
        () if fits(-32768.0, 32767.0) && volume.value_offset != 0.0 => SampleType::I16,
        () if fits(0.0, 65535.0) => SampleType::U16,
        () if fits(-32768.0, 32767.0) => SampleType::I16,
        () => SampleType::F32,
    }
}

fn nrrd(_report: Report, path: &Path, volume: &Volume) -> Result<(), Error> {
    write_nrrd(path, &Lattice::of(volume), Samples::Volume(volume), &[])
}

/// <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>
fn npy(report: Report, path: &Path, volume: &Volume) -> Result<(), Error> {
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

/// All physical values as [`sample_type`] says, x fastest, little-endian.
pub(crate) fn write_values(sink: &mut dyn Write, volume: &Volume) -> io::Result<()> {
    let sample = sample_type(volume);
    let mut chunk = Vec::new();
    for index in 0..volume.voxels.len() {
        let stored = volume.voxels.stored(index).unwrap_or_default();
        let value = stored * volume.value_scale + volume.value_offset;
        match sample {
            SampleType::U8 => chunk.push(value as u8),
            SampleType::I8 => chunk.extend((value as i8).to_le_bytes()),
            SampleType::U16 => chunk.extend((value as u16).to_le_bytes()),
            SampleType::I16 => chunk.extend((value as i16).to_le_bytes()),
            _ => chunk.extend(value.to_le_bytes()),
        }
        if chunk.len() >= 64 * 1024 {
            sink.write_all(&chunk)?;
            chunk.clear();
        }
    }
    sink.write_all(&chunk)
}
