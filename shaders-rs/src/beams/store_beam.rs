//! Beams of the straight pieces that pencils of light have just come to: behind the surfaces that they met, or for the shadow, the light that
//! would go on behind the first surface if no body were there (a beam whose flux is taken away).

use super::density::optical_depth;
use super::emission::{self, Start};
use super::medium::{inside, transmittance};
use crate::abi::beams::{BeamsUniforms, part};
use crate::abi::receivers::ahead;
use crate::abi::record::pencil::{self, stage};
use crate::abi::record::{Beam, Pencil, beam};
use crate::field::access::read;
use crate::kernel::record;
use crate::math::{length, max, select_vector};
use crate::optics::receiver::FAR;
use spirv_std::glam::Vec3;

/// The beam of the pencil of texel (x, y); one without flux if it has none in this round.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    mode: u32,
    pencils: &[f32],
    pictures: &[f32],
    materials: &[f32],
) -> [f32; beam::SIZE] {
    let count = u.dispatch.width * u.dispatch.height;
    let pencil = Pencil::load(&record::load::<{ pencil::SIZE }>(pencils, y * u.dispatch.width + x, count));
    let is_first = pencil.bounces == 0;
    let shadow = mode == part::SHADOW;
    let stands = (pencil.stage == stage::PAUSED) & (pencil.pieces == u.limits.round as i32 + 1);
    let lit = stands & (is_first == shadow) & (!shadow | (pencil.triangle >= 0));
    // The shadow begins where the light arrives.
    let to_begin = if shadow { pencil.distance } else { 0.0 };
    let far = if shadow { FAR } else { pencil.distance };
    let fog = inside(&u.medium, pencil.position, pencil.direction, to_begin, far);
    let spread = pencil.spread().limited().moved(fog.enters);
    let start: Start = emission::start(u, x as i32, y as i32);
    let before = optical_depth(&u.medium, materials, pencil.position, pencil.direction, 0.0, fog.enters);
    let attenuated = transmittance(&u.medium, max(before, 0.0));
    let flux = emission::flux(u, pictures, &start) * pencil.transmittance * attenuated;
    let none = Vec3::new(0.0, 0.0, 0.0);
    Beam {
        position: pencil.position + pencil.direction * fog.enters,
        direction: pencil.direction,
        position_u: spread.position_u,
        position_v: spread.position_v,
        direction_u: spread.direction_u,
        direction_v: spread.direction_v,
        flux: select_vector(lit, flux, none),
        radius: 0.5 * (length(spread.position_u) + length(spread.position_v)),
        opening: 0.5 * (length(spread.direction_u) + length(spread.direction_v)),
        length: fog.leaves - fog.enters,
        reach: far - fog.enters,
        target: if shadow { ahead::NOTHING } else { pencil.triangle },
    }
    .store()
}

/// Whether beam number `number` of `count` has any flux; the beams' records begin at float `first`.
#[inline(always)]
pub fn has_flux(beams: &[f32], first: i32, number: i32, count: i32) -> bool {
    let channel = |channel: i32| read(beams, first + (beam::FLUX as i32 + channel) * count + number);
    (channel(0) + channel(1)) + channel(2) > 0.0
}

/// Beam number `number` of `count`; the beams' records begin at float `first`.
#[inline(always)]
pub fn beam_of(beams: &[f32], first: i32, number: i32, count: i32) -> Beam {
    let component = |component: usize| read(beams, first + component as i32 * count + number);
    let vector = |at: usize| Vec3::new(component(at), component(at + 1), component(at + 2));
    Beam {
        position: vector(beam::POSITION),
        direction: vector(beam::DIRECTION),
        position_u: vector(beam::POSITION_U),
        position_v: vector(beam::POSITION_V),
        direction_u: vector(beam::DIRECTION_U),
        direction_v: vector(beam::DIRECTION_V),
        flux: vector(beam::FLUX),
        radius: component(beam::RADIUS),
        opening: component(beam::OPENING),
        length: component(beam::LENGTH),
        reach: component(beam::REACH),
        target: component(beam::TARGET) as i32,
    }
}
