//! How light and viewing rays travel from plane to plane (sweep §4).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The rule that advances a ray by one plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Integrator {
    /// Kick–drift–kick on dx/dσ = v, dv/dσ = η∇η: second order.
    #[default]
    Symplectic,
    /// The paper's Eqs. 8 and 10 with Δs = plane distance: for comparison, it does not converge for oblique rays.
    Euler,
}

/// The rule that turns converging light into brighter light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Intensity {
    /// The Jacobian of the back-traced points: flux through a plane is conserved.
    #[default]
    Jacobian,
    /// The paper's Eq. 13, a product of derivative lengths.
    Paper,
    /// No correction: no caustics (sweep, Fig. 4b).
    None,
}

/// How ∇η is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Gradient {
    /// η of six neighbours, then central differences (sweep §5).
    #[default]
    Central,
    /// ∇η = η'(f)·∇f.
    Chain,
}

/// What carries light from plane to plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Transport {
    /// Texels, each with one direction that is followed back (sweep §4.2): right before a focus, too dark behind it.
    #[default]
    Texels,
    /// Sheets of rays that are followed forward and scattered onto each plane: right behind a focus, too.
    Sheets,
}

/// How light and viewing rays travel from plane to plane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Sweep {
    /// Distance of the planes in units of the smallest voxel edge, 0.05 to 16.
    #[schemars(range(min = 0.05, max = 16))]
    pub sample_distance: f32,
    /// `texels` or `sheets`.
    pub light: Transport,
    /// Sheets that a soft light is made of where `light` is `sheets`, 1 to 64; a crisp one has one.
    #[schemars(range(min = 1, max = 64))]
    pub sheets: u32,
    /// `symplectic` or `euler`.
    pub integrator: Integrator,
    /// `jacobian`, `paper` or `none`. Sheets need no correction: they conserve flux.
    pub intensity: Intensity,
    /// `central` or `chain`.
    pub gradient: Gradient,
    /// Whether indices of refraction bend rays at all; `false` keeps every ray straight.
    pub refraction: bool,
    /// Wavelengths that are followed one after another where `transfer.ior` disperses, 3 (one for red, green and blue each) to 32.
    #[schemars(range(min = 3, max = 32))]
    pub wavelengths: u32,
    /// Whether space that the transfer functions leave empty is skipped. The picture is the same.
    pub empty_space_skipping: bool,
}

impl Default for Sweep {
    fn default() -> Self {
        Self {
            sample_distance: 1.0,
            light: Transport::Texels,
            sheets: 8,
            integrator: Integrator::Symplectic,
            intensity: Intensity::Jacobian,
            gradient: Gradient::Central,
            refraction: true,
            wavelengths: 3,
            empty_space_skipping: true,
        }
    }
}
