//! The frame of a wavefront from a point: its grid is one of tangents, around an axis from the point through the volumes.

use super::frame::{FEWEST, Frame, MOST};
use crate::error::Error;
use crate::method::sweep::crop;
use crate::method::sweep::planes::Planes;
use crate::method::view::light::axis;
use crate::method::view::{Bounds, View};
use crate::scene::{Light, LightKind, Scene};
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use glam::{DMat3, DVec2, DVec3};
use vitrum_kernels::abi::wavefront::SpotCone;

/// The widest angle between the frame's axis and light that reaches a volume, in degrees. Farther out cells would be far wider than voxels.
const WIDEST: f64 = 80.0;
/// Steps of the search for the axis, each of which goes less far than the one before.
const STEPS: u32 = 200;
/// The greatest depth of the middle of the volume, in radii of the sphere around it: the frame begins there, so that single precision tells its planes
/// apart however far away the light is.
const DEEPEST: f64 = 4.0;

/// The point from which a wavefront comes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::method::sweep) struct Source {
    /// Its depth in the frame, 0 or less.
    pub(super) depth: f64,
    /// The cone of a spot.
    pub(super) cone: SpotCone,
}

impl Source {
    /// The same point, shining to all sides.
    pub(super) fn bare(self) -> Self {
        Self { cone: SpotCone::default(), ..self }
    }
}

/// The axis of a narrow cone from `position` around `corners` (Bădoiu and Clarkson 2003).
fn axis_around(position: DVec3, corners: &[DVec3]) -> DVec3 {
    let directions: Vec<DVec3> = corners.iter().filter_map(|corner| (*corner - position).try_normalize()).collect();
    let unit = |v: DVec3| v.try_normalize().unwrap_or(DVec3::Z);
    let mut axis = unit(directions.iter().sum());
    for step in 2..STEPS {
        let farthest = directions.iter().copied().min_by(|a, b| a.dot(axis).total_cmp(&b.dot(axis))).unwrap_or(axis);
        axis = unit(axis + (farthest - axis) / f64::from(step));
    }
    axis
}

/// Tangents of the light along `axes` that goes to each corner; `None` where it is across the axis, or beyond [`WIDEST`].
fn tangents(position: DVec3, axes: &DMat3, corners: &[DVec3]) -> Option<Vec<DVec2>> {
    let widest = libm::tan(WIDEST.to_radians());
    let tangent = |corner: &DVec3| {
        let way = axes.transpose() * (*corner - position);
        Some(way.truncate() / way.z).filter(|tangent| way.z > 0.0 && tangent.length() <= widest)
    };
    corners.iter().map(tangent).collect()
}

/// The axes of the frame.
fn axes(position: DVec3, corners: &[DVec3], up: DVec3) -> DMat3 {
    let away = axis_around(position, corners);
    let right = away.cross(up).try_normalize().unwrap_or_else(|| away.any_orthonormal_vector());
    DMat3::from_cols(right, right.cross(away), away)
}

/// The error for a light from which not all corners are seen.
fn too_near(position: DVec3, index: Option<usize>) -> Error {
    Unrenderable::LightInVolume { index, position: position.as_vec3().to_array(), limit: WIDEST }.into()
}

/// Checks that light from `position` reaches all of the box with these corners at once. `index` is the number of the light, where it is known.
///
/// # Errors
/// [`Unrenderable::LightInVolume`] where the light stands inside the box, or next to it.
pub(in crate::method::sweep) fn check(
    position: DVec3,
    corners: &[DVec3],
    up: DVec3,
    index: Option<usize>,
) -> Result<(), Error> {
    let seen = tangents(position, &axes(position, corners, up), corners);
    seen.map(drop).ok_or_else(|| too_near(position, index))
}

/// The cone of a light in the frame with these axes; one that is open to all sides for a point.
fn cone(light: &Light, view: &View, bounds: Bounds, axes: &DMat3) -> Result<SpotCone, Error> {
    if light.kind != LightKind::Spot {
        return Ok(SpotCone::default());
    }
    let tangent = |angle: f64| libm::tan(angle.to_radians());
    let outer = tangent(f64::from(light.cone_angle));
    let inner = tangent(f64::from(light.cone_angle) * (1.0 - f64::from(light.penumbra)));
    // An edge that is crisp is a millionth of the cone wide.
    let slope = 1.0 / (outer - inner).max(1e-6 * outer);
    let axis = axes.transpose() * axis(light, view, bounds)?;
    Ok(SpotCone { axis: axis.as_vec3().into(), tangent: outer as f32, slope: slope as f32 })
}

impl Frame {
    /// The frame of the scene's first light, a point or spot at `position`, for the camera's view `view`. Light without shadows is not carried, and may be
    /// anywhere.
    ///
    /// # Errors
    /// As [`check`] and [`Planes::new`].
    pub(in crate::method::sweep) fn of_point(
        scene: &Scene,
        view: &View,
        volumes: Volumes<'_>,
        position: DVec3,
    ) -> Result<Self, Error> {
        let light = scene.first_light();
        let bounds = Bounds::from(volumes.shown);
        let corners: Vec<DVec3> = crop::corners(scene, volumes).collect();
        // In single precision, as in the frame of light from far away.
        let position = position.as_vec3().as_dvec3();
        let axes = axes(position, &corners, view.up);
        let tangents = match tangents(position, &axes, &corners) {
            Some(tangents) => tangents,
            None if light.shadows => return Err(too_near(position, None)),
            None => vec![DVec2::NEG_ONE, DVec2::ONE],
        };
        let cone = cone(light, view, bounds, &axes)?;
        let (centre, radius) = bounds.sphere();
        let away = axes.z_axis;
        let distance = (centre - position).dot(away);
        let depth = (DEEPEST * radius - distance).min(0.0);
        let eye = position - away * depth;
        let view = View { eye, axes, orthographic: true, target_depth: distance + depth, ..*view };
        let mut planes = Planes::within(scene, &view, volumes)?;
        // The first plane is between the light and the volume.
        planes.first_depth = planes.first_depth.max(depth + 0.5 * (planes.volume_depths[0] - depth).max(0.0));
        let low = tangents.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = tangents.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let longer = (high - low).max_element();
        let voxel = f64::from(volumes.shown.finest_spacing());
        // Cells are as wide as voxels in the middle of the volume.
        let usual = || (longer * distance / voxel).clamp(FEWEST, MOST);
        let wanted = scene.sweep.light_cells.map_or_else(usual, f64::from);
        let wanted = if light.shadows { wanted } else { 4.0 };
        let source = Some(Source { depth, cone });
        let frame =
            Self { view, planes, source, corner: low, cell: 0.0, cells: [0; 2], stride: 1, has_particles: false };
        Ok(frame.with_cells(low, high, longer / wanted))
    }

    /// Plane irradiance, over that at a distance of 1, of unoccluded light with coordinates (x, y), in cells, at `depth`; 1 for light from far away.
    pub(super) fn irradiance(&self, x: f64, y: f64, depth: f64) -> f64 {
        let Some(Source { depth: start, cone }) = self.source else { return 1.0 };
        let towards = (self.corner + DVec2::new(x, y) * self.cell).extend(1.0);
        let axis = DVec3::new(f64::from(cone.axis.x), f64::from(cone.axis.y), f64::from(cone.axis.z));
        let along = towards.dot(axis);
        let tangent = (towards - axis * along).length() / along.max(1e-20);
        let t = ((f64::from(cone.tangent) - tangent) * f64::from(cone.slope)).clamp(0.0, 1.0);
        let lit = if along > 0.0 { t * t * (3.0 - 2.0 * t) } else { 0.0 };
        let share = if cone.slope > 0.0 { lit } else { 1.0 };
        let squared = towards.length_squared();
        share / (squared * squared.sqrt() * (depth - start) * (depth - start))
    }

    /// The steepest slope of unrefracted light, distance across over depth.
    pub(in crate::method::sweep) fn steepest(&self) -> f64 {
        let size = DVec2::new(f64::from(self.cells[0]), f64::from(self.cells[1])) * self.cell;
        self.source.map_or(0.0, |_| self.corner.abs().max((self.corner + size).abs()).length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> Vec<DVec3> {
        let end = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
        (0..8).map(|corner| DVec3::new(end(corner, 0), end(corner, 1), end(corner, 2))).collect()
    }

    #[test]
    fn the_axis_is_that_of_the_narrowest_cone() {
        // Before the middle of a face it is across the face, wherever the far corners are.
        for distance in [1.2, 2.0, 50.0] {
            let axis = axis_around(DVec3::X * distance, &cube());
            assert!((axis + DVec3::X).length() < 0.02, "{axis} from {distance}");
        }
    }

    #[test]
    fn a_light_inside_or_next_to_the_box_is_refused() {
        for (position, is_seen) in [
            (DVec3::ZERO, false),
            (DVec3::new(0.5, -0.9, 0.2), false),
            (DVec3::X * 1.05, false),
            (DVec3::X * 1.4, true),
            (DVec3::new(1.3, 1.3, 0.0), true),
            (DVec3::new(3.0, -400.0, 7.0), true),
        ] {
            let found = check(position, &cube(), DVec3::Z, Some(2));
            assert_eq!(found.is_ok(), is_seen, "{position}: {found:?}");
        }
        let error = check(DVec3::ZERO, &cube(), DVec3::Z, Some(2)).expect_err("it is inside").to_string();
        assert!(error.contains("light.2"), "{error}");
    }
}
