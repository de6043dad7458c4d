//! The attributes that matter, and how they are asked for.

use dicom_object::{InMemDicomObject, Tag};

pub(super) const FRAME_OFFSETS: Tag = Tag(0x3004, 0x000c);
pub(super) const INSTANCE: Tag = Tag(0x0008, 0x0018);
pub(super) const ACQUISITION_TIME: Tag = Tag(0x0008, 0x0032);
pub(super) const CONTENT_TIME: Tag = Tag(0x0008, 0x0033);
pub(super) const MODALITY: Tag = Tag(0x0008, 0x0060);
pub(super) const SERIES_DESCRIPTION: Tag = Tag(0x0008, 0x103e);
pub(super) const BODY_PART: Tag = Tag(0x0018, 0x0015);
pub(super) const KVP: Tag = Tag(0x0018, 0x0060);
pub(super) const PROTOCOL: Tag = Tag(0x0018, 0x1030);
pub(super) const SERIES_NUMBER: Tag = Tag(0x0020, 0x0011);
pub(super) const RESCALE_TYPE: Tag = Tag(0x0028, 0x1054);
pub(super) const SLICE_THICKNESS: Tag = Tag(0x0018, 0x0050);
pub(super) const SPACING_BETWEEN_SLICES: Tag = Tag(0x0018, 0x0088);
pub(super) const ECHO_TIME: Tag = Tag(0x0018, 0x0081);
pub(super) const TRIGGER_TIME: Tag = Tag(0x0018, 0x1060);
pub(super) const IMAGER_PIXEL_SPACING: Tag = Tag(0x0018, 0x1164);
pub(super) const ACQUISITION_NUMBER: Tag = Tag(0x0020, 0x0012);
pub(super) const INSTANCE_NUMBER: Tag = Tag(0x0020, 0x0013);
pub(super) const TEMPORAL_POSITION: Tag = Tag(0x0020, 0x0100);
pub(super) const FRAME_CONTENT: Tag = Tag(0x0020, 0x9111);
pub(super) const TEMPORAL_POSITION_INDEX: Tag = Tag(0x0020, 0x9128);
pub(super) const DETECTORS: Tag = Tag(0x0054, 0x0022);
pub(super) const SERIES: Tag = Tag(0x0020, 0x000e);
pub(super) const POSITION: Tag = Tag(0x0020, 0x0032);
pub(super) const ORIENTATION: Tag = Tag(0x0020, 0x0037);
pub(super) const PLANE_POSITIONS: Tag = Tag(0x0020, 0x9113);
pub(super) const PLANE_ORIENTATIONS: Tag = Tag(0x0020, 0x9116);
pub(super) const SAMPLES_PER_PIXEL: Tag = Tag(0x0028, 0x0002);
pub(super) const PHOTOMETRIC: Tag = Tag(0x0028, 0x0004);
pub(super) const FRAMES: Tag = Tag(0x0028, 0x0008);
pub(super) const ROWS: Tag = Tag(0x0028, 0x0010);
pub(super) const COLUMNS: Tag = Tag(0x0028, 0x0011);
pub(super) const PIXEL_SPACING: Tag = Tag(0x0028, 0x0030);
pub(super) const BITS_ALLOCATED: Tag = Tag(0x0028, 0x0100);
pub(super) const BITS_STORED: Tag = Tag(0x0028, 0x0101);
pub(super) const HIGH_BIT: Tag = Tag(0x0028, 0x0102);
pub(super) const SIGNED: Tag = Tag(0x0028, 0x0103);
pub(super) const PADDING: Tag = Tag(0x0028, 0x0120);
pub(super) const PADDING_LIMIT: Tag = Tag(0x0028, 0x0121);
pub(super) const INTERCEPT: Tag = Tag(0x0028, 0x1052);
pub(super) const SLOPE: Tag = Tag(0x0028, 0x1053);
pub(super) const PIXEL_MEASURES: Tag = Tag(0x0028, 0x9110);
pub(super) const TRANSFORMATIONS: Tag = Tag(0x0028, 0x9145);
pub(super) const SHARED_GROUPS: Tag = Tag(0x5200, 0x9229);
pub(super) const FRAME_GROUPS: Tag = Tag(0x5200, 0x9230);
pub(super) const FLOAT_PIXEL_DATA: Tag = Tag(0x7fe0, 0x0008);
pub(super) const DOUBLE_PIXEL_DATA: Tag = Tag(0x7fe0, 0x0009);
pub(super) const PIXEL_DATA: Tag = Tag(0x7fe0, 0x0010);

/// A text without the padding around it.
pub(super) fn text(object: &InMemDicomObject, tag: Tag) -> Option<String> {
    let text = object.get(tag)?.to_str().ok()?;
    let text = text.trim_matches(|character: char| character.is_whitespace() || character == '\0');
    (!text.is_empty()).then(|| text.to_owned())
}

/// A whole number, 0 or more.
pub(super) fn whole(object: &InMemDicomObject, tag: Tag) -> Option<u32> {
    object.get(tag)?.to_int::<u32>().ok()
}

/// The numbers of an attribute, if all of them are finite.
pub(super) fn numbers(object: &InMemDicomObject, tag: Tag) -> Option<Vec<f64>> {
    let numbers = object.get(tag)?.to_multi_float64().ok()?;
    (!numbers.is_empty() && numbers.iter().all(|number| number.is_finite())).then_some(numbers)
}

/// Exactly `COUNT` finite numbers.
pub(super) fn vector<const COUNT: usize>(object: &InMemDicomObject, tag: Tag) -> Option<[f64; COUNT]> {
    numbers(object, tag)?.try_into().ok()
}

/// The items of a sequence.
pub(super) fn items(object: &InMemDicomObject, tag: Tag) -> &[InMemDicomObject] {
    object.get(tag).and_then(|element| element.items()).unwrap_or_default()
}
