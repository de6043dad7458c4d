//! The direction of the light, as the camera has it.

use super::{View, from_angles, vector};
use crate::error::Error;
use crate::scene::{Attachment, Light};
use crate::unrenderable::Unrenderable;
use glam::DVec3;

/// The unit direction in which light travels, in the view frame.
pub(in crate::method) fn travels(light: &Light, view: &View) -> Result<DVec3, Error> {
    let travels = match (light.attachment(), light.direction) {
        (Attachment::Camera, Some(v)) => {
            let v = vector(v);
            DVec3::new(v.x, v.y, -v.z)
        }
        (Attachment::World, Some(v)) => view.direction(vector(v)),
        (Attachment::Camera, None) => {
            let radians = |degrees: f32| f64::from(degrees).to_radians();
            let [(sin, cos), (height, level)] =
                [light.azimuth, light.elevation].map(|angle| libm::sincos(radians(angle)));
            DVec3::new(-sin * level, -height, cos * level)
        }
        (Attachment::World, None) => view.direction(-from_angles(view.up, view.front, light.azimuth, light.elevation)),
    };
    let no_length = || Unrenderable::NoDirection { key: "the `direction` of a light".to_owned() }.into();
    travels.try_normalize().ok_or_else(no_length)
}
