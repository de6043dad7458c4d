//! The sum of a frame's exposures.

use super::output::{Blend, Output};
use crate::method::{Exposure, Part};
use vitrum_io::Picture;

/// The sum of the exposures so far.
pub(crate) struct Accumulator {
    outputs: &'static [Output],
    /// Number of exposures; a single one is the sum itself.
    count: usize,
    /// Planar film records.
    pub film: Vec<f32>,
    /// The light on the last plane.
    pub light: Option<Picture>,
    /// The least distance so far.
    nearest: f64,
}

impl Accumulator {
    /// The empty sum of `count` exposures by a method with these outputs.
    pub fn new(outputs: &'static [Output], count: usize) -> Self {
        Self { outputs, count, film: Vec::new(), light: None, nearest: f64::INFINITY }
    }

    /// Adds an exposure: its planar records for `rays` viewing rays, and its light.
    pub fn add(&mut self, exposure: &Exposure, film: Vec<f32>, rays: usize, light: Option<Picture>) {
        let is_whole = exposure.part == Part::Whole;
        let is_nearest = is_whole && exposure.distance < self.nearest;
        self.nearest = if is_whole { self.nearest.min(exposure.distance) } else { self.nearest };
        if self.count == 1 {
            (self.film, self.light) = (film, light);
            return;
        }
        self.film.resize(film.len(), 0.0);
        for output in self.outputs {
            for (channel, &(name, component)) in output.channels.iter().enumerate() {
                let part = component * rays..(component + 1) * rays;
                let (whole, added) = (&mut self.film[part.clone()], &film[part]);
                match output.blend {
                    Blend::Sum if !is_whole => {}
                    Blend::Radiance if !is_whole && channel > 2 => {}
                    Blend::Sum | Blend::Radiance => {
                        add_weighted(whole, added, weight(exposure.weights, name, channel));
                    }
                    Blend::Nearest if is_nearest => whole.copy_from_slice(added),
                    Blend::Nearest => {}
                }
            }
        }
        // Each light has a grid of its own, and the picture is that of the first.
        if let Some(light) = light.filter(|_| is_whole) {
            self.add_light(light, exposure.weights);
        }
    }

    fn add_light(&mut self, mut light: Picture, weights: [f32; 3]) {
        let first = self.light.is_none();
        let whole = self.light.get_or_insert_with(|| light.clone());
        let channels =
            whole.layers.iter_mut().zip(&mut light.layers).flat_map(|(a, b)| a.channels.iter_mut().zip(&b.channels));
        for ((whole, added), weight) in channels.zip(weights) {
            if first {
                whole.data.fill(0.0);
            }
            add_weighted(&mut whole.data, &added.data, weight);
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

fn add_weighted(whole: &mut [f32], added: &[f32], weight: f32) {
    for (whole, added) in whole.iter_mut().zip(added) {
        *whole += added * weight;
    }
}
