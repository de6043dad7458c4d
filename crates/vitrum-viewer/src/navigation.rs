//! Navigation: the camera of the scene under the hand.

use glam::DVec3;
use vitrum::method::{Bounds, View};
use vitrum::scene::{Camera, Light, Projection, Scene};

/// Degrees that a drag across the shorter side of the picture turns the camera.
const ACROSS: f32 = 180.0;

/// The highest elevation of a camera, in degrees.
const STEEPEST: f32 = 89.0;

/// Zooms that scenes have.
const ZOOMS: [f32; 2] = [0.01, 100.0];

/// What is shown, as the camera of a scene sees it.
pub struct Placed {
    view: View,
    size: [u32; 2],
    /// The box around what is shown.
    pub bounds: Bounds,
}

impl Placed {
    /// What the scene's camera sees of what lies in `bounds`.
    pub fn new(scene: &Scene, bounds: Bounds) -> Self {
        Self { view: View::new(scene, bounds), size: [scene.film.width, scene.film.height], bounds }
    }

    /// The picture's place of a point of the world, in shares of its width and height from the upper left corner; `None` behind the eye.
    pub fn share(&self, world: DVec3) -> Option<[f64; 2]> {
        let [x, y] = self.view.project(world, self.size)?;
        Some([x / f64::from(self.size[0]), y / f64::from(self.size[1])])
    }
}

/// Turns the camera around its target, as if the hand turned what is shown: by `delta`, in shares of the picture's shorter side, to the right and downwards.
pub fn orbit(scene: &mut Scene, bounds: Bounds, delta: [f32; 2]) {
    go_on_orbit(scene, bounds);
    let camera = &mut scene.camera;
    // Upside down the hand would pull the other way.
    let (sin, cos) = libm::sincosf(camera.roll.to_radians());
    let [across, down] = [delta[0] * cos - delta[1] * sin, delta[0] * sin + delta[1] * cos];
    camera.azimuth = wrapped(camera.azimuth - across * ACROSS);
    camera.elevation = (camera.elevation + down * ACROSS).clamp(-STEEPEST, STEEPEST);
}

/// Moves what is shown across the viewing direction, by `delta` in shares of the picture's height, to the right and downwards.
pub fn pan(scene: &mut Scene, bounds: Bounds, delta: [f32; 2]) {
    go_on_orbit(scene, bounds);
    let view = View::new(scene, bounds);
    let height = view.pixel_size(1, view.target_depth);
    let [right, down] = delta.map(f64::from);
    let target = view.eye + view.axes.z_axis * view.target_depth;
    let moved = target - view.axes.x_axis * (right * height) + view.axes.y_axis * (down * height);
    scene.camera.target = Some(moved.as_vec3().to_array());
}

/// Magnifies by a factor.
pub fn zoom(camera: &mut Camera, factor: f32) {
    let [least, most] = ZOOMS;
    camera.zoom = (camera.zoom * factor).clamp(least, most);
}

/// Turns the picture around its middle, in degrees counter-clockwise.
pub fn roll(camera: &mut Camera, degrees: f32) {
    camera.roll = wrapped(camera.roll - degrees);
}

/// Changes the projection; what lies at the depth of the target keeps its size.
pub fn project(scene: &mut Scene, bounds: Bounds, projection: Projection) {
    if scene.camera.projection == projection {
        return;
    }
    go_on_orbit(scene, bounds);
    let height = |scene: &Scene| {
        let view = View::new(scene, bounds);
        view.pixel_size(1, view.target_depth)
    };
    let before = height(scene);
    scene.camera.projection = projection;
    let after = height(scene);
    zoom(&mut scene.camera, (after / before) as f32);
}

/// Turns a distant light: what is dragged to the right shines more from the right. `delta` is in radii of the ball.
pub fn turn_light(light: &mut Light, delta: [f32; 2]) {
    // A direction takes the place of angles.
    light.direction = None;
    light.azimuth = wrapped(light.azimuth + delta[0] * 60.0);
    light.elevation = (light.elevation - delta[1] * 60.0).clamp(-90.0, 90.0);
}

/// Puts a camera whose position is given onto an orbit around its target, where it sees the same.
fn go_on_orbit(scene: &mut Scene, bounds: Bounds) {
    if scene.camera.position.is_none() {
        return;
    }
    let view = View::new(scene, bounds);
    let towards_eye = -view.axes.z_axis;
    let right = (-view.front).cross(view.up);
    let camera = &mut scene.camera;
    let target = view.eye + view.axes.z_axis * view.target_depth;
    camera.azimuth = libm::atan2(towards_eye.dot(right), towards_eye.dot(view.front)).to_degrees() as f32;
    let elevation = libm::asin(towards_eye.dot(view.up).clamp(-1.0, 1.0)).to_degrees() as f32;
    camera.elevation = elevation.clamp(-STEEPEST, STEEPEST);
    camera.target = Some(target.as_vec3().to_array());
    camera.distance = Some(view.target_depth);
    camera.position = None;
}

/// An angle from −180 to 180 degrees.
fn wrapped(degrees: f32) -> f32 {
    let turns = ((degrees + 180.0) / 360.0).floor();
    degrees - 360.0 * turns
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::io::Volume;

    fn cube() -> Bounds {
        let volume = Volume::new("a cube", [8; 3], [1.0; 3], vec![0_u8; 512].into()).expect("it is valid");
        Bounds::from(&volume)
    }

    #[test]
    fn what_is_dragged_to_the_right_turns_to_the_right() {
        let mut scene = Scene::default();
        let point = View::new(&scene, cube()).eye;
        orbit(&mut scene, cube(), [0.1, 0.0]);
        // The point that was nearest is now on the right.
        assert!(View::new(&scene, cube()).point(point).x > 0.0);
        assert_eq!(scene.camera.azimuth, Camera::default().azimuth - 18.0);
        orbit(&mut scene, cube(), [0.0, 10.0]);
        assert_eq!(scene.camera.elevation, STEEPEST);
        scene.camera.azimuth = -179.0;
        orbit(&mut scene, cube(), [0.1, 0.0]);
        assert_eq!(scene.camera.azimuth, 163.0);
    }

    #[test]
    fn a_point_under_the_hand_stays_there_while_panned() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let mut scene = Scene::default();
            (scene.camera.projection, scene.camera.roll) = (projection, 30.0);
            (scene.film.width, scene.film.height) = (200, 100);
            let view = View::new(&scene, cube());
            let target = view.eye + view.axes.z_axis * view.target_depth;
            let at = view.project(target, [200, 100]).expect("it is in front");
            pan(&mut scene, cube(), [0.2, -0.1]);
            let moved = View::new(&scene, cube()).project(target, [200, 100]).expect("it is in front");
            let [x, y] = [moved[0] - at[0], moved[1] - at[1]];
            assert!((x - 20.0).abs() < 1e-3 && (y + 10.0).abs() < 1e-3, "{projection:?} {x} {y}");
        }
    }

    #[test]
    fn a_camera_at_a_position_goes_on_an_orbit_without_a_jump() {
        let mut scene = Scene::default();
        scene.camera.position = Some([20.0, -7.0, 9.0]);
        let before = View::new(&scene, cube());
        orbit(&mut scene, cube(), [0.0, 0.0]);
        let after = View::new(&scene, cube());
        assert!(scene.camera.position.is_none());
        assert!((before.eye - after.eye).length() < 1e-4, "{} {}", before.eye, after.eye);
        assert!((before.axes.x_axis - after.axes.x_axis).length() < 1e-5);
    }

    #[test]
    fn another_projection_keeps_the_size() {
        let mut scene = Scene::default();
        scene.camera.zoom = 1.5;
        let size = |scene: &Scene| {
            let view = View::new(scene, cube());
            view.pixel_size(100, view.target_depth)
        };
        let before = size(&scene);
        project(&mut scene, cube(), Projection::Orthographic);
        assert!((size(&scene) / before - 1.0).abs() < 1e-5);
        project(&mut scene, cube(), Projection::Perspective);
        assert!((scene.camera.zoom - 1.5).abs() < 1e-5);
    }

    #[test]
    fn light_follows_the_hand() {
        let mut light = Light { azimuth: 0.0, elevation: 0.0, direction: Some([0.0, 0.0, -1.0]), ..Light::default() };
        turn_light(&mut light, [0.5, -0.5]);
        assert_eq!((light.azimuth, light.elevation, light.direction), (30.0, 30.0, None));
    }
}
