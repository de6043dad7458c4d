//! Light on the present straight piece of a viewing ray, but for beams: airlight, and where the piece ends its way, the radiance of the surface in
//! the light of the source, or of the environment (composition: Hu et al. 2010, Fig. 2).

use super::airlight::airlight;
use super::bend::mean;
use super::density::optical_depth;
use super::medium::{depth_from, inside, transmittance};
use super::shade::ending;
use super::viewing;
use crate::abi::beams::{BeamsUniforms, flag};
use crate::abi::receivers::ahead;
use crate::abi::record::pencil::{self, stage};
use crate::abi::record::{Pencil, Sight, search, sight};
use crate::field::access::read;
use crate::kernel::record;
use crate::math::{dot, length, max, min, select, select_vector};
use crate::optics::ambient::irradiance;
use crate::optics::environment::{environment, in_environment};
use crate::optics::light_source::arriving;
use crate::optics::receiver::FAR;
use crate::voxels::shade::{facing, share};
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// The least share of a piece's light that comes to the eye, below which the medium's light on it is left out.
pub const LEAST: f32 = 0.01;

/// A straight piece of a viewing ray.
#[derive(Clone, Copy)]
pub struct Piece {
    /// Position at which it begins: the first one at the eye.
    pub from: Vec3,
    /// Distance from there at which it ends, in voxels.
    pub far: f32,
    /// Share of the light at its beginning that comes to the eye.
    pub weight: Vec3,
}

/// The piece that the pencil of pixel (x, y) has come to.
#[inline(always)]
pub fn piece_of(x: u32, y: u32, u: &BeamsUniforms, pencil: &Pencil) -> Piece {
    let first = pencil.bounces == 0;
    let eye = viewing::start(u, x as i32, y as i32).position;
    // The pencil begins where it comes to the box of all surfaces, and has the medium in front of it in its transmittance.
    let before = select(first, dot(pencil.position - eye, pencil.direction), 0.0);
    Piece {
        from: select_vector(first, eye, pencil.position),
        far: before + pencil.distance,
        weight: select_vector(first, Vec3::new(1.0, 1.0, 1.0), pencil.transmittance),
    }
}

/// The level of work of the pencil of pixel (x, y): whether it has come to a new piece in this round.
#[inline(always)]
pub fn level_of(x: u32, y: u32, u: &BeamsUniforms, pencils: &[f32]) -> u32 {
    let count = (u.dispatch.width * u.dispatch.height) as i32;
    let at = (y * u.dispatch.width + x) as i32;
    let component = |component: usize| read(pencils, component as i32 * count + at);
    let stands = component(pencil::STAGE) == stage::PAUSED;
    if stands & (component(pencil::PIECES) as i32 == u.limits.round as i32 + 1) { level::WORK } else { level::ENDED }
}

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
    _materials: &[f32],
    _searches: &[f32],
) -> u32 {
    level_of(x, y, u, pencils)
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
    materials: &[f32],
    searches: &[f32],
) -> [f32; sight::SIZE] {
    let mut seen = Sight::load(&before);
    let count = u.dispatch.width * u.dispatch.height;
    let at = y * u.dispatch.width + x;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, at, count));
    let first = pencil.bounces == 0;
    let piece = piece_of(x, y, u, &pencil);
    let d = pencil.direction;
    let fog = inside(&u.medium, piece.from, d, 0.0, piece.far);
    let dimmed = transmittance(&u.medium, optical_depth(&u.medium, materials, piece.from, d, 0.0, piece.far));
    if (u.flags & flag::SCATTERS != 0) & (mean(piece.weight) >= LEAST) {
        seen.airlight += airlight(u, pictures, materials, piece.from, d, fog.enters, fog.leaves) * piece.weight;
    }
    let end = ending(u, &pencil, &piece, corners, looks, materials);
    let nothing = pencil.triangle == ahead::NOTHING;
    if first {
        seen.depth = select(nothing, FAR, piece.far);
        seen.enters = min(fog.enters, piece.far);
        seen.leaves = min(fog.leaves, piece.far);
        seen.normal = select_vector(nothing, Vec3::new(0.0, 0.0, 0.0), facing(&end.point, d));
        // Without an environment the picture is transparent where there is neither a surface nor a medium.
        let veil = 1.0 - mean(dimmed);
        seen.coverage = select(nothing, max(u.environment.visible, veil), 1.0);
    }
    if nothing {
        let angle = max(length(pencil.direction_u), length(pencil.direction_v));
        let radiance = environment(&u.environment, pictures, in_environment(&u.environment, d), angle);
        let visible = select(first, u.environment.visible, 1.0);
        seen.radiance += radiance * dimmed * piece.weight * visible;
    } else if end.is_diffuse {
        let light = arriving(&u.light, pictures, end.point.position);
        let hidden = read(searches, (search::HIDDEN as u32 * count + at) as i32);
        let way = depth_from(&u.medium, materials, &u.light, end.point.position, light.direction);
        let arrives = transmittance(&u.medium, way) * (1.0 - hidden);
        let normal = facing(&end.point, d);
        let strength = share(&end.point, normal, d, light.direction);
        let ambient = irradiance(&u.ambient, &u.environment, normal);
        let sent = end.point.color * (light.radiance * arrives * strength + ambient);
        seen.radiance += sent * dimmed * piece.weight;
    }
    seen.store()
}
