//! Placement of a NIfTI grid in the world, which is RAS+ as Vitrum's is.

use super::header::Header;
use crate::error::{Error, Place, Report};
use crate::orientation::Orientation;
use crate::placement::{Placement, unoriented};
use crate::source::Assumptions;
use crate::volume::{IDENTITY, check_spacing};

/// The placement of the grid by the header's codes: the sform, an affine matrix; the qform, a rotation; or the spacings alone.
pub(super) fn placement(header: &Header, report: Report, assumptions: &mut Assumptions) -> Result<Placement, Error> {
    let scale = unit_scale(header, report, assumptions)?;
    let pixdim = [header.pixdim[1], header.pixdim[2], header.pixdim[3]];
    let spacing = pixdim.map(|spacing| (spacing * scale) as f32);
    let placed = |columns: [[f64; 3]; 3], origin: [f64; 3]| {
        Placement::from_columns(columns, Some(origin), Orientation::Patient)
            .map_err(|problem| report.invalid(Place::File, problem, "correct the sform or the qform in the header"))
    };
    if header.sform_code > 0 {
        let world = |column: usize| header.srow.map(|row| row[column] * scale);
        let placement = placed([world(0), world(1), world(2)], world(3))?;
        assumptions.extend(placement.shear_note());
        let differs = |(a, b): (&f32, &f32)| (a - b).abs() > 0.01 * a;
        if placement.spacing.iter().zip(&spacing).any(differs) {
            assumptions.push(format!(
                "the spacings {:?} of the sform were taken, not {spacing:?} of pixdim",
                placement.spacing
            ));
        }
        return Ok(placement);
    }
    check_spacing(report, spacing)?;
    if header.qform_code > 0 {
        let rotation = rotation(header.quaternion).ok_or_else(|| {
            report.invalid(
                Place::Byte(header.layout.quaternion as u64),
                format!("the quaternion {:?} is no rotation", header.quaternion),
                "correct the qform in the header",
            )
        })?;
        // pixdim[0] says whether z is mirrored: a quaternion cannot.
        let handedness = if header.pixdim[0] < 0.0 { -1.0 } else { 1.0 };
        let steps = spacing.map(f64::from);
        let steps = [steps[0], steps[1], steps[2] * handedness];
        let column = |axis: usize| rotation.map(|row| row[axis] * steps[axis]);
        let origin = header.qoffset.map(|value| value * scale);
        return placed([column(0), column(1), column(2)], origin);
    }
    assumptions.push("the file has neither sform nor qform".to_owned());
    assumptions.push(unoriented());
    Ok(Placement { spacing, axes: IDENTITY, origin: None, orientation: Orientation::Unknown })
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
fn unit_scale(header: &Header, report: Report, assumptions: &mut Assumptions) -> Result<f64, Error> {
    // The low 3 bits are of space, the next 3 of time.
    let (scale, note) = match header.units & 7 {
        0 => (1.0, "the file names no unit of length: its own was kept"),
        1 => (1e3, "lengths in m were turned into mm"),
        2 => return Ok(1.0),
        3 => (1e-3, "lengths in µm were turned into mm"),
        other => {
            return Err(report.invalid(
                Place::Byte(header.layout.units as u64),
                format!("xyzt_units has {other} for space, not 0 to 3"),
                "correct the header",
            ));
        }
    };
    assumptions.push(note.to_owned());
    Ok(scale)
}
