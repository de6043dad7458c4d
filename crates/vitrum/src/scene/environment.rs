//! What a ray sees behind everything (sweep §4.4).

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The pattern of the environment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum EnvironmentKind {
    /// `color` everywhere.
    Color,
    /// `horizon` at eye level, `color` at the zenith, `nadir` straight down.
    #[default]
    Gradient,
    /// Squares of `color` and `horizon` in longitude and latitude.
    Checkerboard,
    /// An equirectangular picture (`file`), world up in its middle row's normal.
    Map,
}

/// What a ray sees behind everything, by its final direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// `color`, `gradient`, `checkerboard` or `map`.
    pub kind: EnvironmentKind,
    /// Linear RGB, each 0 to 1e6; see `kind`.
    #[schemars(inner(range(min = 0, max = 1e6)))]
    pub color: Rgb,
    /// Linear RGB, each 0 to 1e6; see `kind`.
    #[schemars(inner(range(min = 0, max = 1e6)))]
    pub horizon: Rgb,
    /// Linear RGB, each 0 to 1e6; see `kind`.
    #[schemars(inner(range(min = 0, max = 1e6)))]
    pub nadir: Rgb,
    /// Edge of a checkerboard square in degrees, 0.5 to 90.
    #[schemars(range(min = 0.5, max = 90))]
    pub square: f32,
    /// The equirectangular picture (HDR, EXR, PNG, JPEG), relative to the scene file; `map` only, and needed there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<std::path::PathBuf>,
    /// Degrees by which the environment is turned around the world's up.
    pub rotation: f32,
    /// Factor on the environment's radiance, 0 to 1e6.
    #[schemars(range(min = 0, max = 1e6))]
    pub intensity: f32,
    /// Whether the environment shows in the picture; if `false` the background is transparent.
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
            visible: true,
        }
    }
}
