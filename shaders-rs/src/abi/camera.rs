//! The camera.

/// The picture's plane in the view frame: x right, y up, z the depth away from the eye.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Camera {
    /// Half the picture's width at depth 1 (perspective) or anywhere (orthographic), in the method's unit of length.
    pub half_width: f32,
    /// Half the picture's height, likewise.
    pub half_height: f32,
    /// Depth at which rays start, in the method's unit of length.
    pub start: f32,
    /// 1 if the projection is orthographic, 0 if it is perspective.
    pub orthographic: u32,
}
