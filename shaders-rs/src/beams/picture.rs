//! The picture of a beam: a ray of light is a straight line in the picture, whose edge function is the light's moment about the eye seen along
//! the viewing rays (the reciprocal product of two lines, Plücker 1865).

use crate::abi::beams::BeamsUniforms;
use crate::abi::record::Beam;
use crate::math::{cross, dot, select, xyz};
use spirv_std::glam::Vec3;

/// A function of the picture's pixels, `x` · column + `y` · row + `constant`, from the centre of the first pixel on.
#[derive(Clone, Copy)]
pub struct Edge {
    /// Factor of the column.
    pub x: f32,
    /// Factor of the row.
    pub y: f32,
    /// The value at the first pixel's centre.
    pub constant: f32,
}

impl Edge {
    /// The value at a pixel.
    #[inline(always)]
    pub fn at(&self, column: f32, row: f32) -> f32 {
        self.x * column + (self.y * row + self.constant)
    }
}

/// The edge function w' · (offset × turned + …) of a moment about the eye, `moment`, of a line whose direction is, or changes by, `direction`: w' is the
/// viewing direction of length 1 along the view's axis; in a parallel projection the eye moves with the pixel.
#[inline(always)]
fn edge(u: &BeamsUniforms, moment: Vec3, direction: Vec3) -> Edge {
    let (right, up, away) = (xyz(u.right), xyz(u.up), xyz(u.away));
    let orthographic = u.camera.orthographic != 0;
    // −away · (right × d), −away · (up × d)
    let across = select(orthographic, -dot(cross(away, right), direction), dot(right, moment));
    let upwards = select(orthographic, -dot(cross(away, up), direction), dot(up, moment));
    let constant = dot(away, moment);
    let (width, height) = (u.picture.width as i32 as f32, u.picture.height as i32 as f32);
    let (half_width, half_height) = (u.camera.half_width, u.camera.half_height);
    Edge {
        x: across * (2.0 * half_width / width),
        y: upwards * (-2.0 * half_height / height),
        constant: constant
            + across * (half_width / width - half_width)
            + upwards * (half_height - half_height / height),
    }
}

/// The edge functions of a beam.
#[derive(Clone, Copy)]
pub struct Edges {
    /// 0 where the beam's middle is, in voxels.
    pub middle: Edge,
    /// Change over the texel along its first coordinate.
    pub change_u: Edge,
    /// Change along its second coordinate.
    pub change_v: Edge,
}

impl Edges {
    /// The edge functions of a beam for the viewing rays of the picture.
    #[inline(always)]
    pub fn new(u: &BeamsUniforms, beam: &Beam) -> Self {
        let offset = beam.position - xyz(u.eye);
        let change = |position: Vec3, direction: Vec3| {
            edge(u, cross(position, beam.direction) + cross(offset, direction), direction)
        };
        Self {
            middle: edge(u, cross(offset, beam.direction), beam.direction),
            change_u: change(beam.position_u, beam.direction_u),
            change_v: change(beam.position_v, beam.direction_v),
        }
    }
}
