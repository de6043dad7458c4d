//! OpenEXR: every layer with its name, float32, and metadata.

use std::io;

use exr::block::lines::LineRefMut;
use exr::image::write::samples::{SamplesWriter, WritableSamples};
use exr::math::RoundingMode;
use exr::meta::MetaData;
use exr::meta::attribute::{AttributeValue, LevelMode, SampleType, Text};
use exr::meta::header::{Header, standard_names};
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, Image, ImageAttributes, IntegerBounds, LayerAttributes, ReadChannels,
    ReadLayers, Vec2, WritableImage, read,
};

use super::options::Metadata;
use super::picture::{COLOR, Channel, Layer, Picture};
use super::size::{check_size, empty};
use crate::atomic_write::Sink;
use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::storage::Storage;

pub(super) fn encode(sink: &mut dyn Sink, picture: &Picture, metadata: &Metadata) -> io::Result<()> {
    let size = Vec2(picture.width as usize, picture.height as usize);
    let mut attributes = ImageAttributes::new(IntegerBounds::from_dimensions(size));
    for (key, value) in metadata {
        // A name of the format's own would make the file wrong.
        let reserved = standard_names::ALL.contains(&key.as_bytes());
        let key = if reserved { format!("vitrum.{key}") } else { key.clone() };
        attributes.other.insert(text(&key), AttributeValue::Text(text(value)));
    }
    let layers: Vec<_> = picture.layers.iter().map(|layer| encoded_layer(size, layer)).collect();
    let image = Image::from_layers(attributes, layers);
    image.write().to_buffered(sink).map_err(|error| match error {
        exr::error::Error::Io(error) => error,
        other => io::Error::other(other),
    })
}

/// The values of a channel, where they are.
struct Plane<'a>(&'a [f32]);

/// Those of a picture so many pixels wide.
struct PlaneWriter<'a>(&'a [f32], usize);

impl<'slf> WritableSamples<'slf> for Plane<'_> {
    type Writer = PlaneWriter<'slf>;

    fn sample_type(&self) -> SampleType {
        SampleType::F32
    }

    fn infer_level_modes(&self) -> (LevelMode, RoundingMode) {
        (LevelMode::Singular, RoundingMode::Down)
    }

    fn create_samples_writer(&'slf self, header: &Header) -> PlaneWriter<'slf> {
        PlaneWriter(self.0, header.layer_size.width())
    }
}

impl SamplesWriter for PlaneWriter<'_> {
    fn extract_line(&self, line: LineRefMut<'_>) {
        let Vec2(x, y) = line.location.position;
        let start = y * self.1 + x;
        let values = &self.0[start..start + line.location.sample_count];
        // A line has the bytes of its samples, and memory takes them all.
        let _ = line.write_samples_from_slice(values);
    }
}

fn encoded_layer(size: Vec2<usize>, layer: &Layer) -> exr::image::Layer<AnyChannels<Plane<'_>>> {
    let channels = layer.channels.iter().map(|channel| AnyChannel::new(text(&channel.name), Plane(&channel.data)));
    exr::image::Layer::new(
        size,
        LayerAttributes::named(text(&layer.name)),
        Encoding::SMALL_LOSSLESS,
        AnyChannels::sort(channels.collect()),
    )
}

/// The file format says bytes; everybody writes UTF-8.
fn text(string: &str) -> Text {
    Text::from_bytes_unchecked(string.bytes().collect())
}

fn string(text: &Text) -> String {
    String::from_utf8_lossy(text.as_slice()).into_owned()
}

/// Reads every layer: a part by its name, and channels such as `depth.Z` as a layer `depth`.
pub(super) fn decode(storage: &Storage, report: Report, options: &OpenOptions) -> Result<Picture, Error> {
    let wrong = |error: exr::error::Error| match error {
        exr::error::Error::Io(error) if error.kind() != io::ErrorKind::UnexpectedEof => report.unreadable(error),
        other => report.invalid(
            Place::File,
            format!("this OpenEXR file cannot be decoded: {other}"),
            "write it anew with flat, uncompressed or ZIP-compressed layers",
        ),
    };
    let open = || storage.open().map_err(|error| report.unreadable(error));
    let metadata = MetaData::read_from_buffered(open()?, false).map_err(wrong)?;
    // All layers have one size, and stand in memory twice: as decoded, and as returned.
    let channels: u64 = metadata.headers.iter().map(|header| header.channels.list.len() as u64).sum();
    for header in &metadata.headers {
        let Vec2(width, height) = header.layer_size;
        if width == 0 || height == 0 || header.channels.list.is_empty() {
            return Err(empty(report));
        }
        check_size(report, width as u64, height as u64, 2 * channels, options)?;
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_buffered(open()?)
        .map_err(wrong)?;
    let Some(size) = image.layer_data.first().map(|layer| layer.size) else {
        return Err(report.invalid(Place::File, "there are no layers", "write it anew"));
    };
    let mut layers: Vec<Layer> = Vec::new();
    for part in image.layer_data {
        let name = part.attributes.layer_name.as_ref().map_or(String::new(), string);
        if part.size != size {
            return Err(report.unsupported(
                Place::File,
                format!("layer `{name}` has another size than the first"),
                "write all layers with one size",
            ));
        }
        for channel in part.channel_data.list {
            let full_name = string(&channel.name);
            if channel.sampling != Vec2(1, 1) {
                return Err(report.unsupported(
                    Place::File,
                    format!("channel `{full_name}` has fewer samples than there are pixels"),
                    "write it with a sample a pixel",
                ));
            }
            let data = channel.sample_data.values_as_f32().collect();
            add_channel(&mut layers, &name, &full_name, data);
        }
    }
    sort_colors(&mut layers);
    Ok(Picture { width: size.0 as u32, height: size.1 as u32, layers })
}

fn add_channel(layers: &mut Vec<Layer>, part: &str, full_name: &str, data: Vec<f32>) {
    let (prefix, name) = full_name.rsplit_once('.').unwrap_or(("", full_name));
    let layer_name = match (part, prefix) {
        ("", "") => COLOR.to_owned(),
        (part, "") => part.to_owned(),
        ("", prefix) => prefix.to_owned(),
        (part, prefix) => format!("{part}.{prefix}"),
    };
    let channel = Channel { name: name.to_owned(), data };
    match layers.iter_mut().find(|layer| layer.name == layer_name) {
        Some(layer) => layer.channels.push(channel),
        None => layers.push(Layer { name: layer_name, channels: vec![channel] }),
    }
}

/// Files hold channels by alphabet: put colours as R, G, B, A again, and their layer first.
fn sort_colors(layers: &mut [Layer]) {
    for layer in layers.iter_mut() {
        let rank = |channel: &Channel| ["R", "G", "B", "A"].iter().position(|n| *n == channel.name);
        layer.channels.sort_by_key(|channel| rank(channel).unwrap_or(usize::MAX));
    }
    layers.sort_by_key(|layer| layer.channel("R").is_none() && layer.name != COLOR);
}
