//! Distant lights in the place of an environment (`environment.lights`).
//!
//! A spiral inverts the environment's luminance in strata (`spiral.rs`); the regions of directions that are nearest to its points have a light
//! each, in the direction of the region's luminance and with its flux, integrated over cells (`cells.rs`). No random numbers are used.
//!
//! The flux of all lights is that of the environment, so that their irradiance, averaged over the orientations of a surface, is exact whatever
//! the regions. What is left is how evenly they lie. Median cut (Debevec 2005) halves rectangles of longitude and latitude, which are
//! narrow near the poles and whose numbers are powers of 2; regions around a spiral are round and of any number. The relative error of the irradiance of
//! 32 lights, root mean square over all orientations, by median cut and by the spiral: 2.3 % and 0.9 % of one colour, 2.5 % and 0.9 % of the default
//! gradient, 7.4 % and 5.4 % of a bright sky above black ground, 2.6 % and 1.4 % of a sky with a sun. Moving points to the middles of their
//! regions and dividing again (Lloyd) gains nothing from there.

mod cells;
mod spiral;
#[cfg(test)]
mod tests;

use crate::method::view::environment::axes;
use crate::method::view::up_and_front;
use crate::scene::{Attachment, Light, LightKind, Scene};
use cells::{Cell, cells};
use glam::DVec3;
use spiral::spiral;
use std::f64::consts::PI;
use vitrum_io::Picture;

/// The greatest angular radius of a light, in degrees, as in scenes.
const WIDEST: f64 = 45.0;
/// The least angular radius that is not taken for 0, in degrees.
const NARROWEST: f64 = 0.01;

/// The lights of a scene's environment, whose map is `picture`: `environment.lights` or, where fewer directions shine, fewer.
pub(super) fn environment_lights(scene: &Scene, picture: Option<&Picture>) -> Vec<Light> {
    let environment = &scene.environment;
    if environment.lights == 0 || environment.intensity == 0.0 {
        return Vec::new();
    }
    let cells = cells(environment, picture);
    let (up, front) = up_and_front(&scene.camera);
    let axes = axes(environment, up, front);
    let light = |(towards, region): &(DVec3, Cell)| {
        let towards = axes[0] * towards.x + axes[1] * towards.y + axes[2] * towards.z;
        Light {
            // Radiance times solid angle is irradiance.
            color: region.flux.map(|flux| (flux / PI) as f32),
            intensity: environment.intensity,
            attachment: Some(Attachment::World),
            direction: Some((-towards).as_vec3().to_array()),
            angular_radius: angular_radius(region),
            ..Light::of_kind(LightKind::Distant)
        }
    };
    regions(&cells, environment.lights).iter().map(light).collect()
}

/// Regions of directions that shine, `count` at most, each with the direction of its luminance.
fn regions(cells: &[Cell], count: u32) -> Vec<(DVec3, Cell)> {
    let shining = || cells.iter().filter(|cell| cell.luminance > 0.0);
    if shining().next().is_none() {
        return Vec::new();
    }
    let points = spiral(cells, count);
    let mut regions: Vec<(DVec3, Cell)> = points.iter().map(|&point| (point, Cell::default())).collect();
    for cell in shining() {
        let mut nearest = (0, f64::NEG_INFINITY);
        for (index, point) in points.iter().enumerate() {
            let along = cell.moment.dot(*point);
            if along > nearest.1 {
                nearest = (index, along);
            }
        }
        regions[nearest.0].1.add(cell);
    }
    regions.retain(|(_, region)| region.luminance > 0.0);
    for (towards, region) in &mut regions {
        // The luminance of a whole sphere has no direction; its point has one.
        if region.moment.length() > 1e-6 * region.luminance {
            *towards = region.moment.normalize();
        }
    }
    regions
}

/// The angular radius, in degrees, of a source that is equally bright all over and whose light is as parallel as that of a region.
///
/// The mean of the unit directions of a cap of angular radius α is (1 + cos α) / 2 long.
fn angular_radius(region: &Cell) -> f32 {
    let cosine = 2.0 * region.moment.length() / region.luminance - 1.0;
    let degrees = libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    if degrees < NARROWEST { 0.0 } else { degrees.min(WIDEST) as f32 }
}
