//! The part of a volume that is there: all of it, or what the crop box leaves.

use crate::error::Error;
use crate::method::view::{point_between_voxels, vector, voxel_steps};
use crate::scene::{Crop, Scene};
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use glam::DVec3;
use vitrum_io::Volume;

/// How far from a face between voxels, in voxels, a corner is taken to lie on it: shares are in single precision.
const ROUNDING: f64 = 1e-3;

/// A box along a volume's axes, in its voxel coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extent {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

fn voxels(volume: &Volume) -> DVec3 {
    DVec3::from_array(volume.dimensions.map(f64::from))
}

impl Extent {
    /// The box of a whole volume.
    fn whole(volume: &Volume) -> Self {
        Self { low: DVec3::splat(-0.5), high: voxels(volume) - 0.5 }
    }

    /// The box that is left of `volume`, one of `volumes`, in `scene`. The crop box is one of the volume that is shown.
    pub(super) fn new(scene: &Scene, volumes: Volumes<'_>, volume: &Volume) -> Self {
        let whole = Self::whole(volume);
        let Some(crop) = &scene.crop else { return whole };
        // Bodies within the volume are not cropped.
        if volumes.bodies.is_some_and(|bodies| std::ptr::eq(volume, bodies)) {
            return whole;
        }
        let cropped = Self::of_crop(crop, volumes.shown);
        if std::ptr::eq(volume, volumes.shown) {
            return cropped;
        }
        let inverse = voxel_steps(volume).inverse();
        let corners = cropped.corners(volumes.shown).map(|corner| inverse * (corner - vector(volume.origin)));
        let within = |at: DVec3| at.clamp(whole.low, whole.high);
        Self {
            low: within(corners.into_iter().fold(DVec3::INFINITY, DVec3::min)),
            high: within(corners.into_iter().fold(DVec3::NEG_INFINITY, DVec3::max)),
        }
    }

    fn of_crop(crop: &Crop, shown: &Volume) -> Self {
        let at = |share: crate::scene::Vector| {
            let faces = vector(share) * voxels(shown);
            let near = (faces - faces.round()).abs().cmplt(DVec3::splat(ROUNDING));
            DVec3::select(near, faces.round(), faces) - 0.5
        };
        Self { low: at(crop.min), high: at(crop.max) }
    }

    /// Its corners, in the world; bit `a` of a corner's index says whether it is at the high end of the volume's axis `a`.
    pub(super) fn corners(&self, volume: &Volume) -> [DVec3; 8] {
        std::array::from_fn(|corner| {
            let end = |axis: usize| if corner >> axis & 1 == 0 { self.low[axis] } else { self.high[axis] };
            point_between_voxels(volume, DVec3::new(end(0), end(1), end(2)))
        })
    }
}

/// The corners, in the world, of the boxes that are left of all volumes.
pub(super) fn corners<'a>(scene: &'a Scene, volumes: Volumes<'a>) -> impl Iterator<Item = DVec3> + 'a {
    volumes.iter().flat_map(move |volume| Extent::new(scene, volumes, volume).corners(volume))
}

/// Checks that the crop box is a box along the axes of the second volume, too, if there is one.
///
/// # Errors
/// [`Unrenderable::ObliqueCrop`] where it is not.
pub(super) fn check(scene: &Scene, volumes: Volumes<'_>) -> Result<(), Error> {
    let (Some(_), Some(bending)) = (&scene.crop, volumes.ior) else { return Ok(()) };
    let turned = voxel_steps(bending).inverse() * voxel_steps(volumes.shown);
    // Each axis is along one of the other's, up to a thousandth.
    let along = |axis: usize| {
        let step = turned.col(axis).abs();
        step.element_sum() - step.max_element() <= 1e-3 * step.max_element()
    };
    if (0..3).all(along) { Ok(()) } else { Err(Unrenderable::ObliqueCrop { name: bending.name.clone() }.into()) }
}
