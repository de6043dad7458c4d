//! The parts of a scene that every method has: the camera's view, the environment, receivers, lights' directions and places.
//!
//! The view frame, in which all of them are stated: x right, y up, z the depth away from the eye, in world units, the eye at the origin.

pub(in crate::method) mod ambient;
pub(in crate::method) mod bounds;
pub(in crate::method) mod environment;
pub(in crate::method) mod light;
mod matrices;
pub(in crate::method) mod pictures;
pub(in crate::method) mod receivers;

pub use bounds::Bounds;
pub use matrices::CameraMatrices;

use crate::scene::{Camera, Projection, Scene, Vector};
use glam::{DMat3, DVec3};
use vitrum_io::Volume;

/// The share of the bounding sphere's radius that fits into the picture where `zoom` is 1 and no distance is given: a box seen face on fills it well, and
/// only a box seen exactly corner on touches the edge.
const FIT: f64 = 0.87;

/// The view: position, axes and projection of the camera.
#[derive(Debug, Clone, Copy)]
pub struct View {
    /// The eye, in the world.
    pub eye: DVec3,
    /// Unit vectors of the view frame, in the world, as columns: right, up, away from the eye.
    pub axes: DMat3,
    /// Whether rays are parallel.
    pub orthographic: bool,
    /// Half the picture's width and height: at depth 1 (perspective), or anywhere (orthographic).
    pub half_size: [f64; 2],
    /// The world's up as the camera has it.
    pub up: DVec3,
    /// The horizontal direction from which azimuth 0 looks.
    pub front: DVec3,
    /// Depth of the target.
    pub target_depth: f64,
}

/// A scene vector in double precision.
pub(crate) fn vector(v: Vector) -> DVec3 {
    DVec3::new(f64::from(v[0]), f64::from(v[1]), f64::from(v[2]))
}

/// Columns: the world vector of one voxel step along each axis of the volume.
pub(in crate::method) fn voxel_steps(volume: &Volume) -> DMat3 {
    let step = |axis: usize| vector(volume.axes[axis]) * f64::from(volume.spacing[axis]);
    DMat3::from_cols(step(0), step(1), step(2))
}

/// The point in the world at voxel coordinates `at`.
pub(crate) fn point_between_voxels(volume: &Volume, at: DVec3) -> DVec3 {
    vector(volume.origin) + voxel_steps(volume) * at
}

/// The world's up and, across it, the direction from which azimuth 0 looks.
pub(in crate::method) fn up_and_front(camera: &Camera) -> (DVec3, DVec3) {
    let up = vector(camera.up).try_normalize().unwrap_or(DVec3::Z);
    let front = if up.y.abs() < 0.9 { DVec3::Y } else { DVec3::Z };
    (up, (front - up * front.dot(up)).normalize())
}

/// The direction from the centre towards (azimuth, elevation), in degrees: 0, 0 is `front`, positive azimuth to the right of a
/// viewer who stands there.
pub(in crate::method) fn from_angles(up: DVec3, front: DVec3, azimuth: f32, elevation: f32) -> DVec3 {
    let right = (-front).cross(up);
    let [(sin, cos), (height, level)] =
        [azimuth, elevation].map(|degrees| libm::sincos(f64::from(degrees).to_radians()));
    (front * cos + right * sin) * level + up * height
}

/// The tangent of half the narrower side of the camera's field of view with zoom 1.
fn narrow_tangent(scene: &Scene) -> f64 {
    tangent(&scene.camera) * aspect(scene).min(1.0)
}

/// The tangent of half the camera's vertical field of view with zoom 1.
fn tangent(camera: &Camera) -> f64 {
    libm::tan((f64::from(camera.field_of_view) * 0.5).to_radians())
}

/// The picture's width over its height.
fn aspect(scene: &Scene) -> f64 {
    f64::from(scene.film.width) / f64::from(scene.film.height)
}

/// The distance from the eye, in perspective, at which a sphere of radius `radius` / `share` fits into a picture with zoom 1.
pub(in crate::method) fn fitting_distance(scene: &Scene, radius: f64, share: f64) -> f64 {
    let narrow = narrow_tangent(scene);
    FIT * radius / share * (1.0 + narrow * narrow).sqrt() / narrow
}

impl View {
    /// The view of a scene's camera on a subject with these bounds.
    pub fn new(scene: &Scene, bounds: impl Into<Bounds>) -> Self {
        let camera = &scene.camera;
        let (centre, radius) = bounds.into().sphere();
        let target = camera.target.map_or(centre, vector);
        let (up, front) = up_and_front(camera);
        let orthographic = camera.projection == Projection::Orthographic;
        let aspect = aspect(scene);
        let zoom = f64::from(camera.zoom);
        let distance = if orthographic {
            4.0 * radius
        } else {
            camera.distance.unwrap_or_else(|| fitting_distance(scene, radius, 1.0))
        };
        let towards_eye = from_angles(up, front, camera.azimuth, camera.elevation);
        let eye = camera.position.map_or(target + towards_eye * distance, vector);
        let away = (target - eye).try_normalize().unwrap_or(-towards_eye);
        let right = away.cross(up).try_normalize().unwrap_or_else(|| away.any_orthonormal_vector());
        let (sin, cos) = libm::sincos(f64::from(camera.roll).to_radians());
        let above = right.cross(away);
        let axes = DMat3::from_cols(right * cos + above * sin, above * cos - right * sin, away);
        // The narrower side of the picture decides what fits.
        let half_height = if orthographic { FIT * radius / zoom / aspect.min(1.0) } else { tangent(camera) / zoom };
        Self {
            eye,
            axes,
            orthographic,
            half_size: [half_height * aspect, half_height],
            up,
            front,
            target_depth: (target - eye).dot(away),
        }
    }

    /// A world point in the view frame.
    pub fn point(&self, world: DVec3) -> DVec3 {
        self.direction(world - self.eye)
    }

    /// A world direction in the view frame.
    pub fn direction(&self, world: DVec3) -> DVec3 {
        self.axes.transpose() * world
    }

    /// The edge of a pixel, in world units, at `depth`.
    pub fn pixel_size(&self, height: u32, depth: f64) -> f64 {
        let at = if self.orthographic { 1.0 } else { depth };
        2.0 * self.half_size[1] * at / f64::from(height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube of edge 2 around the origin.
    fn view(change: impl FnOnce(&mut Scene)) -> View {
        let mut scene = Scene::default();
        change(&mut scene);
        View::new(&scene, Bounds::new([[-1.0, 1.0]; 3], |at| at))
    }

    /// Where a point of the world is in the picture, from its centre, in halves of its height.
    fn projected(view: &View, world: DVec3) -> [f64; 2] {
        let at = view.point(world);
        let depth = if view.orthographic { 1.0 } else { at.z };
        [at.x, at.y].map(|across| across / (depth * view.half_size[1]))
    }

    #[test]
    fn zoom_magnifies_the_picture() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let zoomed = |zoom: f32| {
                view(|scene| {
                    scene.camera.projection = projection;
                    scene.camera.zoom = zoom;
                })
            };
            for point in [DVec3::new(0.3, -0.2, 0.5), DVec3::new(-0.9, 0.4, 0.1)] {
                let [[x, y], [wide, high]] = [1.0, 2.0].map(|zoom| projected(&zoomed(zoom), point));
                assert!((wide - 2.0 * x).abs() < 1e-12 && (high - 2.0 * y).abs() < 1e-12, "{projection:?}");
            }
            let whole = zoomed(1.0).eye;
            for zoom in [0.01, 6.0, 100.0] {
                assert_eq!(zoomed(zoom).eye, whole, "{projection:?}, {zoom}");
            }
            assert!(whole.length() > 3f64.sqrt());
        }
    }

    #[test]
    fn distance_moves_the_eye() {
        for distance in [0.5, 3.0, 40.0] {
            let moved = view(|scene| {
                scene.camera.distance = Some(distance);
                scene.camera.target = Some([0.5, 0.25, -0.5]);
                scene.camera.zoom = 3.0;
            });
            assert!(((moved.eye - DVec3::new(0.5, 0.25, -0.5)).length() - distance).abs() < 1e-12);
            assert!((moved.target_depth - distance).abs() < 1e-12);
        }
        let placed = view(|scene| {
            scene.camera.distance = Some(3.0);
            scene.camera.position = Some([0.0, 5.0, 0.0]);
        });
        assert_eq!(placed.eye, DVec3::new(0.0, 5.0, 0.0));
        let parallel = |distance| {
            view(|scene| {
                scene.camera.projection = Projection::Orthographic;
                scene.camera.distance = distance;
            })
        };
        assert_eq!(parallel(Some(1.5)).eye, parallel(None).eye);
    }

    /// A ball of the bounding sphere's radius times [`FIT`] touches the sides of the picture.
    #[test]
    fn the_distance_that_fits_a_ball_shows_its_outline() {
        for (width, height) in [(512, 512), (300, 500), (500, 300)] {
            let fitted = view(|scene| (scene.film.width, scene.film.height) = (width, height));
            let sine = FIT * 3f64.sqrt() / fitted.target_depth;
            let narrow = fitted.half_size[0].min(fitted.half_size[1]);
            assert!((sine / (1.0 - sine * sine).sqrt() - narrow).abs() < 1e-12, "{width} x {height}");
        }
    }
}
