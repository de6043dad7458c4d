//! Rows of stored voxels, as floats.

use super::access::{read, read_bytes, read_halves};
use crate::abi::format::{VoxelFormat, page};
use crate::abi::grid::Grid;

/// The voxels x − 1 to x + 2 of a row, from the row's start.
#[derive(Clone, Copy)]
pub struct Columns {
    /// Where they are read: 8 bits as one word; 16 bits as words from x − 1, x and x + 1 on; floats one by one.
    at: [i32; 4],
    /// By how many bits what is read is shifted: 8 bits for each voxel; 16 bits for two voxels of each word.
    shift: [u32; 6],
}

/// The larger of two whole numbers.
#[inline(always)]
fn most(a: i32, b: i32) -> i32 {
    if a > b { a } else { b }
}

/// The smaller of two whole numbers.
#[inline(always)]
fn least(a: i32, b: i32) -> i32 {
    if a < b { a } else { b }
}

/// The numbers i − 1 to i + 2, each limited to 0…`last`, for −1 ≤ i ≤ `last`.
#[inline(always)]
pub fn neighbours(i: i32, last: i32) -> [i32; 4] {
    [most(i - 1, 0), most(i, 0), least(i + 1, last), least(i + 2, last)]
}

/// The bits before voxel `at` in a word that begins with voxel `start`.
#[inline(always)]
fn bits<const SIZE: i32>(at: i32, start: i32) -> u32 {
    ((at - start) * SIZE) as u32
}

/// The columns around x, −1 ≤ x < width: those beyond the row are its first and its last voxel.
#[inline(always)]
fn columns<V: VoxelFormat>(x: i32, width: i32) -> Columns {
    let at = neighbours(x, width - 1);
    if V::BITS == 8 {
        // Four voxels of the row; of a shorter one all, and what lies behind.
        let start = least(at[0], most(width - 4, 0));
        let shift =
            [bits::<8>(at[0], start), bits::<8>(at[1], start), bits::<8>(at[2], start), bits::<8>(at[3], start), 0, 0];
        Columns { at: [start, start, start, start], shift }
    } else if V::BITS == 16 {
        let last = most(width - 2, 0);
        let (left, middle, right) = (least(at[0], last), least(at[1], last), least(at[2], last));
        let shift = [
            bits::<16>(at[0], left),
            bits::<16>(at[1], left),
            bits::<16>(at[1], middle),
            bits::<16>(at[2], middle),
            bits::<16>(at[2], right),
            bits::<16>(at[3], right),
        ];
        Columns { at: [left, middle, right, 0], shift }
    } else {
        Columns { at, shift: [0; 6] }
    }
}

/// The columns `at` − 1 to `at` + 2 of a row that has them all.
#[inline(always)]
fn inner_columns<V: VoxelFormat>(at: i32) -> Columns {
    if V::BITS == 8 {
        Columns { at: [at - 1, at - 1, at - 1, at - 1], shift: [0, 8, 16, 24, 0, 0] }
    } else {
        Columns { at: [at - 1, at, at + 1, at + 2], shift: [0, 16, 0, 16, 0, 16] }
    }
}

/// Voxels x and x + 1 of the row that starts at `row`.
#[inline(always)]
pub fn pair<V: VoxelFormat>(voxels: &[u32], row: i32, columns: &Columns) -> (f32, f32) {
    let Columns { at, shift } = columns;
    if V::BITS == 8 {
        let word = read_bytes(voxels, row + at[0]);
        (((word >> shift[1]) & 0xff) as i32 as f32, ((word >> shift[2]) & 0xff) as i32 as f32)
    } else if V::BITS == 16 {
        let word = read_halves(voxels, row + at[1]);
        (((word >> shift[2]) & 0xffff) as i32 as f32, ((word >> shift[3]) & 0xffff) as i32 as f32)
    } else {
        (f32::from_bits(read(voxels, row + at[1])), f32::from_bits(read(voxels, row + at[2])))
    }
}

/// The words of voxels x and x + 1 of the row that starts at `row`, of a volume with a word for each voxel, beside one of 16 bits.
#[inline(always)]
pub fn words(voxels: &[u32], row: i32, columns: &Columns) -> (u32, u32) {
    let Columns { at, shift } = columns;
    (read(voxels, row + at[1] + (shift[2] >> 4) as i32), read(voxels, row + at[1] + (shift[3] >> 4) as i32))
}

/// Voxels x − 1 to x + 2 of the row that starts at `row`.
#[inline(always)]
pub fn quad<V: VoxelFormat>(voxels: &[u32], row: i32, columns: &Columns) -> (f32, f32, f32, f32) {
    let Columns { at, shift } = columns;
    if V::BITS == 8 {
        let word = read_bytes(voxels, row + at[0]);
        (
            ((word >> shift[0]) & 0xff) as i32 as f32,
            ((word >> shift[1]) & 0xff) as i32 as f32,
            ((word >> shift[2]) & 0xff) as i32 as f32,
            ((word >> shift[3]) & 0xff) as i32 as f32,
        )
    } else if V::BITS == 16 {
        let (left, right) = (read_halves(voxels, row + at[0]), read_halves(voxels, row + at[2]));
        (
            ((left >> shift[0]) & 0xffff) as i32 as f32,
            ((left >> shift[1]) & 0xffff) as i32 as f32,
            ((right >> shift[4]) & 0xffff) as i32 as f32,
            ((right >> shift[5]) & 0xffff) as i32 as f32,
        )
    } else {
        (
            f32::from_bits(read(voxels, row + at[0])),
            f32::from_bits(read(voxels, row + at[1])),
            f32::from_bits(read(voxels, row + at[2])),
            f32::from_bits(read(voxels, row + at[3])),
        )
    }
}

/// The rows around a cell: the row at y − 1 + j and z − 1 + k starts at `y[j] + z[k]`.
#[derive(Clone, Copy)]
pub struct Rows {
    /// Along x.
    pub columns: Columns,
    /// Along y.
    pub y: [i32; 4],
    /// Along z.
    pub z: [i32; 4],
}

/// Where the voxels around cell (x, y, z) are stored; −1 ≤ x < width, and so on.
#[inline(always)]
pub fn rows<V: VoxelFormat>(voxels: &[u32], grid: &Grid, x: i32, y: i32, z: i32) -> Rows {
    let (row, slice) = (grid.row_pitch, grid.slice_pitch);
    if V::PAGED {
        // Cell −1 is the first of the first page.
        let (x, y, z) = (x + 1, y + 1, z + 1);
        let (pages_x, pages_y) = (grid.pages.x as i32, grid.pages.y as i32);
        let entry = (x >> page::SHIFT) + pages_x * ((y >> page::SHIFT) + pages_y * (z >> page::SHIFT));
        let start = read(voxels, entry) as i32;
        let (x, y, z) = (x & page::MASK, y & page::MASK, z & page::MASK);
        let (first_row, first_slice) = (y * row, start + z * slice);
        Rows {
            columns: inner_columns::<V>(x + 1),
            y: [first_row, first_row + row, first_row + 2 * row, first_row + 3 * row],
            z: [first_slice, first_slice + slice, first_slice + 2 * slice, first_slice + 3 * slice],
        }
    } else {
        let (y, z) = (neighbours(y, grid.size.y as i32 - 1), neighbours(z, grid.size.z as i32 - 1));
        Rows {
            columns: columns::<V>(x, grid.size.x as i32),
            y: [y[0] * row, y[1] * row, y[2] * row, y[3] * row],
            z: [z[0] * slice, z[1] * slice, z[2] * slice, z[3] * slice],
        }
    }
}
