//! Where the light of a texel comes from: the back trace to the plane behind (sweep §4.2, Algorithm 1, lines 7 and 8).

use crate::abi::record::{light as record, trace};
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::access::read;
use crate::field::light::direction;
use crate::math::{max, select};
use spirv_std::glam::Vec3;

/// Texels that light with direction `v` moves between the planes, relative to the sheared grid.
#[inline(always)]
fn slope(u: &SweepUniforms, v: Vec3) -> (f32, f32) {
    let inverse = 1.0 / max(v.z, 1e-6);
    let texels = u.plane.z * u.light_grid.w;
    ((v.x * inverse - u.light_shear.x) * texels, (v.y * inverse - u.light_shear.y) * texels)
}

/// The point, in texels of the plane behind, from which light reaches texel (x, y).
///
/// The paper takes the direction at the same texel of the plane behind. Light flies straight from plane to plane with the
/// direction it has where it starts, so the default takes one more step of the fixed-point iteration p = x − s(p).
#[inline(always)]
pub fn invoke(x: u32, y: u32, u: &SweepUniforms, _mode: u32, light: &[f32]) -> [f32; trace::SIZE] {
    let at = (y * u.size.z + x) as i32;
    let texels = (u.size.z * u.size.w) as i32;
    let component = |c: usize| read(light, c as i32 * texels + at);
    let here = Vec3::new(
        component(record::DIRECTION_X),
        component(record::DIRECTION_X + 1),
        component(record::DIRECTION_X + 2),
    );
    let (x, y) = (x as i32 as f32, y as i32 as f32);
    let (sx, sy) = slope(u, here);
    let (first_x, first_y) = (x - sx, y - sy);
    let (sx, sy) = slope(u, direction(u, light, first_x, first_y));
    let euler = u.dispatch.w & flag::EULER != 0;
    [select(euler, first_x, x - sx), select(euler, first_y, y - sy)]
}
