//! Light as sheets of rays: carried forward, then scattered onto each plane, so that any number of directions may cross a point.
//!
//! None of the plane sweep's published kin does this: they keep one direction a texel, which cannot say what a focus leaves behind.

use super::carrier::{Carrier, Maker, VolumeBuffers};
use super::uniforms::Fixed;
use crate::backend::{BackendError, Buffer, Pass};
use vitrum_kernels::abi::record::{light, sheet, sums};
use vitrum_kernels::abi::sweep::mode;
use vitrum_kernels::kernel::{Window, kernels};

/// The buffers of sheets.
pub(super) struct Sheets {
    volumes: VolumeBuffers,
    count: u32,
    sources: Buffer,
    nodes: Buffer,
    sums: Buffer,
    light: Buffer,
    irradiance: Buffer,
}

impl Sheets {
    pub(super) fn new(
        maker: &mut Maker<'_>,
        volumes: VolumeBuffers,
        sources: &[[f32; 3]],
    ) -> Result<Self, BackendError> {
        let texels = maker.fixed.light_grid.size;
        let count = sources.len() as u32;
        Ok(Self {
            volumes,
            count,
            sources: maker.floats("directions of sheets", sources.as_flattened())?,
            nodes: maker.planar("sheets", nodes(texels, count), sheet::SIZE)?,
            sums: maker.planar("sums", texels, sums::SIZE)?,
            light: maker.planar("light", texels, light::SIZE)?,
            irradiance: maker.irradiance()?,
        })
    }
}

/// Nodes across, and up over all sheets.
fn nodes(texels: [u32; 2], count: u32) -> [u32; 2] {
    [texels[0] + 1, (texels[1] + 1) * count]
}

impl Carrier for Sheets {
    fn start(&self, fixed: &Fixed) -> Vec<Pass> {
        let nodes = nodes(fixed.light_grid.size, self.count);
        let mut passes = Vec::from(fixed.unoccluded(&self.light, &self.irradiance));
        passes.push(fixed.pass(&kernels::sweep_initialize_sheet, nodes, 0, 0, &[&self.sources, &self.nodes]));
        passes
    }

    fn advance(&self, fixed: &Fixed, plane: u32, passes: &mut Vec<Pass>) {
        let texels = fixed.light_grid.size;
        let [width, height] = texels;
        let cells = [width, height * self.count];
        let mut push =
            |kernel, size, mode, buffers: &[&Buffer]| passes.push(fixed.pass(kernel, size, mode, plane, buffers));
        let VolumeBuffers { voxels, ior_voxels, occupancy, tables } = &self.volumes;
        let bound = [voxels, ior_voxels, occupancy, tables, &self.sources, &self.nodes];
        push(
            kernels::sweep_advance_sheet.get(fixed.format),
            nodes(texels, self.count),
            mode::any_medium(fixed.mode),
            &bound,
        );
        push(&kernels::sweep_clear_sums, texels, 0, &[&self.sums]);
        push(&kernels::sweep_scatter_sheet, cells, 0, &[&self.nodes, &self.sources, &self.sums]);
        push(&kernels::sweep_collect_light, texels, 0, &[&self.sums, &self.light]);
        passes.push(fixed.concentrate(Window::whole(width, height), plane, &self.light, &self.irradiance));
    }

    fn irradiance(&self) -> &Buffer {
        &self.irradiance
    }
}
