//! Light on texels: each texel follows its light back to the plane behind (semi-Lagrangian advection; sweep §4.2).

use super::carrier::{BufferAllocator, Carrier, VolumeBuffers};
use super::uniforms::FramePlan;
use super::window::VisibleLight;
use crate::backend::{BackendError, Buffer, Pass};
use vitrum_kernels::abi::record::{light, trace};
use vitrum_kernels::abi::sweep::mode;
use vitrum_kernels::kernel::{Window, kernels};

/// The buffers of light on texels.
pub(super) struct Texels {
    volumes: VolumeBuffers,
    visible: Option<VisibleLight>,
    /// Light of the plane before and of the plane: the buffers swap these roles from plane to plane.
    light: [Buffer; 2],
    filtered: Buffer,
    irradiance: Buffer,
    traced: Buffer,
}

impl Texels {
    /// The buffers of light on texels. Viewing rays read the light in the region `visible`, or anywhere if it is `None`.
    pub(super) fn new(
        buffers: &mut BufferAllocator<'_>,
        volumes: VolumeBuffers,
        visible: Option<VisibleLight>,
    ) -> Result<Self, BackendError> {
        let texels = buffers.plan.light_grid.size;
        Ok(Self {
            volumes,
            visible,
            light: [
                buffers.planar("light of even planes", texels, light::SIZE)?,
                buffers.planar("light of odd planes", texels, light::SIZE)?,
            ],
            filtered: buffers.planar(
                "filtered light",
                if buffers.plan.is_soft() { texels } else { [1, 1] },
                light::SIZE,
            )?,
            irradiance: buffers.irradiance()?,
            traced: buffers.planar("back-traced points", texels, trace::SIZE)?,
        })
    }

    fn light(&self, plane: u32) -> &Buffer {
        &self.light[plane as usize % 2]
    }
}

impl Carrier for Texels {
    fn start(&self, plan: &FramePlan) -> Vec<Pass> {
        plan.unoccluded(self.light(0), &self.irradiance).into()
    }

    fn advance(&self, plan: &FramePlan, plane: u32, passes: &mut Vec<Pass>) {
        let texels = plan.light_grid.size;
        let (behind, ahead) = (self.light(plane - 1), self.light(plane));
        let whole = Window::whole(texels[0], texels[1]);
        let window = self.visible.as_ref().map_or(whole, |visible| plan.window(visible, plane));
        let mut push = |kernel, mode, buffers: &[&Buffer]| {
            passes.push(plan.pass_over(window, kernel, texels, mode, plane, buffers));
        };
        let colors = if mode::is_clear(plan.mode) { mode::CLEAR_STRAIGHT } else { mode::STRAIGHT };
        // The light that is advected: of the plane behind, filtered where the light is soft.
        let source = if plan.is_soft() { &self.filtered } else { behind };
        if plan.is_soft() {
            push(&kernels::sweep_filter_light, colors, &[behind, &self.filtered]);
        }
        push(&kernels::sweep_trace_light, 0, &[source, &self.traced]);
        push(&kernels::sweep_gather_light, colors, &[source, &self.traced, ahead]);
        if !plan.planes.is_behind(plane) {
            let VolumeBuffers { voxels, ior_voxels, occupancy, tables } = &self.volumes;
            let bound = [voxels, ior_voxels, occupancy, tables, &self.traced, ahead];
            push(kernels::sweep_refract_light.get(plan.format), plan.mode, &bound);
        }
        passes.push(plan.concentrate(window, plane, ahead, &self.irradiance));
    }

    fn irradiance(&self) -> &Buffer {
        &self.irradiance
    }
}
