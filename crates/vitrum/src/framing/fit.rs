//! The nearest eye from which all points are in the picture.

use crate::assets::Assets;
use crate::method::{Bounds, View};
use crate::scene::Scene;
use glam::{DMat3, DVec3};

/// The part of the picture's half that stays free around what is visible.
const MARGIN: f64 = 0.05;

/// The same where a ground shows a shadow.
const MARGIN_ON_GROUND: f64 = 0.1;

/// The axes of a view and the picture's size, whose eye is to be found.
pub(super) struct Fit {
    /// Right, up, away from the eye.
    axes: DMat3,
    /// Half the picture's width and height at depth 1, without the margin.
    tangent: [f64; 2],
    /// The picture's width over its height.
    aspect: f64,
    filled: f64,
    /// Half the height of a parallel picture with the scene's own zoom.
    pub(super) whole_half_height: f64,
    /// The world's up.
    pub(super) up: DVec3,
}

impl Fit {
    pub(super) fn new(scene: &Scene, assets: &Assets) -> Self {
        let view = View::new(scene, Bounds::from(&assets.subject));
        let filled = 1.0 - if scene.ground.is_some() { MARGIN_ON_GROUND } else { MARGIN };
        // Zoom magnifies what is found for a zoom of 1.
        let zoom = f64::from(scene.camera.zoom);
        Self {
            axes: view.axes,
            tangent: view.half_size.map(|half| half * zoom * filled),
            aspect: view.half_size[0] / view.half_size[1],
            filled,
            whole_half_height: view.half_size[1] * zoom,
            up: view.up,
        }
    }

    /// The target and the distance of the nearest eye that sees all points, in perspective.
    ///
    /// A point is left of the picture's right side where x − t z ≤ e_x − t e_z, for an eye at e and the tangent t of half the field of view; the
    /// sides on the right and on the left together give e_z, their difference e_x, and the same above and below.
    pub(super) fn perspective(&self, points: &[DVec3]) -> Option<(DVec3, f64)> {
        let [low, high] = bounding_box_along(points, self.axes)?;
        let (mut eye, mut depth) = (DVec3::ZERO, f64::INFINITY);
        for axis in 0..2 {
            let tangent = self.tangent[axis];
            let beyond = |sign: f64| {
                let over = |point: &DVec3| {
                    let at = self.axes.transpose() * *point;
                    sign * at[axis] - tangent * at.z
                };
                points.iter().map(over).fold(f64::NEG_INFINITY, f64::max)
            };
            let (right, left) = (beyond(1.0), beyond(-1.0));
            eye[axis] = 0.5 * (right - left);
            depth = depth.min(-0.5 * (right + left) / tangent);
        }
        let middle = 0.5 * (low.z + high.z);
        // Points in one place need some distance.
        let near = low.z - 1e-3 * (high - low).length().max(1e-6);
        eye.z = depth.min(near);
        Some((self.axes * eye.with_z(middle), middle - eye.z))
    }

    /// The distance from `target` at which all points are in the picture, in perspective.
    pub(super) fn distance_from(&self, points: &[DVec3], target: DVec3) -> f64 {
        let distance = |point: &DVec3| {
            let at = self.axes.transpose() * (*point - target);
            (at.x.abs() / self.tangent[0]).max(at.y.abs() / self.tangent[1]).max(1e-6) - at.z
        };
        points.iter().map(distance).fold(1e-6, f64::max)
    }

    /// The target and half the height of the least parallel picture with all points.
    pub(super) fn orthographic(&self, points: &[DVec3]) -> Option<(DVec3, f64)> {
        let [low, high] = bounding_box_along(points, self.axes)?;
        let target = self.axes * (0.5 * (low + high));
        Some((target, self.half_height_around(points, target)))
    }

    /// Half the height of a parallel picture around `target` with all points.
    pub(super) fn half_height_around(&self, points: &[DVec3], target: DVec3) -> f64 {
        let size = |point: &DVec3| {
            let at = self.axes.transpose() * (*point - target);
            at.y.abs().max(at.x.abs() / self.aspect)
        };
        points.iter().map(size).fold(1e-9, f64::max) / self.filled
    }
}

/// The least and the greatest coordinates of points; `None` where there are none.
pub(super) fn bounding_box(points: &[DVec3]) -> Option<[DVec3; 2]> {
    bounding_box_along(points, DMat3::IDENTITY)
}

fn bounding_box_along(points: &[DVec3], axes: DMat3) -> Option<[DVec3; 2]> {
    let placed = points.iter().map(|point| [axes.transpose() * *point; 2]);
    placed.reduce(|[low, high], [point, _]| [low.min(point), high.max(point)])
}
