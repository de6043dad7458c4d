//! Directions of light in one word: how far they are from the initial one.
//!
//! Viewing rays read four of them at scattered places; one word instead of three floats makes that a third as long. Light that nothing has
//! bent has exactly the initial direction.

use crate::abi::sweep::SweepUniforms;
use crate::math::{absolute, floor_to_int, length, max, select, sqrt, xyz};
use spirv_std::glam::Vec3;

/// Units in 1. Components of two unit vectors differ by at most 2.
const SCALE: f32 = 16255.0;
/// One of them.
pub const UNIT: f32 = 1.0 / SCALE;
/// The lower half of a word with no difference in x.
const NONE: i32 = 0x8000;
/// The least that stands in the upper half, beside the sign: with it no word has the bits of a denormal float or of a NaN, which a device
/// may change when it moves them.
const LEAST: i32 = 0x80;

/// The difference between the direction of `v` and the initial one, x and y.
#[inline(always)]
pub fn pack(u: &SweepUniforms, v: Vec3) -> f32 {
    let inverse = 1.0 / max(length(v), 1e-20);
    let initial = xyz(u.light.direction);
    pack_difference(v.x * inverse - initial.x, v.y * inverse - initial.y)
}

/// The difference (x, y) of two unit directions.
#[inline(always)]
pub fn pack_difference(x: f32, y: f32) -> f32 {
    let units = |difference: f32| floor_to_int(absolute(difference) * SCALE + 0.5, 0.0, 2.0 * SCALE);
    let across = if x < 0.0 { NONE - units(x) } else { NONE + units(x) };
    let up = units(y);
    // A zero has no sign: devices round a difference of nearly nothing to either side.
    let sign = if (y < 0.0) & (up > 0) { 1u32 << 31 } else { 0 };
    f32::from_bits(sign | (((up + LEAST) as u32) << 16) | across as u32)
}

/// The initial direction.
pub const UNBENT: f32 = f32::from_bits(((LEAST as u32) << 16) | NONE as u32);

/// The differences in a word, in units, which [`direction`] takes.
#[inline(always)]
pub fn unpack(word: f32) -> (f32, f32) {
    let bits = word.to_bits();
    let across = ((bits & 0xffff) as i32 - NONE) as f32;
    let up = (((bits >> 16) & 0x7fff) as i32 - LEAST) as f32;
    (across, select(bits >> 31 != 0, -up, up))
}

/// The unit direction that differs by (`across`, `up`) units from the initial one.
#[inline(always)]
pub fn direction(u: &SweepUniforms, across: f32, up: f32) -> Vec3 {
    let initial = xyz(u.light.direction);
    let (x, y) = (initial.x + across * (1.0 / SCALE), initial.y + up * (1.0 / SCALE));
    // Light goes away from the eye, and never along the planes.
    Vec3::new(x, y, sqrt(max(1.0 - (x * x + y * y), 1e-4)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::abi::light::Light;

    fn under(initial: Vec3) -> SweepUniforms {
        let light = Light { direction: initial.into(), ..Light::default() };
        SweepUniforms { light, ..SweepUniforms::default() }
    }

    fn unit(towards: Vec3) -> Vec3 {
        towards / length(towards)
    }

    #[test]
    fn directions_come_back() {
        for initial in [Vec3::Z, unit(Vec3::new(0.6, -0.5, 0.3)), unit(Vec3::new(-0.9, 0.2, 0.1))] {
            let u = under(initial);
            for i in 0..441 {
                let towards = Vec3::new((i % 21 - 10) as f32, (i / 21 - 10) as f32, 5.0) / 10.0;
                let word = pack(&u, towards);
                assert!(word.is_normal(), "{towards} has the bits of {word}");
                let (across, up) = unpack(word);
                let found = direction(&u, across, up);
                // Half a unit in x and in y; z is what is left to a length of 1.
                let expected = unit(towards);
                let off = (found - expected).abs();
                assert!(off.x < 0.51 / SCALE && off.y < 0.51 / SCALE, "{expected} became {found}");
                assert!(off.z < 1.5 / SCALE / expected.z, "{expected} became {found}");
            }
        }
    }

    #[test]
    fn the_initial_direction_is_exact() {
        for initial in [Vec3::Z, unit(Vec3::new(0.3, -0.8, 0.4)), unit(Vec3::new(-0.99, 0.0, 0.1))] {
            let u = under(initial);
            assert_eq!(pack(&u, initial).to_bits(), UNBENT.to_bits());
            assert_eq!(unpack(UNBENT), (0.0, 0.0));
            let found = direction(&u, 0.0, 0.0);
            assert_eq!((found.x, found.y), (initial.x, initial.y));
            assert!((found.z - initial.z).abs() < 1e-6);
        }
    }

    #[test]
    fn no_word_is_a_number_that_devices_change() {
        // Opposite directions along the planes are as far apart as any.
        for sign in [-1.0, 1.0] {
            let u = under(Vec3::new(-sign, 0.0, 0.0));
            assert!(pack(&u, Vec3::new(sign, 0.0, 1e-6)).is_normal());
            let u = under(Vec3::new(0.0, -sign, 0.0));
            let word = pack(&u, Vec3::new(0.0, sign, 1e-6));
            assert!(word.is_normal());
            assert!((unpack(word).1 - sign * 2.0 * SCALE).abs() < 1.0);
        }
    }
}
