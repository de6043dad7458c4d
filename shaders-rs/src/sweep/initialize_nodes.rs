//! The wavefront on the first plane: a node at every corner between cells.

use crate::abi::record::{Node, node, node_status};
use crate::abi::sweep::SweepUniforms;
use crate::sweep::light::wavefront::{unrefracted, unrefracted_direction};
use spirv_std::glam::Vec3;

/// Node (x, y).
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32) -> [f32; node::SIZE] {
    let w = &u.wavefront;
    let position = unrefracted(w, x as i32 as f32, y as i32 as f32, w.first_depth);
    let node = Node {
        position,
        direction: unrefracted_direction(w, position),
        flux: Vec3::new(1.0, 1.0, 1.0),
        inside: 0.0,
        bent: 0.0,
        status: node_status::ACTIVE,
        absorbed_at: 0.0,
        left_at: 0.0,
    };
    node.store()
}
