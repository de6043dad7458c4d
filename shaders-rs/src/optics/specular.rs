//! Cook–Torrance reflection: GGX distribution, Smith visibility, exact dielectric Fresnel (sweep §4.3).

use crate::math::{PI, dot, length, max, select, sqrt};
use spirv_std::glam::Vec3;

/// Reflectance of a boundary from index `eta_from` to `eta_to` for unpolarised light at cosine `cosine` (Cook & Torrance 1982).
/// ((η₁−η₂)/(η₁+η₂))² at normal incidence, exactly 0 for equal indices, 1 under total reflection.
#[inline(always)]
pub fn fresnel(eta_from: f32, eta_to: f32, cosine: f32) -> f32 {
    let ratio = eta_to / eta_from;
    let squared = ratio * ratio - 1.0 + cosine * cosine;
    let g = sqrt(squared);
    let a = (g - cosine) / max(g + cosine, 1e-6);
    let b = (cosine * (g + cosine) - 1.0) / max(cosine * (g - cosine) + 1.0, 1e-6);
    let reflected = 0.5 * a * a * (1.0 + b * b);
    select(eta_from == eta_to, 0.0, select(squared <= 0.0, 1.0, reflected))
}

/// The Fresnel reflectance of a boundary from index `eta_from` to `eta_to` for light that has the cosine `cosine` where the index is `eta_here`, between the
/// two: its component along the boundary is the same everywhere (Snell's law).
#[inline(always)]
pub fn fresnel_from(eta_from: f32, eta_to: f32, cosine: f32, eta_here: f32) -> f32 {
    let ratio = eta_here / eta_from;
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    fresnel(eta_from, eta_to, sqrt(max(squared, 0.0)))
}

/// A lobe of reflected light.
#[derive(Clone, Copy)]
pub struct Lobe {
    /// Radiance towards the viewer for unit radiance of light and a reflectance of 1.
    pub radiance: f32,
    /// Cosine of the angle at which light meets the facets that reflect it to the viewer.
    pub cosine: f32,
}

/// The lobe of light that facets of all tilts reflect to the viewer: GGX distribution, height-correlated Smith visibility.
///
/// `normal` need not be of unit length (0: no reflection), `light` and `view` are travel directions; the light and the viewer
/// must be on the same side.
#[inline(always)]
pub fn lobe(normal: Vec3, light: Vec3, view: Vec3, roughness: f32) -> Lobe {
    let size = length(normal);
    let n = normal * (1.0 / max(size, 1e-20));
    let to_light = light * (-1.0 / max(length(light), 1e-20));
    let to_eye = view * (-1.0 / max(length(view), 1e-20));
    // The gradient points to larger scalars; the normal is the side the viewer is on.
    let facing = dot(n, to_eye);
    let n = n * select(facing < 0.0, -1.0, 1.0);
    let nv = max(dot(n, to_eye), 1e-4);
    let nl = dot(n, to_light);
    let sum = to_light + to_eye;
    let half = sum * (1.0 / max(length(sum), 1e-6));
    let nh = max(dot(n, half), 0.0);
    let vh = max(dot(to_eye, half), 0.0);

    let a2 = (roughness * roughness) * (roughness * roughness);
    let spread = nh * nh * (a2 - 1.0) + 1.0;
    let distribution = a2 / (PI * spread * spread);
    let lit = max(nl, 0.0);
    // Height-correlated Smith: G / (4 nv nl).
    let visibility = 0.5 / max(nv * sqrt(lit * lit * (1.0 - a2) + a2) + lit * sqrt(nv * nv * (1.0 - a2) + a2), 1e-6);
    let seen = (nl > 0.0) & (size > 1e-12);
    Lobe { radiance: select(seen, distribution * visibility * lit, 0.0), cosine: vh }
}

/// Radiance reflected towards the viewer for unit radiance of light at a boundary from index `eta_from` to `eta_to`; see [`lobe`].
#[inline(always)]
pub fn cook_torrance(normal: Vec3, light: Vec3, view: Vec3, roughness: f32, eta_from: f32, eta_to: f32) -> f32 {
    let lobe = lobe(normal, light, view, roughness);
    lobe.radiance * fresnel(eta_from, eta_to, lobe.cosine)
}
