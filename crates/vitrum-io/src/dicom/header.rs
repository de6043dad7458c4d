//! Header of an image file: size, sample type, and places of its frames.

use std::path::Path;

use dicom_object::InMemDicomObject;

use super::attributes::{self, items, numbers, text, vector, whole};
use super::envelope::Envelope;
use super::facts;
use super::image::{File, Frame, Pixels, TIMES, normal};
use super::padding;
use super::syntax::BIG_ENDIAN;
use crate::error::{Error, Place, Report, clip};
use crate::samples::SampleType;
use crate::storage::Storage;

/// Kind of a DICOM file.
pub(super) enum Header {
    Image(Box<File>),
    /// An image that is not read, such as one in colours.
    Refused {
        series: String,
        error: Error,
    },
    /// A file without an image.
    Other,
}

impl File {
    /// Reads the header of the file whose bytes lie in `storage`; `path` is its path, or the name that its bytes were given under.
    pub fn read(storage: &Storage, path: &Path, name: &str, length: u64) -> Result<Header, Error> {
        let report = Report::new(name);
        let envelope = Envelope::open(storage, length, report)?;
        let object = envelope.object(report, false)?;
        let series = text(&object, attributes::SERIES).unwrap_or_default();
        let place = Origin { path, name, length };
        match Self::of(&object, &place, &envelope) {
            Ok(Some(file)) => Ok(Header::Image(Box::new(file))),
            Ok(None) => Ok(Header::Other),
            Err(error @ Error::Unsupported { .. }) => Ok(Header::Refused { series, error }),
            Err(error) => Err(error),
        }
    }

    /// The header of an image; `None` for an object without an image.
    fn of(object: &InMemDicomObject, origin: &Origin, envelope: &Envelope) -> Result<Option<Self>, Error> {
        let Origin { path, name, length } = *origin;
        let report = Report::new(name);
        let (Some(rows), Some(columns)) = (whole(object, attributes::ROWS), whole(object, attributes::COLUMNS)) else {
            return Ok(None);
        };
        if rows == 0 || columns == 0 {
            return Err(report.invalid(Place::File, "the image has no rows or no columns", "get the whole file"));
        }
        let Some((tag, kind)) = envelope.found.pixels else {
            return Err(report.invalid(Place::File, "there are no pixels behind the header", "get the whole file"));
        };
        let (inverted, palette) = check_gray(object, report)?;
        let pixels = match tag {
            attributes::FLOAT_PIXEL_DATA => Pixels { sample: SampleType::F32, stored: 32, low_bit: 0 },
            attributes::DOUBLE_PIXEL_DATA => Pixels { sample: SampleType::F64, stored: 64, low_bit: 0 },
            _ => pixels(object, report)?,
        };
        let frames = frames(object, report, length)?;
        let shared = items(object, attributes::SHARED_GROUPS).first();
        let groups = [shared, items(object, attributes::FRAME_GROUPS).first()];
        let measures = groups.into_iter().flatten().find_map(|group| items(group, attributes::PIXEL_MEASURES).first());
        let places = || [Some(object), measures].into_iter().flatten();
        let positive = |value: &f64| *value > 0.0;
        let spacing = [attributes::PIXEL_SPACING, attributes::IMAGER_PIXEL_SPACING]
            .into_iter()
            .find_map(|tag| places().find_map(|place| vector::<2>(place, tag)).filter(|two| two.iter().all(positive)));
        let between = places().find_map(|place| numbers(place, attributes::SPACING_BETWEEN_SLICES));
        let thickness = places().find_map(|place| numbers(place, attributes::SLICE_THICKNESS));
        let step = [between, thickness].into_iter().flatten().map(|numbers| numbers[0].abs()).find(positive);
        let said = [attributes::MODALITY, attributes::SERIES_DESCRIPTION].map(|tag| text(object, tag));
        Ok(Some(Self {
            path: path.to_owned(),
            length,
            series: text(object, attributes::SERIES).unwrap_or_default(),
            description: clip(&said.into_iter().flatten().collect::<Vec<_>>().join(", ")),
            instance: text(object, attributes::INSTANCE).unwrap_or_default(),
            syntax: envelope.stated.clone(),
            swapped: envelope.syntax == BIG_ENDIAN && kind == *b"OW" && pixels.sample.size() == 4,
            data: tag,
            palette,
            columns,
            rows,
            pixels,
            padding: padding::of(object, pixels),
            inverted,
            spacing,
            step,
            frames,
            facts: facts::of(object, &places().collect::<Vec<_>>()),
            name: name.to_owned(),
        }))
    }
}

/// Where a file comes from.
struct Origin<'a> {
    path: &'a Path,
    name: &'a str,
    length: u64,
}

pub(super) fn damaged(report: Report, error: &dyn std::error::Error) -> Error {
    let mut problem = error.to_string();
    let mut source = error.source();
    while let Some(error) = source {
        problem = format!("{problem}: {error}");
        source = error.source();
    }
    report.invalid(
        Place::File,
        format!("this DICOM file is damaged: {}", problem.chars().take(300).collect::<String>()),
        "get the whole file, or write it anew",
    )
}

/// Whether white is the smallest value, and whether values stand for colours; an error where the image itself is in colours.
fn check_gray(object: &InMemDicomObject, report: Report) -> Result<(bool, bool), Error> {
    let samples = whole(object, attributes::SAMPLES_PER_PIXEL).unwrap_or(1);
    let kind = text(object, attributes::PHOTOMETRIC).unwrap_or_else(|| "MONOCHROME2".to_owned());
    match kind.as_str() {
        "MONOCHROME1" | "MONOCHROME2" | "PALETTE COLOR" if samples == 1 => {
            Ok((kind == "MONOCHROME1", kind == "PALETTE COLOR"))
        }
        kind => Err(report.unsupported(
            Place::File,
            format!("the image is in colours ({}, {samples} sample(s) a pixel), not in gray", clip(kind)),
            "leave such files out, or convert them to gray",
        )),
    }
}

fn pixels(object: &InMemDicomObject, report: Report) -> Result<Pixels, Error> {
    let allocated = whole(object, attributes::BITS_ALLOCATED).unwrap_or(16);
    let stored = whole(object, attributes::BITS_STORED).unwrap_or(allocated);
    let high_bit = whole(object, attributes::HIGH_BIT).unwrap_or(stored.saturating_sub(1));
    let signed = whole(object, attributes::SIGNED).unwrap_or(0) == 1;
    let sample = match (allocated, signed) {
        (8, false) => SampleType::U8,
        (8, true) => SampleType::I8,
        (16, false) => SampleType::U16,
        (16, true) => SampleType::I16,
        (32, false) => SampleType::U32,
        (32, true) => SampleType::I32,
        _ => {
            return Err(report.unsupported(
                Place::File,
                format!("the pixels have {allocated} bits, and those of 8, 16 and 32 are read"),
                "convert them to 16 bits",
            ));
        }
    };
    match (high_bit + 1).checked_sub(stored) {
        Some(low_bit) if stored > 0 && high_bit < allocated => Ok(Pixels { sample, stored, low_bit }),
        _ => Err(report.invalid(
            Place::File,
            format!("{stored} bits up to bit {high_bit} do not fit into {allocated} bits"),
            "correct Bits Stored and High Bit",
        )),
    }
}

fn frames(object: &InMemDicomObject, report: Report, length: u64) -> Result<Vec<Frame>, Error> {
    let count = whole(object, attributes::FRAMES).unwrap_or(1).max(1);
    // A frame takes a byte at the least, whatever it is compressed by.
    if u64::from(count) > length {
        return Err(report.invalid(
            Place::File,
            format!("{count} frames do not fit into {length} bytes"),
            "get the whole file",
        ));
    }
    let shared = items(object, attributes::SHARED_GROUPS).first();
    let groups = items(object, attributes::FRAME_GROUPS);
    let offsets = numbers(object, attributes::FRAME_OFFSETS).filter(|offsets| offsets.len() == count as usize);
    let detector = items(object, attributes::DETECTORS).first();
    // Nuclear medicine says where the first frame lies, and how far and to which side the others.
    let step = detector.and_then(|_| numbers(object, attributes::SPACING_BETWEEN_SLICES)).map(|numbers| numbers[0]);
    let frames = (0..count as usize).map(|index| {
        let places = [groups.get(index), shared, Some(object), detector];
        let places = || places.into_iter().flatten();
        // In a group, an attribute lies in a sequence of one item; at the top, by itself.
        let within = |sequence, tag| {
            places().find_map(|place| {
                items(place, sequence).first().and_then(|item| numbers(item, tag)).or_else(|| numbers(place, tag))
            })
        };
        let orientation =
            within(attributes::PLANE_ORIENTATIONS, attributes::ORIENTATION).and_then(|six| six.try_into().ok());
        let position: Option<[f64; 3]> =
            within(attributes::PLANE_POSITIONS, attributes::POSITION).and_then(|three| three.try_into().ok());
        let offset = offsets.as_ref().map(|offsets| offsets[index] - offsets[0]);
        let position = match (position, offset, orientation) {
            (Some(position), Some(offset), Some(orientation)) => {
                let normal = normal(orientation);
                Some([0, 1, 2].map(|axis| position[axis] + offset * normal[axis]))
            }
            (Some(position), None, Some(orientation)) if step.is_some() && groups.is_empty() => {
                let normal = normal(orientation);
                let along = index as f64 * step.unwrap_or_default();
                Some([0, 1, 2].map(|axis| position[axis] + along * normal[axis]))
            }
            // One position for many frames is that of none of them but the first.
            (position, ..) if count == 1 || groups.len() == count as usize => position,
            _ => None,
        };
        let number = |tag, absent| {
            within(attributes::TRANSFORMATIONS, tag).and_then(|numbers| numbers.first().copied()).unwrap_or(absent)
        };
        let rescale = [number(attributes::SLOPE, 1.0), number(attributes::INTERCEPT, 0.0)];
        let index_in_time = within(attributes::FRAME_CONTENT, attributes::TEMPORAL_POSITION_INDEX);
        let times = TIMES.map(|(tag, _)| match tag {
            attributes::TEMPORAL_POSITION => {
                let position = index_in_time.as_ref().and_then(|numbers| numbers.first().copied());
                position.or_else(|| numbers(object, tag).map(|numbers| numbers[0]))
            }
            attributes::ACQUISITION_TIME | attributes::CONTENT_TIME => seconds(&text(object, tag)?),
            tag => numbers(object, tag).map(|numbers| numbers[0]),
        });
        Frame { position, orientation, rescale, times }
    });
    Ok(frames.collect())
}

/// Seconds since midnight of a time such as `131501.25`.
fn seconds(time: &str) -> Option<f64> {
    let part = |range: std::ops::Range<usize>| time.get(range)?.parse::<f64>().ok();
    let rest = time.get(4..).filter(|rest| !rest.is_empty()).map_or(Some(0.0), |rest| rest.parse().ok());
    Some(3600.0 * part(0..2)? + 60.0 * part(2..4)? + rest?)
}
