//! Spacing of a TIFF file's pixels and slices.

use crate::source::Assumptions;
use tiff::decoder::ifd::Value;
use tiff::tags::Tag;

use super::decoder::Reader;

/// The tags and the description that matter, as found.
#[derive(Debug, Default)]
pub(super) struct Notes {
    /// Pixels per unit along x and y.
    resolution: Option<[f64; 2]>,
    /// 2 for an inch, 3 for a centimetre.
    unit: u16,
    /// The lines that ImageJ writes, such as `spacing=8.8`.
    imagej: Vec<(String, String)>,
}

impl Notes {
    /// The notes of a page. A broken tag counts as absent: it is no part of the picture.
    pub fn read(decoder: &mut Reader) -> Self {
        let mut resolution = |tag| match decoder.find_tag(tag) {
            Ok(Some(Value::Rational(pixels, units))) => {
                Some(f64::from(pixels) / f64::from(units)).filter(|value| value.is_finite() && *value > 0.0)
            }
            _ => None,
        };
        let resolution = resolution(Tag::XResolution).zip(resolution(Tag::YResolution)).map(|(x, y)| [x, y]);
        // Without that tag, a resolution is in inches.
        let unit = decoder.find_tag_unsigned(Tag::ResolutionUnit).ok().flatten();
        let unit = unit.unwrap_or(if resolution.is_some() { 2 } else { 1 });
        let text = match decoder.find_tag(Tag::ImageDescription) {
            Ok(Some(Value::Ascii(text))) if text.starts_with("ImageJ=") => text,
            _ => String::new(),
        };
        let lines = text.lines().filter_map(|line| line.split_once('='));
        let imagej = lines.map(|(name, value)| (name.to_owned(), value.trim().to_owned())).collect();
        Self { resolution, unit, imagej }
    }

    fn imagej(&self, name: &str) -> Option<&str> {
        self.imagej.iter().find(|(other, _)| other == name).map(|(_, value)| value.as_str())
    }

    /// A count such as `channels`, 1 where it is not given.
    pub fn count(&self, name: &str) -> u64 {
        self.imagej(name).and_then(|value| value.parse().ok()).unwrap_or(1)
    }

    /// The spacing in millimetres, or where no unit is named in the file's own.
    pub fn spacing(&self, assumptions: &mut Assumptions) -> [f32; 3] {
        let scale = match (self.imagej("unit"), self.unit) {
            (Some(unit), _) => millimetres(unit),
            (None, 3) => Some(10.0),
            (None, 2) => Some(25.4),
            _ => None,
        };
        if let (Some(unit), None) = (self.imagej("unit"), scale) {
            assumptions.push(format!("the unit `{}` is not known: it was taken for a millimetre", unit.escape_debug()));
        }
        let along = |resolution: f64| scale.unwrap_or(1.0) / resolution;
        // Other programs write inches or no unit for printers, and mean no more than the pixels' shape.
        let measures = !self.imagej.is_empty() || self.unit == 3;
        let in_slice = match self.resolution {
            Some([x, y]) if measures => Some([along(x), along(y)]),
            Some([x, y]) if x != y => Some([1.0, x / y]),
            _ => None,
        };
        let between = self.imagej("spacing").and_then(|value| value.parse().ok()).map(f64::abs);
        let between =
            between.filter(|value| value.is_finite() && *value > 0.0).map(|value| value * scale.unwrap_or(1.0));
        match (in_slice, between) {
            (None, None) => assumptions.push("the file says no spacing: 1 was taken along each axis".to_owned()),
            (Some(_), None) => {
                assumptions.push("the file says no distance between slices: 1 was taken".to_owned());
            }
            (None, Some(_)) => assumptions.push("the file says no size of a pixel: 1 was taken".to_owned()),
            _ => {}
        }
        let [x, y] = in_slice.unwrap_or([1.0; 2]);
        [x, y, between.unwrap_or(1.0)].map(|value| value as f32)
    }
}

/// Millimetres in a unit as ImageJ names it.
fn millimetres(unit: &str) -> Option<f64> {
    match unit.to_lowercase().as_str() {
        "nm" | "nanometer" => Some(1e-6),
        // ImageJ escapes what is not ASCII.
        "um" | "µm" | "μm" | "micron" | "microns" | "micrometer" | "\\u00b5m" => Some(1e-3),
        "mm" | "millimeter" => Some(1.0),
        "cm" | "centimeter" => Some(10.0),
        "m" | "meter" => Some(1000.0),
        "inch" | "in" | "inches" => Some(25.4),
        "pixel" | "pixels" => Some(1.0),
        _ => None,
    }
}
