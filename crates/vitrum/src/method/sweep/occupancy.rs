//! Occupancy of bricks, for empty-space skipping: a brick without opacity, filter and gradient of η is empty.

use super::hull::hull;
use super::tables::Tables;
use super::transfer::window::Window;
use super::voxels::{brick_shift, bricks};
use crate::backend::Buffer;
use crate::method::brick_distances::spread;
use crate::method::view::point_between_voxels;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::sync::Arc;
use vitrum_io::{BrickRanges, Volume, Voxels};
use vitrum_kernels::abi::sweep::blend;
use vitrum_kernels::field::bodies::SURFACE;
use vitrum_kernels::field::tables::ior;

/// The bricks of all volumes on a backend.
#[derive(Debug, Clone)]
pub(super) struct Occupancy {
    /// A word for each brick, see [`OccupancyQuery::write_distances`], one volume after the other.
    pub(super) buffer: Buffer,
    /// Points in the world whose convex hull encloses all bricks that are not empty.
    pub(super) occupied: Arc<[DVec3]>,
}

/// The part of a volume in the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum VolumeRole {
    /// The volume's scalar gives colour, opacity, filter and index of refraction.
    Both,
    /// The volume's scalar gives colour, opacity and filter; the second volume's scalar gives the index of refraction.
    Shown,
    /// The volume's scalar gives the index of refraction.
    Bending,
    /// The volume's values are the share of bodies, 0 to 255.
    Bodies,
}

/// The least value of a voxel around which a body's surface may be.
const BODY: f32 = SURFACE * 255.0 - 1.0;

/// The least and the greatest value of a set.
type Range<T> = (T, T);

/// The least and the greatest stored value of each brick, x fastest. They stay the same while transfer functions change.
#[derive(Debug)]
pub(super) enum Ranges {
    U8(Vec<Range<u8>>),
    U16(Vec<Range<u16>>),
    F32(Vec<Range<f32>>),
}

impl Ranges {
    pub(super) fn new(volume: &Volume) -> Self {
        if let Some(paged) = &volume.paged {
            return match &paged.ranges {
                BrickRanges::U8(ranges) => Self::U8(ranges.clone()),
                BrickRanges::U16(ranges) => Self::U16(ranges.clone()),
                BrickRanges::F32(ranges) => Self::F32(ranges.clone()),
            };
        }
        let bricks = bricks(volume).map(|n| n as usize);
        let edge = 1 << brick_shift(volume);
        match &volume.voxels {
            Voxels::U8(voxels) => Self::U8(ranges(voxels, volume.dimensions, bricks, edge)),
            Voxels::U16(voxels) => Self::U16(ranges(voxels, volume.dimensions, bricks, edge)),
            Voxels::F32(voxels) => Self::F32(ranges(voxels, volume.dimensions, bricks, edge)),
        }
    }
}

impl Ranges {
    /// The range of the bricks that hold the voxels from `low` to `high`.
    pub(super) fn within(&self, volume: &Volume, low: [u32; 3], high: [u32; 3]) -> Range<f32> {
        match self {
            Self::U8(ranges) => union(ranges, volume, low, high),
            Self::U16(ranges) => union(ranges, volume, low, high),
            Self::F32(ranges) => union(ranges, volume, low, high),
        }
    }
}

fn union<T: Copy + PartialOrd>(ranges: &[Range<T>], volume: &Volume, low: [u32; 3], high: [u32; 3]) -> Range<f32>
where
    f32: From<T>,
{
    let shift = brick_shift(volume);
    let [width, height, _] = bricks(volume);
    let along = |axis: usize| low[axis] >> shift..=high[axis] >> shift;
    let rows = along(2).flat_map(|z| along(1).map(move |y| z * height + y));
    let all = rows.flat_map(|row| along(0).map(move |x| ranges[(row * width + x) as usize]));
    let whole = all.reduce(wider).unwrap_or(ranges[0]);
    (f32::from(whole.0), f32::from(whole.1))
}

/// The union of two ranges.
fn wider<T: Copy + PartialOrd>((low, high): Range<T>, (lower, higher): Range<T>) -> Range<T> {
    (if lower < low { lower } else { low }, if higher > high { higher } else { high })
}

/// A query for the bricks of a volume in which nothing can happen to a ray: the volume, its ranges and the functions over them.
pub(super) struct OccupancyQuery<'a> {
    pub(super) volume: &'a Volume,
    pub(super) ranges: &'a Ranges,
    pub(super) tables: &'a Tables,
    /// The longest step in voxels.
    pub(super) reach: u32,
    pub(super) role: VolumeRole,
    /// Whether a clipping plane or the crop box cuts through the space in which the volume bends.
    pub(super) cut: bool,
    /// The [`blend`] of a projection, to which every scalar counts.
    pub(super) blend: Option<u32>,
}

impl OccupancyQuery<'_> {
    /// Writes to `words`, x fastest, the Chebyshev distance of each brick to the nearest brick that is not empty, 0 for such a brick
    /// itself. A brick counts together with all bricks that have voxels up to `reach` + 2 beyond it: a step of `reach`, and the
    /// stencil.
    pub(super) fn write_distances(&self, words: &mut [u32]) {
        match self.ranges {
            Ranges::U8(ranges) => self.classify(ranges, words),
            Ranges::U16(ranges) => self.classify(ranges, words),
            Ranges::F32(ranges) => self.classify(ranges, words),
        }
        spread(words, bricks(self.volume).map(|n| n as usize));
    }

    /// Writes to `words`, x fastest, the bits of the largest normalised scalar in reach of each brick, or of the smallest one where the projection
    /// shows that. A mean has no use for them.
    pub(super) fn write_bounds(&self, words: &mut [u32]) {
        match self.ranges {
            Ranges::U8(ranges) => self.bound(ranges, words),
            Ranges::U16(ranges) => self.bound(ranges, words),
            Ranges::F32(ranges) => self.bound(ranges, words),
        }
    }

    fn bound<T: Copy + PartialOrd + Send + Sync>(&self, ranges: &[Range<T>], words: &mut [u32])
    where
        f32: From<T>,
    {
        let widened = self.in_reach(ranges);
        words.par_iter_mut().zip(widened).for_each(|(word, (low, high))| {
            let [lower, higher] = self.normalised(f32::from(low), f32::from(high));
            *word = if self.blend == Some(blend::MAXIMUM) { higher } else { lower }.to_bits();
        });
    }

    /// The range of each brick with all bricks that have voxels up to `reach` + 2 beyond it.
    fn in_reach<T: Copy + PartialOrd + Send + Sync>(&self, ranges: &[Range<T>]) -> Vec<Range<T>> {
        let bricks = bricks(self.volume).map(|n| n as usize);
        let beyond = (self.reach as usize + 2).div_ceil(1 << brick_shift(self.volume));
        let widened = widen(ranges, bricks, 0, beyond);
        (1..3).fold(widened, |ranges, axis| widen(&ranges, bricks, axis, beyond))
    }

    /// Points in the world whose convex hull encloses all bricks that are not empty.
    pub(super) fn occupied(&self, words: &[u32]) -> Vec<DVec3> {
        let [width, height, _] = bricks(self.volume).map(|n| n as usize);
        let edge = 1 << brick_shift(self.volume);
        let end =
            |brick: usize, axis: usize| ((brick * edge) as f64).min(f64::from(self.volume.dimensions[axis])) - 0.5;
        let layers = words.par_chunks(width * height).enumerate().map(|(z, layer)| {
            let mut around = Vec::new();
            for (y, row) in layer.chunks(width).enumerate() {
                let Some(first) = row.iter().position(|word| *word == 0) else { continue };
                let last = row.iter().rposition(|word| *word == 0).unwrap_or(first);
                let ends = [end(first, 0), end(last + 1, 0)].map(|x| [y, y + 1].map(|y| DVec2::new(x, end(y, 1))));
                around.extend(ends.as_flattened());
            }
            let corners = hull(around);
            [z, z + 1].map(|z| corners.iter().map(|corner| corner.extend(end(z, 2))).collect::<Vec<_>>()).concat()
        });
        let points: Vec<Vec<DVec3>> = layers.collect();
        points.concat().into_iter().map(|point| point_between_voxels(self.volume, point)).collect()
    }

    /// The bricks in which something looks at the light, each as the corners, in the world, of a box that holds it and a voxel around: bricks with
    /// particles and, if surfaces are `specular`, where η changes.
    pub(super) fn looked_at(&self, specular: bool) -> Vec<[DVec3; 8]> {
        match self.ranges {
            Ranges::U8(ranges) => self.looked_at_of(ranges, specular),
            Ranges::U16(ranges) => self.looked_at_of(ranges, specular),
            Ranges::F32(ranges) => self.looked_at_of(ranges, specular),
        }
    }

    fn looked_at_of<T: Copy + PartialOrd + Send + Sync>(&self, ranges: &[Range<T>], specular: bool) -> Vec<[DVec3; 8]>
    where
        f32: From<T>,
    {
        let bricks = bricks(self.volume).map(|n| n as usize);
        let edge = 1_usize << brick_shift(self.volume);
        // The stencil looks a voxel beyond the brick.
        let widened = (0..3).fold(None, |before: Option<Vec<_>>, axis| {
            Some(widen(before.as_deref().unwrap_or(ranges), bricks, axis, 1))
        });
        let widened = widened.unwrap_or_default();
        let looks = |index: usize| {
            let (low, high) = (f32::from(widened[index].0), f32::from(widened[index].1));
            let at = [index % bricks[0], index / bricks[0] % bricks[1], index / bricks[0] / bricks[1]];
            let on_border = at.iter().zip(bricks).any(|(&at, count)| at == 0 || at + 1 == count);
            if self.role == VolumeRole::Bodies {
                return high >= BODY;
            }
            let particles = self.role != VolumeRole::Bending && !self.is_without_particles(low, high);
            let changes = self.role != VolumeRole::Shown && !self.is_uniform(low, high);
            let border = (self.cut || on_border) && !self.is_like_outside(low, high);
            particles || (specular && (changes || border))
        };
        let corners = |index: usize| {
            let at = [index % bricks[0], index / bricks[0] % bricks[1], index / bricks[0] / bricks[1]];
            // A step looks at the light on its way to a sample.
            let beyond = f64::from(self.reach) + 1.0;
            std::array::from_fn(|corner: usize| {
                let end = |axis: usize| {
                    let far = corner >> axis & 1;
                    let voxel = (at[axis] + far) * edge;
                    let most = self.volume.dimensions[axis] as usize;
                    voxel.min(most) as f64 - 0.5 + if far == 1 { beyond } else { -beyond }
                };
                point_between_voxels(self.volume, DVec3::new(end(0), end(1), end(2)))
            })
        };
        (0..ranges.len()).into_par_iter().filter(|&index| looks(index)).map(corners).collect()
    }

    fn is_without_particles(&self, low: f32, high: f32) -> bool {
        let [lower, higher] = self.normalised(low, high);
        (low == high && self.tables.is_without_particles_at(self.scalar(low)))
            || self.tables.is_without_particles(lower, higher)
    }

    /// Writes to `words` 0 for a brick that is not empty, and a large number for an empty one.
    fn classify<T: Copy + PartialOrd + Send + Sync>(&self, ranges: &[Range<T>], words: &mut [u32])
    where
        f32: From<T>,
    {
        let bricks = bricks(self.volume).map(|n| n as usize);
        let farthest = bricks.iter().max().map_or(0, |&count| count as u32);
        let widened = self.in_reach(ranges);
        let edge = 1_usize << brick_shift(self.volume);
        words.par_iter_mut().zip(widened).enumerate().for_each(|(index, (word, (low, high)))| {
            let (low, high) = (f32::from(low), f32::from(high));
            // A step of `reach` that ends in the brick may have begun outside, or where light is settled, a voxel inside.
            let [x, y, z] = [index % bricks[0], index / bricks[0] % bricks[1], index / bricks[0] / bricks[1]];
            let near_border = [x, y, z]
                .iter()
                .zip(bricks)
                .any(|(&at, count)| at.min(count - 1 - at) * edge <= self.reach as usize + 1);
            let empty = self.is_empty(low, high) && (!(self.cut || near_border) || self.is_like_outside(low, high));
            *word = if empty { farthest } else { 0 };
        });
    }

    /// Whether stored values from `low` to `high` bend no light at the border of the volume: they have the index of the surroundings, 1.
    fn is_like_outside(&self, low: f32, high: f32) -> bool {
        if matches!(self.role, VolumeRole::Shown | VolumeRole::Bodies) {
            return true;
        }
        let [lower, higher] = self.normalised(low, high);
        let alike = |scalar: f32| ior(&self.tables.words, scalar) == 1.0;
        // Between equal voxels there is just this scalar, and η may rise right next to it.
        if low == high { alike(self.scalar(low)) } else { self.is_uniform(low, high) && alike(lower) && alike(higher) }
    }

    /// Whether stored values from `low` to `high` are empty: without opacity, filter and change of η.
    pub(super) fn is_empty(&self, low: f32, high: f32) -> bool {
        if self.role == VolumeRole::Bodies {
            return high < BODY;
        }
        self.blend.is_none()
            && (self.role == VolumeRole::Bending || self.is_clear(low, high))
            && (self.role == VolumeRole::Shown || self.is_uniform(low, high))
    }

    fn is_clear(&self, low: f32, high: f32) -> bool {
        let [lower, higher] = self.normalised(low, high);
        // Between equal voxels there is just this scalar, and functions may rise right next to it.
        (low == high && self.tables.is_clear_at(self.scalar(low))) || self.tables.is_clear(lower, higher)
    }

    fn is_uniform(&self, low: f32, high: f32) -> bool {
        let [lower, higher] = self.normalised(low, high);
        low == high || self.tables.is_uniform(lower, higher)
    }

    fn window(&self) -> Window {
        if self.role == VolumeRole::Bending { self.tables.bending } else { self.tables.shown }
    }

    /// The normalised scalar of a stored value, as kernels have it.
    fn scalar(&self, stored: f32) -> f32 {
        self.window().normalised_as_kernels_do(stored, self.volume)
    }

    /// The range of the normalised scalars of stored values from `low` to `high`, with a margin for the kernels' rounding.
    fn normalised(&self, low: f32, high: f32) -> [f32; 2] {
        let (a, b) = (self.scalar(low), self.scalar(high));
        // A little wider: kernels interpolate in single precision.
        [a.min(b) - 1e-5, a.max(b) + 1e-5]
    }
}

/// The range of each brick's stored voxels.
fn ranges<T: Copy + PartialOrd + Send + Sync>(
    voxels: &[T],
    dimensions: [u32; 3],
    bricks: [usize; 3],
    edge: usize,
) -> Vec<Range<T>> {
    let [width, height, depth] = dimensions.map(|n| n as usize);
    // In its place at once: parts that are put together later would be there twice.
    let mut ranges = vec![(voxels[0], voxels[0]); bricks.iter().product()];
    ranges.par_chunks_mut(bricks[0]).enumerate().for_each(|(row, ranges)| {
        let (y, z) = (row % bricks[1] * edge, row / bricks[1] * edge);
        let lines: Vec<&[T]> = (z..(z + edge).min(depth))
            .flat_map(|z| (y..(y + edge).min(height)).map(move |y| &voxels[(z * height + y) * width..][..width]))
            .collect();
        for (brick, range) in ranges.iter_mut().enumerate() {
            let (first, last) = (brick * edge, ((brick + 1) * edge).min(width));
            let (mut low, mut high) = (lines[0][first], lines[0][first]);
            for line in &lines {
                for &value in &line[first..last] {
                    low = if value < low { value } else { low };
                    high = if value > high { value } else { high };
                }
            }
            *range = (low, high);
        }
    });
    ranges
}

/// The union of each brick's range with the ranges of up to `by` bricks before and after it along `axis`.
pub(super) fn widen<T: Copy + PartialOrd + Send + Sync>(
    ranges: &[Range<T>],
    bricks: [usize; 3],
    axis: usize,
    by: usize,
) -> Vec<Range<T>> {
    let step = bricks[..axis].iter().product::<usize>();
    (0..ranges.len())
        .into_par_iter()
        .map(|index| {
            let at = index / step % bricks[axis];
            let first = index - at.min(by) * step;
            let last = index + (bricks[axis] - 1 - at).min(by) * step;
            (first..=last).step_by(step).fold(ranges[index], |range, other| wider(range, ranges[other]))
        })
        .collect()
}
