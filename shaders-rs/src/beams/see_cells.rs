//! Light that the medium has scattered more than once on the present straight piece of a viewing ray, from the cells of the medium ([`super::cells`]). It is
//! scattered there to the eye, and behind surfaces taken to be the same towards the ray.

use super::bend::mean;
use super::cells::fluence_at;
use super::density::{density_at, over_part};
use super::medium::{inside, transmittance};
use super::see::{LEAST, level_of, piece_of};
use crate::abi::beams::BeamsUniforms;
use crate::abi::record::{Pencil, Sight, pencil, sight};
use crate::kernel::record;
use crate::math::xyz;
use spirv_std::glam::Vec3;

pub use crate::voxels::ray::level;

/// Parts of the piece: more than cells.
const PARTS: i32 = 24;

/// The level of work: whether the ray has come to a new piece in this round.
#[inline(always)]
pub fn level(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    _before: [f32; sight::SIZE],
    pencils: &[f32],
    _cells: &[f32],
    _materials: &[f32],
) -> u32 {
    level_of(x, y, u, pencils)
}

/// The pixel's sight, with the light on the piece.
#[inline(always)]
pub fn invoke<const LEVEL: u32>(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    before: [f32; sight::SIZE],
    pencils: &[f32],
    cells: &[f32],
    materials: &[f32],
) -> [f32; sight::SIZE] {
    let mut seen = Sight::load(&before);
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let piece = piece_of(x, y, u, &pencil);
    let d = pencil.direction;
    let fog = inside(&u.medium, piece.from, d, 0.0, piece.far);
    if (fog.leaves <= fog.enters) | (mean(piece.weight) < LEAST) {
        return before;
    }
    let step = (fog.leaves - fog.enters) * (1.0 / PARTS as f32);
    let varies = u.medium.nodes > 0;
    let mut sum = Vec3::new(0.0, 0.0, 0.0);
    let mut depth = 0.0;
    let mut part = 0;
    while part < PARTS {
        let near = fog.enters + step * part as f32;
        let at = piece.from + d * (near + 0.5 * step);
        let within = if varies { over_part(&u.medium, materials, piece.from, d, near, near + step) } else { step };
        let density = if varies { density_at(&u.medium, materials, at) } else { 1.0 };
        sum += fluence_at(u, cells, at) * transmittance(&u.medium, depth + 0.5 * within) * density;
        depth += within;
        part += 1;
    }
    seen.multiple += sum * xyz(u.medium.scattering) * piece.weight * step;
    seen.store()
}
