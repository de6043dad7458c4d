//! Transport of light from plane to plane: on texels (sweep §4.2), or none for unoccluded light.

use super::uniforms::FramePlan;
use crate::backend::{Backend, BackendError, Buffer, Pass};
use crate::method::cache::{Label, Scratch};
use vitrum_kernels::abi::sweep::SweepUniforms;
use vitrum_kernels::kernel::{Kernel, Window, kernels};

/// Transport of light from the first plane to the last, as passes.
pub(super) trait Carrier {
    /// The passes for the light on the first plane.
    fn start(&self, plan: &FramePlan) -> Vec<Pass>;

    /// Appends the passes that carry light from the plane before `plane` to `plane`.
    fn advance(&self, plan: &FramePlan, plane: u32, passes: &mut Vec<Pass>);

    /// The buffer with the irradiance of the latest planes, laid out as [`FramePlan::ring`]: records as
    /// [`irradiance`](vitrum_kernels::abi::record::irradiance) describes.
    fn irradiance(&self) -> &Buffer;
}

/// The buffers that describe the volume.
#[derive(Clone)]
pub(super) struct VolumeBuffers {
    pub(super) voxels: Buffer,
    pub(super) ior_voxels: Buffer,
    pub(super) occupancy: Buffer,
    pub(super) tables: Buffer,
}

/// The allocator of the buffers of a frame: on the backend, or left by the frame before.
pub(super) struct BufferAllocator<'a> {
    pub(super) plan: &'a FramePlan,
    pub(super) scratch: &'a mut Scratch,
    pub(super) backend: &'a mut dyn Backend,
}

impl BufferAllocator<'_> {
    /// A planar buffer of records, or one of sums.
    pub(super) fn planar(
        &mut self,
        label: impl Into<Label>,
        records: [u32; 2],
        words: usize,
    ) -> Result<Buffer, BackendError> {
        let bytes = u64::from(records[0]) * u64::from(records[1]) * words as u64 * 4;
        self.scratch.zeros(label, bytes, self.backend)
    }

    /// A buffer for the irradiance of as many planes as the ring holds.
    pub(super) fn irradiance(&mut self) -> Result<Buffer, BackendError> {
        let words = self.plan.ring().words() * u64::from(self.plan.ring().planes);
        self.scratch.zeros("irradiance", words * 4, self.backend)
    }
}

impl FramePlan {
    /// Passes that fill `light` and `irradiance` with the unoccluded light of the first plane.
    pub(super) fn unoccluded(&self, light: &Buffer, irradiance: &Buffer) -> [Pass; 2] {
        let texels = self.light_grid.size;
        [
            self.pass(&kernels::sweep_initialize_light, texels, 0, 0, &[light]),
            self.concentrate(Window::whole(texels[0], texels[1]), 0, light, irradiance),
        ]
    }

    /// The pass that computes the irradiance of plane `plane` from its light.
    pub(super) fn concentrate(&self, window: Window, plane: u32, light: &Buffer, irradiance: &Buffer) -> Pass {
        let texels = self.light_grid.size;
        let pass = self.pass_over(window, &kernels::sweep_concentrate_light, texels, 0, plane, &[light, irradiance]);
        Pass { start: self.ring().start(plane), ..pass }
    }

    /// A pass over `size` invocations that leads to plane `plane`.
    pub(super) fn pass(
        &self,
        kernel: &'static Kernel,
        size: [u32; 2],
        mode: u32,
        plane: u32,
        buffers: &[&Buffer],
    ) -> Pass {
        self.pass_over(Window::whole(size[0], size[1]), kernel, size, mode, plane, buffers)
    }

    /// A pass over a part of `size` invocations that leads to plane `plane`.
    pub(super) fn pass_over(
        &self,
        window: Window,
        kernel: &'static Kernel,
        size: [u32; 2],
        mode: u32,
        plane: u32,
        buffers: &[&Buffer],
    ) -> Pass {
        self.pass_of(&self.block(size, window, mode, plane), kernel, (size, window), buffers)
    }

    /// A pass of that uniform block.
    fn pass_of(
        &self,
        block: &SweepUniforms,
        kernel: &'static Kernel,
        (size, window): ([u32; 2], Window),
        buffers: &[&Buffer],
    ) -> Pass {
        Pass {
            kernel,
            uniforms: bytemuck::bytes_of(block).to_vec(),
            buffers: buffers.iter().copied().cloned().collect(),
            start: 0,
            width: size[0],
            height: size[1],
            window,
        }
    }

    /// The pass in which all viewing rays set out, each from its place on the picture.
    pub(super) fn initialize(&self, buffers: &[&Buffer]) -> Pass {
        let whole = Window::whole(self.rays[0], self.rays[1]);
        // Of a tile each ray is listed, and yet rays beside one another are on the picture, too.
        let block =
            SweepUniforms { refined: self.listed(), ..self.block(self.rays, whole, 0, self.planes.first_visible) };
        self.pass_of(&block, &kernels::sweep_initialize_rays, (self.rays, whole), buffers)
    }
}
