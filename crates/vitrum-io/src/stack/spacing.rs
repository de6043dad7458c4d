//! Spacing of a TIFF file's pixels and slices.

use crate::error::clip;
use crate::options::OpenOptions;
use crate::placement::millimetres;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use tiff::decoder::ifd::Value;
use tiff::tags::Tag;

use super::decoder::Reader;
use super::ome::Ome;

/// The tags and the description that matter, as found.
#[derive(Debug, Default)]
pub(super) struct Notes {
    /// Pixels per unit along x and y.
    resolution: Option<[f64; 2]>,
    /// 2 for an inch, 3 for a centimetre.
    unit: u16,
    /// The lines that ImageJ writes, such as `spacing=8.8`.
    imagej: Vec<(String, String)>,
    /// What OME-XML says, which goes before all else.
    pub ome: Option<Ome>,
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
            Ok(Some(Value::Ascii(text))) => text,
            _ => String::new(),
        };
        let ome = Ome::read(&text);
        let text = if text.starts_with("ImageJ=") { text } else { String::new() };
        let lines = text.lines().filter_map(|line| line.split_once('='));
        let imagej = lines.map(|(name, value)| (name.to_owned(), value.trim().to_owned())).collect();
        Self { resolution, unit, imagej, ome }
    }

    fn imagej(&self, name: &str) -> Option<&str> {
        self.imagej.iter().find(|(other, _)| other == name).map(|(_, value)| value.as_str())
    }

    /// A count such as `channels`, 1 where it is not given.
    pub fn count(&self, name: &str) -> u64 {
        self.imagej(name).and_then(|value| value.parse().ok()).unwrap_or(1)
    }

    /// The straight line by which ImageJ turns samples into values: offset and factor. Signed samples are written so.
    pub fn calibration(&self) -> Option<[f64; 2]> {
        let number = |name: &str| self.imagej(name)?.parse::<f64>().ok().filter(|value| value.is_finite());
        let is_line = self.imagej("cf").is_none_or(|function| function == "0");
        let [offset, factor] = [number("c0")?, number("c1")?];
        (is_line && factor != 0.0 && [offset, factor] != [0.0, 1.0]).then_some([offset, factor])
    }

    /// The spacing in millimetres, or where no unit is named in the file's own.
    pub fn spacing(&self, options: &OpenOptions, assumptions: &mut Assumptions) -> [f32; 3] {
        if let Some(ome) = self.ome.as_ref().filter(|ome| ome.spacing.iter().any(Option::is_some)) {
            return of_ome(ome, options, assumptions);
        }
        let named = self.imagej("unit");
        let scale = match (named, self.unit) {
            (Some(unit), _) => unit_of_imagej(unit),
            (None, 3) => Some(10.0),
            (None, 2) => Some(25.4),
            _ => None,
        };
        if let (Some(unit), None) = (named, scale) {
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
        let mut tell = |fact: &str| {
            if options.spacing.is_none() {
                assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
            }
        };
        let [x, y] = in_slice.unwrap_or([1.0; 2]);
        let z = match (in_slice, between) {
            (_, Some(between)) => {
                if in_slice.is_none() {
                    tell("the file says no size of a pixel: 1 was taken");
                }
                between
            }
            // ImageJ leaves a distance of 1 out.
            (_, None) if named.is_some() => {
                tell("ImageJ says no distance between slices, as where it is 1 of its unit: that was taken");
                scale.unwrap_or(1.0)
            }
            (None, None) => {
                tell("the file says no spacing: 1 was taken along each axis");
                1.0
            }
            (Some([x, _]), None) => {
                tell("the file says no distance between slices: that of pixels was taken");
                x
            }
        };
        if in_slice.is_some() || between.is_some() {
            let from = if self.imagej.is_empty() { "the tags of the resolution" } else { "ImageJ's description" };
            assumptions.push(format!("the spacing was taken from {from}"));
        }
        [x, y, z].map(|value| value as f32)
    }
}

/// The spacing that OME-XML says; an axis without one takes that of another.
fn of_ome(ome: &Ome, options: &OpenOptions, assumptions: &mut Assumptions) -> [f32; 3] {
    if let Some(unit) = &ome.unknown_unit {
        assumptions.push(format!("the unit `{}` is not known: it was taken for a millimetre", clip(unit)));
    }
    if ome.unknown_unit.is_none() {
        assumptions.note_fact("unit", "mm", "OME-XML");
    }
    assumptions.push("the spacing was taken from OME-XML".to_owned());
    let other = ome.spacing.into_iter().flatten().next().unwrap_or(1.0);
    if ome.spacing.iter().any(Option::is_none) && options.spacing.is_none() {
        let fact = "OME-XML says no spacing of an axis: that of another was taken";
        assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
    }
    ome.spacing.map(|spacing| spacing.unwrap_or(other) as f32)
}

/// Millimetres in a unit as ImageJ names it.
fn unit_of_imagej(unit: &str) -> Option<f64> {
    match unit.to_lowercase().as_str() {
        "pixel" | "pixels" => Some(1.0),
        _ => millimetres(unit),
    }
}
