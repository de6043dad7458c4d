//! Which bricks are empty: neither opacity, nor medium, nor a change of η.

use super::tables::Tables;
use super::voxels::bricks;
use crate::method::brick_distances::spread;
use rayon::prelude::*;
use vitrum_io::{Volume, Voxels};
use vitrum_kernels::abi::grid::BRICK_SHIFT;

/// What a volume is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It is shown, and bends.
    Both,
    /// It is shown; another one bends.
    Shown,
    /// It bends.
    Bending,
}

/// The least and the greatest value of something.
type Range = (f32, f32);

/// The range of each brick's stored voxels, x fastest: what a volume is asked for again and again while tables change.
#[derive(Debug)]
pub(super) struct Ranges(Vec<Range>);

impl Ranges {
    pub(super) fn new(volume: &Volume) -> Self {
        let bricks = bricks(volume).map(|n| n as usize);
        Self(match &volume.voxels {
            Voxels::U8(voxels) => ranges(voxels, volume.dimensions, bricks),
            Voxels::U16(voxels) => ranges(voxels, volume.dimensions, bricks),
            Voxels::F32(voxels) => ranges(voxels, volume.dimensions, bricks),
        })
    }
}

fn union(a: Range, b: Range) -> Range {
    (a.0.min(b.0), a.1.max(b.1))
}

/// 0 for each brick in which something may happen, else how many bricks away the next such one is, x fastest. A brick counts with
/// all bricks that have voxels up to `reach` + 2 beyond it: a step of `reach`, and the stencil.
pub(super) fn classify(volume: &Volume, ranges: &Ranges, tables: &Tables, reach: u32, role: Role) -> Vec<u32> {
    let scale = volume.range[1] - volume.range[0];
    let normalise = |value: f32| {
        if scale > 0.0 { ((value - volume.range[0]) / scale).clamp(0.0, 1.0) } else { 0.0 }
    };
    let bricks = bricks(volume).map(|n| n as usize);
    let beyond = (reach as usize + 2).div_ceil(1 << BRICK_SHIFT);
    let widened = widen(&ranges.0, bricks, 0, beyond);
    let widened = (1..3).fold(widened, |ranges, axis| widen(&ranges, bricks, axis, beyond));
    let mut words: Vec<u32> = widened
        .into_par_iter()
        .map(|range| {
            let physical = |stored: f32| stored * volume.value_scale + volume.value_offset;
            let (a, b) = (physical(range.0), physical(range.1));
            // A little wider: kernels normalise in single precision.
            let (low, high) = (normalise(a.min(b)) - 1e-5, normalise(a.max(b)) + 1e-5);
            let clear = role == Role::Bending || tables.is_clear(low, high);
            let uniform = role == Role::Shown || tables.is_uniform(low, high);
            if clear && uniform { u32::MAX } else { 0 }
        })
        .collect();
    let farthest = bricks.iter().max().map_or(0, |&count| count as u32);
    words.iter_mut().for_each(|word| *word = (*word).min(farthest));
    spread(&mut words, bricks);
    words
}

/// The range of each brick's stored voxels.
fn ranges<T: Copy + PartialOrd + Sync>(voxels: &[T], dimensions: [u32; 3], bricks: [usize; 3]) -> Vec<Range>
where
    f32: From<T>,
{
    let [width, height, depth] = dimensions.map(|n| n as usize);
    let edge = 1 << BRICK_SHIFT;
    (0..bricks[1] * bricks[2])
        .into_par_iter()
        .flat_map_iter(|row| {
            let (y, z) = (row % bricks[1] * edge, row / bricks[1] * edge);
            let lines: Vec<&[T]> = (z..(z + edge).min(depth))
                .flat_map(|z| (y..(y + edge).min(height)).map(move |y| &voxels[(z * height + y) * width..][..width]))
                .collect();
            (0..bricks[0]).map(move |brick| {
                let (first, last) = (brick * edge, ((brick + 1) * edge).min(width));
                let (mut low, mut high) = (lines[0][first], lines[0][first]);
                for line in &lines {
                    for &value in &line[first..last] {
                        low = if value < low { value } else { low };
                        high = if value > high { value } else { high };
                    }
                }
                (f32::from(low), f32::from(high))
            })
        })
        .collect()
}

/// Each brick's range together with those of up to `by` bricks before and after it along `axis`.
fn widen(ranges: &[Range], bricks: [usize; 3], axis: usize, by: usize) -> Vec<Range> {
    let step = bricks[..axis].iter().product::<usize>();
    (0..ranges.len())
        .into_par_iter()
        .map(|index| {
            let at = index / step % bricks[axis];
            let first = index - at.min(by) * step;
            let last = index + (bricks[axis] - 1 - at).min(by) * step;
            (first..=last).step_by(step).fold(ranges[index], |range, other| union(range, ranges[other]))
        })
        .collect()
}
