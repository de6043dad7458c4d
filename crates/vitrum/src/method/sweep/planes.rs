//! The planes of a sweep.

use super::crop::corners;
use crate::error::Error;
use crate::method::view::receivers::Receivers;
use crate::method::view::{Bounds, View};
use crate::scene::Scene;
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use glam::DVec3;
use vitrum_io::Volume;

/// The most planes of one frame.
const MOST_PLANES: f64 = 65_536.0;

/// The distance of planes behind the volume, over the distance of planes within it. Light is straight behind the volume, so that a long
/// step is exact; and each step blurs the light a little by interpolation.
const STRIDE_BEHIND: f64 = 4.0;

/// The depth at which rays start where the volume surrounds the eye, as a share of the volume's depth.
const EYE: f64 = 1e-5;

/// Planes at equal distances from in front of the volume to behind it, and farther apart from there to behind its shadow on the
/// receivers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planes {
    /// Depth of plane 0.
    pub first_depth: f64,
    /// Distance of neighbouring planes within the volume, world units.
    pub distance: f64,
    /// The first plane behind the volume.
    pub behind: u32,
    /// Number of planes.
    pub count: u32,
    /// The first plane with viewing rays: those before it are behind the eye.
    pub first_visible: u32,
    /// Depth of the volume's near and far ends.
    pub volume_depths: [f64; 2],
}

/// The distance of planes within a volume, world units.
pub(super) fn plane_distance(scene: &Scene, shown: &Volume) -> f64 {
    f64::from(shown.finest_spacing()) * f64::from(scene.sweep.sample_distance)
}

impl Planes {
    /// The planes of a sweep whose light is on texels, which is carried on to where the volume's shadow falls on receivers.
    ///
    /// # Errors
    /// [`Error::Unrenderable`] where planes are too many, or the volume is behind the camera.
    pub(super) fn new(
        scene: &Scene,
        view: &View,
        volumes: Volumes<'_>,
        receivers: &Receivers,
        light: DVec3,
    ) -> Result<Self, Error> {
        Self::up_to(scene, view, volumes, |points, far| {
            // Where the volume's shadow falls on a receiver, but not endlessly far; without shadows all ends behind the volume.
            let limit =
                if scene.first_light().shadows { far + 3.0 * Bounds::from(volumes.shown).sphere().1 } else { far };
            points
                .iter()
                .filter_map(|point| receivers.first(*point, light).map(|along| point.z + light.z * along))
                .fold(far, f64::max)
                .min(limit)
        })
    }

    /// The planes from in front of the volumes to behind them.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(super) fn within(scene: &Scene, view: &View, volumes: Volumes<'_>) -> Result<Self, Error> {
        Self::up_to(scene, view, volumes, |_, far| far)
    }

    /// The planes from in front of the volumes to the depth that `reach` computes from the volumes' corners and their far end.
    fn up_to(
        scene: &Scene,
        view: &View,
        volumes: Volumes<'_>,
        reach: impl Fn(&[DVec3], f64) -> f64,
    ) -> Result<Self, Error> {
        let distance = plane_distance(scene, volumes.shown);
        let points: Vec<DVec3> = corners(scene, volumes).map(|corner| view.point(corner)).collect();
        let near = points.iter().map(|point| point.z).fold(f64::INFINITY, f64::min);
        let far = points.iter().map(|point| point.z).fold(f64::NEG_INFINITY, f64::max);
        let reach = reach(&points, far);
        // Just in front of the eye: rays start there.
        let start = if view.orthographic { f64::NEG_INFINITY } else { EYE * (far - near) };
        let front = near - 0.5 * distance;
        // With the eye in the volume, rays start on a plane, so that they miss nothing of what is in front of them.
        let first_depth = if front < start { start - ((start - front) / distance).ceil() * distance } else { front };
        let behind = ((far - first_depth) / distance).floor() + 1.0;
        let rest = reach - (first_depth + behind * distance);
        let steps = behind + (rest / (distance * STRIDE_BEHIND)).ceil().max(0.0);
        if steps > MOST_PLANES {
            let sample_distance = scene.sweep.sample_distance;
            return Err(Unrenderable::TooManyPlanes { sample_distance, planes: steps, limit: MOST_PLANES }.into());
        }
        let count = steps as u32 + 1;
        let first_visible = ((start - first_depth) / distance).round().max(0.0);
        if first_visible > behind {
            return Err(Unrenderable::BehindCamera.into());
        }
        Ok(Self {
            first_depth,
            distance,
            behind: behind as u32,
            count,
            first_visible: first_visible as u32,
            volume_depths: [near, far],
        })
    }

    /// Depth of plane `index`.
    pub fn depth(&self, index: u32) -> f64 {
        let within = f64::from(index.min(self.behind));
        let beyond = f64::from(index.saturating_sub(self.behind));
        self.first_depth + (within + beyond * STRIDE_BEHIND) * self.distance
    }

    /// Distance of plane `index` from the one before.
    pub fn step(&self, index: u32) -> f64 {
        if self.is_behind(index) { self.distance * STRIDE_BEHIND } else { self.distance }
    }

    /// The length of the run of equally spaced planes after plane `index`.
    pub fn alike(&self, index: u32) -> u32 {
        let last = if self.is_behind(index) { self.count - 1 } else { self.behind };
        last.saturating_sub(index)
    }

    /// Whether the way from the plane before to plane `index` lies behind the volume.
    pub fn is_behind(&self, index: u32) -> bool {
        index > self.behind
    }
}
