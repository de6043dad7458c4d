//! Refinement of a picture: the pixels that differ from their neighbours, and their new values.

use super::output::{Output, PixelFilter};
use vitrum_io::Layer;
use vitrum_kernels::sweep::place::{COLUMN_BITS, word};

/// The difference of neighbouring pixels, in displayed values (the square root of radiance up to 1, and coverage), from which on both are refined. Half
/// of it would refine half as many pixels again, for a picture that is hardly nearer to one of 64 rays a pixel.
const VISIBLE: f32 = 1.0 / 8.0;

/// The pixels of the layer `color` that differ from a neighbour, by [`word`], in squares of [`TILE`] × [`TILE`] pixels: rays of pixels that are near one
/// another run together. `exposure` is the factor with which radiance is shown.
pub(crate) fn differing(color: &Layer, [width, height]: [u32; 2], exposure: f32) -> Vec<u32> {
    let channels: Vec<Vec<f32>> =
        color.channels.iter().map(|channel| displayed(&channel.data, &channel.name, exposure)).collect();
    let differ = |a: usize, b: usize| channels.iter().any(|shown| (shown[a] - shown[b]).abs() > VISIBLE);
    let (columns, rows) = (width as usize, height as usize);
    let mut marked = vec![false; columns * rows];
    for at in 0..columns * rows {
        let mut mark = |other: usize| {
            if differ(at, other) {
                (marked[at], marked[other]) = (true, true);
            }
        };
        if at % columns + 1 < columns {
            mark(at + 1);
        }
        if at + columns < columns * rows {
            mark(at + columns);
        }
    }
    let tiles = (0..height.div_ceil(TILE)).flat_map(|row| (0..width.div_ceil(TILE)).map(move |column| (column, row)));
    let pixels = tiles.flat_map(|(column, row)| {
        let within = (0..TILE * TILE).map(move |index| (column * TILE + index % TILE, row * TILE + index / TILE));
        within.filter(|&(x, y)| x < width && y < height)
    });
    pixels.filter(|&(x, y)| marked[y as usize * columns + x as usize]).map(|(x, y)| word(x, y)).collect()
}

/// The number of a pixel, row by row, by its [`word`].
pub(crate) fn index_of(word: u32, width: u32) -> usize {
    let (column, row) = (word & ((1 << COLUMN_BITS) - 1), word >> COLUMN_BITS);
    row as usize * width as usize + column as usize
}

/// Pixels along each side of a square whose pixels follow one another.
const TILE: u32 = 16;

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

    #[test]
    fn both_sides_of_an_edge_are_refined_and_nothing_else() {
        let row = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let color = grey([row, row].concat());
        let mut pixels = differing(&color, [6, 2], 1.0);
        pixels.sort_unstable();
        assert_eq!(pixels, [word(2, 0), word(3, 0), word(2, 1), word(3, 1)]);
        assert!(differing(&color, [6, 2], 1e-6).is_empty(), "nothing is seen of it");
        assert!(differing(&grey(vec![1.0, 4.0]), [2, 1], 1.0).is_empty(), "both are white");
    }
}
