//! Surface voxelization: the voxels that triangles meet, and the attributes that triangles bring to them.

use super::fixed_point::FixedPoint;
use super::grid::Grid;
use super::items::{Plan, Slices, pass};
use super::triangles;
use super::work::Work;
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use bytemuck::cast_slice;
use rayon::prelude::*;
use std::ops::Range;
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::attributes;
use vitrum_kernels::abi::vector::Counts;
use vitrum_kernels::abi::voxelize::{VoxelizeUniforms, brought, item, pieces, triangle};
use vitrum_kernels::field::sums::to_number;
use vitrum_kernels::glam::IVec3;
use vitrum_kernels::kernel::{Kernel, kernels};
use vitrum_kernels::voxelize::place::{Place, is_tiny};

/// The mask of a grid: a bit for each voxel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mask {
    dimensions: [u32; 3],
    /// Number of words of a row along x.
    row: usize,
    words: Vec<u32>,
}

impl Mask {
    /// Whether voxel (x, y, z), which must be in the grid, is set.
    #[must_use]
    pub fn get(&self, [x, y, z]: [u32; 3]) -> bool {
        let line = z as usize * self.dimensions[1] as usize + y as usize;
        self.words[line * self.row + (x / 32) as usize] >> (x % 32) & 1 == 1
    }

    /// The bits, 32 along x in a word; each row begins with a new word.
    pub(crate) fn words(&self) -> &[u32] {
        &self.words
    }

    /// The number of voxels in the mask.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.words.par_iter().map(|word| u64::from(word.count_ones())).sum()
    }

    /// A value for each voxel, x fastest: `set` or `clear`.
    #[must_use]
    pub fn dense(&self, set: u8, clear: u8) -> Vec<u8> {
        let rows = self.words.par_chunks(self.row);
        rows.flat_map_iter(|row| {
            (0..self.dimensions[0] as usize).map(|x| if row[x / 32] >> (x % 32) & 1 == 1 { set } else { clear })
        })
        .collect()
    }

    /// Ranks: the number of voxels in the mask before each of its words, and the number of all.
    pub(crate) fn ranks(&self) -> (Vec<u32>, u64) {
        let mut sum = 0;
        let ranks = self.words.iter().map(|word| {
            let before = sum;
            sum += u64::from(word.count_ones());
            before as u32
        });
        (ranks.collect(), sum)
    }

    /// `values`, one for each voxel that is set, spread over the grid; `clear` elsewhere. As many values as [`Self::count`].
    #[must_use]
    pub fn spread<T: Copy>(&self, values: &[T], clear: T) -> Vec<T> {
        let mut values = values.iter().copied();
        let width = self.dimensions[0] as usize;
        let is_set = |row: &[u32], x: usize| row[x / 32] >> (x % 32) & 1 == 1;
        let rows = self.words.chunks(self.row);
        rows.flat_map(|row| (0..width).map(move |x| is_set(row, x)))
            .map(|set| if set { values.next().unwrap_or(clear) } else { clear })
            .collect()
    }
}

/// The attributes that triangles bring to each voxel of the mask, in the order of the voxels, x fastest.
#[derive(Debug, Clone, PartialEq)]
pub struct Attributes {
    /// The number of triangles that meet the voxel, at least 1: the paper's measure of density.
    pub counts: Vec<u32>,
    /// Sums of unit normals, one a triangle, in units of 2⁻¹⁶; 0 of triangles without area.
    pub normals: Vec<[f32; 3]>,
    /// Sums of linear colours, one a triangle, in units of 2⁻¹⁶.
    pub colors: Vec<[f32; 3]>,
    /// The largest number of a material among the triangles'; `None` if no triangle has a material.
    pub materials: Vec<Option<u32>>,
}

/// Triangles that are prepared and done together: few enough to stay in a processor's cache.
const BATCH: usize = 1 << 16;

/// Triangles that a thread prepares at a time.
const PART: usize = 1 << 11;

/// Writes the further data of a batch of triangles.
type Prepare<'a> = dyn Fn(Range<usize>, &mut dyn Backend) -> Result<(), Error> + 'a;

/// The triangles of a surface.
pub(super) struct Surface<'a> {
    mesh: &'a Mesh,
    grid: Grid,
    fixed: FixedPoint,
    uniforms: VoxelizeUniforms,
}

impl<'a> Surface<'a> {
    pub(super) fn new(mesh: &'a Mesh, grid: Grid, overlap: f32) -> Self {
        let fixed = FixedPoint::new(grid);
        let [x, y, z] = grid.dimensions;
        let overlap = (f64::from(overlap) * f64::from(1u32 << fixed.units)).ceil() as u32;
        let uniforms = VoxelizeUniforms {
            size: Counts::new(x, y, z),
            row_words: x.div_ceil(32),
            corner_units: fixed.units,
            margin: overlap,
            ..VoxelizeUniforms::default()
        };
        Self { mesh, grid, fixed, uniforms }
    }

    /// Writes the corners of `triangles` as kernels read them. The result has the triangles that are too large for the batch of small
    /// ones, by their index from the first.
    fn write_corners(&self, triangles: Range<usize>, words: &mut [u32]) -> Vec<(usize, Slices)> {
        let parts = self.mesh.triangles[triangles].par_chunks(PART).zip(words.par_chunks_mut(PART * triangle::SIZE));
        let write = |(part, (triangles, words)): (usize, (&[[u32; 3]], &mut [u32]))| {
            let mut large = Vec::new();
            for (number, (vertices, words)) in triangles.iter().zip(words.chunks_exact_mut(triangle::SIZE)).enumerate()
            {
                let corners = vertices.map(|vertex| self.fixed.position(self.mesh.positions[vertex as usize]));
                for (word, coordinate) in words.iter_mut().zip(corners.as_flattened()) {
                    *word = *coordinate as u32;
                }
                let [a, b, c] = corners.map(IVec3::from_array);
                if is_tiny(&self.uniforms, a, b, c) {
                    continue;
                }
                let place = Place::new(&self.uniforms, a, b, c);
                if !place.is_small() {
                    let slices = Slices { first: 0, count: place.slices() as u32, rows: place.rows() as u32 };
                    large.push((part * PART + number, slices));
                }
            }
            large
        };
        parts.enumerate().flat_map_iter(write).collect()
    }

    /// Prepares triangles, batch by batch, and runs a kernel with their corners, their items and the buffers `others`; `prepare` writes
    /// the further data of a batch.
    fn run(
        &self,
        kernel: &'static Kernel,
        others: &[Buffer],
        prepare: &Prepare<'_>,
        backend: &mut dyn Backend,
        work: &mut Work<'_>,
    ) -> Result<(), Error> {
        let all = self.mesh.triangles.len();
        let corners_bytes = (all.clamp(1, BATCH) * triangle::SIZE * 4) as u64;
        let corners = backend.create("corners", Contents::Zeros(corners_bytes))?;
        let no_items = backend.create("no items", Contents::Zeros(item::SIZE as u64 * 4))?;
        for first in (0..all).step_by(BATCH) {
            let triangles = first..(first + BATCH).min(all);
            let count = triangles.len();
            let mut large = Vec::new();
            backend.write(&corners, count * triangle::SIZE, &mut |words| {
                large = self.write_corners(triangles.clone(), words);
            })?;
            prepare(triangles, backend)?;
            let small = count - large.len();
            if small > 0 {
                let bound = [&[corners.clone(), no_items.clone()], others].concat();
                let passes = pass(kernel, count as u32, pieces::TRIANGLES, self.uniforms, &bound);
                work.run(backend, &passes, small as u64, small as u64)?;
            }
            if large.is_empty() {
                continue;
            }
            let pieces = large.len() as u64;
            let mut slices = vec![Slices::default(); count];
            large.into_iter().for_each(|(number, of_triangle)| slices[number] = of_triangle);
            for batch in Plan::new(&slices).batches() {
                let mut uniforms = self.uniforms;
                uniforms.first_triangle = batch.first as u32;
                let items = backend.create("items", Contents::Bytes(cast_slice(&batch.items)))?;
                let bound = [&[corners.clone(), items], others].concat();
                let passes = pass(kernel, batch.items(), pieces::ITEMS, uniforms, &bound);
                work.run(backend, &passes, 0, u64::from(batch.items()))?;
            }
            work.done += pieces;
        }
        Ok(())
    }

    /// Marks the voxels that triangles meet.
    pub(super) fn mark(&self, backend: &mut dyn Backend, work: &mut Work<'_>) -> Result<Mask, Error> {
        let Counts { y, z, .. } = self.uniforms.size;
        let row = self.uniforms.row_words;
        let bytes = u64::from(row) * u64::from(y) * u64::from(z) * 4;
        let mask = backend.create("mask of the surface", Contents::Zeros(bytes))?;
        self.run(&kernels::voxelize_mark_surface, std::slice::from_ref(&mask), &|_, _| Ok(()), backend, work)?;
        let words = backend.take(mask)?;
        Ok(Mask { dimensions: self.grid.dimensions, row: row as usize, words })
    }

    /// Sums up the attributes that triangles bring to the voxels of `mask`.
    pub(super) fn attributes(
        &self,
        mask: &Mask,
        backend: &mut dyn Backend,
        work: &mut Work<'_>,
    ) -> Result<Attributes, Error> {
        let (ranks, count) = mask.ranks();
        let mask = backend.create("mask of the surface", Contents::Bytes(cast_slice(&mask.words)))?;
        let ranks = backend.create("ranks of the mask", Contents::Bytes(cast_slice(&ranks)))?;
        let sums = backend.create("attributes", Contents::Zeros(count.max(1) * attributes::SIZE as u64 * 4))?;
        let most = self.mesh.triangles.len().clamp(1, BATCH);
        let bytes = (most * brought::SIZE * 4) as u64;
        let brought = backend.create("attributes of triangles", Contents::Zeros(bytes))?;
        let prepare = |triangles: Range<usize>, backend: &mut dyn Backend| {
            backend.write(&brought, triangles.len() * brought::SIZE, &mut |words| {
                let records = words.par_chunks_exact_mut(brought::SIZE).zip(triangles.clone());
                records.for_each(|(words, index)| {
                    words.copy_from_slice(&triangles::attributes(self.mesh, index).map(f32::to_bits));
                });
            })?;
            Ok(())
        };
        let others = [brought.clone(), mask, ranks, sums.clone()];
        self.run(&kernels::voxelize_sum_attributes, &others, &prepare, backend, work)?;
        drop(others);
        Ok(read(&backend.take(sums)?, count))
    }
}

fn read(words: &[u32], count: u64) -> Attributes {
    let records = || words.chunks_exact(attributes::SIZE).take(count as usize);
    let vectors = |from: usize| {
        let number = move |record: &[u32], at: usize| to_number(record[at], record[at + 1]) / attributes::SCALE;
        records().map(|record| [from, from + 2, from + 4].map(|at| number(record, at))).collect()
    };
    Attributes {
        counts: records().map(|record| record[attributes::COUNT]).collect(),
        normals: vectors(attributes::NORMAL),
        colors: vectors(attributes::COLOR),
        materials: records().map(|record| record[attributes::MATERIAL].checked_sub(1)).collect(),
    }
}
