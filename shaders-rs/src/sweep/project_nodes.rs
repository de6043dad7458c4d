//! The wavefront's nodes on a plane, as cells between them are scattered onto its samples.

use crate::abi::record::{Node, Projected, course, node_status as status, projected};
use crate::abi::sweep::SweepUniforms;
use crate::math::{length, max, select, select_vector};
use crate::sweep::light::wavefront::{coordinates, fluence_of_flux, node, point_at, unrefracted_direction};
use spirv_std::glam::Vec3;

/// Node (x, y) on the plane ahead.
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32, nodes: &[f32]) -> [f32; projected::SIZE] {
    let w = &u.wavefront;
    let node: Node = node(w, nodes, x, y);
    let at = point_at(&node, u.step.ahead);
    let cells = coordinates(w, at);
    let straight = unrefracted_direction(w, at);
    let unit = node.direction * (1.0 / max(length(node.direction), 1e-20));
    // Behind a receiver there is no light.
    let ended = node.status == status::LANDED;
    let fluence = node.flux * fluence_of_flux(w, node.direction, at);
    let bent = select(node.bent != 0.0, course::BENT, course::STRAIGHT);
    let projected = Projected {
        x: cells.x - w.first_sample,
        y: cells.y - w.first_sample,
        fluence: select_vector(ended, Vec3::new(0.0, 0.0, 0.0), fluence),
        aside_x: unit.x - straight.x,
        aside_y: unit.y - straight.y,
        course: select(node.status == status::TURNED, course::TURNED, bent),
    };
    projected.store()
}
