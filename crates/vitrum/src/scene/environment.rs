//! The environment: the radiance behind everything, by direction (sweep §4.4).

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The pattern of the environment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum EnvironmentKind {
    /// One colour, `color`.
    Color,
    /// From `nadir` straight down over `horizon` at eye level to `color` at the zenith.
    #[default]
    Gradient,
    /// Squares of `color` and `horizon` in longitude and latitude.
    Checkerboard,
    /// An equirectangular picture, `file`, whose middle row is the horizon.
    Map,
}

/// The environment: radiance behind everything, by a ray's final direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Pattern of the environment.
    pub kind: EnvironmentKind,
    /// Radiance, linear RGB: see `kind`.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "radiance"))]
    pub color: Rgb,
    /// Radiance, linear RGB: see `kind`.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "radiance"))]
    pub horizon: Rgb,
    /// Radiance, linear RGB: see `kind`.
    #[schemars(inner(range(min = 0, max = 1e6)), extend("x-unit" = "radiance"))]
    pub nadir: Rgb,
    /// Edge of a checkerboard square.
    #[schemars(range(min = 0.5, max = 90), extend("x-unit" = "degrees"))]
    pub square: f32,
    /// Equirectangular picture (HDR, EXR, PNG, JPEG, TIFF) of the kind `map`, which needs it; a relative path starts at
    /// the scene file's folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a path"))]
    pub file: Option<std::path::PathBuf>,
    /// Angle by which the environment is turned around the world's up.
    #[schemars(extend("x-unit" = "degrees"))]
    pub rotation: f32,
    /// Factor on the environment's radiance.
    #[schemars(range(min = 0, max = 1e6))]
    pub intensity: f32,
    /// Distant lights that shine in the place of the environment, each with the radiance of a region of it, whether it is visible or not; 0 if
    /// it gives no light to surfaces. Each takes as long as a light of the scene.
    #[schemars(range(min = 0, max = 256))]
    pub lights: u32,
    /// Factor on the environment's radiance as ambient light, without shadows: particles scatter its mean, opaque surfaces and receivers reflect its
    /// irradiance by their normals (spherical harmonics up to the second order: Ramamoorthi & Hanrahan 2001). 1 if it lights as bright as it shows,
    /// whether it is visible or not; 0 if `shading.ambient` is all ambient light. Not with `lights`, which shine in its place.
    #[schemars(range(min = 0, max = 1e6))]
    pub ambient: f32,
    /// Whether the environment shows in the picture; `false` makes the background transparent.
    pub visible: bool,
}

impl Default for Environment {
    fn default() -> Self {
        Self {
            kind: EnvironmentKind::Gradient,
            color: [0.30, 0.38, 0.50],
            horizon: [0.82, 0.84, 0.86],
            nadir: [0.34, 0.32, 0.30],
            square: 10.0,
            file: None,
            rotation: 0.0,
            intensity: 1.0,
            lights: 0,
            ambient: 0.0,
            visible: true,
        }
    }
}
