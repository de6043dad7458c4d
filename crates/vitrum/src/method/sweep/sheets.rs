//! Light as sheets of rays: carried forward, then scattered onto each plane, so that any number of directions may cross a point.
//!
//! None of the plane sweep's published kin does this: they keep one direction a texel, which cannot say what a focus leaves behind.

use super::carrier::{Carrier, Maker, VolumeBuffers, bytes};
use super::uniforms::Fixed;
use crate::backend::{BackendError, Buffer, Pass};
use vitrum_kernels::abi::record::{light, sheet, sums};
use vitrum_kernels::abi::sweep::mode;
use vitrum_kernels::kernel::{Window, kernels};

/// The buffers of sheets.
pub(super) struct Sheets {
    volumes: VolumeBuffers,
    groups: Vec<Group>,
    sums: Buffer,
    light: Buffer,
    irradiance: Buffer,
}

/// Sheets whose nodes lie in one buffer: as many as the largest buffer of the device takes. All groups add to the same sums, which are
/// integers, so that the light does not depend on how sheets are grouped.
struct Group {
    count: u32,
    sources: Buffer,
    nodes: Buffer,
}

impl Sheets {
    pub(super) fn new(
        maker: &mut Maker<'_>,
        volumes: VolumeBuffers,
        sources: &[[f32; 3]],
    ) -> Result<Self, BackendError> {
        let texels = maker.fixed.light_grid.size;
        let most = maker.backend.largest_buffer() / bytes(nodes(texels, 1), sheet::SIZE);
        // A single sheet beyond the limit is the backend's to refuse, by name and size.
        let groups = sources.chunks(most.clamp(1, sources.len().max(1) as u64) as usize).enumerate();
        let groups = groups.map(|(number, sources)| Group::new(maker, number, sources)).collect::<Result<_, _>>()?;
        Ok(Self {
            volumes,
            groups,
            sums: maker.planar("sums", texels, sums::SIZE)?,
            light: maker.planar("light", texels, light::SIZE)?,
            irradiance: maker.irradiance()?,
        })
    }
}

impl Group {
    fn new(maker: &mut Maker<'_>, number: usize, sources: &[[f32; 3]]) -> Result<Self, BackendError> {
        let (texels, count) = (maker.fixed.light_grid.size, sources.len() as u32);
        Ok(Self {
            count,
            sources: maker.floats("directions of sheets", sources.as_flattened())?,
            nodes: maker.planar_of_several("sheets", number, nodes(texels, count), sheet::SIZE)?,
        })
    }
}

/// Nodes across, and up over all sheets.
fn nodes(texels: [u32; 2], count: u32) -> [u32; 2] {
    [texels[0] + 1, (texels[1] + 1) * count]
}

impl Carrier for Sheets {
    fn start(&self, fixed: &Fixed) -> Vec<Pass> {
        let mut passes = Vec::from(fixed.unoccluded(&self.light, &self.irradiance));
        passes.extend(self.groups.iter().map(|Group { count, sources, nodes: buffer }| {
            let nodes = nodes(fixed.light_grid.size, *count);
            fixed.pass(&kernels::sweep_initialize_sheet, nodes, 0, 0, &[sources, buffer])
        }));
        passes
    }

    fn advance(&self, fixed: &Fixed, plane: u32, passes: &mut Vec<Pass>) {
        let texels = fixed.light_grid.size;
        let [width, height] = texels;
        let mut push =
            |kernel, size, mode, buffers: &[&Buffer]| passes.push(fixed.pass(kernel, size, mode, plane, buffers));
        let VolumeBuffers { voxels, ior_voxels, occupancy, tables } = &self.volumes;
        for Group { count, sources, nodes: buffer } in &self.groups {
            push(
                kernels::sweep_advance_sheet.get(fixed.format),
                nodes(texels, *count),
                mode::any_medium(fixed.mode),
                &[voxels, ior_voxels, occupancy, tables, sources, buffer],
            );
        }
        push(&kernels::sweep_clear_sums, texels, 0, &[&self.sums]);
        for Group { count, sources, nodes } in &self.groups {
            push(&kernels::sweep_scatter_sheet, [width, height * count], 0, &[nodes, sources, &self.sums]);
        }
        push(&kernels::sweep_collect_light, texels, 0, &[&self.sums, &self.light]);
        passes.push(fixed.concentrate(Window::whole(width, height), plane, &self.light, &self.irradiance));
    }

    fn irradiance(&self) -> &Buffer {
        &self.irradiance
    }
}
