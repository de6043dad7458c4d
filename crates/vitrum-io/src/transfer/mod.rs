//! Transfer functions in the files of other programs: 3D Slicer's volume properties (`.vp`, `.json`, MRML), ParaView's colour maps (JSON, XML,
//! state files), VTK's colour and opacity functions (XML, and plain lists of numbers).

mod color_space;
mod curve;
mod lists;
mod paraview;
mod property;
mod slicer;
mod write;
mod xml;

pub use color_space::{ColorSpace, color_at};
pub use curve::simplify;
pub use write::paraview_json;

use std::fs;
use std::path::Path;

use self::curve::{Colors, Opacities};
use crate::error::{Error, Place, Report};
use crate::input::display_name;
use crate::source::Assumptions;
use crate::tolerance::{self, BYTE_ORDER_MARK};

/// Largest file, in bytes: real ones have a few thousand, and ParaView's collections of all its maps a million.
const MOST_BYTES: u64 = 8 << 20;

/// Most points of a function in a file.
const MOST_POINTS: usize = 1 << 14;

/// The functions of a file, piecewise linear over the scalar.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TransferFile {
    /// The kind of the file, such as `ParaView JSON`.
    pub format: &'static str,
    /// The name of the functions in the file; empty where they have none.
    pub name: String,
    /// Scalars in ascending order and linear RGB; two at one scalar make a step. Empty where the file has no colours.
    pub color: Vec<(f32, [f32; 3])>,
    /// Scalars in ascending order and opacities of a layer as thick as `unit_distance`. Empty where the file has none.
    pub opacity: Vec<(f32, f32)>,
    /// Magnitudes of the gradient in ascending order and factors of opacity. Empty where they change nothing.
    pub gradient: Vec<(f32, f32)>,
    /// The thickness of the layer that opacities are stated for, in world units, where the file states it.
    pub unit_distance: Option<f32>,
    /// Statements about gaps in the file, and about what was left out.
    pub assumptions: Assumptions,
}

impl TransferFile {
    /// The first and the last scalar of all points.
    #[must_use]
    pub fn range(&self) -> [f32; 2] {
        let scalars = self.color.iter().map(|point| point.0).chain(self.opacity.iter().map(|point| point.0));
        scalars.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    }
}

/// What a parser found, before it is sampled.
#[derive(Debug, Default)]
struct Found {
    format: &'static str,
    name: String,
    colors: Colors,
    opacities: Opacities,
    gradients: Opacities,
    unit_distance: Option<f64>,
    assumptions: Assumptions,
}

/// Reads a file of transfer functions. Behind `#` in the path may stand the name of one of several in the file, such as
/// `presets.xml#CT-Bone`.
///
/// # Errors
///
/// [`Error::Unreadable`], [`Error::TooLarge`] beyond 8 MiB, [`Error::Invalid`] and [`Error::Unsupported`] where there are no functions in it.
pub fn read_transfer(path: &Path) -> Result<TransferFile, Error> {
    let text = path.to_string_lossy();
    let (file, name) = match text.rsplit_once('#') {
        Some((file, name)) if !path.exists() => (Path::new(file), Some(name)),
        _ => (path, None),
    };
    let shown = display_name(file);
    let report = Report::new(&shown);
    let metadata = fs::metadata(file).map_err(|error| report.unreadable(error))?;
    if !metadata.is_file() {
        return Err(report.unsupported(Place::File, "this is no file", "name a file of transfer functions"));
    }
    check_size(report, metadata.len())?;
    let bytes = fs::read(file).map_err(|error| report.unreadable(error))?;
    read_transfer_bytes(&shown, &bytes, name)
}

/// As [`read_transfer`], for the bytes of a file of the name `file`; `name` is that of one of several functions in it.
///
/// # Errors
///
/// Those of [`read_transfer`].
pub fn read_transfer_bytes(file: &str, bytes: &[u8], name: Option<&str>) -> Result<TransferFile, Error> {
    let report = Report::new(file);
    check_size(report, bytes.len() as u64)?;
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    let text = tolerance::name(bytes);
    let found = match text.trim_start().chars().next() {
        Some('{' | '[') => {
            let value = serde_json::from_str(&text).map_err(|error| {
                report.invalid(
                    Place::Line(error.line()),
                    format!("this is not well-formed JSON: {error}"),
                    "write the file anew",
                )
            })?;
            property::read(report, &value, name)?
        }
        Some('<') => xml::read(report, &text, name)?,
        Some(_) if file.to_ascii_lowercase().ends_with(".vp") => slicer::read(report, &text)?,
        Some(_) => lists::read(report, &text)?,
        None => return Err(report.invalid(Place::File, "there is nothing in it", "write the file anew")),
    };
    finish(report, found)
}

/// The functions as they are used: finite, ascending, sampled where they are not linear.
fn finish(report: Report, found: Found) -> Result<TransferFile, Error> {
    let Found { format, name, colors, opacities, gradients, unit_distance, mut assumptions } = found;
    if colors.points.is_empty() && opacities.points.is_empty() {
        return Err(report.invalid(
            Place::File,
            "there are neither colours nor opacities in it",
            "give a volume property of 3D Slicer (.vp, .json, MRML), a colour map of ParaView (.json, .xml), or lists of numbers",
        ));
    }
    let opacity = opacities.sampled(report, &mut assumptions)?;
    let color = colors.sampled(report, &mut assumptions)?;
    let mut gradient = gradients.sampled(report, &mut assumptions)?;
    if gradient.iter().all(|point| point.1 == 1.0) {
        gradient.clear();
    }
    let usable = |distance: &f64| distance.is_finite() && *distance > 0.0 && (*distance as f32).is_normal();
    let stated = unit_distance.is_some();
    let unit_distance = unit_distance.filter(usable).map(|distance| distance as f32);
    if stated && unit_distance.is_none() {
        assumptions.push("the distance that opacities are stated for is no distance: it was left out".to_owned());
    }
    Ok(TransferFile { format, name, color, opacity, gradient, unit_distance, assumptions })
}

fn check_size(report: Report, bytes: u64) -> Result<(), Error> {
    if bytes > MOST_BYTES {
        return Err(report.too_large(bytes, MOST_BYTES, "transfer functions are smaller: name the right file"));
    }
    Ok(())
}

/// Fails where a function has more points than any file needs.
fn check_points(report: Report, place: Place, count: usize) -> Result<(), Error> {
    if count > MOST_POINTS {
        let problem = format!("a function of {count} points, and {MOST_POINTS} are the most");
        return Err(report.unsupported(place, problem, "write it with fewer points"));
    }
    Ok(())
}

/// Picks one of several: that of the name `wanted`, else the first, which is told. `names` are those of all.
fn pick(report: Report, names: &[String], wanted: Option<&str>, assumptions: &mut Assumptions) -> Result<usize, Error> {
    let shown = |names: &[String]| names.iter().take(40).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    match wanted {
        Some(wanted) => names.iter().position(|name| name == wanted).ok_or_else(|| {
            let near = crate::suggest::nearest(wanted, names.iter().map(String::as_str));
            let advice = match near {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("it has {}", shown(names)),
            };
            report.unsupported(Place::File, format!("there is no transfer function `{wanted}` in it"), advice)
        }),
        None => {
            if names.len() > 1 {
                assumptions.push(format!(
                    "the file has {} transfer functions, {}: the first was taken; FILE#NAME takes another",
                    names.len(),
                    shown(names)
                ));
            }
            Ok(0)
        }
    }
}
