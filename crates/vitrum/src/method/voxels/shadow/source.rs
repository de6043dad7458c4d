//! Sources of light, as shadow maps see them.

use crate::error::Error;
use crate::method::view::light::{axis, direction_of_light, position};
use crate::method::{Bounds, View};
use crate::scene::{Light, LightKind};
use crate::unrenderable::Unrenderable;
use glam::DVec3;

/// Least distance of a light from the mesh's box, over the box's diagonal: from nearer, parts of the mesh would be seen in columns that
/// are nearly parallel to the box's faces.
const NEAREST: f64 = 1.0 / 64.0;

/// The source of the light that a shadow map follows, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::method) enum Source {
    /// A distant source, with the unit direction of its light.
    Distant(DVec3),
    /// A point source, with its position.
    Point(DVec3),
    /// A point source that shines into a cone.
    Spot {
        position: DVec3,
        /// The cone's unit axis.
        axis: DVec3,
        /// Tangent of the cone's half-angle.
        tangent: f64,
    },
}

impl Source {
    /// The source of a light of a scene.
    ///
    /// # Errors
    /// [`Unrenderable::NoDirection`] where a light has no direction.
    pub(in crate::method) fn of(light: &Light, view: &View, bounds: Bounds) -> Result<Self, Error> {
        let distant = || Ok(Self::Distant(view.axes * direction_of_light(light, view)?));
        position(light, view).map_or_else(distant, |position| {
            Ok(match light.kind {
                LightKind::Spot => {
                    let tangent = libm::tan(f64::from(light.cone_angle).to_radians());
                    Self::Spot { position, axis: axis(light, view, bounds)?, tangent }
                }
                LightKind::Point | LightKind::Distant => Self::Point(position),
            })
        })
    }

    /// The position of a point or spot.
    pub(super) fn position(&self) -> Option<DVec3> {
        match *self {
            Self::Distant(_) => None,
            Self::Point(position) | Self::Spot { position, .. } => Some(position),
        }
    }

    /// Checks that all of a box can be seen from the source through a plane. `index` is the number of the light, where it is known.
    ///
    /// # Errors
    /// [`Unrenderable::LightInMesh`] where the source stands inside the box, or next to it.
    pub(in crate::method) fn check(&self, [low, high]: [DVec3; 2], index: Option<usize>) -> Result<(), Error> {
        let Some(position) = self.position() else { return Ok(()) };
        let least = NEAREST * (high - low).length();
        if (position.clamp(low, high) - position).length() >= least {
            return Ok(());
        }
        let [position, low, high] = [position, low, high].map(|point| point.as_vec3().to_array());
        Err(Unrenderable::LightInMesh { index, position, low, high, distance: least as f32 }.into())
    }
}
