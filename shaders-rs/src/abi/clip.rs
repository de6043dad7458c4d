//! Clipping planes.

use super::vector::Affine;

/// A clipping plane.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Clip {
    /// Signed distance, positive on the side that is removed; 0 everywhere if the plane is unused.
    pub plane: Affine,
    /// 1 if it removes everything, 0 if it removes particles only.
    pub everything: u32,
}

/// The most clipping planes.
pub const MOST_CLIPS: usize = 4;
