//! Where nodes stand in the world.

use super::document::Node;
use crate::mesh::measure::{cross, dot};

/// An affine map: the images of the axes, and of the origin.
#[derive(Debug, Clone, Copy)]
pub(super) struct Transform {
    columns: [[f64; 3]; 4],
}

impl Transform {
    pub const IDENTITY: Self = Self { columns: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]] };

    /// That of a node within its parent.
    pub fn of(node: &Node) -> Self {
        if let Some(matrix) = node.matrix {
            return Self { columns: [0, 4, 8, 12].map(|start| [matrix[start], matrix[start + 1], matrix[start + 2]]) };
        }
        let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let scale = node.scale.unwrap_or([1.0; 3]);
        let axes = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let [a, b, c] = [0, 1, 2].map(|axis| axes[axis].map(|component| component * scale[axis]));
        Self { columns: [a, b, c, node.translation.unwrap_or_default()] }
    }

    /// First `inner`, then this one.
    pub fn after(&self, inner: &Self) -> Self {
        let [a, b, c, origin] = inner.columns;
        Self { columns: [self.vector(a), self.vector(b), self.vector(c), self.point(origin)] }
    }

    pub fn point(&self, point: [f64; 3]) -> [f64; 3] {
        let vector = self.vector(point);
        std::array::from_fn(|axis| vector[axis] + self.columns[3][axis])
    }

    fn vector(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c, _] = self.columns;
        std::array::from_fn(|axis| a[axis] * x + b[axis] * y + c[axis] * z)
    }

    /// Whether it turns a right hand into a left one.
    pub fn mirrors(&self) -> bool {
        let [a, b, c, _] = self.columns;
        dot(a, cross(b, c)) < 0.0
    }

    /// A normal by the inverse transpose, up to its length, which is there for flat maps too.
    pub fn normal(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c, _] = self.columns;
        let sign = if self.mirrors() { -1.0 } else { 1.0 };
        let (u, v, w) = (cross(b, c), cross(c, a), cross(a, b));
        std::array::from_fn(|axis| sign * (u[axis] * x + v[axis] * y + w[axis] * z))
    }
}
