//! Settings of beams of light in a medium (Hu et al. 2010).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The estimator: how the light of a beam is spread over the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Estimator {
    /// Over the beam's own cross-section, the parallelogram that its texel's derivatives span.
    #[default]
    Beams,
    /// Over lines one pixel wide, with the same flux, as Hu et al. (2010) draw: for comparison. They need many more rays for the same error.
    Lines,
}

/// Beams of light in a medium.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Beams {
    /// Rays of light along each edge of the grid that covers the bodies, for each light.
    #[schemars(range(min = 4, max = 1024), extend("x-unit" = "rays"))]
    pub rays: u32,
    /// Straight pieces of a ray's ways between bodies that become beams, at most; the flux of further ones is counted as lost.
    #[schemars(range(min = 1, max = 64), extend("x-unit" = "pieces"))]
    pub segments: u32,
    /// Largest number of surfaces that refract or reflect a ray.
    #[schemars(range(min = 1, max = 16), extend("x-unit" = "surfaces"))]
    pub bounces: u32,
    /// Share of a ray's flux below which a reflected or refracted part is not followed.
    #[schemars(range(min = 0, max = 1), extend("x-unit" = "share"))]
    pub threshold: f32,
    /// Straight pieces between bodies of a viewing ray's ways that are followed at most.
    #[schemars(range(min = 1, max = 32), extend("x-unit" = "pieces"))]
    pub views: u32,
    /// Number of wavelengths that are followed one after another where a material disperses; each takes the time of a frame
    /// for each light. 3 are one for red, green and blue each, which shows as three colours in a wide spectrum. Each method
    /// has its own number, as of bounces: a frame's time differs a lot between methods.
    #[schemars(range(min = 3, max = 32), extend("x-unit" = "wavelengths"))]
    pub wavelengths: u32,
    /// Nodes of each straight piece at which the optical depth of a medium of varying density (`medium.density`) is known; between them it is taken to
    /// grow evenly.
    #[schemars(range(min = 2, max = 64), extend("x-unit" = "nodes"))]
    pub nodes: u32,
    /// Whether squares of the grid of `rays` are split into four where the curvature of their light shows in the medium. Beams then take five times the
    /// memory.
    pub adaptive: bool,
    /// Estimator.
    pub estimator: Estimator,
    /// Whether wide beams are drawn in coarser pictures and interpolated.
    pub pyramid: bool,
}

impl Default for Beams {
    fn default() -> Self {
        Self {
            rays: 64,
            segments: 8,
            bounces: 16,
            threshold: 0.001,
            views: 6,
            wavelengths: 3,
            nodes: 16,
            adaptive: false,
            estimator: Estimator::Beams,
            pyramid: true,
        }
    }
}
