//! Size and exposure of the picture.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Size and exposure of the picture: at most 2^28 viewing rays, `width` · `height` · `supersampling`².
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Film {
    /// Pixels across, 1 to 16384.
    #[schemars(range(min = 1, max = 16384))]
    pub width: u32,
    /// Pixels down, 1 to 16384.
    #[schemars(range(min = 1, max = 16384))]
    pub height: u32,
    /// Stops by which the picture is brightened (2^exposure), −20 to 20; applies to `color` only.
    #[schemars(range(min = -20, max = 20))]
    pub exposure: f32,
    /// Rays per pixel edge, 1 to 4; the picture is averaged from that many times larger a one.
    #[schemars(range(min = 1, max = 4))]
    pub supersampling: u32,
}

impl Film {
    /// Most viewing rays that a picture may take: `width` · `height` · `supersampling`².
    pub const MOST_RAYS: u64 = 1 << 28;
}

impl Default for Film {
    fn default() -> Self {
        Self { width: 512, height: 512, exposure: 0.0, supersampling: 1 }
    }
}
