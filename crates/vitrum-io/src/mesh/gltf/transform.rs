//! Affine maps of nodes, from their own space to the world's.

use glam::{DAffine3, DMat4, DQuat, DVec3};

use super::document::Node;

/// The affine map from a node's space to the space of its parent.
pub(super) fn of_node(node: &Node) -> DAffine3 {
    if let Some(matrix) = node.matrix {
        return DAffine3::from_mat4(DMat4::from_cols_array(&matrix));
    }
    let rotation = DQuat::from_array(node.rotation.unwrap_or(DQuat::IDENTITY.to_array()));
    let scale = DVec3::from(node.scale.unwrap_or([1.0; 3]));
    DAffine3::from_scale_rotation_translation(scale, rotation, DVec3::from(node.translation.unwrap_or_default()))
}

/// Whether a map turns a right hand into a left one.
pub(super) fn mirrors(map: &DAffine3) -> bool {
    let [a, b, c] = axes(map);
    a.dot(b.cross(c)) < 0.0
}

/// A normal by the inverse transpose, up to its length, which is there for flat maps too.
pub(super) fn normal(map: &DAffine3, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = axes(map);
    let sign = if mirrors(map) { -1.0 } else { 1.0 };
    (sign * (b.cross(c) * x + c.cross(a) * y + a.cross(b) * z)).to_array()
}

/// The images of the axes.
fn axes(map: &DAffine3) -> [DVec3; 3] {
    [map.matrix3.x_axis, map.matrix3.y_axis, map.matrix3.z_axis]
}
