//! The source of a volume's voxels.

use super::Mask;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A volume on disk, or one that Vitrum computes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct VolumeSource {
    /// Volume file, folder of DICOM or TIFF files, or `-`, standard input; `vitrum info` shows the contents. A relative
    /// path starts at the scene file's folder. Exactly one of `file` and `builtin` is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a path"))]
    pub file: Option<std::path::PathBuf>,
    /// Name of a procedural volume, such as `ball`, `glass` or `supernova`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a name"))]
    pub builtin: Option<String>,
    /// Number of voxels along the longest edge of a procedural volume, which has a resolution of its own if this is
    /// absent; files have theirs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 16, max = 2048), extend("x-unit" = "voxels"))]
    pub resolution: Option<u32>,
    /// Edges of a voxel, instead of the file's; the middle of the volume stays where it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units", "items" = { "type": "number", "format": "float", "exclusiveMinimum": 0 }))]
    pub spacing: Option<[f32; 3]>,
    /// Layout of a file without a header: `256x256x109:u8`, perhaps with `:le` or `:be` and `:skip=BYTES` behind it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a layout"))]
    pub raw: Option<String>,
    /// Array of a VTK or NumPy file with several, else its active scalars or its first; of a TIFF file the number of a
    /// channel, counted from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a name"))]
    pub array: Option<String>,
    /// Point in time of a file with several, counted from 0; the first if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 1_000_000_000))]
    pub time: Option<u32>,
    /// Point in time in seconds, instead of `time`: the nearest of those that the file states.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "s"))]
    pub seconds: Option<f64>,
    /// Direction that is turned to point up: `x`, `-x`, `y`, `-y`, `z`, `-z` or `right`, `left`, `anterior`, `posterior`,
    /// `superior`, `inferior`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "an axis"))]
    pub up: Option<String>,
    /// Interpolation between voxels.
    #[serde(skip_serializing_if = "Interpolation::is_linear")]
    pub interpolation: Interpolation,
    /// A segmentation by which parts of the volume are hidden.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mask: Option<Mask>,
}

/// The interpolation of values between voxels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Interpolation {
    /// Trilinear, between the eight voxels around a point.
    #[default]
    Linear,
    /// The cubic spline through the voxels' values along each axis, without swings at edges: for volumes whose voxels are much larger than pixels. A finer
    /// grid is made for it once, so that memory grows eightfold at least.
    Cubic,
    /// A point has the value of the voxel in which it lies: for labels of parts, between which no other value means anything.
    Nearest,
}

impl Interpolation {
    fn is_linear(&self) -> bool {
        *self == Self::Linear
    }
}

impl VolumeSource {
    /// Takes over from `keys` how a file is read: `raw`, `spacing`, `array`, `time` or `seconds`, `up` and `mask` where they are set there.
    pub fn read_as(&mut self, keys: Self) {
        let Self { raw, spacing, array, time, seconds, up, mask, file: _, builtin: _, resolution: _, interpolation: _ } =
            keys;
        self.mask = mask.or(self.mask.take());
        self.raw = raw.or(self.raw.take());
        self.spacing = spacing.or(self.spacing);
        self.array = array.or(self.array.take());
        // One of the two says it.
        if time.is_some() || seconds.is_some() {
            (self.time, self.seconds) = (time, seconds);
        }
        self.up = up.or(self.up.take());
    }
}
