//! Writing NRRD: one attached file, gzip, of the world's space.

use crate::error::{Error, Report};
use crate::image::create_beside;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::fmt::Write as _;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Samples of a grid, x fastest; those of a vector lie next to each other.
#[derive(Debug, Clone, Copy)]
pub enum Samples<'a> {
    /// One byte a voxel.
    U8(&'a [u8]),
    /// One float a voxel.
    F32(&'a [f32]),
    /// A vector a voxel, which stays as it is when the grid is turned.
    Colors(&'a [[f32; 3]]),
    /// A vector a voxel, which turns with the grid.
    Vectors(&'a [[f32; 3]]),
}

impl Samples<'_> {
    fn count(self) -> usize {
        match self {
            Self::U8(samples) => samples.len(),
            Self::F32(samples) => samples.len(),
            Self::Colors(samples) | Self::Vectors(samples) => samples.len(),
        }
    }

    /// NRRD's names: the type, and the kind of the components if there are several.
    fn names(self) -> (&'static str, Option<&'static str>) {
        match self {
            Self::U8(_) => ("uint8", None),
            Self::F32(_) => ("float", None),
            Self::Colors(_) => ("float", Some("RGB-color")),
            Self::Vectors(_) => ("float", Some("3-vector")),
        }
    }

    /// Writes the samples, little-endian.
    fn write(self, to: &mut dyn Write) -> std::io::Result<()> {
        let floats = |samples: &[f32], to: &mut dyn Write| {
            // A piece at a time, so that the bytes do not take as much memory as the samples again.
            samples.chunks(1 << 16).try_for_each(|piece| {
                let bytes: Vec<u8> = piece.iter().flat_map(|sample| sample.to_le_bytes()).collect();
                to.write_all(&bytes)
            })
        };
        match self {
            Self::U8(samples) => to.write_all(samples),
            Self::F32(samples) => floats(samples, to),
            Self::Colors(samples) | Self::Vectors(samples) => floats(samples.as_flattened(), to),
        }
    }
}

/// A grid along the world's axes, for [`write_nrrd`].
#[derive(Debug, Clone, Copy)]
pub struct Lattice {
    /// Voxels along x, y and z.
    pub dimensions: [u32; 3],
    /// Distance between voxels' centres, in world units.
    pub spacing: f64,
    /// The centre of the first voxel.
    pub origin: [f64; 3],
}

/// Whether an NRRD file can be written to `path` now; worth asking before long work.
///
/// # Errors
/// [`Error::Write`] where the extension is not `.nrrd`, and where no file can be created there.
pub fn check_nrrd_writable(path: &Path) -> Result<(), Error> {
    let shown = path.display().to_string();
    let report = Report::new(&shown);
    check_extension(report, path)?;
    create_beside(report, path).map(drop)
}

fn check_extension(report: Report, path: &Path) -> Result<(), Error> {
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("nrrd")) {
        return Ok(());
    }
    Err(report.write("voxels are written as NRRD", "use the extension .nrrd", None))
}

/// Writes samples with their grid and `fields`, further `key:=value` pairs, beside `path` and renames them onto it.
///
/// # Errors
/// [`Error::Write`] where the extension is not `.nrrd`, there are not as many samples as the grid has voxels, a field has a line
/// break, or the file cannot be written.
pub fn write_nrrd(
    path: &Path,
    lattice: &Lattice,
    samples: Samples<'_>,
    fields: &[(&str, String)],
) -> Result<(), Error> {
    let shown = path.display().to_string();
    let report = Report::new(&shown);
    check_extension(report, path)?;
    let voxels = lattice.dimensions.iter().map(|&count| u64::from(count)).product::<u64>();
    if samples.count() as u64 != voxels {
        let problem = format!("{} samples for {voxels} voxels", samples.count());
        return Err(report.write(problem, "this is the caller's mistake: report it", None));
    }
    if fields.iter().any(|(key, value)| key.contains([':', '\n', '\r']) || value.contains(['\n', '\r'])) {
        return Err(report.write(
            "a field with a line break or colon",
            "this is the caller's mistake: report it",
            None,
        ));
    }
    let mut file = create_beside(report, path)?;
    let failed = |error: std::io::Error| {
        let problem = error.to_string();
        report.write(problem, "check the free space and the permissions", Some(error))
    };
    let mut buffered = BufWriter::new(file.as_file_mut());
    buffered.write_all(header(lattice, samples, fields).as_bytes()).map_err(failed)?;
    // Masks are mostly runs; the level above costs twice the time for some percent.
    let mut encoder = GzEncoder::new(&mut buffered, Compression::new(3));
    samples.write(&mut encoder).and_then(|()| encoder.finish().map(drop)).map_err(failed)?;
    buffered.flush().map_err(failed)?;
    drop(buffered);
    file.as_file().sync_all().map_err(failed)?;
    file.persist(path).map(drop).map_err(|error| failed(error.error))
}

fn header(lattice: &Lattice, samples: Samples<'_>, fields: &[(&str, String)]) -> String {
    let Lattice { dimensions: [x, y, z], spacing, origin: [left, front, low] } = *lattice;
    let (name, kind) = samples.names();
    let (dimension, components, none, first) = match kind {
        Some(kind) => (4, "3 ", "none ", format!("{kind} ")),
        None => (3, "", "", String::new()),
    };
    let mut text = format!(
        "NRRD0005\ntype: {name}\ndimension: {dimension}\nspace: 3D-right-handed\nsizes: {components}{x} {y} {z}\n\
         space directions: {none}({spacing},0,0) (0,{spacing},0) (0,0,{spacing})\n\
         kinds: {first}domain domain domain\nendian: little\nencoding: gzip\nspace origin: ({left},{front},{low})\n"
    );
    if matches!(samples, Samples::Vectors(_)) {
        text.push_str("measurement frame: (1,0,0) (0,1,0) (0,0,1)\n");
    }
    for (key, value) in fields {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{key}:={value}");
    }
    text.push('\n');
    text
}
