//! Refinement of a picture: the pixels that differ from their neighbours, and their new values.

use super::output::{Output, PixelFilter};
use vitrum_io::Layer;
use vitrum_kernels::abi::record::status;
use vitrum_kernels::sweep::place::{COLUMN_BITS, word};

/// The difference of neighbouring pixels, in displayed values (the square root of radiance up to 1, and coverage), from which on both are refined. Half
/// of it would refine half as many pixels again, for a picture that is hardly nearer to one of 64 rays a pixel.
const VISIBLE: f32 = 1.0 / 8.0;

/// The cost of a ray that turned back and was followed to no end, over the cost of one that did not.
const TURNED: f32 = 12.0;

/// The picture of which pixels are to be refined.
pub(crate) struct Rendered<'a> {
    /// The layer of radiance and coverage.
    pub color: &'a Layer,
    /// The fate of each pixel's ray ([`status`]), where the method tells it.
    pub fates: Option<&'a [f32]>,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// The factor with which radiance is shown.
    pub exposure: f32,
}

impl Rendered<'_> {
    /// The pixels that differ from a neighbour, by [`word`], in squares of [`TILE`] × [`TILE`] pixels: rays of pixels that are near one another run together.
    /// They cost at most `budget` times as much as the picture itself, if each has `rays` times as many rays: first those which promise most for
    /// their cost, by the square of their difference.
    pub fn differing(&self, rays: f32, budget: f32) -> Vec<u32> {
        let width = self.size[0] as usize;
        let costs = |pixel: usize| match self.fates {
            Some(fates) if fates[pixel] == status::TURNED => TURNED,
            _ => 1.0,
        };
        let differences = self.differences();
        let mut left: f64 = (0..differences.len()).map(|pixel| f64::from(costs(pixel) * budget)).sum();
        let mut pixels: Vec<usize> = (0..differences.len()).filter(|&pixel| differences[pixel] > VISIBLE).collect();
        let gain = |pixel: usize| differences[pixel] * differences[pixel] / costs(pixel);
        // Pixels of one gain stay in their order: the sort is stable.
        pixels.sort_by(|&a, &b| gain(b).total_cmp(&gain(a)));
        let affordable = pixels.iter().take_while(|&&pixel| {
            left -= f64::from(costs(pixel) * rays);
            left >= 0.0
        });
        let mut chosen: Vec<usize> = affordable.copied().collect();
        let tile = |pixel: usize| {
            let (x, y) = (pixel % width, pixel / width);
            (y / TILE, x / TILE, y, x)
        };
        chosen.sort_unstable_by_key(|&pixel| tile(pixel));
        chosen.into_iter().map(|pixel| word((pixel % width) as u32, (pixel / width) as u32)).collect()
    }

    /// The largest difference of each pixel from its four neighbours.
    fn differences(&self) -> Vec<f32> {
        let [width, height] = self.size.map(|n| n as usize);
        let mut differences = vec![0.0f32; width * height];
        for channel in &self.color.channels {
            let shown = displayed(&channel.data, &channel.name, self.exposure);
            let mut compare = |a: usize, b: usize| {
                let difference = (shown[a] - shown[b]).abs();
                differences[a] = differences[a].max(difference);
                differences[b] = differences[b].max(difference);
            };
            for at in 0..width * height {
                if at % width + 1 < width {
                    compare(at, at + 1);
                }
                if at + width < width * height {
                    compare(at, at + width);
                }
            }
        }
        differences
    }
}

/// The number of a pixel, row by row, by its [`word`].
pub(crate) fn index_of(word: u32, width: u32) -> usize {
    let (column, row) = (word & ((1 << COLUMN_BITS) - 1), word >> COLUMN_BITS);
    row as usize * width as usize + column as usize
}

/// Pixels along each side of a square whose pixels follow one another.
const TILE: usize = 16;

/// Values as they are displayed: radiance nearly so, since the square root is nearly the curve of a screen.
fn displayed(values: &[f32], name: &str, exposure: f32) -> Vec<f32> {
    let shown = |value: f32| match name {
        "A" => value,
        _ => (value * exposure).clamp(0.0, 1.0).sqrt(),
    };
    values.iter().map(|&value| shown(value)).collect()
}

/// Puts the values of refined pixels, each of which has a value in `refined`, in place of a layer's. What the ray at a pixel's middle says stays.
pub(crate) fn replace(layer: &mut Layer, output: &Output, refined: &Layer, pixels: &[usize]) {
    if let PixelFilter::Nearest = output.pixel {
        return;
    }
    for (channel, anew) in layer.channels.iter_mut().zip(&refined.channels) {
        for (&pixel, &value) in pixels.iter().zip(&anew.data) {
            channel.data[pixel] = value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_io::Channel;

    fn grey(values: Vec<f32>) -> Layer {
        Layer { name: "color".to_owned(), channels: vec![Channel { name: "R".to_owned(), data: values }] }
    }

    fn rendered(color: &Layer, width: u32, exposure: f32) -> Rendered<'_> {
        let height = color.channels[0].data.len() as u32 / width;
        Rendered { color, fates: None, size: [width, height], exposure }
    }

    #[test]
    fn both_sides_of_an_edge_are_refined_and_nothing_else() {
        let row = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let color = grey([row, row].concat());
        let pixels = rendered(&color, 6, 1.0).differing(9.0, 100.0);
        assert_eq!(pixels, [word(2, 0), word(3, 0), word(2, 1), word(3, 1)]);
        assert!(rendered(&color, 6, 1e-6).differing(9.0, 100.0).is_empty(), "nothing is seen of it");
        assert!(rendered(&grey(vec![1.0, 4.0]), 2, 1.0).differing(9.0, 100.0).is_empty(), "both are white");
    }

    #[test]
    fn a_budget_goes_to_the_largest_differences_and_to_cheap_rays() {
        let color = grey(vec![0.0, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0, 0.0]);
        let of_one = rendered(&color, 8, 1.0);
        // Eight pixels' cost is 8; the edge of 1 is worth more than the edge of ½.
        assert_eq!(of_one.differing(4.0, 1.0), [word(6, 0), word(7, 0)]);
        let mut fates = [0.0; 8];
        (fates[6], fates[7]) = (status::TURNED, status::TURNED);
        let followed = Rendered { fates: Some(&fates), ..of_one };
        // Now its rays cost twelve times as much.
        assert_eq!(followed.differing(4.0, 0.3), [word(0, 0), word(1, 0)]);
    }
}
