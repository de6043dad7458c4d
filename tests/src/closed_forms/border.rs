//! A block of glass that fills its volume's box: rays are bent at the faces of the box alone, by Snell's law.

use vitrum::Frame;
use vitrum::io::Volume;
use vitrum::method::View;
use vitrum::scene::{Clip, IorPoint, Scene};
use vitrum_kernels::glam::DVec3;

use super::{cuboid, end, straight_on};
use crate::refraction::refract;

/// Voxels of the block along each axis.
pub const VOXELS: [u32; 3] = [40, 32, 24];
/// Edge of a voxel.
pub const VOXEL: f32 = 0.05;

/// The block; its scalar is 1 everywhere, and the scene says which index that is.
#[must_use]
pub fn block() -> Volume {
    cuboid(VOXELS, VOXEL, |_| 1.0)
}

/// Half the block's edges.
#[must_use]
pub fn half() -> DVec3 {
    DVec3::from_array(VOXELS.map(|n| f64::from(n) * f64::from(VOXEL) * 0.5))
}

/// A scene that shows nothing of the block but its refraction.
#[must_use]
pub fn scene(ior: f32, pixels: u32) -> Scene {
    let mut scene = straight_on(pixels);
    scene.transfer.ior = vec![IorPoint::new(0.0, ior), IorPoint::new(2.0, ior)];
    scene.transfer.opacity = vec![vitrum::scene::OpacityPoint { value: 0.0, opacity: 0.0 }];
    scene.shading.specular = 0.0;
    scene
}

/// The half-space `normal · x ≤ distance` of the world that a clipping plane of a block around the origin leaves.
#[must_use]
pub fn cut(normal: [f32; 3], distance: f32) -> Clip {
    Clip { normal, offset: distance, ..Clip::default() }
}

/// A ray: a point of it and its unit direction, in the world.
pub type Ray = (DVec3, DVec3);

/// The viewing ray of pixel (x, y), and its end in the picture.
///
/// # Panics
/// If the frame has no such outputs.
#[must_use]
pub fn ray_and_end(scene: &Scene, volume: &Volume, frame: &Frame, (x, y): (u32, u32)) -> (Ray, Ray, f32) {
    let view = View::new(scene, volume);
    let share = |at: u32, edge: u32| (f64::from(at) + 0.5) / f64::from(edge) * 2.0 - 1.0;
    let across = share(x, frame.width) * view.half_size[0];
    let up = -share(y, frame.height) * view.half_size[1];
    let side = view.axes.x_axis * across + view.axes.y_axis * up;
    let begins = if view.orthographic {
        (view.eye + side, view.axes.z_axis)
    } else {
        (view.eye, (view.axes.z_axis + side).normalize())
    };
    let found = end(frame, x, y);
    let world = |[x, y, z]: [f64; 3]| view.axes * DVec3::new(x, y, -z);
    (begins, (view.eye + world(found.position), world(found.direction)), found.status)
}

/// Planes as (outward unit normal, distance): the convex space on their inner sides is glass.
#[must_use]
pub fn faces(cuts: &[Clip]) -> Vec<(DVec3, f64)> {
    let mut faces: Vec<(DVec3, f64)> = (0..6)
        .map(|face| {
            let mut normal = DVec3::ZERO;
            normal[face / 2] = if face % 2 == 0 { 1.0 } else { -1.0 };
            (normal, half()[face / 2])
        })
        .collect();
    for cut in cuts {
        let normal = DVec3::from_array(cut.normal.map(f64::from)).normalize();
        faces.push((normal, f64::from(cut.offset)));
    }
    faces
}

/// The end of a ray that goes through the glass of index `ior` between `faces`, or begins in it; `None` if it is reflected more than a few
/// times, or turns back from `towards`.
#[must_use]
pub fn through(ray: Ray, faces: &[(DVec3, f64)], ior: f64, towards: DVec3) -> Option<Ray> {
    let (mut at, mut direction) = ray;
    let (mut enters, mut face) = (f64::NEG_INFINITY, DVec3::ZERO);
    let mut leaves = f64::INFINITY;
    for &(normal, distance) in faces {
        let (outside, speed) = (normal.dot(at) - distance, normal.dot(direction));
        if speed < 0.0 && -outside / speed > enters {
            (enters, face) = (-outside / speed, normal);
        } else if speed > 0.0 {
            leaves = leaves.min(-outside / speed);
        } else if speed == 0.0 && outside > 0.0 {
            return Some(ray);
        }
    }
    if enters >= leaves || leaves <= 0.0 {
        return Some(ray);
    }
    if enters > 0.0 {
        at += direction * enters;
        direction = refract(direction, face, 1.0, ior)?;
    }
    for _ in 0..4 {
        let way = |&(normal, distance): &(DVec3, f64)| {
            let speed = normal.dot(direction);
            (speed > 1e-12).then(|| ((distance - normal.dot(at)) / speed, normal))
        };
        let (along, normal) = faces.iter().filter_map(way).min_by(|a, b| a.0.total_cmp(&b.0))?;
        at += direction * along;
        if let Some(out) = refract(direction, normal, ior, 1.0) {
            return (out.dot(towards) > 0.05).then_some((at, out));
        }
        direction -= normal * (2.0 * direction.dot(normal));
        if direction.dot(towards) < 0.05 {
            return None;
        }
    }
    None
}
