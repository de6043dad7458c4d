//! Solid voxelization: the coverage of each voxel by the inside of the surface.

use super::grid::Grid;
use super::items::{Batch, Plan, Slices, pass};
use super::settings::FillRule;
use super::work::Work;
use super::{columns, triangles};
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use crate::unrenderable::Unrenderable;
use bytemuck::{cast_slice, pod_collect_to_vec};
use rayon::prelude::*;
use vitrum_io::Mesh;
use vitrum_kernels::abi::vector::Counts;
use vitrum_kernels::abi::voxelize::{VoxelizeUniforms, mode};
use vitrum_kernels::kernel::kernels;

/// log₂ of the columns through a voxel along y, and along z. A face across y or z is off by up to half of their distance: with 2 × 2
/// columns, not 4 × 4, a plate in a grid of 128 had lost half a percent.
const COLUMNS: u32 = 2;

/// Words of changes that a slab has at most, so that a processor's cache holds them.
const CACHED_WORDS: u64 = 1 << 21;

/// The most words of a slab's changes, less than any device's buffer.
const MOST_WORDS: u64 = 1 << 24;

/// Least number of words of a slab for each triangle: every slab tests all triangles, which should take less time than its voxels.
const WORDS_PER_TRIANGLE: u64 = 64;

/// The coverage of voxels by the inside of a surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solid {
    /// The coverage of each voxel, x fastest, in 255ths: 0 is a voxel outside, 255 one inside.
    pub coverage: Vec<u8>,
    /// Rows of voxels along x that go through a hole of the surface, so that the winding at their end differs from 0. They are left
    /// empty.
    pub open_rows: u64,
}

impl Solid {
    /// The volume of the inside, in voxels.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let sum: u64 = self.coverage.par_iter().map(|&coverage| u64::from(coverage)).sum();
        sum as f64 / 255.0
    }
}

/// The buffers of a slab.
pub(super) struct Slab {
    changes: Buffer,
    coverage: Buffer,
}

/// The triangles of a solid, and the work on them.
pub(super) struct Body {
    grid: Grid,
    corners: Vec<[[f32; 3]; 3]>,
    /// log₂ of the units that a column has along a voxel.
    scale: u32,
    rule: FillRule,
}

impl Body {
    /// # Errors
    /// Where there are more triangles than the sums' units allow.
    pub(super) fn new(mesh: &Mesh, grid: Grid, rule: FillRule) -> Result<Self, Error> {
        let count = mesh.triangles.len();
        let scale = columns::scale(count)
            .checked_sub(2 * COLUMNS)
            .ok_or_else(|| Unrenderable::TooManyToFill { name: mesh.name.clone(), count })?;
        let corners = (0..count).into_par_iter();
        let corners = corners.map(|index| triangles::solid(triangles::corners(mesh, grid, index), grid)).collect();
        Ok(Self { grid, corners, scale, rule })
    }

    /// Layers of a slab.
    fn layers(&self) -> u32 {
        let [x, y, z] = self.grid.dimensions;
        let layer = (u64::from(x) + 1) * u64::from(y);
        let all = layer * u64::from(z);
        let few = (self.corners.len() as u64 * WORDS_PER_TRIANGLE).clamp(CACHED_WORDS, MOST_WORDS);
        let words = if all > MOST_WORDS { few } else { all };
        (words / layer).clamp(1, u64::from(z)) as u32
    }

    /// The first layer of each slab, and its number of layers.
    pub(super) fn slabs(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let (layers, end) = (self.layers(), self.grid.dimensions[2]);
        (0..end).step_by(layers as usize).map(move |first| [first, layers.min(end - first)])
    }

    /// For each triangle, the rows of columns of a slab that may cross it.
    pub(super) fn slices(&self, slab: [u32; 2]) -> Vec<Slices> {
        columns::slices(&self.corners, COLUMNS, slab)
    }

    fn uniforms(&self, [first, layers]: [u32; 2], row: u32) -> VoxelizeUniforms {
        let [x, y, _] = self.grid.dimensions;
        VoxelizeUniforms {
            size: Counts::new(x, y, layers),
            row_words: row,
            column_shift: COLUMNS,
            first_layer: first,
            column_units: self.scale,
            voxel_units: self.scale + 2 * COLUMNS,
            ..VoxelizeUniforms::default()
        }
    }

    /// The buffers for the changes of a slab, which all slabs share.
    pub(super) fn buffers(&self, backend: &mut dyn Backend) -> Result<Slab, Error> {
        let [x, y, _] = self.grid.dimensions;
        let rows = u64::from(y) * u64::from(self.layers());
        Ok(Slab {
            changes: backend.create("changes of the winding", Contents::Zeros(u64::from(x + 1) * rows * 4))?,
            coverage: backend.create("coverage", Contents::Zeros((u64::from(x.div_ceil(4)) * rows + 1) * 4))?,
        })
    }

    /// Fills one slab, writing to `solid`.
    pub(super) fn fill(
        &self,
        slab: [u32; 2],
        plan: &Plan<'_>,
        Slab { changes, coverage }: &Slab,
        backend: &mut dyn Backend,
        work: &mut Work<'_>,
        solid: &mut Solid,
    ) -> Result<(), Error> {
        let [x, y, _] = self.grid.dimensions;
        let rows = y * slab[1];
        if slab[0] > 0 {
            backend.clear(changes)?;
            backend.clear(coverage)?;
        }
        for batch in plan.batches() {
            self.cross(slab, &batch, changes, backend, work)?;
        }
        let row = x.div_ceil(4);
        let rule = match self.rule {
            FillRule::Nonzero => mode::NONZERO,
            FillRule::EvenOdd => mode::EVEN_ODD,
        };
        let passes = pass(
            &kernels::voxelize_fill_rows,
            rows,
            rule,
            self.uniforms(slab, row),
            &[changes.clone(), coverage.clone()],
        );
        work.run(backend, &passes, 0, 0)?;
        let (row, x) = (4 * row as usize, x as usize);
        let written = u64::from(rows) * row as u64;
        let target = &mut solid.coverage[slab[0] as usize * y as usize * x..][..rows as usize * x];
        let open_rows = &mut solid.open_rows;
        backend.read(coverage, 0..written + 4, &mut |bytes| {
            let (bytes, open) = bytes.split_at(written as usize);
            *open_rows += u64::from(pod_collect_to_vec::<u8, u32>(open)[0]);
            let layers = target.par_chunks_mut(x * y as usize).zip(bytes.par_chunks(row * y as usize));
            layers.for_each(|(to, from)| {
                to.chunks_exact_mut(x)
                    .zip(from.chunks_exact(row))
                    .for_each(|(to, from)| to.copy_from_slice(&from[..x]));
            });
        })?;
        Ok(())
    }

    fn cross(
        &self,
        slab: [u32; 2],
        batch: &Batch,
        changes: &Buffer,
        backend: &mut dyn Backend,
        work: &mut Work<'_>,
    ) -> Result<(), Error> {
        let corners = backend.create("corners", Contents::Bytes(cast_slice(&self.corners[batch.first..batch.end])))?;
        let items = backend.create("items", Contents::Bytes(cast_slice(&batch.items)))?;
        let uniforms = self.uniforms(slab, self.grid.dimensions[0] + 1);
        let bound = [corners, items, changes.clone()];
        let passes = pass(&kernels::voxelize_cross_columns, batch.items(), 0, uniforms, &bound);
        let items = u64::from(batch.items());
        work.run(backend, &passes, items, items)
    }
}
