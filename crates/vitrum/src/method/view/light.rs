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
            let (azimuth, elevation) = (f64::from(light.azimuth).to_radians(), f64::from(light.elevation).to_radians());
            DVec3::new(-azimuth.sin() * elevation.cos(), -elevation.sin(), azimuth.cos() * elevation.cos())
        }
        (Attachment::World, None) => view.direction(-from_angles(view.up, view.front, light.azimuth, light.elevation)),
    };
    let no_length = || Unrenderable::NoDirection { key: "the `direction` of a light".to_owned() }.into();
    travels.try_normalize().ok_or_else(no_length)
}
