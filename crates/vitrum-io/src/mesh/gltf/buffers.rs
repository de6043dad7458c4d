//! The bytes that a glTF file's buffers hold: in the file, in the JSON as base64, or in files beside it.

use std::borrow::Cow;
use std::fs;

use base64::Engine;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;

use super::document::{Buffer, Document};
use super::lookup::lookup;
use crate::detached::locate;
use crate::error::{Error, Place, Report, clip};
use crate::input::Input;
use crate::mesh::build::Builder;

/// The decoded buffers, in the order of the document.
#[derive(Debug)]
pub(super) struct Buffers<'a>(Vec<Result<Cow<'a, [u8]>, Missing>>);

/// A buffer that is not there: a fault as soon as a triangle needs it, and none before.
#[derive(Debug)]
struct Missing {
    place: Place,
    problem: String,
    advice: String,
    unsupported: bool,
}

impl Missing {
    /// Keeps an error for later; one of memory is returned.
    fn of(error: Error) -> Result<Self, Error> {
        match error {
            Error::Invalid { place, problem, advice, .. } => Ok(Self { place, problem, advice, unsupported: false }),
            Error::Unsupported { place, problem, advice, .. } => Ok(Self { place, problem, advice, unsupported: true }),
            error => Err(error),
        }
    }

    fn error(&self, report: Report) -> Error {
        let Self { place, problem, advice, unsupported } = self;
        if *unsupported { report.unsupported(*place, problem, advice) } else { report.invalid(*place, problem, advice) }
    }
}

impl<'a> Buffers<'a> {
    pub fn load(
        document: &Document,
        binary: Option<&'a [u8]>,
        input: &Input,
        builder: &mut Builder,
    ) -> Result<Self, Error> {
        let mut buffers = Vec::new();
        for (index, buffer) in document.buffers.iter().enumerate() {
            buffers.push(match load(buffer, index, binary, input, builder) {
                Ok(bytes) => Ok(bytes),
                Err(error) => Err(Missing::of(error)?),
            });
        }
        Ok(Self(buffers))
    }

    /// The bytes of a view; `from` says who names it.
    pub fn view(&self, builder: &Builder, document: &Document, index: usize, from: &str) -> Result<&[u8], Error> {
        let report = builder.report;
        let name = || format!("{from}.bufferView");
        let view = lookup(report, &document.buffer_views, "bufferViews", index, name)?;
        let buffer = lookup(report, &self.0, "buffers", view.buffer, || format!("bufferViews[{index}].buffer"))?;
        let buffer = buffer.as_ref().map_err(|missing| missing.error(report))?;
        let end = view.byte_offset.saturating_add(view.byte_length);
        let range = usize::try_from(view.byte_offset).ok().zip(usize::try_from(end).ok());
        range.and_then(|(start, end)| buffer.get(start..end)).ok_or_else(|| {
            let problem = format!("bufferViews[{index}] ends at byte {end} of a buffer of {} bytes", buffer.len());
            report.invalid(Place::File, problem, "correct `byteOffset` and `byteLength`")
        })
    }
}

fn load<'a>(
    buffer: &Buffer,
    index: usize,
    binary: Option<&'a [u8]>,
    input: &Input,
    builder: &mut Builder,
) -> Result<Cow<'a, [u8]>, Error> {
    let bytes = match &buffer.uri {
        Some(uri) => Cow::Owned(read(uri, index, buffer, input, builder)?),
        None => Cow::Borrowed(binary.filter(|_| index == 0).unwrap_or_default()),
    };
    // The chunk of a GLB file may be padded.
    if (bytes.len() as u64) < buffer.byte_length {
        return Err(builder.report.invalid(
            Place::File,
            format!("buffers[{index}] promises {} bytes, {} are there", buffer.byte_length, bytes.len()),
            "get the whole file, or correct `byteLength`",
        ));
    }
    Ok(bytes)
}

fn read(uri: &str, index: usize, buffer: &Buffer, input: &Input, builder: &mut Builder) -> Result<Vec<u8>, Error> {
    let report = builder.report;
    let wrong = |problem: String| {
        let advice = "name a file beside this one, or embed the bytes as base64";
        report.invalid(Place::File, format!("buffers[{index}].uri {problem}"), advice)
    };
    if let Some(data) = uri.strip_prefix("data:") {
        let Some((_, text)) = data.split_once(";base64,") else {
            return Err(wrong("embeds data that is not base64".to_owned()));
        };
        builder.budget.take(text.len() as u64 / 4 * 3)?;
        let config = GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
        let engine = GeneralPurpose::new(&base64::alphabet::STANDARD, config);
        return engine.decode(text).map_err(|error| wrong(format!("holds damaged base64: {error}")));
    }
    if uri.contains("://") {
        return Err(wrong(format!("is `{}`, and nothing is fetched from elsewhere", clip(uri))));
    }
    let name = percent_decode_str(uri).decode_utf8().map_err(|_| wrong(format!("is `{}`, not UTF-8", clip(uri))))?;
    let (path, length) = locate(report, Place::File, input, &name)?;
    if length < buffer.byte_length {
        return Err(report.invalid(
            Place::File,
            format!("buffers[{index}] promises {} bytes, and `{}` has {length}", buffer.byte_length, clip(&name)),
            "get the whole file, or correct `byteLength`",
        ));
    }
    builder.budget.take(length)?;
    fs::read(&path).map_err(|error| report.unreadable(error))
}
