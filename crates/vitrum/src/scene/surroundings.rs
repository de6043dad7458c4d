//! The clear matter around a volume or a mesh.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The clear matter around what is shown: air, or water around a cell, or the agar in which an embryo is embedded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Surroundings {
    /// Index of refraction outside of the volume's box, and of the mesh's bodies: 1 is air's, 1.33 water's.
    #[schemars(range(min = 0.2, max = 5))]
    pub ior: f32,
}

impl Default for Surroundings {
    fn default() -> Self {
        Self { ior: 1.0 }
    }
}
