//! Pencils of light by maps of the bodies ([`super::maps`]) in place of their triangles (Hu et al. 2010, §5.1; Hu & Qin 2007).
//!
//! A texel's light has two pieces behind the first surface: what a mirror reflects, or what is refracted by the front and the back of a clear body
//! ([`super::refract_maps`]); and what the front of a clear body reflects. Maps know no other bodies: both go on to the next receiver. All else is lost.

use super::bend::mean;
use super::density::optical_depth;
use super::exit::{Exit, exit, spread};
use super::maps::{Front, Line, of_texel};
use super::medium::transmittance;
use crate::abi::beams::BeamsUniforms;
use crate::abi::receivers::ahead;
use crate::abi::record::Pencil;
use crate::abi::record::pencil::{SIZE, stage};
use crate::abi::record::way;
use crate::abi::voxels::material;
use crate::field::access::read_vector;
use crate::math::max;
use crate::optics::receiver::{Ahead, first_ahead};
use crate::voxels::ray::{CONTACT, attenuation};
use crate::voxels::surface::{bend, ior};
use spirv_std::glam::Vec3;

/// The pencil of texel (x, y) at the beginning of the piece of a round: its shares of the flux are those of all pieces before, and those that follow are
/// lost so far.
#[inline(always)]
pub fn invoke(
    x: u32,
    y: u32,
    u: &BeamsUniforms,
    _mode: u32,
    faces: &[f32],
    ways: &[f32],
    materials: &[f32],
) -> [f32; SIZE] {
    let (column, row) = (x as i32, y as i32);
    let texels = (u.dispatch.width * u.dispatch.height) as i32;
    let number = row * u.dispatch.width as i32 + column;
    let round = u.limits.round as i32;
    let line = Line::new(u, column, row);
    let front = Front::load(faces, number, texels);
    let mut pencil = Pencil::load(&[0.0; SIZE]);
    pencil.stage = stage::DONE;
    if line.misses {
        return pencil.store();
    }
    pencil.pieces = 1;
    pencil.transmittance = Vec3::new(1.0, 1.0, 1.0);
    pencil.position = line.at(line.enters);
    pencil.direction = line.start.direction;
    let fog = optical_depth(&u.medium, materials, line.start.position, pencil.direction, line.source, line.enters);
    pencil.extinguished += pencil.attenuate(transmittance(&u.medium, fog));
    pencil.distance = max(front.distance - line.enters, 0.0);
    pencil.triangle = front.triangle;
    if round == 0 {
        pencil.stage = stage::PAUSED;
        pencil.set_spread(line.start.spread.moved(line.enters));
        pencil.lost = mean(pencil.transmittance);
        return pencil.store();
    }
    let fog = optical_depth(&u.medium, materials, pencil.position, pencil.direction, 0.0, pencil.distance);
    pencil.extinguished += pencil.attenuate(transmittance(&u.medium, fog));
    let index = if front.triangle >= 0 { ior(front.material, materials) } else { 0.0 };
    let arrives = pencil.transmittance;
    if index == 0.0 {
        let share = mean(arrives);
        pencil.escaped += if front.triangle == ahead::NOTHING { share } else { 0.0 };
        pencil.received += if front.triangle == ahead::NOTHING { 0.0 } else { share };
        return pencil.store();
    }
    let (mut first, mut second) = (arrives, Vec3::new(0.0, 0.0, 0.0));
    if index < 0.0 {
        let at = front.material * material::SIZE as i32 + material::ABSORPTION as i32;
        first *= read_vector(materials, at);
        pencil.absorbed += mean(arrives) - mean(first);
    } else {
        let reflectance = bend(line.start.direction, front.normal, 1.0, index).reflectance;
        let follows = |share: f32| (share >= 0.5) | (highest(arrives) * share >= u.limits.threshold);
        let (through, back) = (1.0 - reflectance, of_texel(ways, way::REFLECTANCE, number, texels));
        let into = arrives * if follows(through) { through } else { 0.0 };
        let reaches = into * attenuation(front.material, of_texel(ways, way::LENGTH, number, texels), materials);
        first = reaches * (1.0 - back);
        second = arrives * if follows(reflectance) { reflectance } else { 0.0 };
        pencil.absorbed += mean(into) - mean(reaches);
        pencil.lost += mean(arrives * through) - mean(into);
        pencil.lost += mean(reaches) - mean(first);
        pencil.lost += mean(arrives * reflectance) - mean(second);
    }
    let mirror = index < 0.0;
    let mut piece = 1;
    while piece <= 2 {
        let share = if piece == 1 { first } else { second };
        let left = mean(share);
        if (left > 0.0) & (piece > round) {
            pencil.lost += left;
        } else if left > 0.0 {
            let reflects = mirror | (piece == 2);
            let Exit { position, direction, .. } = exit(u, faces, ways, materials, column, row, reflects);
            let Ahead { which, distance } = first_ahead(&u.receivers, position, direction, CONTACT);
            if piece == round {
                pencil.stage = stage::PAUSED;
                pencil.pieces = piece + 1;
                pencil.bounces = if reflects { 1 } else { 2 };
                pencil.position = position;
                pencil.direction = direction;
                pencil.set_spread(spread(u, faces, ways, materials, column, row, reflects));
                pencil.transmittance = share;
                pencil.triangle = which;
                pencil.distance = distance;
                pencil.lost += left;
            } else {
                let fog = optical_depth(&u.medium, materials, position, direction, 0.0, distance);
                let arrives = mean(share * transmittance(&u.medium, fog));
                pencil.extinguished += left - arrives;
                pencil.escaped += if which == ahead::NOTHING { arrives } else { 0.0 };
                pencil.received += if which == ahead::NOTHING { 0.0 } else { arrives };
            }
        }
        piece += 1;
    }
    pencil.store()
}

/// The highest channel.
#[inline(always)]
fn highest(color: Vec3) -> f32 {
    max(max(color.x, color.y), color.z)
}
