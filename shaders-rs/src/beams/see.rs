//! What a viewing ray brings from its present straight piece in air: airlight, and where the piece ends its way, the radiance of the surface or
//! of the environment there (composition: Hu et al. 2010, Fig. 2).

use super::airlight::airlight;
use super::medium::{inside, transmittance};
use super::viewing;
use crate::abi::beams::BeamsUniforms;
use crate::abi::receivers::ahead;
use crate::abi::record::pencil::{self, stage};
use crate::abi::record::{Pencil, Sight, sight};
use crate::field::access::read;
use crate::kernel::record;
use crate::math::{dot, length, max, min, select, select_vector};
use crate::optics::environment::{environment, in_environment};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// The level of work: whether the ray has come to a new piece in this round.
#[inline(always)]
pub fn level(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    _before: [f32; sight::SIZE],
    pencils: &[f32],
    _pictures: &[f32],
    _corners: &[f32],
    _looks: &[f32],
) -> u32 {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let at = (y * u.dispatch.width + x) as i32;
    let component = |component: usize| read(pencils, component as i32 * count + at);
    let stands = component(pencil::STAGE) == stage::PAUSED;
    if stands & (component(pencil::PIECES) as i32 == u.limits.round as i32 + 1) { level::WORK } else { level::ENDED }
}

/// What the pixel sees, with the piece.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; sight::SIZE],
    pencils: &[f32],
    pictures: &[f32],
    corners: &[f32],
    looks: &[f32],
) -> [f32; sight::SIZE] {
    let _ = (corners, looks);
    let mut seen = Sight::load(&before);
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let first = pencil.bounces == 0;
    let eye = viewing::start(u, x as i32, y as i32).position;
    // The first piece begins at the eye, and its pencil where it comes to the box of all surfaces.
    let before = select(first, dot(pencil.position - eye, pencil.direction), 0.0);
    let from = select_vector(first, eye, pencil.position);
    let far = before + pencil.distance;
    let fog = inside(&u.medium, from, pencil.direction, 0.0, far);
    // The pencil's own transmittance has the medium in front of the box.
    let weight = select_vector(first, Vec3::new(1.0, 1.0, 1.0), pencil.transmittance);
    seen.airlight += airlight(u, pictures, from, pencil.direction, fog.enters, fog.leaves) * weight;
    if first {
        seen.depth = far;
        seen.enters = min(fog.enters, far);
    }
    if pencil.triangle == ahead::NOTHING {
        let dimmed = transmittance(&u.medium, fog.leaves - fog.enters);
        let direction = in_environment(&u.environment, pencil.direction);
        let angle = max(length(pencil.direction_u), length(pencil.direction_v));
        let radiance = environment(&u.environment, pictures, direction, angle);
        // Without an environment the picture is transparent where there is no surface.
        let visible = select(first, u.environment.visible, 1.0);
        seen.radiance += radiance * dimmed * weight * visible;
    }
    seen.store()
}
