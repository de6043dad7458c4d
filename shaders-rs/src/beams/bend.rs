//! A pencil at a surface: refraction and reflection (Snell's law, Fresnel's equations), and the ways that it leaves for later.

use super::facet::Facet;
use super::spread::{Bending, Spread};
use crate::abi::record::Pencil;
use crate::abi::voxels::material;
use crate::field::access::read_vector;
use crate::math::{dot, max, min};
use crate::voxels::surface::{Bent, bend, ior};
use spirv_std::glam::Vec3;

/// The mean of the channels.
#[inline(always)]
pub fn mean(color: Vec3) -> f32 {
    ((color.x + color.y) + color.z) * (1.0 / 3.0)
}

/// The highest channel.
#[inline(always)]
fn highest(color: Vec3) -> f32 {
    max(max(color.x, color.y), color.z)
}

impl Pencil {
    /// The derivatives.
    #[inline(always)]
    pub fn spread(&self) -> Spread {
        Spread {
            position_u: self.position_u,
            position_v: self.position_v,
            direction_u: self.direction_u,
            direction_v: self.direction_v,
        }
    }

    /// Sets the derivatives.
    #[inline(always)]
    pub fn set_spread(&mut self, spread: Spread) {
        self.position_u = spread.position_u;
        self.position_v = spread.position_v;
        self.direction_u = spread.direction_u;
        self.direction_v = spread.direction_v;
    }

    /// Whether the present piece belongs to no way that was followed before: all turns of the way have been taken.
    #[inline(always)]
    pub fn is_new(&self) -> bool {
        let behind = self.turns & ((1 << self.bounces) - 1);
        behind.count_ones() as i32 == self.level
    }

    /// Attenuates the light to `share` of it, and returns the mean share of the flux at the start that is gone, 0 on a piece that is not new.
    #[inline(always)]
    pub fn attenuate(&mut self, share: Vec3) -> f32 {
        let before = mean(self.transmittance);
        self.transmittance *= share;
        if self.is_new() { before - mean(self.transmittance) } else { 0.0 }
    }

    /// Reflects the pencil at a mirror of material number `number`.
    #[inline(always)]
    pub fn reflect(&mut self, facet: &Facet, number: i32, materials: &[f32]) {
        let reflectance = read_vector(materials, number * material::SIZE as i32 + material::ABSORPTION as i32);
        self.absorbed += self.attenuate(reflectance);
        let facet = facet.facing(self.direction);
        let bending = Bending { direction: self.direction, normal: facet.normal, ratio: 1.0, reflected: true };
        self.set_spread(self.spread().bent(&bending, &facet));
        self.direction = bend(self.direction, facet.normal, 1.0, 1.0).mirrored;
        self.bounces += 1;
    }

    /// Refracts or reflects the pencil at a surface between the media `from` and `to`; the result is whether it goes through. Parts of the flux
    /// below the share `threshold` are not followed.
    #[inline(always)]
    pub fn cross(&mut self, threshold: f32, facet: &Facet, from: i32, to: i32, materials: &[f32]) -> bool {
        let (index, other) = (ior(from, materials), ior(to, materials));
        let Bent { direction, mirrored, reflected, reflectance } = bend(self.direction, facet.normal, index, other);
        let number = self.bounces;
        let reflects = reflectance > 0.5;
        let weaker = min(reflectance, 1.0 - reflectance);
        let turns = (number < self.decided) & ((self.turns >> number) & 1 == 1);
        if !reflected & (number >= self.decided) {
            let follows = highest(self.transmittance) * weaker >= threshold;
            if !self.is_new() {
                self.pending |= if follows { 1 << number } else { 0 };
            } else if follows {
                self.deeper = 1;
            } else {
                self.lost += mean(self.transmittance) * weaker;
            }
        }
        let turns = turns != reflects;
        let stays = reflected | turns;
        if !reflected {
            self.transmittance *= if turns { reflectance } else { 1.0 - reflectance };
        }
        let facet = facet.facing(self.direction);
        let bending =
            Bending { direction: self.direction, normal: facet.normal, ratio: index / other, reflected: stays };
        self.set_spread(self.spread().bent(&bending, &facet));
        self.direction = if stays { mirrored } else { direction };
        self.bounces += 1;
        !stays
    }
}

/// The facet that a pencil is bent by, on its way from medium `from` to `to`: with the normal between its corners, or where that normal would put
/// the pencil on the wrong side of the triangle, the triangle's own.
#[inline(always)]
pub fn facet_for(facet: Facet, direction: Vec3, from: f32, to: f32) -> Facet {
    let bent = bend(direction, facet.normal, from, to);
    let comes = dot(direction, facet.plane);
    let through = dot(bent.direction, facet.plane) * if bent.reflected { -1.0 } else { 1.0 };
    let back = -dot(bent.mirrored, facet.plane);
    let right = (dot(facet.normal, direction) * comes > 0.0) & (through * comes > 0.0) & (back * comes > 0.0);
    facet.flat_if(!right)
}
