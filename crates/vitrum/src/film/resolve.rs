//! Resolution of the film: from the records of several rays a pixel to one value a pixel.

use super::output::{Output, PixelFilter};
use rayon::prelude::*;
use vitrum_io::{Channel, Layer};

/// Planar records of `edge` × `edge` rays for each pixel.
#[derive(Clone, Copy)]
pub(crate) struct RayRecords<'a> {
    pub records: &'a [f32],
    /// Pixels across and down.
    pub size: [u32; 2],
    pub edge: u32,
}

impl RayRecords<'_> {
    /// The layer of an output.
    pub fn layer(&self, output: &Output) -> Layer {
        let Output { name, pixel, channels, .. } = *output;
        let mut data: Vec<Vec<f32>> = channels.iter().map(|&(_, component)| self.resolve(pixel, component)).collect();
        if let (PixelFilter::Direction, 2..) = (pixel, self.edge) {
            for at in 0..data.first().map_or(0, Vec::len) {
                let length = data.iter().map(|data| data[at] * data[at]).sum::<f32>().sqrt();
                data.iter_mut().filter(|_| length > 0.0).for_each(|data| data[at] /= length);
            }
        }
        let channels = channels.iter().zip(data).map(|(&(name, _), data)| Channel { name: name.to_owned(), data });
        Layer { name: name.to_owned(), channels: channels.collect() }
    }

    /// One component, a number a pixel.
    fn resolve(&self, pixel: PixelFilter, component: usize) -> Vec<f32> {
        let [width, height] = self.size.map(|n| n as usize);
        let edge = self.edge as usize;
        let across = width * edge;
        let plane = |component: usize| &self.records[component * across * height * edge..][..across * height * edge];
        let values = plane(component);
        if edge == 1 {
            return values.to_vec();
        }
        let weights = if let PixelFilter::WeightedBy(component) = pixel { plane(component) } else { &[] };
        let weight = |at: usize| match pixel {
            PixelFilter::Mean | PixelFilter::Direction => 1.0,
            PixelFilter::WeightedBy(_) => weights[at],
            PixelFilter::Present => f32::from(u8::from(values[at] != 0.0)),
            PixelFilter::Nearest => {
                f32::from(u8::from((at % across % edge, at / across % edge) == (edge / 2, edge / 2)))
            }
        };
        (0..width * height)
            .into_par_iter()
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
    fn resolved(pixel: PixelFilter) -> [f32; 2] {
        let first = [2.0, 0.0, 4.0, 8.0];
        let weights = [1.0, 1.0, 0.0, 3.0];
        let rows = |rays: [f32; 4]| [rays[0], rays[1], 0.0, 0.0, rays[2], rays[3], 0.0, 0.0];
        let records = [rows(first), rows(weights)].concat();
        let rays = RayRecords { records: &records, size: [2, 1], edge: 2 };
        let layer = rays.layer(&Output::mean("x", &[("Y", 0)], "").filtered(pixel));
        [layer.channels[0].data[0], layer.channels[0].data[1]]
    }

    #[test]
    fn pixels_of_several_rays_follow_their_outputs_rule() {
        assert_eq!(resolved(PixelFilter::Mean), [3.5, 0.0]);
        assert_eq!(resolved(PixelFilter::WeightedBy(1)), [26.0 / 5.0, 0.0]);
        assert_eq!(resolved(PixelFilter::Present), [14.0 / 3.0, 0.0]);
        assert_eq!(resolved(PixelFilter::Nearest), [8.0, 0.0]);
        assert_eq!(resolved(PixelFilter::Direction), [1.0, 0.0]);
    }
}
