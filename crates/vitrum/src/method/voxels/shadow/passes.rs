//! The passes that make a shadow map, slab by slab across the light.

use super::Cast;
use super::casters::{Caster, Turned};
use crate::backend::{Backend, Buffer, Contents, Pass, PassList};
use crate::error::Error;
use crate::method::Tools;
use crate::method::voxelize::Grid;
use crate::method::voxelize::columns::{scale, slices};
use crate::method::voxelize::items::{Batch, Plan, dispatch, pass};
use crate::method::voxelize::triangles;
use crate::request::{Progress, Stage};
use crate::scene::Coefficient;
use bytemuck::{bytes_of, cast_slice};
use rayon::prelude::*;
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::abi::record::absorption;
use vitrum_kernels::abi::shadow::{ShadowUniforms, Spread, caster, mode, row_words};
use vitrum_kernels::abi::vector::Counts;
use vitrum_kernels::abi::voxelize::VoxelizeUniforms;
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// The most words of a slab's optical depths: less than any device's buffer.
const SLAB_WORDS: u64 = 1 << 24;

/// A triangle's corners in voxels.
type Corners = [[f32; 3]; 3];

/// A clear body.
struct Solid {
    corners: Vec<Corners>,
    /// log₂ of the number of units of a winding in a voxel.
    scale: u32,
    /// Optical depth of a voxel's edge inside the body, red, green and blue.
    absorption: [f32; 3],
}

/// The work on a shadow map: its casters, in voxels.
struct Work<'a> {
    grid: Grid,
    channels: u32,
    /// The first word of the map.
    first: u32,
    /// Opaque triangles, and as kernels read them.
    surface: Vec<Corners>,
    words: Vec<[f32; caster::SIZE]>,
    solids: Vec<Solid>,
    uniform: Option<u32>,
    spread: Spread,
    divergence: f32,
    progress: &'a mut (dyn FnMut(Progress) -> bool + Send),
    done: u64,
    total: u64,
}

/// An optical depth in units, limited to [`absorption::MOST`], beyond which no light is left.
fn limited(depth: f32) -> f32 {
    depth.min(absorption::MOST)
}

/// Words of a shadow map.
pub(super) fn words(grid: Grid, channels: u32) -> u64 {
    let [x, y, z] = grid.dimensions;
    u64::from(row_words(x)) * u64::from(y) * u64::from(z) * u64::from(channels)
}

/// Makes the shadow map of `cast` in a grid along the light, in `map` from word `first` on, where all is 0.
pub(super) fn run(
    cast: &Cast,
    turned: &Turned,
    grid: Grid,
    channels: u32,
    (map, first): (&Buffer, u32),
    tools: &mut Tools<'_>,
) -> Result<(), Error> {
    let Tools { backend, progress } = tools;
    let backend = &mut **backend;
    let mut work = Work::new(cast, turned, grid, channels, *progress);
    work.first = first;
    work.slabs().try_for_each(|slab| work.slab(slab, map, backend))
}

impl<'a> Work<'a> {
    fn new(
        cast: &Cast,
        turned: &Turned,
        grid: Grid,
        channels: u32,
        progress: &'a mut (dyn FnMut(Progress) -> bool + Send),
    ) -> Self {
        let divergence = super::divergence(&turned.frame, grid);
        let length = f64::from(grid.dimensions[0]);
        let in_voxels = |corners: &Vec<[[f64; 3]; 3]>| -> Vec<Corners> {
            let voxels = |at: [f64; 3]| {
                let [depth, y, z] = std::array::from_fn(|axis| (at[axis] - grid.origin[axis]) / grid.voxel_size);
                // The place whose depth it is (see `vitrum_kernels::voxelize::columns::depth`).
                [depth * (1.0 + divergence * length) / (1.0 + divergence * depth), y, z]
            };
            corners.par_iter().map(|corners| triangles::solid(corners.map(voxels), grid)).collect()
        };
        let (mut surface, mut words, mut solids) = (Vec::new(), Vec::new(), Vec::new());
        for (caster, corners) in cast.casters.iter().zip(&turned.bodies).filter(|(caster, _)| !caster.is_nothing()) {
            let corners = in_voxels(corners);
            match caster {
                Caster::Surface(depth) => {
                    words.extend(corners.iter().map(|corners| {
                        let mut floats = [limited(*depth); caster::SIZE];
                        floats[caster::CORNERS..][..9].copy_from_slice(corners.as_flattened());
                        floats
                    }));
                    surface.extend(corners);
                }
                Caster::Solid(coefficient) => {
                    let absorption = coefficient.map(|a_unit| limited((a_unit * grid.voxel_size) as f32));
                    let most = absorption.iter().copied().fold(0.0, f32::max);
                    let absorption = if channels == 1 { [most; 3] } else { absorption };
                    solids.push(Solid { scale: scale(corners.len()), corners, absorption });
                }
            }
        }
        let units = |depth: f32| (f64::from(limited(depth)) * f64::from(absorption::SCALE)).round() as u32;
        let uniform = (cast.coefficient == Coefficient::Uniform).then(|| units(cast.absorption));
        let mut work = Self {
            grid,
            channels,
            first: 0,
            surface,
            words,
            solids,
            uniform,
            spread: super::spread(&turned.frame, grid),
            divergence: divergence as f32,
            progress,
            done: 0,
            total: 0,
        };
        work.total = work.slabs().len() as u64 * (2 + 2 * work.solids.len() as u64);
        work
    }

    /// The first layer of each slab, and its number of layers.
    fn slabs(&self) -> std::vec::IntoIter<[u32; 2]> {
        let [x, y, z] = self.grid.dimensions;
        let layer = u64::from(x) * u64::from(y) * u64::from(self.channels) * absorption::SIZE as u64;
        let layers = (SLAB_WORDS / layer).clamp(1, u64::from(z)) as u32;
        let slabs: Vec<[u32; 2]> =
            (0..z).step_by(layers as usize).map(|first| [first, layers.min(z - first)]).collect();
        slabs.into_iter()
    }

    /// Runs a pass of `count` invocations.
    fn pass(
        &mut self,
        kernel: &'static Kernel,
        count: u32,
        block: ShadowUniforms,
        buffers: Vec<Buffer>,
        backend: &mut dyn Backend,
    ) -> Result<(), Error> {
        let [width, height] = dispatch(count);
        let dispatch = Dispatch { width, height, ..block.dispatch };
        let block = ShadowUniforms { dispatch, work: count, ..block };
        let pass = Pass {
            kernel,
            uniforms: bytes_of(&block).to_vec(),
            buffers,
            width,
            height,
            start: 0,
            window: Window::whole(width, height),
        };
        self.run(&PassList { passes: vec![pass], ..PassList::default() }, backend)
    }

    fn run(&mut self, passes: &PassList, backend: &mut dyn Backend) -> Result<(), Error> {
        let (progress, done, total) = (&mut *self.progress, self.done, self.total);
        Ok(backend.run(passes, &mut |_| progress(Progress { stage: Stage::Shadow, done: done.min(total), total }))?)
    }

    /// Computes one slab and writes it to the map.
    fn slab(&mut self, [first, layers]: [u32; 2], map: &Buffer, backend: &mut dyn Backend) -> Result<(), Error> {
        let [x, y, z] = self.grid.dimensions;
        let rows = y * layers;
        let words = u64::from(x) * u64::from(rows) * u64::from(self.channels) * absorption::SIZE as u64;
        let depths = backend.create("optical depths", Contents::Zeros(words * 4))?;
        let block = ShadowUniforms {
            width: x,
            height: y,
            layers,
            first_layer: first,
            first_word: self.first,
            depth: z,
            channels: self.channels,
            uniform_depth: self.uniform.unwrap_or(0),
            spread: self.spread,
            divergence: self.divergence,
            ..ShadowUniforms::default()
        };
        let slices = slices(&self.surface, 0, [first, layers]);
        for batch in Plan::new(&slices).batches() {
            let words = Contents::Bytes(cast_slice(&self.words[batch.first..batch.end]));
            let casters = backend.create("casters", words)?;
            let items = backend.create("items", Contents::Bytes(cast_slice(&batch.items)))?;
            let buffers = vec![casters, items, depths.clone()];
            self.pass(&kernels::shadow_count_crossings, batch.items(), block, buffers, backend)?;
        }
        self.done += 1;
        for index in 0..self.solids.len() {
            self.solid(index, block, &depths, backend)?;
        }
        let mode = if self.uniform.is_some() { mode::UNIFORM } else { mode::COUNTED };
        let block = ShadowUniforms { dispatch: Dispatch { mode, ..Dispatch::default() }, ..block };
        self.pass(&kernels::shadow_accumulate, rows * self.channels, block, vec![depths, map.clone()], backend)?;
        self.done += 1;
        Ok(())
    }

    /// Adds the absorption of clear body number `index` to a slab.
    fn solid(
        &mut self,
        index: usize,
        block: ShadowUniforms,
        depths: &Buffer,
        backend: &mut dyn Backend,
    ) -> Result<(), Error> {
        let ShadowUniforms { width: x, height: y, layers, first_layer: first, .. } = block;
        let scale = self.solids[index].scale;
        let bytes = u64::from(x + 1) * u64::from(y * layers) * 4;
        let changes = backend.create("changes of the winding", Contents::Zeros(bytes))?;
        let slices = slices(&self.solids[index].corners, 0, [first, layers]);
        let uniforms = VoxelizeUniforms {
            size: Counts::new(x, y, layers),
            row_words: x + 1,
            first_layer: first,
            column_units: scale,
            voxel_units: scale,
            divergence: self.divergence,
            ..VoxelizeUniforms::default()
        };
        for batch in Plan::new(&slices).batches() {
            let Batch { first, end, items: words } = &batch;
            let corners = Contents::Bytes(cast_slice(&self.solids[index].corners[*first..*end]));
            let corners = backend.create("corners", corners)?;
            let items = backend.create("items", Contents::Bytes(cast_slice(words)))?;
            let bound = [corners, items, changes.clone()];
            self.run(&pass(&kernels::voxelize_cross_columns, batch.items(), 0, uniforms, &bound), backend)?;
        }
        let absorption = self.solids[index].absorption.into();
        let block = ShadowUniforms { absorption, winding_units: scale, ..block };
        self.pass(&kernels::shadow_absorb_solid, y * layers, block, vec![changes, depths.clone()], backend)?;
        self.done += 2;
        Ok(())
    }
}
