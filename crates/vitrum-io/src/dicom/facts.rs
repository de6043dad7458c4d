//! What a radiologist asks of a series first: which one it is, how it was taken, and what its values are.

use dicom_object::InMemDicomObject;

use super::attributes::{self, numbers, text};
use super::image::Slice;
use crate::error::clip;
use crate::options::OpenOptions;
use crate::source::{Assumptions, Fact};

/// The facts of a file; `places` are the objects that may say a slice's measures.
pub(super) fn of(object: &InMemDicomObject, places: &[&InMemDicomObject]) -> Vec<Fact> {
    let said = |tag| text(object, tag).map(|text| clip(&text));
    let number = |tag| places.iter().find_map(|place| numbers(place, tag)).map(|numbers| numbers[0]);
    let modality = said(attributes::MODALITY);
    let mut facts = Vec::new();
    let mut add = |name, value: Option<String>, from: &str| {
        if let Some(value) = value {
            facts.push(Fact { name, value, from: from.to_owned() });
        }
    };
    let series: Vec<_> =
        [attributes::SERIES_NUMBER, attributes::SERIES_DESCRIPTION].into_iter().filter_map(said).collect();
    add("series", (!series.is_empty()).then(|| series.join(": ")), "Series Number, Series Description");
    add("modality", modality.clone(), "Modality");
    add("body part", said(attributes::BODY_PART), "Body Part Examined");
    add("protocol", said(attributes::PROTOCOL), "Protocol Name");
    add("kVp", number(attributes::KVP).map(|value| value.to_string()), "KVP");
    let thickness = number(attributes::SLICE_THICKNESS).filter(|value| *value > 0.0);
    add("thickness", thickness.map(|value| format!("{value} mm a slice")), "Slice Thickness");
    let unit = said(attributes::RESCALE_TYPE);
    // CT without the type of its rescaled values is in Hounsfield units: PS3.3, C.11.1.1.2.
    let rescaled = numbers(object, attributes::INTERCEPT).is_some();
    match (unit.as_deref(), modality.as_deref()) {
        (Some("HU"), _) => add("values", Some("Hounsfield units (HU)".to_owned()), "Rescale Type"),
        (None | Some("US"), Some("CT")) if rescaled => {
            add("values", Some("Hounsfield units (HU)".to_owned()), "Modality CT with Rescale Intercept");
        }
        (Some(other), _) if other != "US" => add("values", Some(other.to_owned()), "Rescale Type"),
        (_, Some("MR")) => add("values", Some("signal, in no unit; not Hounsfield units".to_owned()), "Modality MR"),
        _ => {}
    }
    facts
}

/// Tells the facts of the first slice's file, and where spacing and orientation come from.
pub(super) fn tell(slices: &[Slice], options: &OpenOptions, assumptions: &mut Assumptions) {
    let Some(first) = slices.first() else { return };
    for Fact { name, value, from } in &first.file.facts {
        assumptions.note_fact(name, value.clone(), from.clone());
    }
    let placed = slices.iter().all(|slice| slice.position.is_some() && slice.orientation.is_some());
    if placed {
        assumptions.note_origin("orientation", "Image Orientation (Patient)");
    }
    if options.spacing.is_none() && first.file.spacing.is_some() {
        let between = match (placed && slices.len() > 1, first.file.step) {
            (true, _) => ", Image Position (Patient)",
            (false, Some(_)) => ", Spacing Between Slices or Slice Thickness",
            (false, None) => "",
        };
        assumptions.note_origin("spacing", format!("Pixel Spacing{between}"));
    }
    if first.file.spacing.is_some() {
        assumptions.note_fact("unit", "mm", "the format");
    }
}
