//! Ground and wall as planes of the view frame.

use super::{Bounds, View, from_angles};
use crate::scene::Scene;
use glam::{DVec3, DVec4};

/// Planes of the view frame: signed distance = xyz · point + w, positive on the visible side; all 0 if absent.
#[derive(Debug, Clone, Copy)]
pub(in crate::method) struct Receivers {
    pub(in crate::method) ground: DVec4,
    pub(in crate::method) wall: DVec4,
}

/// The plane through `point` with `normal` (world), in the view frame.
pub(in crate::method) fn plane(view: &View, normal: DVec3, point: DVec3) -> DVec4 {
    view.direction(normal).extend((view.eye - point).dot(normal))
}

impl Receivers {
    pub(in crate::method) fn new(scene: &Scene, view: &View, bounds: Bounds) -> Self {
        let (centre, radius) = bounds.sphere();
        let ground = scene.ground.as_ref().map_or(DVec4::ZERO, |ground| {
            let height = ground.height.map_or(bounds.lowest(view.up), f64::from);
            plane(view, view.up, view.up * height)
        });
        let wall = scene.wall.as_ref().map_or(DVec4::ZERO, |wall| {
            let facing = from_angles(view.up, view.front, wall.azimuth, 0.0);
            let distance = wall.distance.map_or(radius, f64::from);
            plane(view, facing, centre - facing * distance)
        });
        Self { ground, wall }
    }

    /// Distance from `point` along `direction` to the first receiver, in lengths of `direction`; `None` if the ray meets none.
    pub(in crate::method) fn first(&self, point: DVec3, direction: DVec3) -> Option<f64> {
        [self.ground, self.wall]
            .iter()
            .filter_map(|plane| {
                let distance = plane.truncate().dot(point) + plane.w;
                let speed = -plane.truncate().dot(direction);
                (distance > 0.0 && speed > 1e-9).then(|| distance / speed)
            })
            .min_by(f64::total_cmp)
    }
}
