//! The uniform block of the probe kernel.

use super::Dispatched;
use spirv_std::glam::UVec4;

/// Uniforms of [`crate::probe::apply_function`].
#[repr(C, align(16))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct ProbeUniforms {
    /// Width and height of the dispatch, mode (always 0), the function's number (see [`crate::probe::functions`]).
    pub dispatch: UVec4,
}

impl Dispatched for ProbeUniforms {
    fn window(&self) -> UVec4 {
        UVec4::new(0, 0, self.dispatch.x, self.dispatch.y)
    }
}
