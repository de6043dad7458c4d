//! From the records of several rays a pixel to one value a pixel.

use vitrum_io::{Channel, Layer};

/// The channels of a colour whose components begin at `from`.
pub(crate) fn rgb(from: usize) -> [(&'static str, usize); 3] {
    [("R", from), ("G", from + 1), ("B", from + 2)]
}

/// The channels of a colour and its coverage.
pub(crate) fn rgba(from: usize) -> [(&'static str, usize); 4] {
    [("R", from), ("G", from + 1), ("B", from + 2), ("A", from + 3)]
}

/// The channels of a vector.
pub(crate) fn xyz(from: usize) -> [(&'static str, usize); 3] {
    [("X", from), ("Y", from + 1), ("Z", from + 2)]
}

/// What a pixel of several rays shows of an output.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Pixel {
    /// The mean.
    Mean,
    /// The mean, weighted by another component; 0 where that is 0 everywhere.
    WeightedBy(usize),
    /// The mean of the rays for which it is not 0.
    Present,
    /// The unit vector of the mean's direction; 0 where the mean is.
    Direction,
    /// That of one ray, the next one to the pixel's centre: numbers between which there is nothing.
    Central,
}

/// Planar records of `edge` × `edge` rays for each pixel.
#[derive(Clone, Copy)]
pub(crate) struct Rays<'a> {
    pub records: &'a [f32],
    /// Pixels across and down.
    pub size: [u32; 2],
    pub edge: u32,
}

impl Rays<'_> {
    /// An output: `channels` are names and component numbers.
    pub fn layer<const N: usize>(&self, name: &str, pixel: Pixel, channels: [(&str, usize); N]) -> Layer {
        let mut data: [Vec<f32>; N] = std::array::from_fn(|channel| self.resolve(pixel, channels[channel].1));
        if let (Pixel::Direction, 2..) = (pixel, self.edge) {
            for at in 0..data.first().map_or(0, Vec::len) {
                let length = data.iter().map(|data| data[at] * data[at]).sum::<f32>().sqrt();
                data.iter_mut().filter(|_| length > 0.0).for_each(|data| data[at] /= length);
            }
        }
        let channels = channels.iter().zip(data).map(|(&(name, _), data)| Channel { name: name.to_owned(), data });
        Layer { name: name.to_owned(), channels: channels.collect() }
    }

    /// One component, a number a pixel.
    fn resolve(&self, pixel: Pixel, component: usize) -> Vec<f32> {
        let [width, height] = self.size.map(|n| n as usize);
        let edge = self.edge as usize;
        let across = width * edge;
        let plane = |component: usize| &self.records[component * across * height * edge..][..across * height * edge];
        let values = plane(component);
        if edge == 1 {
            return values.to_vec();
        }
        let weights = if let Pixel::WeightedBy(component) = pixel { plane(component) } else { &[] };
        let weight = |at: usize| match pixel {
            Pixel::Mean | Pixel::Direction => 1.0,
            Pixel::WeightedBy(_) => weights[at],
            Pixel::Present => f32::from(u8::from(values[at] != 0.0)),
            Pixel::Central => f32::from(u8::from((at % across % edge, at / across % edge) == (edge / 2, edge / 2))),
        };
        (0..width * height)
            .map(|pixel| {
                let (x, y) = (pixel % width * edge, pixel / width * edge);
                let rays = (0..edge).flat_map(|dy| (0..edge).map(move |dx| (y + dy) * across + x + dx));
                let (sum, whole) =
                    rays.fold((0.0, 0.0), |(sum, whole), at| (sum + values[at] * weight(at), whole + weight(at)));
                if whole > 0.0 { sum / whole } else { 0.0 }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One pixel of four rays with two components, and a second pixel of nothing.
    fn resolved(pixel: Pixel) -> [f32; 2] {
        let first = [2.0, 0.0, 4.0, 8.0];
        let weights = [1.0, 1.0, 0.0, 3.0];
        let rows = |rays: [f32; 4]| [rays[0], rays[1], 0.0, 0.0, rays[2], rays[3], 0.0, 0.0];
        let records = [rows(first), rows(weights)].concat();
        let rays = Rays { records: &records, size: [2, 1], edge: 2 };
        let layer = rays.layer("x", pixel, [("Y", 0)]);
        [layer.channels[0].data[0], layer.channels[0].data[1]]
    }

    #[test]
    fn pixels_of_several_rays_follow_their_outputs_rule() {
        assert_eq!(resolved(Pixel::Mean), [3.5, 0.0]);
        assert_eq!(resolved(Pixel::WeightedBy(1)), [26.0 / 5.0, 0.0]);
        assert_eq!(resolved(Pixel::Present), [14.0 / 3.0, 0.0]);
        assert_eq!(resolved(Pixel::Central), [8.0, 0.0]);
        assert_eq!(resolved(Pixel::Direction), [1.0, 0.0]);
    }
}
