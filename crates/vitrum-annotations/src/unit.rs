//! The unit of length of a volume's world, and lengths in it.

use crate::canvas::number;
use vitrum::io::Volume;

/// Units of length, each with its length in millimetres.
const UNITS: [(&str, f64); 5] = [("nm", 1e-6), ("µm", 1e-3), ("mm", 1.0), ("m", 1e3), ("km", 1e6)];

/// Formats whose lengths are in millimetres unless their reader says that the file names no unit.
const IN_MILLIMETRES: [&str; 5] = ["DICOM", "NIfTI", "NRRD", "MetaImage", "TIFF"];

/// The unit of a volume's world: mm where its file says lengths.
pub fn of(volume: &Volume) -> Option<&'static str> {
    let named = IN_MILLIMETRES.iter().any(|format| volume.source.format.starts_with(format));
    let kept = volume.source.assumptions.iter().any(|told| {
        let fact = &told.fact;
        fact.contains("unit of length") && fact.ends_with("kept")
            || fact.contains("no spacing")
            || fact.contains("spacing 1 was")
    });
    (named && !kept).then_some("mm")
}

/// A length in words, in the unit of its own size: `0.05` of `mm` is `50 µm`.
pub fn told(length: f64, unit: Option<&str>) -> String {
    let Some(unit) = unit else { return number(length, 4) };
    let plain = if unit == "um" { "µm" } else { unit };
    let Some((_, millimetres)) = UNITS.iter().find(|(name, _)| *name == plain) else {
        return format!("{} {plain}", number(length, 4));
    };
    if (0.1..1000.0).contains(&length) {
        return format!("{} {plain}", number(length, 4));
    }
    let millimetres = length * millimetres;
    let fits = |(_, size): &&(&str, f64)| millimetres >= *size * 0.999_999;
    let (name, size) = UNITS.iter().rev().find(fits).unwrap_or(&UNITS[0]);
    format!("{} {name}", number(millimetres / size, 4))
}

#[cfg(test)]
mod tests {
    use super::told;

    #[test]
    fn lengths_are_told_in_the_unit_of_their_size() {
        let mm = |length| told(length, Some("mm"));
        assert_eq!([mm(50.0), mm(0.5), mm(0.05), mm(2e-6), mm(2000.0)], ["50 mm", "0.5 mm", "50 µm", "2 nm", "2 m"]);
        assert_eq!([told(0.05, Some("um")), told(20.0, Some("px"))], ["50 nm", "20 px"]);
        assert_eq!([told(0.001, None), told(1e9, Some("px"))], ["0.001", "1e9 px"]);
    }
}
