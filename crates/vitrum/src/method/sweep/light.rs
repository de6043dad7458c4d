//! The light's direction and its grid.

use super::crop;
use super::planes::Planes;
use super::wavefront::{Frame, check_point};
use crate::error::Error;
use crate::method::environment_lights::environment_lights;
use crate::method::lights;
use crate::method::view::light::{axis, direction_of_light, position};
use crate::method::view::{Bounds, View};
use crate::scene::{Light, LightKind, Scene, Transport};
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use glam::{DVec2, DVec3};
use vitrum_io::Picture;

/// The steepest angle between light and viewing direction, in degrees (sweep §7).
const STEEPEST: f64 = 85.0;
/// The steepest slope of light that the grid follows; the strip of texels would be too wide beyond it.
const STEEPEST_SHEAR: f64 = 2.0;
/// The most texels along an edge.
const MOST_TEXELS: f64 = 8192.0;

/// The grid of light texels: one rectangle per plane, shifted from plane to plane along the light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightGrid {
    /// Corner of texel (0, 0) on plane 0, in the view frame.
    pub corner: DVec2,
    /// Edge of a texel, world units.
    pub texel: f64,
    /// Texels across and up.
    pub size: [u32; 2],
    /// Shift per unit of depth.
    pub shear: DVec2,
    /// Unit direction in which the light starts.
    pub direction: DVec3,
}

/// Checks that the sweep can carry each light of a scene.
///
/// # Errors
/// [`Error::Unrenderable`] where a light on texels is too far from the viewing direction, and where a point or spot that casts shadows is inside the box
/// with these bounds.
pub(super) fn check(scene: &Scene, bounds: Bounds, map: Option<&Picture>) -> Result<(), Error> {
    let view = View::new(scene, bounds);
    if scene.sweep.light != Transport::Forward {
        for (index, light) in scene.light.iter().enumerate() {
            direction(light, Some(index), &view)?;
        }
        return environment_lights(scene, map).iter().try_for_each(|light| direction(light, None, &view).map(drop));
    }
    for (index, light) in scene.light.iter().enumerate() {
        match light.kind {
            LightKind::Distant => direction_of_light(light, &view).map(|_| ())?,
            LightKind::Spot => axis(light, &view, bounds).map(|_| ())?,
            LightKind::Point => {}
        }
        let samples =
            if light.shadows { lights::crisp(scene, std::slice::from_ref(light), bounds) } else { Vec::new() };
        for at in samples.iter().filter_map(|sample| position(sample, &view)) {
            check_point(at, &bounds.corners, view.up, Some(index))?;
        }
    }
    Ok(())
}

/// Unit direction of light `index`, or of one in the place of the environment, in the view frame; an error if its angle to the viewing direction is above [`STEEPEST`].
pub(super) fn direction(light: &Light, index: Option<usize>, view: &View) -> Result<DVec3, Error> {
    let unit = direction_of_light(light, view)?;
    let angle = libm::acos(unit.z.clamp(-1.0, 1.0)).to_degrees();
    if angle > STEEPEST {
        return Err(Unrenderable::ObliqueLight { index, angle, limit: STEEPEST }.into());
    }
    Ok(unit)
}

impl LightGrid {
    pub(super) fn new(
        scene: &Scene,
        view: &View,
        volumes: Volumes<'_>,
        planes: &Planes,
        direction: DVec3,
    ) -> Result<Self, Error> {
        let slope = direction.truncate() / direction.z;
        let shear = slope.clamp_length_max(STEEPEST_SHEAR);
        let first = planes.depth(0);
        let last = planes.depth(planes.count - 1);
        // Along the sheared grid, unrefracted light stays where it is: the volume's outline is all that can hold shadow. Where
        // the shear is limited, shadows drift on to the last plane.
        let drift = (slope - shear) * (last - first);
        let mut low = DVec2::INFINITY;
        let mut high = DVec2::NEG_INFINITY;
        for corner in crop::corners(scene, volumes) {
            let point = view.point(corner);
            let outline = point.truncate() - shear * (point.z - first);
            low = low.min(outline).min(outline + drift);
            high = high.max(outline).max(outline + drift);
        }
        let margin = (high - low) * f64::from(scene.sweep.light_margin);
        let (low, high) = (low - margin, high + margin);
        let rays = scene.film.height * scene.film.supersampling;
        let depth = 0.5 * (planes.volume_depths[0].max(planes.volume_depths[1] * 0.1) + planes.volume_depths[1]);
        let pixel = view.pixel_size(rays, depth.abs().max(1e-6)) / f64::from(scene.sweep.light_resolution);
        let extent = high - low;
        // Close up, pixels get finer than any voxel; light needs no more than a few texels a voxel.
        let voxel = volumes.shown.finest_spacing();
        let finest = (f64::from(voxel) / (4.0 * f64::from(scene.sweep.light_resolution)))
            .max(extent.max_element() / MOST_TEXELS);
        // Light that is the same everywhere needs no texels.
        let finest = if scene.first_light().shadows { finest } else { f64::INFINITY };
        let texel = pixel.max(finest).min(extent.max_element() / 16.0);
        let count = |length: f64| (length / texel).ceil().clamp(4.0, MOST_TEXELS) as u32;
        let size = [count(extent.x), count(extent.y)];
        let centre = (low + high) * 0.5;
        let half = DVec2::new(f64::from(size[0]), f64::from(size[1])) * (0.5 * texel);
        Ok(Self { corner: centre - half, texel, size, shear, direction })
    }

    /// The grid of a wavefront's cells, which are across the light.
    pub(super) fn of_frame(frame: &Frame, direction: DVec3) -> Self {
        let Frame { corner, cell, cells, .. } = *frame;
        Self { corner, texel: cell, size: cells, shear: DVec2::ZERO, direction }
    }

    /// Whether texels move as unrefracted light does; light that is too oblique drifts over them.
    pub(super) fn follows_light(&self) -> bool {
        (self.direction.truncate() / self.direction.z).length() <= STEEPEST_SHEAR
    }

    /// The radius of the filter's taps across the light, in texels.
    fn tap_radius(&self, angular_radius: f32, planes: &Planes, index: u32) -> f64 {
        let depth = planes.volume_depths[1] - planes.volume_depths[0];
        let tangent = libm::tan(f64::from(angular_radius).to_radians());
        tangent * (planes.step(index) * depth * 0.5).sqrt() / self.texel
    }

    /// Largest distance of a tap of the soft-shadow filter from its texel, in texels.
    pub(super) fn filter_radius(&self, angular_radius: f32, planes: &Planes, index: u32) -> f64 {
        self.tap_radius(angular_radius, planes, index) / self.direction.z
    }

    /// The three taps of the soft-shadow filter at plane `index`, in texels (sweep §4.2, after Patel et al. 2013).
    ///
    /// The taps lie on an ellipse, stretched along the light's tilt and turned by a hash of the plane's index. Blurring n times
    /// adds variances, so a radius of Δz·tan(angular radius) would blur by √n instead of n and depend on the sample distance. The
    /// radius is chosen so that the blur over the volume's depth D is that of a source of that angular radius: three taps
    /// have variance r²/2 an axis, a disc R²/4, and n r²/2 = (D tan)²/4 gives r = tan √(Δz D / 2).
    ///
    /// Every plane filters, even if the radius is a fraction of a texel: one wider filter after several planes gives the same blur
    /// of a shadow, but between filters refracted light breaks into stripes.
    pub(super) fn taps(&self, angular_radius: f32, planes: &Planes, index: u32) -> [DVec2; 3] {
        let radius = self.tap_radius(angular_radius, planes, index);
        let along = self.direction.truncate().try_normalize().unwrap_or(DVec2::X);
        let across = along.perp();
        let start = hash(index) * std::f64::consts::TAU;
        std::array::from_fn(|tap| {
            let (sin, cos) = libm::sincos(start + tap as f64 * std::f64::consts::TAU / 3.0);
            (along * (cos / self.direction.z) + across * sin) * radius
        })
    }
}

/// A number in 0…1 for a plane, the same everywhere (the finaliser of MurmurHash3).
fn hash(index: u32) -> f64 {
    let mut h = index.wrapping_add(0x9e37_79b9);
    h ^= h >> 16;
    h = h.wrapping_mul(0x85eb_ca6b);
    h ^= h >> 13;
    h = h.wrapping_mul(0xc2b2_ae35);
    h ^= h >> 16;
    f64::from(h) / 4_294_967_296.0
}
