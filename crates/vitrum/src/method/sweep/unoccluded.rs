//! Unoccluded light: the same on every plane, without passes.

use super::carrier::{BufferAllocator, Carrier};
use super::uniforms::FramePlan;
use crate::backend::{BackendError, Buffer, Pass};
use vitrum_kernels::abi::record::light;

/// The buffers of unoccluded light.
pub(super) struct Unoccluded {
    light: Buffer,
    irradiance: Buffer,
}

impl Unoccluded {
    pub(super) fn new(buffers: &mut BufferAllocator<'_>) -> Result<Self, BackendError> {
        let texels = buffers.plan.light_grid.size;
        Ok(Self { light: buffers.planar("light", texels, light::SIZE)?, irradiance: buffers.irradiance()? })
    }
}

impl Carrier for Unoccluded {
    fn start(&self, plan: &FramePlan) -> Vec<Pass> {
        plan.unoccluded(&self.light, &self.irradiance).into()
    }

    fn advance(&self, _plan: &FramePlan, _plane: u32, _passes: &mut Vec<Pass>) {}

    fn irradiance(&self) -> &Buffer {
        &self.irradiance
    }
}
