//! The voxels that triangles meet, and what these bring there.

use super::grid::Grid;
use super::items::{Batch, Held, Plan, Slices, pass};
use super::{Stage, triangles};
use crate::backend::{Backend, Buffer};
use crate::render::Error;
use bytemuck::{cast_slice, pod_collect_to_vec};
use rayon::prelude::*;
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::attributes;
use vitrum_kernels::abi::voxelize::{VoxelizeUniforms, triangle};
use vitrum_kernels::field::sums::to_number;
use vitrum_kernels::glam::UVec4;
use vitrum_kernels::kernel::kernels;

/// A bit for each voxel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mask {
    dimensions: [u32; 3],
    /// Words that a row along x takes.
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

    /// How many voxels are set.
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

    /// How many voxels are set before each word; how many in all.
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

/// What triangles bring to each voxel that is set, in the order of the voxels, x fastest.
#[derive(Debug, Clone, PartialEq)]
pub struct Attributes {
    /// How many triangles meet the voxel, at least 1: the paper's measure of density.
    pub counts: Vec<u32>,
    /// Sums of unit normals, one a triangle, in units of 2⁻¹⁶; 0 of triangles without area.
    pub normals: Vec<[f32; 3]>,
    /// Sums of linear colours, one a triangle, in units of 2⁻¹⁶.
    pub colors: Vec<[f32; 3]>,
    /// The largest number of a material among the triangles'; `None` where none has one.
    pub materials: Vec<Option<u32>>,
}

/// What is uploaded of the surface.
pub(super) struct Surface<'a> {
    mesh: &'a Mesh,
    grid: Grid,
    words: Vec<[u32; triangle::SIZE]>,
    slices: Vec<Slices>,
}

impl<'a> Surface<'a> {
    pub(super) fn new(mesh: &'a Mesh, grid: Grid, overlap: f32) -> Self {
        let prepare = |index| triangles::surface(triangles::corners(mesh, grid, index), grid, f64::from(overlap));
        let words: Vec<_> = (0..mesh.triangles.len()).into_par_iter().map(prepare).collect();
        let slices = words.par_iter().map(|words| {
            let [count, rows] = triangles::slices(words);
            Slices { first: 0, count, rows }
        });
        Self { mesh, grid, slices: slices.collect(), words }
    }

    pub(super) fn plan(&self) -> Plan<'_> {
        Plan::new(&self.slices)
    }

    /// Words that a row of the mask takes.
    fn row(&self) -> u32 {
        self.grid.dimensions[0].div_ceil(32)
    }

    fn uniforms(&self) -> VoxelizeUniforms {
        let [x, y, z] = self.grid.dimensions;
        VoxelizeUniforms { size: UVec4::new(x, y, z, self.row()), ..VoxelizeUniforms::default() }
    }

    fn upload(&self, held: &mut Held<'_>, batch: &Batch) -> Result<[Buffer; 2], Error> {
        let triangles = held.create("triangles", cast_slice(&self.words[batch.first..batch.end]))?;
        Ok([triangles, held.create("items", cast_slice(&batch.items))?])
    }

    /// Marks the voxels that triangles meet. The buffer of the mask is one of `held`.
    pub(super) fn mark(
        &self,
        plan: &Plan<'_>,
        held: &mut Held<'_>,
        stage: &mut Stage<'_>,
    ) -> Result<(Mask, Buffer), Error> {
        let [_, y, z] = self.grid.dimensions.map(u64::from);
        let buffer = held.create_zeroed("mask of the surface", u64::from(self.row()) * y * z)?;
        for batch in plan.batches() {
            held.within(|held| -> Result<(), Error> {
                let [triangles, items] = self.upload(held, &batch)?;
                let bound = [triangles, items, buffer];
                let passes = pass(&kernels::voxelize_mark_surface, batch.items(), 0, self.uniforms(), &bound);
                stage.run(held.backend, &passes, u64::from(batch.items()))
            })?;
        }
        let words = pod_collect_to_vec(&held.backend.read(buffer)?);
        Ok((Mask { dimensions: self.grid.dimensions, row: self.row() as usize, words }, buffer))
    }

    /// Sums up what triangles bring to the voxels of `mask`.
    pub(super) fn attributes(
        &self,
        plan: &Plan<'_>,
        (mask, mask_buffer): (&Mask, Buffer),
        held: &mut Held<'_>,
        stage: &mut Stage<'_>,
    ) -> Result<Attributes, Error> {
        let (ranks, count) = mask.ranks();
        held.within(|held| {
            let ranks = held.create("ranks of the mask", cast_slice(&ranks))?;
            let sums = held.create_zeroed("attributes", count.max(1) * attributes::SIZE as u64)?;
            for batch in plan.batches() {
                held.within(|held| -> Result<(), Error> {
                    let [triangles, items] = self.upload(held, &batch)?;
                    let brought = (batch.first..batch.end).into_par_iter();
                    let brought: Vec<_> = brought.map(|index| triangles::attributes(self.mesh, index)).collect();
                    let brought = held.create("attributes of triangles", cast_slice(&brought))?;
                    let bound = [triangles, items, brought, mask_buffer, ranks, sums];
                    let passes = pass(&kernels::voxelize_sum_attributes, batch.items(), 0, self.uniforms(), &bound);
                    stage.run(held.backend, &passes, u64::from(batch.items()))
                })?;
            }
            read(held.backend, sums, count)
        })
    }
}

fn read(backend: &mut dyn Backend, sums: Buffer, count: u64) -> Result<Attributes, Error> {
    let words: Vec<u32> = pod_collect_to_vec(&backend.read(sums)?);
    let records = || words.chunks_exact(attributes::SIZE).take(count as usize);
    let vectors = |from: usize| {
        let number = move |record: &[u32], at: usize| to_number(record[at], record[at + 1]) / attributes::SCALE;
        records().map(|record| [from, from + 2, from + 4].map(|at| number(record, at))).collect()
    };
    Ok(Attributes {
        counts: records().map(|record| record[attributes::COUNT]).collect(),
        normals: vectors(attributes::NORMAL),
        colors: vectors(attributes::COLOR),
        materials: records().map(|record| record[attributes::MATERIAL].checked_sub(1)).collect(),
    })
}
