//! Placement of a NIfTI grid in the world, which is RAS+ as Vitrum's is.

use super::header::Header;
use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::placement::{Placement, unoriented};
use crate::source::Assumptions;
use crate::tolerance;
use crate::volume::IDENTITY;

/// The placement of the grid by the header's codes: the sform, an affine matrix; the qform, a rotation; or the spacings alone. Where
/// one of them is none, the next stands in, and that is told.
pub(super) fn placement(
    header: &Header,
    report: Report,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<Placement, Error> {
    let scale = unit_scale(header, assumptions);
    let pixdim = [header.pixdim[1], header.pixdim[2], header.pixdim[3]].map(|spacing| spacing * scale);
    if header.sform_code > 0 {
        let world = |column: usize| header.srow.map(|row| row[column] * scale);
        let columns = [world(0), world(1), world(2)];
        // A direction that is missing is found elsewhere before it is made up.
        let origin = tolerance::origin(Some(world(3)), assumptions);
        match Placement::from_columns(columns, origin, Orientation::Patient) {
            Ok(placement) => {
                assumptions.extend(placement.shear_note());
                assumptions.note_origin("spacing", "the sform");
                assumptions.note_origin("orientation", "the sform");
                let spacing = pixdim.map(|spacing| spacing as f32);
                let differs = |(a, b): (&f32, &f32)| (a - b).abs() > 0.01 * a;
                if placement.spacing.iter().zip(&spacing).any(differs) {
                    assumptions.push(format!(
                        "the spacings {:?} of the sform were taken, not {spacing:?} of pixdim",
                        placement.spacing
                    ));
                }
                return Ok(placement);
            }
            Err(problem) => {
                let next = if header.qform_code > 0 { "the qform" } else { "the spacings of pixdim" };
                assumptions.push(format!("the sform is none, as {problem}: {next} stood in for it"));
            }
        }
    }
    assumptions.note_origin("spacing", "pixdim");
    // A negative distance is no direction here: those are the qform's.
    let steps = tolerance::steps(pixdim.map(f64::abs), 1.0, options, assumptions);
    if pixdim.iter().any(|step| *step < 0.0) {
        assumptions.push(format!("pixdim has spacings below 0, {pixdim:?}: their amounts were taken"));
    }
    let rotation = if header.qform_code > 0 { rotation(header.quaternion) } else { None };
    if header.qform_code > 0 && rotation.is_none() {
        let quaternion = header.quaternion;
        assumptions.push(format!("the quaternion {quaternion:?} of the qform is no rotation: it was left out"));
    }
    let Some(rotation) = rotation else {
        if header.qform_code <= 0 && header.sform_code <= 0 {
            assumptions.push("the file has neither sform nor qform".to_owned());
        }
        assumptions.push(unoriented());
        let spacing = steps.map(|step| step as f32);
        return Ok(Placement { spacing, axes: IDENTITY, origin: None, orientation: Orientation::Unknown });
    };
    assumptions.note_origin("orientation", "the qform");
    // pixdim[0] says whether z is mirrored: a quaternion cannot.
    let handedness = if header.pixdim[0] < 0.0 { -1.0 } else { 1.0 };
    let steps = [steps[0], steps[1], steps[2] * handedness];
    let column = |axis: usize| rotation.map(|row| row[axis] * steps[axis]);
    let origin = Some(header.qoffset.map(|value| value * scale));
    Placement::mended([column(0), column(1), column(2)], origin, Orientation::Patient, options, assumptions)
        .map_err(|problem| report.invalid(Place::File, problem, "correct the sform or the qform in the header"))
}

/// The rotation matrix, in rows, of the unit quaternion whose last three parts these are.
fn rotation(quaternion: [f64; 3]) -> Option<[[f64; 3]; 3]> {
    let [b, c, d] = quaternion;
    let rest = 1.0 - (b * b + c * c + d * d);
    // Rounding alone may put the length of a half turn slightly above 1.
    if !(rest.is_finite() && rest > -1e-4) {
        return None;
    }
    let a = rest.max(0.0).sqrt();
    let norm = (a * a + b * b + c * c + d * d).sqrt();
    let [a, b, c, d] = [a, b, c, d].map(|part| part / norm);
    Some([
        [a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)],
        [2.0 * (b * c + a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d - a * b)],
        [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a + d * d - b * b - c * c],
    ])
}

/// Millimetres per unit of the file.
fn unit_scale(header: &Header, assumptions: &mut Assumptions) -> f64 {
    // The low 3 bits are of space, the next 3 of time.
    let (scale, note) = match header.units & 7 {
        0 => (1.0, "the file names no unit of length: mm were taken".to_owned()),
        1 => (1e3, "lengths in m were turned into mm".to_owned()),
        2 => {
            assumptions.note_fact("unit", "mm", "xyzt_units");
            return 1.0;
        }
        3 => (1e-3, "lengths in µm were turned into mm".to_owned()),
        other => (1.0, format!("xyzt_units has {other} for space, which is no known unit: mm were taken")),
    };
    if (scale - 1.0_f64).abs() > 0.0 {
        assumptions.note_fact("unit", "mm", "xyzt_units");
    }
    assumptions.push(note);
    scale
}
