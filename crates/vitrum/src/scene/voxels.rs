//! Settings of rays through a mesh of clear materials (voxels §4).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The surfaces that a ray is followed through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Surfaces {
    /// The surface where it enters, and the surface where it leaves (Wyman 2005).
    Two,
    /// All surfaces that it meets, up to `bounces`.
    #[default]
    Multi,
    /// All surfaces, of the triangles themselves, without voxels.
    Exact,
}

/// Source of the normals of voxels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Normals {
    /// Distances to the triangles, smoothed over neighbouring voxels.
    #[default]
    Filtered,
    /// The sum of the normals that triangles bring to the voxel.
    Paper,
}

/// Rays through a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Voxels {
    /// Surfaces that a ray is followed through.
    pub surfaces: Surfaces,
    /// Largest number of surfaces that refract or reflect a ray where `surfaces` is not `two`; a ray that is then still
    /// inside looks up the environment in its direction.
    #[schemars(range(min = 1, max = 64), extend("x-unit" = "surfaces"))]
    pub bounces: u32,
    /// Source of the normals of voxels. Where `surfaces` is `exact` and the mesh has no normals, `filtered` makes them
    /// smooth between triangles that meet at less than 45°, `paper` takes the triangles' own.
    pub normals: Normals,
    /// Length by which a voxel reaches over its neighbours where triangles meet it, with the paper's normals: slices
    /// overlap, so that no ray slips between two voxels of a surface.
    #[schemars(range(min = 0, max = 1), extend("x-unit" = "voxels"))]
    pub overlap: f32,
    /// Angle between the normals of two surfaces below which they are taken for one that was met twice: within two
    /// voxels, or with the paper's normals anywhere.
    #[schemars(range(min = 0, max = 90), extend("x-unit" = "degrees"))]
    pub threshold: f32,
    /// Whether surfaces reflect (Fresnel): of the first one the reflection is seen, those of others along the ways that
    /// `branches` counts. `false` leaves total reflection alone.
    pub reflection: bool,
    /// Ways that each ray is followed along at most: the refracted one, and then each time the strongest reflection at
    /// one of the surfaces behind the first. What is reflected and not followed is as bright as the environment on
    /// average, so that no light is lost.
    #[schemars(range(min = 1, max = 16), extend("x-unit" = "ways"))]
    pub branches: u32,
    /// Whether ground and wall have the light that clear bodies refract onto them, which a sweep's wavefront carries there through the bodies' voxels by the
    /// settings in `sweep`; `false` leaves the shadow of what they absorb (Chang et al. 2010). Light from a spot with a picture, or from a place next to the
    /// bodies, is never carried.
    pub caustics: bool,
    /// Number of wavelengths that are followed one after another where a material disperses; each takes the time of a frame
    /// for each light. 3 are one for red, green and blue each, which shows as three colours in a wide spectrum. Each method
    /// has its own number, as of bounces: a frame's time differs a lot between methods.
    #[schemars(range(min = 3, max = 32), extend("x-unit" = "wavelengths"))]
    pub wavelengths: u32,
}

impl Default for Voxels {
    fn default() -> Self {
        Self {
            surfaces: Surfaces::Multi,
            bounces: 16,
            normals: Normals::Filtered,
            overlap: 0.0,
            threshold: 30.0,
            reflection: true,
            branches: 2,
            caustics: true,
            wavelengths: 3,
        }
    }
}
