//! The box around the subject of a picture.

use super::point_between_voxels;
use crate::subject::Subject;
use glam::DVec3;
use vitrum_io::{Mesh, Volume};

/// Least thickness of the box of a flat mesh, over the mesh's longest edge.
const THINNEST: f32 = 1e-6;

/// The box around a subject: of a volume its whole voxels, along its own axes; of a mesh its bounds, along the world's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The eight corners, in the world.
    pub(in crate::method) corners: [DVec3; 8],
}

impl Bounds {
    /// The corners whose coordinate on axis `a` is the low or the high one of `ends(a)`, turned to the world by `point`.
    pub(super) fn new(ends: [[f64; 2]; 3], point: impl Fn(DVec3) -> DVec3) -> Self {
        let corner = |corner: usize| {
            let end = |axis: usize| ends[axis][corner >> axis & 1];
            point(DVec3::new(end(0), end(1), end(2)))
        };
        Self { corners: std::array::from_fn(corner) }
    }

    /// The eight corners, in the world: bit `a` of a corner's index says whether it is at the high end of the box's axis `a`.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        self.corners
    }

    /// Centre and radius of the sphere around the box, in world units.
    pub(in crate::method) fn sphere(&self) -> (DVec3, f64) {
        let centre = self.corners.iter().sum::<DVec3>() / 8.0;
        let radius = self.corners.iter().map(|corner| (*corner - centre).length()).fold(0.0, f64::max);
        (centre, radius)
    }

    /// The least height of a corner along the unit vector `up`.
    pub(in crate::method) fn lowest(&self, up: DVec3) -> f64 {
        self.corners.iter().map(|corner| corner.dot(up)).fold(f64::INFINITY, f64::min)
    }
}

impl From<&Volume> for Bounds {
    fn from(volume: &Volume) -> Self {
        let ends = volume.dimensions.map(|n| [-0.5, f64::from(n) - 0.5]);
        Self::new(ends, |at| point_between_voxels(volume, at))
    }
}

impl From<&Mesh> for Bounds {
    fn from(mesh: &Mesh) -> Self {
        let [low, high] = mesh.bounds();
        let extent: [f32; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
        let longest = extent.into_iter().fold(f32::MIN_POSITIVE, f32::max);
        let ends = std::array::from_fn(|axis| {
            let middle = f64::from(0.5 * (low[axis] + high[axis]));
            let half = 0.5 * f64::from(extent[axis].max(longest * THINNEST));
            [middle - half, middle + half]
        });
        Self::new(ends, |at| at)
    }
}

impl From<&Subject> for Bounds {
    fn from(subject: &Subject) -> Self {
        match subject {
            Subject::Volume(shown) | Subject::Volumes { shown, .. } => Self::from(&**shown),
            Subject::Mesh(mesh) => Self::from(&**mesh),
        }
    }
}
