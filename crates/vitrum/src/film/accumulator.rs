//! The sum of a frame's exposures, pixel by pixel: an exposure may come in parts, whose rays are forgotten.

use super::output::{Blend, Output, PixelFilter};
use super::resolve::RayRecords;
use crate::error::Error;
use crate::method::{Exposure, Part};
use crate::parts::Rectangle;
use crate::request::Layers;
use rayon::prelude::*;
use vitrum_io::{Channel, Layer, Picture, require_memory};
use vitrum_kernels::sweep::place::COLUMN_BITS;

/// The sum of the exposures so far.
pub(crate) struct Accumulator {
    outputs: Vec<&'static Output>,
    /// Number of exposures; a single one is the sum itself.
    count: usize,
    /// The requested outputs, row 0 on top.
    pub layers: Vec<Layer>,
    /// Pixels across.
    width: u32,
    /// The light on the last plane.
    pub light: Option<Picture>,
    /// The least distance so far.
    nearest: f64,
    current: Current,
}

/// The exposure whose parts are added.
struct Current {
    weights: [f32; 3],
    is_whole: bool,
    is_first: bool,
    is_nearest: bool,
}

/// The pixels of a picture to which the values of a part belong.
pub(crate) enum Places<'a> {
    /// Those of a rectangle, row by row.
    Rectangle(Rectangle),
    /// Those of a list, by [`word`](vitrum_kernels::sweep::place::word), which get other values in place of those that they have.
    Anew(&'a [u32]),
}

impl Places<'_> {
    /// Runs of pixels that follow one another in the part and in the picture: their first one there, their first one here, and their number.
    fn runs(&self, width: u32) -> Box<dyn Iterator<Item = (usize, usize, usize)> + '_> {
        match self {
            Self::Rectangle(Rectangle { first, size }) => {
                let [left, top, across, down] = [first[0], first[1], size[0], size[1]].map(|n| n as usize);
                let at = move |row: usize| (row * across, (top + row) * width as usize + left, across);
                Box::new((0..down).map(at))
            }
            Self::Anew(words) => {
                Box::new(words.iter().enumerate().map(move |(here, &word)| (here, index_of(word, width), 1)))
            }
        }
    }
}

/// The number of a pixel, row by row, by its [`word`](vitrum_kernels::sweep::place::word).
fn index_of(word: u32, width: u32) -> usize {
    let (column, row) = (word & ((1 << COLUMN_BITS) - 1), word >> COLUMN_BITS);
    row as usize * width as usize + column as usize
}

/// What an exposure does to a channel of the sum.
#[derive(Clone, Copy)]
enum Rule {
    /// Its value is the sum's.
    Put,
    /// Its value times that weight is the sum so far.
    Begin(f32),
    /// Its value times that weight is added.
    Add(f32),
}

impl Accumulator {
    /// The empty sum of `count` exposures of a picture of `size` pixels, by a method with these outputs, of which `wanted` are summed up.
    ///
    /// # Errors
    /// Where the memory does not suffice.
    pub fn new(outputs: &'static [Output], wanted: Layers, count: usize, size: [u32; 2]) -> Result<Self, Error> {
        let outputs: Vec<&Output> =
            outputs.iter().filter(|output| !output.channels.is_empty() && wanted.has(output.name)).collect();
        let pixels = size[0] as usize * size[1] as usize;
        let channels: u64 = outputs.iter().map(|output| output.channels.len() as u64).sum();
        let [width, height] = size;
        require_memory(&format!("a film of {width} x {height} pixels"), 4 * channels * pixels as u64)?;
        let channel = |&(name, _): &(&str, usize)| Channel { name: name.to_owned(), data: vec![0.0; pixels] };
        let layer = |output: &&Output| Layer {
            name: output.name.to_owned(),
            channels: output.channels.iter().map(channel).collect(),
        };
        let layers = outputs.iter().map(layer).collect();
        let current = Current { weights: [0.0; 3], is_whole: false, is_first: false, is_nearest: false };
        Ok(Self { outputs, count, layers, width, light: None, nearest: f64::INFINITY, current })
    }

    /// Begins with the parts of exposure number `index`.
    pub fn begin(&mut self, index: usize, exposure: &Exposure) {
        if index == 0 {
            self.nearest = f64::INFINITY;
        }
        let is_whole = exposure.part == Part::Whole;
        let is_nearest = is_whole && exposure.distance < self.nearest;
        self.nearest = if is_whole { self.nearest.min(exposure.distance) } else { self.nearest };
        self.current = Current { weights: exposure.weights, is_whole, is_first: index == 0, is_nearest };
    }

    /// Whether outputs without a mean show the exposure that was begun, as long as none is nearer.
    pub fn is_nearest(&self) -> bool {
        self.current.is_nearest
    }

    /// What the exposure does to a channel, the name of which stands at place `channel` of its output.
    fn rule(&self, blend: Blend, channel: usize, name: &str) -> Option<Rule> {
        let Current { weights, is_whole, is_first, is_nearest } = self.current;
        if self.count == 1 {
            return Some(Rule::Put);
        }
        match blend {
            Blend::Sum if !is_whole => None,
            Blend::Radiance if !is_whole && channel > 2 => None,
            Blend::Sum | Blend::Radiance => {
                let weight = weight(weights, name, channel);
                Some(if is_first { Rule::Begin(weight) } else { Rule::Add(weight) })
            }
            Blend::Nearest => is_nearest.then_some(Rule::Put),
        }
    }

    /// Adds a part of the exposure: the records of its rays, for the pixels at `places`. What the ray at a pixel's middle says is not put anew.
    pub fn add(&mut self, rays: &RayRecords<'_>, places: &Places<'_>) {
        let is_anew = matches!(places, Places::Anew(_));
        let rules: Vec<Vec<Option<Rule>>> = self
            .outputs
            .iter()
            .map(|output| {
                let stays = is_anew && matches!(output.pixel, PixelFilter::Nearest);
                let names = output.channels.iter().enumerate();
                names.map(|(at, &(name, _))| self.rule(output.blend, at, name).filter(|_| !stays)).collect()
            })
            .collect();
        let width = self.width;
        let layers = self.layers.par_iter_mut().zip(self.outputs.par_iter()).zip(rules);
        layers.filter(|(_, rules)| rules.iter().any(Option::is_some)).for_each(|((layer, output), rules)| {
            let part = rays.layer(output);
            for ((whole, added), rule) in layer.channels.iter_mut().zip(&part.channels).zip(rules) {
                let Some(rule) = rule else { continue };
                for (here, there, count) in places.runs(width) {
                    let values = added.data[here..][..count].iter();
                    let sums = whole.data[there..][..count].iter_mut();
                    match rule {
                        Rule::Put => sums.zip(values).for_each(|(sum, value)| *sum = *value),
                        Rule::Begin(weight) => sums.zip(values).for_each(|(sum, value)| *sum = 0.0 + value * weight),
                        Rule::Add(weight) => sums.zip(values).for_each(|(sum, value)| *sum += value * weight),
                    }
                }
            }
        });
    }

    /// Adds the light of the exposure. Each light has a grid of its own, and the picture is that of the first.
    pub fn add_light(&mut self, mut light: Picture) {
        let weights = self.current.weights;
        if self.count == 1 {
            self.light = Some(light);
            return;
        }
        if !self.current.is_whole {
            return;
        }
        let first = self.light.is_none();
        let whole = self.light.get_or_insert_with(|| light.clone());
        let channels =
            whole.layers.iter_mut().zip(&mut light.layers).flat_map(|(a, b)| a.channels.iter_mut().zip(&b.channels));
        for ((whole, added), weight) in channels.zip(weights) {
            if first {
                whole.data.fill(0.0);
            }
            whole.data.iter_mut().zip(&added.data).for_each(|(whole, added)| *whole += added * weight);
        }
    }
}

/// The weight of a channel: by its place for red, green and blue, else the mean weight.
fn weight(weights: [f32; 3], name: &str, channel: usize) -> f32 {
    match name {
        "R" | "G" | "B" => weights[channel],
        _ => (weights[0] + weights[1] + weights[2]) / 3.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method;
    use crate::scene::MethodName;

    #[test]
    fn a_film_beyond_the_memory_is_refused_before_it_is_made() {
        let outputs = method::of(MethodName::Sweep).outputs();
        let made = |size| Accumulator::new(outputs, Layers::color(), 1, size).map(|sum| sum.layers.len());
        assert_eq!(made([4, 3]).ok(), Some(1));
        let told = made([1 << 24, 1 << 24]).expect_err("four petabytes").to_string();
        assert!(told.contains("a film of 16777216 x 16777216 pixels"), "{told}");
    }
}
