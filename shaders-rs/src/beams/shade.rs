//! The diffuse surface at the end of a straight piece of a viewing ray.

use super::see::Piece;
use crate::abi::beams::{BeamsUniforms, flag};
use crate::abi::receivers::ahead;
use crate::abi::record::Pencil;
use crate::math::select;
use crate::voxels::contact::material_of;
use crate::voxels::shade::{Point, on_receiver, on_triangle};
use crate::voxels::surface::ior;

/// Distance within which points of surfaces are taken for one, in voxels.
pub const SAME: f32 = 0.05;

/// The end of a straight piece.
#[derive(Clone, Copy)]
pub struct Ending {
    /// Whether a diffuse surface is there.
    pub is_diffuse: bool,
    /// The surface.
    pub point: Point,
}

/// Whether the piece of a ray that has come to the triangle or receiver `target` ends at a diffuse surface.
#[inline(always)]
pub fn is_diffuse(target: i32, corners: &[f32], materials: &[f32]) -> bool {
    let material = material_of(if target >= 0 { target } else { 0 }, corners);
    let of_triangle = ior(material, materials) == 0.0;
    if target >= 0 { of_triangle } else { target != ahead::NOTHING }
}

/// The end of a piece of a ray.
#[inline(always)]
pub fn ending(
    u: &BeamsUniforms,
    pencil: &Pencil,
    piece: &Piece,
    corners: &[f32],
    looks: &[f32],
    materials: &[f32],
) -> Ending {
    let far = select(pencil.triangle == ahead::NOTHING, 0.0, piece.far);
    let position = piece.from + pencil.direction * far;
    let of_triangle = u.flags & flag::LOOK_OF_TRIANGLE != 0;
    let point = if pencil.triangle >= 0 {
        on_triangle(of_triangle, corners, looks, pencil.triangle, position)
    } else {
        on_receiver(&u.receivers, pencil.triangle, position)
    };
    Ending { is_diffuse: is_diffuse(pencil.triangle, corners, materials), point }
}
