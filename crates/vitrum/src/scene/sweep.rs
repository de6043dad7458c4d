//! Settings of the plane sweep: the transport of light and viewing rays from plane to plane (sweep §4).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The rule that advances a ray by one plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Integrator {
    /// Kick–drift–kick on dx/dσ = v, dv/dσ = η∇η, of second order.
    #[default]
    Symplectic,
    /// The paper's Eqs. 8 and 10 with Δs = plane distance, which does not converge for oblique rays and is there for
    /// comparison.
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
    /// No correction, and no caustics (sweep, Fig. 4b).
    None,
}

/// The computation of ∇η.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Gradient {
    /// Central differences of η, which six neighbours give (sweep §5).
    #[default]
    Central,
    /// The chain rule, ∇η = η'(f)·∇f.
    Chain,
}

/// The carrier of light from plane to plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Transport {
    /// A wavefront whose nodes are followed forward, along the light's own direction: right behind a focus, too, and from any side.
    #[default]
    Forward,
    /// Texels, each with one direction that is followed back (sweep §4.2, the paper's method): right before a focus, too dark behind it, and only for
    /// light that goes away from the camera.
    Texels,
}

/// Transport of light and viewing rays from plane to plane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Sweep {
    /// Distance of the planes. Smaller is slower and more exact.
    #[schemars(range(min = 0.05, max = 16), extend("x-unit" = "smallest voxel edges"))]
    pub sample_distance: f32,
    /// Carrier of light from plane to plane.
    pub light: Transport,
    /// Cells along the longer side of the wavefront where `light` is `forward`; where none are given, as many as the volume has voxels there, at least
    /// 160 and at most 320.
    #[schemars(range(min = 8, max = 4096), extend("x-unit" = "cells"))]
    pub light_cells: Option<u32>,
    /// Rule that advances a ray by one plane.
    pub integrator: Integrator,
    /// Rule that turns converging light into brighter light. Light that is carried forward conserves flux by itself: with it the rule stays
    /// `jacobian`.
    pub intensity: Intensity,
    /// Gradient of the index of refraction.
    pub gradient: Gradient,
    /// Light texels per pixel edge where `light` is `texels`; more makes crisper caustics.
    #[schemars(range(min = 0.125, max = 4), extend("x-unit" = "texels"))]
    pub light_resolution: f32,
    /// Margin of the light grid around the region that it covers, as a share of that region's size. Light from outside the grid counts as
    /// unoccluded.
    #[schemars(range(min = 0, max = 1))]
    pub light_margin: f32,
    /// Whether indices of refraction bend rays; `false` keeps every ray straight.
    pub refraction: bool,
    /// Whether rays that turn back or graze the planes are followed beyond the sweep, each by itself, until they leave the volume; `false`
    /// ends them. The light on their way is taken to be unoccluded. Rays through streamed volumes end.
    pub follow_turned_rays: bool,
    /// Number of wavelengths that are followed one after another where `transfer.ior` or a mesh's material disperses; each
    /// takes the time of a frame. 3 are one for red, green and blue each, which shows as three colours in a wide spectrum.
    #[schemars(range(min = 3, max = 32), extend("x-unit" = "wavelengths"))]
    pub wavelengths: u32,
    /// Whether space that the transfer functions leave empty is skipped. The picture is the same.
    pub empty_space_skipping: bool,
}

impl Default for Sweep {
    fn default() -> Self {
        Self {
            sample_distance: 1.0,
            light: Transport::Forward,
            light_cells: None,
            light_resolution: 0.75,
            light_margin: 0.05,
            integrator: Integrator::Symplectic,
            intensity: Intensity::Jacobian,
            gradient: Gradient::Central,
            refraction: true,
            follow_turned_rays: true,
            wavelengths: 3,
            empty_space_skipping: true,
        }
    }
}
