//! Masks of a volume.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What a mask hides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Hides {
    /// All but the parts with the labels.
    #[default]
    Outside,
    /// The parts with the labels.
    Inside,
}

/// A segmentation of the volume, by which some of its parts are hidden: these have no opacity, no filter, and the index of the surroundings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mask {
    /// Volume file whose values are labels of parts, on the volume's own grid or another; `vitrum info` shows them. A relative path starts at the scene file's
    /// folder.
    #[schemars(extend("x-range" = "a path"))]
    pub file: PathBuf,
    /// Labels of the parts; all but 0 if empty.
    #[serde(default)]
    #[schemars(length(max = 1024))]
    pub labels: Vec<f32>,
    /// What is hidden.
    #[serde(default)]
    pub hides: Hides,
}
