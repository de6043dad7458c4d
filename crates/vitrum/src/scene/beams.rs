//! Settings of beams of light in a medium (Hu et al. 2010).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
    /// Nodes of each straight piece at which the optical depth of a medium of varying density (`medium.density`) is known; between them it is taken to
    /// grow evenly.
    #[schemars(range(min = 2, max = 64), extend("x-unit" = "nodes"))]
    pub nodes: u32,
    /// Whether wide beams are drawn in coarser pictures and interpolated.
    pub pyramid: bool,
}

impl Default for Beams {
    fn default() -> Self {
        Self { rays: 64, segments: 8, bounces: 16, threshold: 0.001, views: 6, nodes: 16, pyramid: true }
    }
}
