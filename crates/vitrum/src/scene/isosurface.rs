//! Isosurfaces.

use super::Rgb;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A surface where the volume's scalar has a value: a sheet of particles without thickness, seen from both sides.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Isosurface {
    /// Scalar value on the surface.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Reflectance of the surface's particles, linear RGB.
    #[serde(default = "white")]
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "reflectance"))]
    pub color: Rgb,
    /// Share that the surface takes of what crosses it, of a viewing ray as of light, each time and at any angle; 1 is opaque.
    #[serde(default = "opaque")]
    #[schemars(range(min = 0, max = 1))]
    pub opacity: f32,
}

fn white() -> Rgb {
    [1.0; 3]
}

fn opaque() -> f32 {
    1.0
}

impl Isosurface {
    /// A white, opaque surface where the scalar is `value`.
    #[must_use]
    pub fn new(value: f32) -> Self {
        Self { value, color: white(), opacity: opaque() }
    }
}
