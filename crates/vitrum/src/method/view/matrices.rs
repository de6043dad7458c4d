//! The camera as matrices, for other programs, and the picture's place of a point.

use super::{Bounds, View};
use glam::{DMat4, DVec3, DVec4};
use serde::Serialize;

/// The camera of a frame, in world units. Matrices are lists of rows and multiply columns: a point of the world is at `projection` · `view` · (x, y, z, 1) in
/// clip coordinates, −1 to 1 from left to right, from bottom to top and from the near to the far plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CameraMatrices {
    /// Edge of a pixel: anywhere (orthographic), or at the depth of the camera's target (perspective).
    pub pixel_size: f64,
    /// Whether viewing rays are parallel, so that `pixel_size` holds at any depth.
    pub orthographic: bool,
    /// The eye.
    pub eye: [f64; 3],
    /// Distance of the plane through the target, across the viewing direction, from the eye.
    pub target_depth: f64,
    /// From the world to the camera, which looks along −z with y up.
    pub view: [[f64; 4]; 4],
    /// From the camera to clip coordinates; near and far plane touch the sphere around the volume or mesh.
    pub projection: [[f64; 4]; 4],
}

impl View {
    /// The place of a point of the world in a picture of `size` pixels, from its upper left corner: the centre of the first pixel is at (½, ½). `None` behind
    /// the eye.
    #[must_use]
    pub fn project(&self, world: DVec3, size: [u32; 2]) -> Option<[f64; 2]> {
        let at = self.point(world);
        let scale = if self.orthographic { 1.0 } else { at.z };
        let [width, height] = size.map(f64::from);
        let x = at.x / (scale * self.half_size[0]);
        let y = at.y / (scale * self.half_size[1]);
        (scale > 0.0).then_some([0.5 * (1.0 + x) * width, 0.5 * (1.0 - y) * height])
    }

    /// The camera's matrices in a picture `height` pixels high of a subject with these bounds.
    #[must_use]
    pub fn matrices(&self, height: u32, bounds: impl Into<Bounds>) -> CameraMatrices {
        let [right, above, away] = [self.axes.x_axis, self.axes.y_axis, self.axes.z_axis];
        let row = |axis: DVec3| axis.extend(-axis.dot(self.eye));
        let view = [row(right), row(above), row(-away), DVec4::W];
        let (centre, radius) = bounds.into().sphere();
        let middle = self.point(centre).z;
        let far = (middle + radius).max(2e-3 * radius);
        let near = middle - radius;
        let [wide, high] = self.half_size;
        let projection = if self.orthographic {
            let depth = far - near;
            [
                DVec4::new(1.0 / wide, 0.0, 0.0, 0.0),
                DVec4::new(0.0, 1.0 / high, 0.0, 0.0),
                DVec4::new(0.0, 0.0, -2.0 / depth, -(far + near) / depth),
                DVec4::W,
            ]
        } else {
            let near = near.max(1e-3 * radius);
            let depth = far - near;
            [
                DVec4::new(1.0 / wide, 0.0, 0.0, 0.0),
                DVec4::new(0.0, 1.0 / high, 0.0, 0.0),
                DVec4::new(0.0, 0.0, -(far + near) / depth, -2.0 * far * near / depth),
                -DVec4::Z,
            ]
        };
        CameraMatrices {
            pixel_size: self.pixel_size(height, self.target_depth),
            orthographic: self.orthographic,
            eye: self.eye.to_array(),
            target_depth: self.target_depth,
            view: view.map(|row| row.to_array()),
            projection: projection.map(|row| row.to_array()),
        }
    }
}

impl CameraMatrices {
    /// A point of the world in clip coordinates, divided by their fourth.
    #[must_use]
    pub fn clip(&self, world: DVec3) -> DVec3 {
        let rows = |rows: [[f64; 4]; 4]| DMat4::from_cols_array_2d(&rows).transpose();
        let at = rows(self.projection) * rows(self.view) * world.extend(1.0);
        at.truncate() / at.w
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Projection, Scene};

    #[test]
    fn matrices_and_projection_are_of_one_mind() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let mut scene = Scene::default();
            scene.camera.projection = projection;
            scene.camera.roll = 20.0;
            (scene.film.width, scene.film.height) = (300, 200);
            let bounds = Bounds::new([[-1.0, 1.0], [-2.0, 2.0], [-0.5, 0.5]], |at| at);
            let view = View::new(&scene, bounds);
            let matrices = view.matrices(200, bounds);
            for point in [DVec3::new(0.3, -0.2, 0.5), DVec3::new(-0.9, 1.4, 0.1), DVec3::ZERO] {
                let clip = matrices.clip(point);
                let [x, y] = view.project(point, [300, 200]).expect("it is before the eye");
                let error = (150.0 * (1.0 + clip.x) - x).abs() + (100.0 * (1.0 - clip.y) - y).abs();
                assert!(error < 1e-9 && clip.z.abs() < 1.0, "{projection:?}: {clip}");
            }
            // The middle of the near plane is as far in front as the sphere's radius is long.
            let (_, radius) = bounds.sphere();
            let near = view.eye + view.axes.z_axis * (view.target_depth - radius);
            assert!((matrices.clip(near).z + 1.0).abs() < 1e-9, "{projection:?}");
        }
    }

    #[test]
    fn what_is_behind_the_eye_has_no_place() {
        let scene = Scene::default();
        let view = View::new(&scene, Bounds::new([[-1.0, 1.0]; 3], |at| at));
        assert_eq!(view.project(view.eye - view.axes.z_axis, [10, 10]), None);
        let [x, y] = view.project(DVec3::ZERO, [10, 10]).expect("the target is before the eye");
        assert!((x - 5.0).abs() < 1e-9 && (y - 5.0).abs() < 1e-9);
    }
}
