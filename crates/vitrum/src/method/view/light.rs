//! Directions and positions of lights.

use super::{Bounds, View, from_angles, vector};
use crate::error::Error;
use crate::scene::{Attachment, Light};
use crate::unrenderable::Unrenderable;
use glam::DVec3;

/// The unit direction in which a light shines, in the view frame.
pub(in crate::method) fn direction_of_light(light: &Light, view: &View) -> Result<DVec3, Error> {
    let direction = match (light.attachment(), light.direction) {
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
    direction.try_normalize().ok_or_else(no_length)
}

/// The position of a point or spot, in the world; `None` for a distant light.
pub(in crate::method) fn position(light: &Light, view: &View) -> Option<DVec3> {
    let given = vector(light.position?);
    Some(match light.attachment() {
        Attachment::World => given,
        Attachment::Camera => {
            let target = view.eye + view.axes.z_axis * view.target_depth;
            target + view.axes * DVec3::new(given.x, given.y, -given.z)
        }
    })
}

/// The unit axis of a spot's cone, in the world: where no direction is given, towards the middle of the subject.
///
/// # Errors
/// [`Unrenderable::NoDirection`] where the spot stands in the middle of the subject and has no direction.
pub(in crate::method) fn axis(light: &Light, view: &View, bounds: Bounds) -> Result<DVec3, Error> {
    if light.direction.is_some() {
        return Ok(view.axes * direction_of_light(light, view)?);
    }
    let (centre, _) = bounds.sphere();
    let no_length =
        || Unrenderable::NoDirection { key: "the `direction` of a spot in the middle of the subject".to_owned() };
    Ok(position(light, view).and_then(|from| (centre - from).try_normalize()).ok_or_else(no_length)?)
}

/// The unit vectors across a spot's axis that are the right and the top of the picture that it projects: for one who looks along the axis,
/// upright. Where the axis is upright the picture's top is away from the viewer.
pub(in crate::method) fn upright(light: &Light, view: &View, axis: DVec3) -> [DVec3; 2] {
    let (up, away) = match light.attachment() {
        Attachment::World => (view.up, -view.front),
        Attachment::Camera => (view.axes.y_axis, view.axes.z_axis),
    };
    let along = axis.dot(up);
    let top = if along.abs() < 0.999_999 { up - axis * along } else { away * -along.signum() };
    let top = (top - axis * axis.dot(top)).normalize();
    [axis.cross(top), top]
}
