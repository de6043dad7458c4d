//! The uniform block of the probe kernel.

use super::Dispatched;
use super::dispatch::Dispatch;

/// Uniforms of [`crate::probe::apply_function`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct ProbeUniforms {
    /// Size of the dispatch.
    pub dispatch: Dispatch,
    /// Number of the function (see [`crate::probe::functions`]).
    pub function: u32,
}

impl Dispatched for ProbeUniforms {
    #[inline(always)]
    fn dispatch(&self) -> Dispatch {
        self.dispatch
    }
}
