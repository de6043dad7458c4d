//! The passes of a wavefront: from plane to plane, into bricks and onto receivers.

use super::Wavefront;
use super::bricks::Layer;
use crate::backend::{BackendError, Buffer, Contents, Pass, Write};
use crate::method::sweep::carrier::{BufferAllocator, VolumeBuffers};
use std::sync::Arc;
use vitrum_kernels::abi::dispatch::{Dispatch, Region};
use vitrum_kernels::abi::format::Format;
use vitrum_kernels::abi::record::{blurred, covered, landed, node, projected, sums};
use vitrum_kernels::abi::sweep::{SweepUniforms, mode};
use vitrum_kernels::abi::vector::Size;
use vitrum_kernels::abi::wavefront::{BRICK, BRICKS_TOGETHER, LAYER, plane_words};
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// The buffers of a wavefront.
pub(in crate::method::sweep) struct WavefrontBuffers {
    pub(super) nodes: Buffer,
    /// What blurred nodes have left, of two passes.
    pub(super) blurred: [Buffer; 2],
    projected: Buffer,
    covered: Buffer,
    bricks: Buffer,
    sums: Buffer,
    pub(super) landed: Buffer,
    /// The light that viewing rays look up.
    pub(in crate::method::sweep) light: Buffer,
}

impl Wavefront {
    /// The buffers of the wavefront.
    ///
    /// # Errors
    /// Where the backend lacks the memory.
    pub(in crate::method::sweep) fn buffers(
        &self,
        buffers: &mut BufferAllocator<'_>,
    ) -> Result<WavefrontBuffers, BackendError> {
        let [width, height] = self.frame.cells;
        let map = self.seen.map.size;
        let most = self.bricks.layers.iter().map(|layer| layer.bricks).max().unwrap_or(0).max(1);
        let bends = mode::bends(self.mode);
        let blurred = if self.seen.blur > 0.0 { [width + 1, height + 1] } else { [1, 1] };
        Ok(WavefrontBuffers {
            nodes: buffers.planar("nodes", [width + 1, height + 1], node::SIZE)?,
            blurred: [
                buffers.planar("blurred nodes", blurred, blurred::SIZE)?,
                buffers.planar("blurred nodes of the pass before", blurred, blurred::SIZE)?,
            ],
            projected: buffers.planar(
                "projected nodes",
                if bends { [width + 1, height + 1] } else { [1, 1] },
                projected::SIZE,
            )?,
            covered: buffers.planar("covered samples", if bends { [width, height] } else { [1, 1] }, covered::SIZE)?,
            bricks: buffers
                .backend
                .create("bricks of light", Contents::Bytes(bytemuck::cast_slice(&self.bricks.words)))?,
            sums: buffers.planar("sums", if bends { self.sums(most) } else { [1, 1] }, sums::SIZE)?,
            landed: buffers.planar("landed light", [map.width, map.height], landed::SIZE)?,
            // Kept from frame to frame, and so none of the buffers that each frame writes anew.
            light: buffers.backend.create("carried light", Contents::Zeros(u64::from(self.words) * 4))?,
        })
    }

    /// The size of the sums on a plane with that many bricks.
    fn sums(&self, bricks: u32) -> [u32; 2] {
        let Size { width, height } = self.seen.wide;
        let in_brick = BRICK * BRICK;
        [in_brick, width * height / in_brick + bricks]
    }

    /// The write that makes the entries of the bricks the beginning of the buffer of light.
    pub(in crate::method::sweep) fn entries(&self, buffers: &WavefrontBuffers) -> Write {
        let entries: Vec<u32> = self.bricks.words[..self.bricks.entries].to_vec();
        let words = entries.len();
        let fill = Arc::new(move |part: &mut [u32]| part.copy_from_slice(&entries));
        Write { before: 0, buffer: buffers.light.clone(), start: 0, words, fill }
    }

    /// All passes of the wavefront, and the number of the first one of each plane.
    pub(in crate::method::sweep) fn passes(
        &self,
        buffers: &WavefrontBuffers,
        volumes: &VolumeBuffers,
        format: Format,
    ) -> (Vec<Pass>, Vec<usize>) {
        let [width, height] = self.frame.cells;
        let nodes = [width + 1, height + 1];
        let VolumeBuffers { voxels, ior_voxels, occupancy, tables } = volumes;
        let none = Layer::default();
        let mut passes = vec![self.pass(&kernels::sweep_initialize_nodes, nodes, 0, 0, &none, &[&buffers.nodes])];
        let mut starts = Vec::new();
        // The plane up to which the nodes are blurred.
        let mut blurred = 0;
        for plane in 0..self.frame.planes.count {
            starts.push(if plane > 0 { passes.len() } else { 0 });
            if plane > 0 {
                let advance = kernels::sweep_advance_nodes.get(format);
                let bound = [voxels, ior_voxels, occupancy, tables, &buffers.nodes];
                passes.push(self.pass(advance, nodes, self.mode, plane, &none, &bound));
            }
            if self.is_blurred(blurred, plane) {
                self.blur([blurred, plane], buffers, &mut passes);
                blurred = plane;
            }
            self.collect(plane, buffers, &mut passes);
        }
        let last = self.frame.planes.count - 1;
        for (which, map) in self.lands() {
            self.land(which, map, last, buffers, &mut passes);
        }
        (passes, starts)
    }

    /// Appends the passes that write the light of plane `plane` to bricks.
    fn collect(&self, plane: u32, buffers: &WavefrontBuffers, passes: &mut Vec<Pass>) {
        let [width, height] = self.frame.cells;
        let stride = self.frame.stride;
        if !plane.is_multiple_of(stride) {
            return;
        }
        let kept = plane / stride;
        let number = kept / BRICK;
        let layer = |number: u32| self.bricks.layers.get(number as usize).copied().unwrap_or_default();
        let of_plane = layer(number);
        let WavefrontBuffers { nodes, projected, covered, bricks, sums, light, .. } = buffers;
        if mode::bends(self.mode) && of_plane.bricks > 0 {
            let places = self.sums(of_plane.bricks);
            passes.push(self.pass(&kernels::sweep_clear_sums, places, 0, plane, &of_plane, &[sums]));
            let project = &kernels::sweep_project_nodes;
            passes.push(self.pass(project, [width + 1, height + 1], 0, plane, &of_plane, &[nodes, projected]));
            let cover = &kernels::sweep_cover_samples;
            passes.push(self.pass(cover, [width, height], 0, plane, &of_plane, &[projected, bricks, covered]));
            let scatter = &kernels::sweep_scatter_cells;
            let chosen = if mode::is_clear(self.mode) { mode::CLEAR_CENTRAL } else { mode::CENTRAL };
            let bound = [covered, projected, bricks, sums];
            passes.push(self.pass(scatter, [width, height], chosen, plane, &of_plane, &bound));
        }
        // The first plane of a layer is the last one of the layer before, too.
        let before = if kept.is_multiple_of(BRICK) && number > 0 { layer(number - 1) } else { Layer::default() };
        for (layer, within) in [(of_plane, kept % BRICK), (before, BRICK)] {
            if layer.bricks == 0 {
                continue;
            }
            let words = self.seen.components;
            let (kernel, chosen): (&'static Kernel, _) = match (words, mode::bends(self.mode)) {
                (1, _) => (&kernels::sweep_collect_straight, mode::STRAIGHT),
                (2, _) => (&kernels::sweep_collect_clear, mode::CLEAR_CENTRAL),
                (_, false) => (&kernels::sweep_collect_light, mode::STRAIGHT),
                (_, true) => (&kernels::sweep_collect_light, mode::CENTRAL),
            };
            let size = [BRICKS_TOGETHER * LAYER, layer.bricks / BRICKS_TOGETHER];
            // Where light bends, by the samples that cells cover on the plane.
            let found = if mode::bends(self.mode) { covered } else { nodes };
            let pass = self.pass(kernel, size, chosen, plane, &layer, &[sums, found, bricks, light]);
            let start = u64::from(layer.start + within * plane_words(layer.bricks, words));
            passes.push(Pass { start, ..pass });
        }
    }

    /// A pass over `size` invocations that leads to plane `plane`, and writes to the bricks of `layer`.
    pub(super) fn pass(
        &self,
        kernel: &'static Kernel,
        [width, height]: [u32; 2],
        mode: u32,
        plane: u32,
        layer: &Layer,
        buffers: &[&Buffer],
    ) -> Pass {
        self.edited(kernel, [width, height], mode, plane, layer, buffers, |_| {})
    }

    /// As [`Self::pass`], with a uniform block that `edit` has changed.
    #[expect(clippy::too_many_arguments, reason = "all that makes a pass")]
    pub(super) fn edited(
        &self,
        kernel: &'static Kernel,
        [width, height]: [u32; 2],
        mode: u32,
        plane: u32,
        layer: &Layer,
        buffers: &[&Buffer],
        edit: impl FnOnce(&mut SweepUniforms),
    ) -> Pass {
        let planes = &self.frame.planes;
        let mut block = self.block;
        block.dispatch = Dispatch { width, height, mode };
        block.region = Region { first_column: 0, first_row: 0, end_column: width, end_row: height };
        block.step.behind = planes.depth(plane.saturating_sub(1)) as f32;
        block.step.ahead = planes.depth(plane) as f32;
        block.step.distance = planes.step(plane) as f32;
        block.step.alike = planes.alike(plane) as f32;
        block.wavefront.layer = plane / self.frame.stride / BRICK;
        block.wavefront.list = layer.list;
        block.wavefront.observed = block.step.ahead;
        edit(&mut block);
        Pass {
            kernel,
            uniforms: bytemuck::bytes_of(&block).to_vec(),
            buffers: buffers.iter().copied().cloned().collect(),
            start: 0,
            width,
            height,
            window: Window::whole(width, height),
        }
    }
}
