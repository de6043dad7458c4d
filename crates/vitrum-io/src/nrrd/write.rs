//! Writing NRRD: one attached file, gzip, of the world's space.

use std::fmt::Write as _;
use std::path::Path;

use flate2::Compression;
use flate2::write::GzEncoder;

use super::samples::Samples;
use crate::atomic_write::{create_beside, write_whole};
use crate::error::{Error, Report};
use crate::input::display_name;
use crate::orientation::Orientation;
use crate::volume::Volume;

/// A grid and its place in the world, for [`write_nrrd`].
#[derive(Debug, Clone, Copy)]
pub struct Lattice {
    /// Voxels along x, y and z.
    pub dimensions: [u32; 3],
    /// Vectors from a voxel's centre to the next voxel's along x, y and z, in world units.
    pub steps: [[f64; 3]; 3],
    /// The centre of the first voxel.
    pub origin: [f64; 3],
    /// Kind of the world, which becomes the file's `space`; the file has none where it is unknown.
    pub orientation: Orientation,
}

impl Lattice {
    /// Cubes along the axes of a world that is no patient's, `spacing` apart.
    #[must_use]
    pub fn of_cubes(dimensions: [u32; 3], spacing: f64, origin: [f64; 3]) -> Self {
        let steps = [[spacing, 0.0, 0.0], [0.0, spacing, 0.0], [0.0, 0.0, spacing]];
        Self { dimensions, steps, origin, orientation: Orientation::World }
    }

    /// A volume's grid.
    #[must_use]
    pub fn of(volume: &Volume) -> Self {
        // The shortest decimals that stand for the same float32.
        let widen = |number: f32| number.to_string().parse().unwrap_or(f64::from(number));
        let step = |axis: usize| volume.axes[axis].map(|component| widen(component * volume.spacing[axis]));
        Self {
            dimensions: volume.dimensions,
            steps: [0, 1, 2].map(step),
            origin: volume.origin.map(widen),
            orientation: volume.orientation,
        }
    }
}

/// Whether an NRRD file can be written to `path` now; worth asking before long work.
///
/// # Errors
/// [`Error::Write`] where the extension is not `.nrrd`, and where no file can be created there.
pub fn check_nrrd_writable(path: &Path) -> Result<(), Error> {
    let name = display_name(path);
    let report = Report::new(&name);
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
    let name = display_name(path);
    let report = Report::new(&name);
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
    write_whole(report, path, |sink| {
        sink.write_all(header(lattice, samples, fields).as_bytes())?;
        // Masks are mostly runs; the level above costs twice the time for some percent.
        let mut packed = GzEncoder::new(sink, Compression::new(3));
        samples.write(&mut packed)?;
        packed.finish().map(drop)
    })
}

fn header(lattice: &Lattice, samples: Samples<'_>, fields: &[(&str, String)]) -> String {
    let Lattice { dimensions: [x, y, z], steps, origin, orientation } = *lattice;
    let (name, kind) = samples.names();
    let (dimension, components, none, first) = match kind {
        Some(kind) => (4, "3 ", "none ", format!("{kind} ")),
        None => (3, "", "", String::new()),
    };
    let space = match orientation {
        Orientation::Patient => "space: right-anterior-superior",
        Orientation::World => "space: 3D-right-handed",
        // Directions take one or the other.
        Orientation::Unknown => "space dimension: 3",
    };
    let vector = |[x, y, z]: [f64; 3]| format!("({x},{y},{z})");
    let (steps, origin) = (steps.map(vector).join(" "), vector(origin));
    let mut text = format!(
        "NRRD0005\n# written by Vitrum\ntype: {name}\ndimension: {dimension}\n{space}\n\
         sizes: {components}{x} {y} {z}\nspace directions: {none}{steps}\nkinds: {first}domain domain domain\n\
         endian: little\nencoding: gzip\nspace origin: {origin}\n"
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
