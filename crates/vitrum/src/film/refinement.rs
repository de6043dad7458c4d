//! Refinement of a picture: the pixels that differ from their neighbours.

use crate::parts::Rectangle;
use vitrum_io::{Channel, Layer};
use vitrum_kernels::sweep::place::word;

/// The difference of neighbouring pixels, in displayed values (the square root of radiance up to 1, and coverage), from which on both are refined. Half
/// of it would refine half as many pixels again, for a picture that is hardly nearer to one of 64 rays a pixel.
const VISIBLE: f32 = 1.0 / 8.0;

/// The cost of a ray that turned back and was followed, over the cost of one that did not.
const TURNED: f32 = 12.0;

/// The rays of each pixel that took much longer than usual ones.
pub(crate) struct Costly {
    /// Their number, row by row.
    counts: Vec<u8>,
    /// Pixels across.
    width: u32,
    /// Rays of a pixel.
    rays: f32,
}

impl Costly {
    /// No such ray in a picture of that size.
    pub fn none([width, height]: [u32; 2]) -> Self {
        Self { counts: vec![0; width as usize * height as usize], width, rays: 1.0 }
    }

    /// Finds them in a part of the picture of `edge` × `edge` rays a pixel; `is_costly` looks at a ray of the part.
    pub fn find(&mut self, part: Rectangle, edge: u32, is_costly: impl Fn(usize) -> bool) {
        self.rays = (edge * edge) as f32;
        let across = (part.size[0] * edge) as usize;
        let edge = edge as usize;
        for (y, x) in (0..part.size[1]).flat_map(|y| (0..part.size[0]).map(move |x| (y, x))) {
            let corner = y as usize * edge * across + x as usize * edge;
            let rays = (0..edge).flat_map(|dy| (0..edge).map(move |dx| corner + dy * across + dx));
            let at = (part.first[1] + y) as usize * self.width as usize + (part.first[0] + x) as usize;
            self.counts[at] = rays.filter(|&ray| is_costly(ray)).count() as u8;
        }
    }

    /// The cost of a ray of a pixel, over that of a usual one.
    fn of(&self, pixel: usize) -> f32 {
        1.0 + (TURNED - 1.0) * f32::from(self.counts[pixel]) / self.rays
    }
}

/// The picture of which pixels are to be refined.
pub(crate) struct Rendered<'a> {
    /// The layer of radiance and coverage.
    pub color: &'a Layer,
    /// The pixels whose rays took longer.
    pub costly: &'a Costly,
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
        let width = self.size[0];
        let costs = |pixel: u32| self.costly.of(pixel as usize);
        let differences = self.differences();
        let all = differences.len() as u32;
        let mut left: f64 = (0..all).map(|pixel| f64::from(costs(pixel) * budget)).sum();
        let mut pixels: Vec<u32> = (0..all).filter(|&pixel| differences[pixel as usize] > VISIBLE).collect();
        let gain = |pixel: u32| differences[pixel as usize] * differences[pixel as usize] / costs(pixel);
        // Pixels of one gain stay in their order.
        pixels.sort_unstable_by(|&a, &b| gain(b).total_cmp(&gain(a)).then(a.cmp(&b)));
        let affordable = pixels.iter().take_while(|&&pixel| {
            left -= f64::from(costs(pixel) * rays);
            left >= 0.0
        });
        pixels.truncate(affordable.count());
        let tile = |pixel: u32| {
            let (x, y) = (pixel % width, pixel / width);
            (y / TILE, x / TILE, y, x)
        };
        pixels.sort_unstable_by_key(|&pixel| tile(pixel));
        pixels.into_iter().map(|pixel| word(pixel % width, pixel / width)).collect()
    }

    /// The largest difference of each pixel from its four neighbours.
    fn differences(&self) -> Vec<f32> {
        let [width, height] = self.size.map(|n| n as usize);
        let mut differences = vec![0.0f32; width * height];
        for Channel { name, data } in &self.color.channels {
            let shown = |row: usize| -> Vec<f32> {
                data[row * width..][..width].iter().map(|&value| displayed(value, name, self.exposure)).collect()
            };
            let mut above: Option<Vec<f32>> = None;
            for y in 0..height {
                let here = shown(y);
                let (before, own) = differences.split_at_mut(y * width);
                for (x, pair) in here.windows(2).enumerate() {
                    let difference = (pair[0] - pair[1]).abs();
                    own[x] = own[x].max(difference);
                    own[x + 1] = own[x + 1].max(difference);
                }
                if let Some(above) = above {
                    let start = before.len() - width;
                    let columns = before[start..].iter_mut().zip(own.iter_mut()).zip(above.iter().zip(&here));
                    for ((upper, lower), (a, b)) in columns {
                        let difference = (a - b).abs();
                        (*upper, *lower) = (upper.max(difference), lower.max(difference));
                    }
                }
                above = Some(here);
            }
        }
        differences
    }
}

/// Pixels along each side of a square whose pixels follow one another.
const TILE: u32 = 16;

/// A value as it is displayed: radiance nearly so, since the square root is nearly the curve of a screen.
fn displayed(value: f32, name: &str, exposure: f32) -> f32 {
    match name {
        "A" => value,
        _ => (value * exposure).clamp(0.0, 1.0).sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(values: Vec<f32>) -> Layer {
        Layer { name: "color".to_owned(), channels: vec![Channel { name: "R".to_owned(), data: values }] }
    }

    fn differing(
        color: &Layer,
        costly: &[usize],
        (width, exposure): (u32, f32),
        (rays, budget): (f32, f32),
    ) -> Vec<u32> {
        let size = [width, color.channels[0].data.len() as u32 / width];
        let mut found = Costly::none(size);
        found.find(Rectangle { first: [0, 0], size }, 1, |ray| costly.contains(&ray));
        Rendered { color, costly: &found, size, exposure }.differing(rays, budget)
    }

    #[test]
    fn both_sides_of_an_edge_are_refined_and_nothing_else() {
        let row = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let color = grey([row, row].concat());
        let pixels = differing(&color, &[], (6, 1.0), (9.0, 100.0));
        assert_eq!(pixels, [word(2, 0), word(3, 0), word(2, 1), word(3, 1)]);
        assert!(differing(&color, &[], (6, 1e-6), (9.0, 100.0)).is_empty(), "nothing is seen of it");
        assert!(differing(&grey(vec![1.0, 4.0]), &[], (2, 1.0), (9.0, 100.0)).is_empty(), "both are white");
        let upright = grey(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
        assert_eq!(differing(&upright, &[], (2, 1.0), (9.0, 100.0)), [word(0, 1), word(1, 1), word(0, 2), word(1, 2)]);
    }

    #[test]
    fn a_budget_goes_to_the_largest_differences_and_to_cheap_rays() {
        let color = grey(vec![0.0, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0, 0.0]);
        // Eight pixels' cost is 8; the edge of 1 is worth more than the edge of ½.
        assert_eq!(differing(&color, &[], (8, 1.0), (4.0, 1.0)), [word(6, 0), word(7, 0)]);
        // Now its rays cost twelve times as much.
        assert_eq!(differing(&color, &[6, 7], (8, 1.0), (4.0, 0.3)), [word(0, 0), word(1, 0)]);
    }

    #[test]
    fn a_pixel_costs_what_its_rays_do() {
        let mut costly = Costly::none([3, 2]);
        // The right part of two pixels, one above the other, of four rays each: one ray of the lower one.
        costly.find(Rectangle { first: [2, 0], size: [1, 2] }, 2, |ray| ray == 5);
        assert_eq!([2, 4, 5].map(|pixel| costly.of(pixel)), [1.0, 1.0, 1.0 + 0.25 * (TURNED - 1.0)]);
    }
}
