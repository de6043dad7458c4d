//! Receivers: the ground and the wall, diffuse planes.

use super::vector::{Affine, Vec3};

/// A diffuse plane.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Receiver {
    /// Signed distance, positive on the visible side; 0 everywhere if there is no such receiver.
    pub plane: Affine,
    /// Reflectance, linear RGB, 0 to 1.
    pub color: Vec3,
}

/// The scene's receivers.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Receivers {
    /// The ground.
    pub ground: Receiver,
    /// The wall.
    pub wall: Receiver,
}

/// Numbers of the things ahead of a ray that are no triangles, whose numbers begin at 0.
pub mod ahead {
    /// Nothing.
    pub const NOTHING: i32 = -1;
    /// The ground.
    pub const GROUND: i32 = -2;
    /// The wall.
    pub const WALL: i32 = -3;
}
