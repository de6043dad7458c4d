//! The light that the medium scatters out of a beam along a viewing ray (single scattering; Jarosz et al. 2011).

use super::density::{density_at, depth_on_piece};
use super::medium::{phase, transmittance};
use super::nearest::Nearest;
use super::shares::Drawing;
use super::viewing::{on_plane, through};
use crate::abi::beams::medium;
use crate::abi::record::sight;
use crate::field::access::read;
use crate::math::{length, max, select, xyz};
use spirv_std::glam::Vec3;

/// Light that a beam sends along a viewing ray.
#[derive(Clone, Copy)]
pub struct Scattered {
    /// Distance from the eye, in voxels; 0 or less where the ray does not meet the beam.
    pub distance: f32,
    /// Radiance over the density of the flux and its transmittance up to where the ray enters the medium.
    pub radiance: Vec3,
}

/// Where a viewing ray is in the medium.
#[derive(Clone, Copy)]
pub struct Sightline {
    /// The number of the pixel whose ray it is, or in whose middle the nearest ray is.
    pixel: i32,
    /// Distance from the eye at which it enters the medium, in voxels.
    pub enters: f32,
    /// Distance at which it leaves it.
    pub leaves: f32,
    /// Distance at which it ends.
    pub depth: f32,
}

impl Drawing<'_> {
    /// The viewing ray of a pixel.
    #[inline(always)]
    pub fn sightline(&self, column: i32, row: i32) -> Sightline {
        let picture = self.u.picture;
        let count = (picture.width * picture.height) as i32;
        let pixel = row * picture.width as i32 + column;
        let component = |component: usize| read(self.sights, component as i32 * count + pixel);
        Sightline {
            pixel,
            enters: component(sight::ENTERS),
            leaves: component(sight::LEAVES),
            depth: component(sight::DEPTH),
        }
    }

    /// Optical depths, over the extinction coefficient where the density is 1: of the beam up to the distance `s`, and of the viewing ray up to `t`.
    #[inline(always)]
    pub(super) fn depths_at(&self, s: f32, t: f32, line: &Sightline) -> (f32, f32) {
        let Self { u, beam, optical_depths, number, .. } = self;
        let first = (u.limits.depth_start + u.limits.round * u.limits.depth_pitch) as i32;
        let count = u.dispatch.width as i32;
        let along = depth_on_piece(&u.medium, optical_depths, first, *number, count, s / beam.length);
        let share = (t - line.enters) / max(line.leaves - line.enters, 1e-9);
        let pixels = (u.picture.width * u.picture.height) as i32;
        (along, depth_on_piece(&u.medium, optical_depths, 0, line.pixel, pixels, share))
    }

    /// The light that the beam sends along the viewing ray through the place (`column`, `row`) of the picture; `MODE` is one of [`medium`].
    #[inline(always)]
    pub fn scattered<const MODE: u32>(&self, column: f32, row: f32, line: &Sightline) -> Scattered {
        let Self { u, beam, materials, .. } = self;
        let (across, upwards) = on_plane(u, column, row);
        let (from, aim) = through(u, across, upwards);
        let size = length(aim);
        let w = aim * (1.0 / size);
        let nearest = Nearest::new(beam.position - from, w, beam.direction);
        let Nearest { t, s, cosine } = nearest;
        let meets = (s >= 0.0) & (s < beam.length) & (t > 0.0);
        // Lines of a march have one weight in all of the picture, in place of 1 over the width of a pixel where they are.
        let size = if MODE == medium::MARCHED { self.drawn.filter * u.limits.line_weight } else { size };
        let strength = size * phase(&u.medium, materials, -cosine);
        let varies = (MODE == medium::VARYING) | ((MODE == medium::MARCHED) & (u.medium.nodes > 0));
        let strength = if varies { strength * density_at(&u.medium, materials, from + w * t) } else { strength };
        let dimmed = if MODE == medium::MARCHED {
            self.marched(&nearest, line)
        } else if MODE == medium::VARYING {
            let (along, towards) = self.depths_at(s, t, line);
            transmittance(&u.medium, along + towards)
        } else {
            transmittance(&u.medium, s + max(t - line.enters, 0.0))
        };
        let radiance = beam.flux * xyz(u.medium.scattering) * dimmed * strength;
        Scattered { distance: select(meets, t, 0.0), radiance }
    }
}
