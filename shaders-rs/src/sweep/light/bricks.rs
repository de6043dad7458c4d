//! Bricks of the wavefront's light: the samples around places where something looks at the light, plane by plane.
//!
//! Their entries stand in a buffer of their own, for kernels that carry light, and again at the beginning of the buffer of light, for kernels that look
//! it up.

use crate::abi::wavefront::{BRICK, ENTRY, LAYER, STORED, Wavefront};
use crate::field::access::read;

/// The entry of the brick that has sample (x, y) of the planes of `layer`, or the number of words before it; −1 if there is no such brick.
#[inline(always)]
fn entry(w: &Wavefront, x: i32, y: i32, layer: i32) -> i32 {
    let shift = BRICK.trailing_zeros();
    let (i, j) = (x >> shift, y >> shift);
    let (across, up, along) = (w.bricks.x as i32, w.bricks.y as i32, w.bricks.z as i32);
    let inside = (i >= 0) & (i < across) & (j >= 0) & (j < up) & (layer >= 0) & (layer < along);
    if inside { ((layer * up + j) * across + i) * ENTRY as i32 } else { -1 }
}

/// Where a brick's samples are.
#[derive(Clone, Copy)]
pub struct Stored {
    /// The first word of its first plane.
    pub start: i32,
    /// The number of bricks on its planes; 0 if it is not stored.
    pub bricks: u32,
}

/// The brick that has sample (x, y) of the planes of `layer`.
#[inline(always)]
pub fn brick(w: &Wavefront, bricks: &[u32], x: i32, y: i32, layer: i32) -> Stored {
    let at = entry(w, x, y, layer);
    let count = read(bricks, at + 1);
    Stored { start: read(bricks, at) as i32, bricks: if at < 0 { 0 } else { count } }
}

/// The number of the place of sample (x, y) of the plane among the sums; −1 if nothing looks there.
#[inline(always)]
pub fn place(w: &Wavefront, bricks: &[u32], x: i32, y: i32) -> i32 {
    let at = entry(w, x, y, w.layer as i32);
    let number = read(bricks, at + 2) as i32;
    let within = BRICK as i32 - 1;
    let place = (number - 1) * (BRICK * BRICK) as i32 + (y & within) * BRICK as i32 + (x & within);
    if (at < 0) | (number == 0) { -1 } else { (w.wide.width * w.wide.height) as i32 + place }
}

/// The number of the place of wide sample (x, y) of the plane among the sums; −1 beyond the grid.
#[inline(always)]
pub fn wide_place(w: &Wavefront, x: i32, y: i32) -> i32 {
    let (width, height) = (w.wide.width as i32, w.wide.height as i32);
    // One beyond each side of the grid counts, too.
    let (column, row) = (x + 1, y + 1);
    let inside = (column >= 0) & (column < width) & (row >= 0) & (row < height);
    if inside { row * width + column } else { -1 }
}

/// Column and row of sample `index` of the bricks in the plane's list; a place that no grid has for one that only fills the list up.
#[inline(always)]
pub fn sample(w: &Wavefront, bricks: &[u32], index: u32) -> (i32, i32) {
    let number = index / LAYER;
    let local = index - number * LAYER;
    let row = local / STORED;
    let word = read(bricks, (w.list + number) as i32);
    let (i, j) = ((word & 0xffff) as i32, (word >> 16) as i32);
    (i * BRICK as i32 + (local - row * STORED) as i32, j * BRICK as i32 + row as i32)
}
