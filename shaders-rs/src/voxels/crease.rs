//! Normals beside creases (not in Chang et al. 2010). Smoothing rounds edges off over some voxels, and the field's gradient there is a mean
//! of the faces' normals. The normal is then that of one face: each face's plane is carried on from where no edge is near, and the plane that
//! the point lies nearest to counts, as essentially non-oscillatory schemes take their differences from one side of a kink (Osher & Shu 1991).

use super::solid::{LEVEL, value};
use crate::abi::voxels::{BAND, VoxelsUniforms};
use crate::math::{absolute, cross, dot, length, max, normalize, select};
use spirv_std::glam::Vec3;

/// Change of a field over a voxel along its gradient, where no edge is near.
const SLOPE: f32 = 65535.0 / (2.0 * BAND);
/// Distance at which the faces beside a crease are looked for, in voxels: smoothing and differences reach 3 voxels along each axis.
const ASIDE: f32 = 6.0;
/// Directions around the point in which they are looked for.
const DIRECTIONS: i32 = 8;
/// Length of the gradient, over that of a plane's, below which an edge is near: half a degree beside a crease of 70°.
const PLANE: f32 = 0.998;
/// Sine of half the angle between two faces from which on the edge between them is a crease: 45°, as for normals at the corners of triangles.
const CREASE: f32 = 0.382_683_43;
/// Distance from a face's plane up to which a point of the smoothed surface may stand for a point of the face, in voxels: smoothing takes
/// 0.56 voxels off an edge of 90°, and less than √(2 / π) off any.
const ROUNDED: f32 = 0.8;
/// Distance along a ray from a point of the smoothed surface up to which a face is the one that it stands for, in voxels.
const FARTHEST: f32 = 4.0;

/// Signed distance from the surface in voxels, positive outside.
#[inline(always)]
fn distance(u: &VoxelsUniforms, fields: &[u32], number: i32, p: Vec3) -> f32 {
    (LEVEL - value(u, fields, number, p)) * (1.0 / SLOPE)
}

/// Gradient of the distance, by central differences over two voxels.
#[inline(always)]
fn gradient(u: &VoxelsUniforms, fields: &[u32], number: i32, p: Vec3) -> Vec3 {
    let at = |dx: f32, dy: f32, dz: f32| value(u, fields, number, Vec3::new(p.x + dx, p.y + dy, p.z + dz));
    let difference = Vec3::new(
        at(-1.0, 0.0, 0.0) - at(1.0, 0.0, 0.0),
        at(0.0, -1.0, 0.0) - at(0.0, 1.0, 0.0),
        at(0.0, 0.0, -1.0) - at(0.0, 0.0, 1.0),
    );
    difference * (0.5 / SLOPE)
}

/// Newton's step from a place near the surface onto it.
#[inline(always)]
fn towards_surface(u: &VoxelsUniforms, fields: &[u32], number: i32, p: Vec3) -> Vec3 {
    let slope = gradient(u, fields, number, p);
    p - slope * (distance(u, fields, number, p) / max(dot(slope, slope), 0.25))
}

/// A unit vector across `v`.
#[inline(always)]
fn across(v: Vec3) -> Vec3 {
    let (x, y, z) = (absolute(v.x), absolute(v.y), absolute(v.z));
    let shortest_x = (x <= y) & (x <= z);
    let axis = if shortest_x {
        Vec3::new(1.0, 0.0, 0.0)
    } else if y <= z {
        Vec3::new(0.0, 1.0, 0.0)
    } else {
        Vec3::new(0.0, 0.0, 1.0)
    };
    normalize(cross(v, axis))
}

/// The face of a body that a ray meets.
#[derive(Clone, Copy)]
pub struct Face {
    /// Unit normal, outwards.
    pub normal: Vec3,
    /// Distance along the ray from the smoothed surface to the face, in voxels; 0 where no crease is near.
    pub ahead: f32,
}

/// The face of material `number` that a ray along `direction` meets where it meets the smoothed surface, at `p`.
#[inline(always)]
pub fn face(u: &VoxelsUniforms, fields: &[u32], number: i32, p: Vec3, direction: Vec3) -> Face {
    let mean = gradient(u, fields, number, p);
    let mean_length = length(mean);
    let smoothed = mean * (1.0 / max(mean_length, 1e-6));
    if mean_length >= PLANE {
        return Face { normal: smoothed, ahead: 0.0 };
    }
    let along = dot(smoothed, direction);
    let first_axis = across(smoothed);
    let second_axis = cross(smoothed, first_axis);
    let (mut cosine, mut sine) = (1.0, 0.0);
    let mut nearest = Face { normal: smoothed, ahead: 0.0 };
    let mut least = FARTHEST;
    let mut i = 0;
    while i < DIRECTIONS {
        let aside = p + (first_axis * cosine + second_axis * sine) * ASIDE;
        // The field is cut off: far from the surface the first step misses it.
        let on_face = towards_surface(u, fields, number, aside);
        let gradient = gradient(u, fields, number, on_face);
        let steepness = length(gradient);
        let normal = gradient * (1.0 / max(steepness, 1e-6));
        // Signed distance of the point from the face's plane.
        let away = distance(u, fields, number, on_face) + dot(normal, p - on_face);
        // The gradient at the point is (1 − w) n + w m, of this face's normal n and another's m: the difference to n is w (m − n), and the
        // angle between both faces twice that whose sine is the cosine between n − m and n.
        let difference = normal - mean;
        let creased = dot(difference, normal) >= CREASE * length(difference);
        // A ray that enters the body does so through a face that it meets from outside. Of several the one counts that it meets
        // nearest to the smoothed surface: the last one that it enters where the edge is convex, the first one where it is concave.
        let facing = dot(normal, direction);
        let ahead = -away / select(facing == 0.0, 1.0, facing);
        let there = (facing * along > 0.0) & (absolute(away) < ROUNDED);
        if (steepness >= PLANE) & creased & there & (absolute(ahead) < least) {
            least = absolute(ahead);
            nearest = Face { normal, ahead };
        }
        // By 45°.
        let turned = core::f32::consts::FRAC_1_SQRT_2;
        (cosine, sine) = ((cosine - sine) * turned, (cosine + sine) * turned);
        i += 1;
    }
    nearest
}
