//! Size and exposure of the picture.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use vitrum_kernels::abi::record::{path, ray};

/// Size and exposure of the picture. The methods `voxels` and `beams`, and `sweep.light = "texels"`, render at most 67108863 viewing rays,
/// `width` · `height` · `supersampling`²; with light carried forward the method `sweep` renders any number of them, part by part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Film {
    /// Width of the picture.
    #[schemars(range(min = 1, max = 16384), extend("x-unit" = "pixels"))]
    pub width: u32,
    /// Height of the picture.
    #[schemars(range(min = 1, max = 16384), extend("x-unit" = "pixels"))]
    pub height: u32,
    /// Exposure: the picture is brightened by 2^exposure; named outputs other than `color` are left alone.
    #[schemars(range(min = -20, max = 20), extend("x-unit" = "stops"))]
    pub exposure: f32,
    /// Number of viewing rays per pixel edge; the picture is averaged from one so many times larger.
    #[schemars(range(min = 1, max = 4), extend("x-unit" = "rays"))]
    pub supersampling: u32,
    /// Number of viewing rays per pixel edge where neighbouring pixels differ: method `sweep` renders those pixels anew. Pictures have that many rays
    /// at their edges, for little time; 1 renders no pixel anew.
    #[schemars(range(min = 1, max = 8), extend("x-unit" = "rays"))]
    pub refinement: u32,
    /// The most that refinement may cost, over the cost of the picture itself: those pixels come first which promise most for their cost.
    #[schemars(range(min = 0, max = 1000), extend("x-unit" = "factor"))]
    pub refinement_budget: f32,
}

impl Film {
    /// Largest number of viewing rays of a picture in one part, `width` · `height` · `supersampling`²: kernels index the records of rays by a
    /// signed number of 32 bits.
    pub const MOST_RAYS: u64 = i32::MAX as u64 / if ray::SIZE > path::SIZE { ray::SIZE } else { path::SIZE } as u64;
}

impl Default for Film {
    fn default() -> Self {
        Self { width: 512, height: 512, exposure: 0.0, supersampling: 1, refinement: 1, refinement_budget: 0.5 }
    }
}

#[cfg(test)]
mod tests {
    use super::Film;

    #[test]
    fn documents_state_the_limit() {
        assert_eq!(Film::MOST_RAYS, 67_108_863);
    }
}
