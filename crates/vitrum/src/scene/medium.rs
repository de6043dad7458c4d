//! A participating medium around and in what is shown.

use super::{Rgb, VolumeSource};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The phase function: the distribution of scattered light over the angle by which its direction changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// That of particles as large as the wavelength or larger, by their `anisotropy` (Henyey and Greenstein 1941).
    #[default]
    HenyeyGreenstein,
    /// That of particles much smaller than the wavelength, such as air's molecules, whose `anisotropy` is 0.
    Rayleigh,
    /// Any, by its values in `phase_values`, such as measured ones.
    Tabulated,
}

/// A participating medium: it absorbs light and scatters it into other directions.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Medium {
    /// Absorption coefficient σ_a, linear RGB, where the density is 1.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "1 / world unit"))]
    pub absorption: Rgb,
    /// Scattering coefficient σ_s, linear RGB, where the density is 1.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "1 / world unit"))]
    pub scattering: Rgb,
    /// Phase function.
    pub phase: Phase,
    /// Values of a `tabulated` phase function at even steps of the angle, from 0° (forward) to 180°, linear in between and in any unit: they are
    /// scaled so that the integral over all directions is 1.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(inner(range(min = 0, max = 1e30)), length(max = 100_000), extend("x-unit" = "any"))]
    pub phase_values: Vec<f32>,
    /// Mean cosine g of the angle that light is scattered by: 0 is equally to all sides, positive forward.
    #[schemars(range(min = -0.99, max = 0.99))]
    pub anisotropy: f32,
    /// Half the edge of the cube that the medium fills, around the middle of the meshes; if absent 12 times the radius of the sphere around
    /// the meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(max = 1e6), extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub extent: Option<f32>,
    /// Volume whose scalar is the density, a factor on both coefficients, and whose box the medium fills; 1 everywhere if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub density: Option<VolumeSource>,
    /// Values of the volume's scalar at which the density is 0 and 1, the lower one first: between them it is linear, beyond them it stays 0 or 1.
    /// If absent the scalar is the density itself. A CT scan from 0 to 4095 would be thousands of times as dense as the coefficients say: give
    /// its window.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "two numbers, the second above the first"))]
    pub density_window: Option<[f32; 2]>,
}
