//! Light that nothing stands in the way of: the same on every plane.

use super::carrier::{Carrier, Maker};
use super::uniforms::FramePlan;
use crate::backend::{BackendError, Buffer, Pass};
use vitrum_kernels::abi::record::light;

/// The buffers of unoccluded light.
pub(super) struct Unoccluded {
    light: Buffer,
    irradiance: Buffer,
}

impl Unoccluded {
    pub(super) fn new(maker: &mut Maker<'_>) -> Result<Self, BackendError> {
        let texels = maker.plan.light_grid.size;
        Ok(Self { light: maker.planar("light", texels, light::SIZE)?, irradiance: maker.irradiance()? })
    }
}

impl Carrier for Unoccluded {
    fn start(&self, plan: &FramePlan) -> Vec<Pass> {
        plan.unoccluded(&self.light, &self.irradiance).into()
    }

    fn advance(&self, _fixed: &FramePlan, _plane: u32, _passes: &mut Vec<Pass>) {}

    fn irradiance(&self) -> &Buffer {
        &self.irradiance
    }
}
