//! How bright light is where refraction has gathered or scattered it: the intensity correction (sweep §4.2, Eqs. 11 and 12).

use crate::abi::record::{Irradiance, irradiance, light as record};
use crate::abi::sweep::{SweepUniforms, flag};
use crate::field::access::{read, read_inside};
use crate::kernel::skip::{Reach, Same};
use crate::math::{max, min, select};
use crate::sweep::light::around::is_inner_row;
use crate::sweep::light::look_up::holds;
use crate::sweep::light::offset::{UNBENT, pack};
use crate::sweep::light::slopes::{jacobian, slopes};
use spirv_std::glam::Vec3;

/// How much of the kernel an invocation needs.
pub mod level {
    /// The texel's row has neighbours.
    pub const INNER: u32 = 1;
    /// It may lie on the grid's border.
    pub const BORDER: u32 = 3;
}

/// How far the concentration may exceed the Jacobian of the displacement. Approaching a focus both fall short of the truth, as
/// interpolation blurs them, by 17 to 22 % at ¾ of the focal distance.
const TRUSTED: f32 = 1.25;

/// The level that texel (x, y) needs.
#[inline(always)]
pub fn level(_x: u32, y: u32, u: &SweepUniforms, _mode: u32, light: &[f32]) -> u32 {
    if holds(u, light, record::SIZE) & is_inner_row(u, y) { level::INNER } else { level::BORDER }
}

#[inline(always)]
fn component<const LEVEL: u32>(u: &SweepUniforms, light: &[f32], component: usize, x: u32, y: u32) -> f32 {
    let base = component as i32 * (u.light_grid.width * u.light_grid.height) as i32 + (y * u.light_grid.width) as i32;
    if LEVEL == level::INNER {
        // SAFETY: `level` found the grid inside the buffer.
        unsafe { read_inside(light, base, x) }
    } else {
        read(light, base + x as i32)
    }
}

/// Unoccluded light has the irradiance it started with.
#[inline(always)]
pub fn same(_u: &SweepUniforms) -> Option<Same<{ irradiance::SIZE }>> {
    let unoccluded = Irradiance { share: Vec3::new(1.0, 1.0, 1.0), direction: UNBENT };
    Some(Same { record: unoccluded.store(), reach: Reach::NEIGHBOURS })
}

/// The irradiance of texel (x, y), over that of unoccluded light, and its direction.
///
/// The stored quantity is the irradiance E = L cos θ of the plane. Flux through the plane, E dS, is what texels carry: it is shared out
/// from plane to plane so that none is created ([`super::light::arriving`]). Here it is only reduced.
///
/// Behind a focus several sheets of light cross a texel that can carry one direction, and their light gathers on few texels. The
/// Jacobian of the whole displacement tells how much light there could be: where the light is denser than that, the rest does not count.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &SweepUniforms,
    _mode: u32,
    light: &[f32],
) -> [f32; irradiance::SIZE] {
    // SAFETY: `level` found that the row has neighbours, and the grid inside the buffer.
    let slopes = unsafe {
        if LEVEL == level::INNER {
            slopes::<true>(u, light, record::DISPLACEMENT_X, 1.0, x, y)
        } else {
            slopes::<false>(u, light, record::DISPLACEMENT_X, 1.0, x, y)
        }
    };
    let concentration = component::<LEVEL>(u, light, record::CONCENTRATION, x, y);
    let bounded = min(1.0, jacobian(&slopes) * TRUSTED / max(concentration, 1e-20));
    let as_it_is = u.flags & (flag::PAPER_INTENSITY | flag::NO_INTENSITY) != 0;
    let factor = select(as_it_is, 1.0, bounded);
    let v = Vec3::new(
        component::<LEVEL>(u, light, record::DIRECTION, x, y),
        component::<LEVEL>(u, light, record::DIRECTION + 1, x, y),
        component::<LEVEL>(u, light, record::DIRECTION + 2, x, y),
    );
    let flux = Vec3::new(
        component::<LEVEL>(u, light, record::FLUX, x, y),
        component::<LEVEL>(u, light, record::FLUX + 1, x, y),
        component::<LEVEL>(u, light, record::FLUX + 2, x, y),
    );
    Irradiance { share: flux * factor, direction: pack(u, v) }.store()
}
