//! Light as sheets of rays: carried forward, then scattered onto each plane, so that any number of directions may cross a point.
//!
//! None of the plane sweep's published kin does this: they keep one direction a texel, which cannot say what a focus leaves behind.

use super::carrier::{BufferAllocator, Carrier, VolumeBuffers};
use super::uniforms::FramePlan;
use crate::backend::{BackendError, Buffer, Pass};
use vitrum_kernels::abi::record::{light, sheet, sums};
use vitrum_kernels::abi::sweep::mode;
use vitrum_kernels::kernel::{Window, kernels};

/// The buffers of sheets.
pub(super) struct Sheets {
    volumes: VolumeBuffers,
    batches: Vec<Batch>,
    sums: Buffer,
    light: Buffer,
    irradiance: Buffer,
}

/// As many sheets as fit one buffer. Their contributions to a texel are summed up in integers, so that the division into batches
/// changes no bit.
struct Batch {
    /// Number of sheets.
    count: u32,
    sources: Buffer,
    nodes: Buffer,
}

impl Sheets {
    pub(super) fn new(
        buffers: &mut BufferAllocator<'_>,
        volumes: VolumeBuffers,
        sources: &[[f32; 3]],
    ) -> Result<Self, BackendError> {
        let texels = buffers.plan.light_grid.size;
        let one = nodes(texels, 1).map(u64::from).iter().product::<u64>() * sheet::SIZE as u64 * 4;
        let most = (buffers.backend.largest_buffer() / one).clamp(1, sources.len() as u64) as usize;
        let mut batches = Vec::new();
        for (number, sources) in sources.chunks(most).enumerate() {
            let count = sources.len() as u32;
            batches.push(Batch {
                count,
                sources: buffers.floats("directions of sheets", sources.as_flattened())?,
                nodes: buffers.planar(("sheets", number), nodes(texels, count), sheet::SIZE)?,
            });
        }
        Ok(Self {
            volumes,
            batches,
            sums: buffers.planar("sums", texels, sums::SIZE)?,
            light: buffers.planar("light", texels, light::SIZE)?,
            irradiance: buffers.irradiance()?,
        })
    }
}

/// Number of nodes across, and up over all sheets.
fn nodes(texels: [u32; 2], count: u32) -> [u32; 2] {
    [texels[0] + 1, (texels[1] + 1) * count]
}

impl Carrier for Sheets {
    fn start(&self, plan: &FramePlan) -> Vec<Pass> {
        let mut passes = Vec::from(plan.unoccluded(&self.light, &self.irradiance));
        for Batch { count, sources, nodes: sheets } in &self.batches {
            let nodes = nodes(plan.light_grid.size, *count);
            passes.push(plan.pass(&kernels::sweep_initialize_sheet, nodes, 0, 0, &[sources, sheets]));
        }
        passes
    }

    fn advance(&self, plan: &FramePlan, plane: u32, passes: &mut Vec<Pass>) {
        let texels = plan.light_grid.size;
        let [width, height] = texels;
        let mut push =
            |kernel, size, mode, buffers: &[&Buffer]| passes.push(plan.pass(kernel, size, mode, plane, buffers));
        let VolumeBuffers { voxels, ior_voxels, occupancy, tables } = &self.volumes;
        for Batch { count, sources, nodes: sheets } in &self.batches {
            push(
                kernels::sweep_advance_sheet.get(plan.format),
                nodes(texels, *count),
                mode::any_medium(plan.mode),
                &[voxels, ior_voxels, occupancy, tables, sources, sheets],
            );
        }
        push(&kernels::sweep_clear_sums, texels, 0, &[&self.sums]);
        for Batch { count, sources, nodes } in &self.batches {
            push(&kernels::sweep_scatter_sheet, [width, height * count], 0, &[nodes, sources, &self.sums]);
        }
        push(&kernels::sweep_collect_light, texels, 0, &[&self.sums, &self.light]);
        passes.push(plan.concentrate(Window::whole(width, height), plane, &self.light, &self.irradiance));
    }

    fn irradiance(&self) -> &Buffer {
        &self.irradiance
    }
}
