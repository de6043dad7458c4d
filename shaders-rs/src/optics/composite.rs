//! Compositing along a viewing ray (sweep Eq. 14).

use crate::field::tables::Segment;
use crate::math::{exp, max, min, select, select_vector};
use crate::optics::isosurfaces::Sheet;
use spirv_std::glam::Vec3;

/// Colour, opacity and transmittance along a ray so far (sweep Eq. 14).
#[derive(Clone, Copy)]
pub struct Gathered {
    /// Particle colour C.
    pub color: Vec3,
    /// Opacity A.
    pub opacity: f32,
    /// Medium colour M.
    pub medium: Vec3,
}

/// A segment's transmittances and emission for its real length.
#[derive(Clone, Copy)]
pub struct Layer {
    /// 1 − α.
    pub clear: f32,
    /// α.
    pub opacity: f32,
    /// m.
    pub medium: Vec3,
    /// α · c.
    pub color: Vec3,
}

/// The layer a segment makes: lengths in units of the reference length, of particles and of medium.
///
/// 1 − α = e^(−τℓ), m = e^(−κℓ), α c = q ℓ (1 − e^(−τℓ)) / (τℓ).
#[inline(always)]
pub fn layer(segment: &Segment, particle_length: f32, medium_length: f32) -> Layer {
    Layer {
        medium: Vec3::new(
            exp(-(segment.medium.x * medium_length)),
            exp(-(segment.medium.y * medium_length)),
            exp(-(segment.medium.z * medium_length)),
        ),
        ..layer_of_particles(segment, particle_length)
    }
}

/// As [`layer`], where the medium is clear.
#[inline(always)]
pub fn layer_of_particles(segment: &Segment, particle_length: f32) -> Layer {
    let clear = exp(-(segment.particles * particle_length));
    let opacity = 1.0 - clear;
    // q/τ is the mean colour; where nothing is there, q is 0 too.
    let scale = opacity / max(segment.particles, 1e-12);
    Layer { clear, opacity, medium: Vec3::new(1.0, 1.0, 1.0), color: segment.emission * scale }
}

impl Layer {
    /// The layer with a sheet in it, and the share that the sheet has in what is seen. `depth` is the optical depth of the layer's particles, of which as much
    /// is taken to lie in front of the sheet as of the segment.
    #[inline(always)]
    #[must_use]
    pub fn with(self, sheet: &Sheet, depth: f32) -> (Self, f32) {
        let front = exp(-(depth * sheet.at));
        let particles = (1.0 - front) + sheet.clear * max(front - self.clear, 0.0);
        let seen = front * (1.0 - sheet.clear);
        let clear = self.clear * sheet.clear;
        let color = self.color * (particles / max(self.opacity, 1e-12)) + sheet.color * seen;
        let crossed = sheet.depth > 0.0;
        let layer = Self {
            clear: select(crossed, clear, self.clear),
            opacity: select(crossed, 1.0 - clear, self.opacity),
            medium: self.medium,
            color: select_vector(crossed, color, self.color),
        };
        (layer, select(crossed, min(seen / max(1.0 - clear, 1e-12), 1.0), 0.0))
    }
}

/// C += (1 − A) M (α c i_d + i_s); A += (1 − A) α; M *= m.
#[inline(always)]
pub fn over(g: Gathered, layer: &Layer, diffuse: Vec3, specular: Vec3) -> Gathered {
    let clear = 1.0 - g.opacity;
    Gathered {
        color: g.color + (g.medium * (layer.color * diffuse + specular)) * clear,
        opacity: g.opacity + clear * layer.opacity,
        medium: g.medium * layer.medium,
    }
}
