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
    /// As Hu et al. (2010, Eq. 3) add them up: lines one pixel wide, all with the same weight in the whole picture, which is right for light that crosses
    /// the view at a right angle at the distance of the bodies, gathered by a march in even steps of `step`: for comparison. Light that is nearer, farther or
    /// oblique is too bright or too dim. Light seen through bodies, and shadows, are those of `beams`.
    Hu2010,
}

/// The tracer: how rays of light find their ways through bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Tracer {
    /// Through the tree of triangles, along all ways on which a worthwhile part of the flux goes.
    #[default]
    Tree,
    /// Through maps of the depths and the normals of the bodies' fronts and backs as the light sees them, as Hu et al. (2010) trace: for comparison. Light is
    /// refracted by the front and the back, or reflected once by the front, and goes on to the ground or the wall; all else is lost, and of `segments` two are
    /// used at most. Viewing rays go through triangles all the same.
    DepthMap,
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
    /// Step Δx of the march along viewing rays of the estimator `hu2010`; if absent 0.2 times the radius of the sphere around the bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(max = 1e6), extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub step: Option<f32>,
    /// Radius r of the support of the filter that hands the light of a line to the steps of that march. Where it is below half a step, lines are missing.
    #[schemars(range(min = 0.01, max = 2), extend("x-unit" = "steps"))]
    pub filter_radius: f32,
    /// Times that light is scattered at most. 1 is single scattering, which is exact but for what `rays` leaves. More add an estimate of the light that the medium
    /// scatters several times, by its exchange between 16 × 16 × 16 cells of the medium; bodies do not stand in the way of this light, and surfaces are not lit by it.
    #[schemars(range(min = 1, max = 64), extend("x-unit" = "times"))]
    pub orders: u32,
    /// Tracer.
    pub tracer: Tracer,
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
            step: None,
            filter_radius: 1.0,
            orders: 1,
            tracer: Tracer::Tree,
            pyramid: true,
        }
    }
}
