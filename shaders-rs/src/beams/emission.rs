//! Rays of light as they start: from a distant light, a point or a spot, through the texels of the lattice (Hu et al. 2010, §5.1).

use super::spread::Spread;
use crate::abi::beams::BeamsUniforms;
use crate::abi::light::kind;
use crate::math::{PI, dot, length, select_vector, xyz};
use crate::optics::light_source::arriving;
use spirv_std::glam::Vec3;

/// A ray at its start: the derivatives are by the coordinates of its texel, or pixel.
#[derive(Clone, Copy)]
pub struct Start {
    /// Position, in voxels.
    pub position: Vec3,
    /// Unit direction.
    pub direction: Vec3,
    /// Changes over the texel.
    pub spread: Spread,
}

/// The ray of light through texel (`column`, `row`).
#[inline(always)]
pub fn start(u: &BeamsUniforms, column: i32, row: i32) -> Start {
    let lattice = &u.lattice;
    let (across, upwards) = (xyz(lattice.across), xyz(lattice.upwards));
    let x = lattice.low_across + (column as f32 + 0.5) * lattice.step_across;
    let y = lattice.low_upwards + (row as f32 + 0.5) * lattice.step_upwards;
    let (along_u, along_v) = (across * lattice.step_across, upwards * lattice.step_upwards);
    let side = across * x + upwards * y;
    let origin = xyz(lattice.origin);
    let axis = xyz(lattice.axis);
    let distant = u.light.kind == kind::DISTANT;
    let zero = Vec3::new(0.0, 0.0, 0.0);
    let aim = axis + side;
    let inverse = 1.0 / length(aim);
    let direction = select_vector(distant, axis, aim * inverse);
    // The derivative of a unit vector lies across it.
    let turned = |along: Vec3| (along - direction * dot(along, direction)) * inverse;
    Start {
        position: select_vector(distant, origin + side, origin),
        direction,
        spread: Spread {
            position_u: select_vector(distant, along_u, zero),
            position_v: select_vector(distant, along_v, zero),
            direction_u: select_vector(distant, zero, turned(along_u)),
            direction_v: select_vector(distant, zero, turned(along_v)),
        },
    }
}

/// Flux of the ray of light through a texel, RGB: irradiance times squared voxels.
#[inline(always)]
pub fn flux(u: &BeamsUniforms, pictures: &[f32], start: &Start) -> Vec3 {
    let lattice = &u.lattice;
    let texel = lattice.step_across * lattice.step_upwards;
    if u.light.kind == kind::DISTANT {
        xyz(u.light.color) * (PI * texel)
    } else {
        // At distance 1 the radiant intensity is the irradiance; the texel's solid angle is its area times the cosine's cube.
        let cosine = dot(start.direction, xyz(lattice.axis));
        let unit = arriving(&u.light, pictures, xyz(lattice.origin) + start.direction);
        unit.radiance * (PI * texel * (cosine * cosine * cosine))
    }
}
