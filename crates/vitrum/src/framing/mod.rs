//! The camera of a picture that shows all of what is visible, and little more.

mod fit;
mod points;

use crate::assets::Assets;
use crate::error::Error;
use crate::scene::{Framing, Projection, Scene};
use crate::shown;
use fit::Fit;
use glam::DVec3;
pub(crate) use points::{PointsKey, of_bodies, points, points_key};

/// The scene with the camera that its picture is taken with, and its ground under what is visible: a scene whose framing is not
/// [`Framing::Visible`], or that says where the eye is, is not changed.
///
/// # Errors
/// Where the memory for a volume that is smoothed first does not suffice.
pub fn framed(scene: &Scene, assets: &Assets) -> Result<Scene, Error> {
    with_points(scene, assets, around)
}

/// As [`framed`], for pictures from all sides: of a camera that goes round the distance is the one that suits all of them.
///
/// # Errors
/// As [`framed`].
pub fn framed_all_round(scene: &Scene, assets: &Assets) -> Result<Scene, Error> {
    with_points(scene, assets, |scene, assets, points| {
        /// Sides from which the camera looks.
        const SIDES: u16 = 36;
        let mut fitted = around(scene, assets, points)?;
        let sides = (0..SIDES).map(|side| {
            let mut turned = scene.clone();
            turned.camera.azimuth += f32::from(side) * 360.0 / f32::from(SIDES);
            Fit::new(&turned, assets)
        });
        let box_of = fit::bounding_box(points)?;
        let middle = 0.5 * (box_of[0] + box_of[1]);
        let target = scene.camera.target.map_or(middle, |target| DVec3::from_array(target.map(f64::from)));
        let fits: Vec<_> = sides.collect();
        let largest = |size: &dyn Fn(&Fit) -> f64| fits.iter().map(size).fold(0.0, f64::max);
        fitted.camera.target = Some(target.as_vec3().to_array());
        match scene.camera.projection {
            Projection::Perspective => {
                fitted.camera.distance = Some(largest(&|fit| fit.distance_from(points, target)));
            }
            Projection::Orthographic => {
                let size = largest(&|fit| fit.half_height_around(points, target));
                fitted.camera.zoom = scene.camera.zoom * (fits[0].whole_half_height / size) as f32;
            }
        }
        Some(fitted)
    })
}

fn with_points(
    scene: &Scene,
    assets: &Assets,
    fit: impl FnOnce(&Scene, &Assets, &[DVec3]) -> Option<Scene>,
) -> Result<Scene, Error> {
    if !is_fitted(scene) {
        return Ok(scene.clone());
    }
    let shown = shown::shown(scene, assets)?;
    let assets = shown.as_ref().unwrap_or(assets);
    let mut points = points(scene, &assets.subject);
    points.extend(of_bodies(assets));
    Ok(fit(scene, assets, &points).unwrap_or_else(|| scene.clone()))
}

/// Whether the camera of a scene depends on what is visible.
pub(crate) fn is_fitted(scene: &Scene) -> bool {
    let camera = &scene.camera;
    camera.framing == Framing::Visible && camera.position.is_none() && camera.distance.is_none()
}

/// The scene with a camera from whose side `points` fill the picture; `None` where there are none.
pub(crate) fn around(scene: &Scene, assets: &Assets, points: &[DVec3]) -> Option<Scene> {
    let fit = Fit::new(scene, assets);
    let mut fitted = scene.clone();
    let camera = &mut fitted.camera;
    match (scene.camera.target, scene.camera.projection) {
        (None, Projection::Perspective) => {
            let (target, distance) = fit.perspective(points)?;
            (camera.target, camera.distance) = (Some(target.as_vec3().to_array()), Some(distance));
        }
        (None, Projection::Orthographic) => {
            let (target, half_height) = fit.orthographic(points)?;
            camera.target = Some(target.as_vec3().to_array());
            camera.zoom *= (fit.whole_half_height / half_height) as f32;
        }
        (Some(target), Projection::Perspective) => {
            let target = DVec3::from_array(target.map(f64::from));
            points.first()?;
            camera.distance = Some(fit.distance_from(points, target));
        }
        (Some(target), Projection::Orthographic) => {
            let target = DVec3::from_array(target.map(f64::from));
            points.first()?;
            camera.zoom *= (fit.whole_half_height / fit.half_height_around(points, target)) as f32;
        }
    }
    // What floats above a ground that lies at the grid's end would not stand on it.
    if let Some(ground) = &mut fitted.ground {
        let lowest = points.iter().map(|point| point.dot(fit.up)).fold(f64::INFINITY, f64::min);
        ground.height.get_or_insert(lowest as f32);
    }
    Some(fitted)
}
