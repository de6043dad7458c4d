//! The shadow that a mesh casts (voxels §3).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Absorption of a voxel of the shadow map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Coefficient {
    /// The sum of the optical depths of the triangles in the voxel (Chang et al. 2010).
    #[default]
    PerTriangle,
    /// The same for each occupied voxel (Eisemann & Décoret 2006), for comparison.
    Uniform,
}

/// Attenuation of light on its way through a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Shadow {
    /// Number of voxels of the shadow map along the longest edge of the mesh's box as the light sees it; if absent three for each four pixels along the
    /// longer side of the picture, at least 256 and at most 512, or as many as fit into 128 MiB.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 16, max = 1024), extend("x-unit" = "voxels"))]
    pub resolution: Option<u32>,
    /// Extinction of a voxel of the shadow map.
    pub coefficient: Coefficient,
    /// Optical depth of a triangle of density 1 that light goes through, or of an occupied voxel where `coefficient` is
    /// `uniform`.
    #[schemars(range(min = 0, max = 100), extend("x-unit" = "optical depth"))]
    pub optical_depth: f32,
    /// Radius, across the light, within which the columns of the shadow map are averaged, besides the nearest; at most 15
    /// voxels of the map. It softens all shadows alike, however far away the body is that casts them. Of a point or spot it is the radius in the middle of
    /// the mesh, and grows with the distance from the light.
    #[schemars(range(min = 0, max = 1e6), extend("x-unit" = "world units"))]
    pub filter_radius: f32,
    /// Number of crisp lights that a distant light with an `angular_radius` is made of, spread over its disc, or a point or spot with a
    /// `radius`, spread over its ball. Each has a shadow map of its own and takes the time of a frame. With 1 the shadow of a distant light is as soft as
    /// the distance of what casts it makes it, up to 15 voxels of the map, and that of a point or spot is crisp.
    #[schemars(range(min = 1, max = 64), extend("x-unit" = "lights"))]
    pub samples: u32,
}

impl Default for Shadow {
    fn default() -> Self {
        Self {
            resolution: None,
            coefficient: Coefficient::PerTriangle,
            optical_depth: 1.0,
            filter_radius: 0.0,
            samples: 1,
        }
    }
}
