//! The parts of two pictures besides their colours: alpha, and in OpenEXR further layers.

use vitrum::io::{Layer, Picture};
use vitrum_compare::{CompareError, Comparison, compare_buffers};

/// A channel of both pictures.
pub struct Part {
    /// `alpha`, or such as `depth.Z`.
    pub name: String,
    pub comparison: Comparison,
    width: u32,
}

impl Part {
    /// Column and row of the first pixel with the largest difference, if any differs.
    pub fn worst_pixel(&self) -> Option<(u32, u32)> {
        self.comparison.worst_pixel().map(|(index, _)| (index % self.width, index / self.width))
    }
}

/// The channels that both have, and the names of those that one has alone.
#[derive(Default)]
pub struct Parts {
    pub both: Vec<Part>,
    pub only_a: Vec<String>,
    pub only_b: Vec<String>,
}

/// The name of the first layers' alpha.
const ALPHA: &str = "alpha";

impl Parts {
    /// The parts besides the colours of two pictures of one size. Where only one of them has alpha, the other is opaque.
    pub fn of(a: &Picture, b: &Picture) -> Result<Self, CompareError> {
        let width = a.width;
        let opaque = vec![1.0; a.width as usize * a.height as usize];
        let [mut a, mut b] = [a, b].map(channels);
        match [&a, &b].map(|channels| find(channels, ALPHA).is_some()) {
            [true, false] => b.insert(0, (ALPHA.to_owned(), &opaque)),
            [false, true] => a.insert(0, (ALPHA.to_owned(), &opaque)),
            _ => {}
        }
        let mut parts = Self::default();
        for (name, values) in &a {
            match find(&b, name) {
                Some(others) => {
                    let comparison = compare_buffers(values, others)?;
                    parts.both.push(Part { name: name.clone(), comparison, width });
                }
                None => parts.only_a.push(name.clone()),
            }
        }
        let alone = b.into_iter().map(|(name, _)| name).filter(|name| find(&a, name).is_none());
        parts.only_b.extend(alone);
        Ok(parts)
    }
}

/// Names and values of all channels but the first layer's colours.
fn channels(picture: &Picture) -> Vec<(String, &[f32])> {
    let layers = picture.layers.iter().enumerate();
    let channels = layers.flat_map(|(index, layer)| {
        let names = if index == 0 { color_channels(layer) } else { Vec::new() };
        let rest = layer.channels.iter().filter(move |channel| !names.contains(&&*channel.name));
        rest.map(move |channel| {
            let alpha = index == 0 && channel.name == "A";
            let name = if alpha { ALPHA.to_owned() } else { format!("{}.{}", layer.name, channel.name) };
            (name, &*channel.data)
        })
    });
    channels.collect()
}

fn find<'a>(channels: &[(String, &'a [f32])], name: &str) -> Option<&'a [f32]> {
    channels.iter().find(|(other, _)| other == name).map(|&(_, values)| values)
}

/// The channels that a layer's colours are made of: see [`Picture::color`].
pub fn color_channels(layer: &Layer) -> Vec<&str> {
    if layer.is_vector() {
        return vec!["X", "Y", "Z"];
    }
    let colors = ["R", "G", "B"];
    if colors.iter().all(|name| layer.channel(name).is_some()) {
        return colors.into();
    }
    layer.channels.first().map(|channel| &*channel.name).into_iter().collect()
}
