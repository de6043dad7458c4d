//! Transfer functions: piecewise linear over the physical scalar.

use super::{GradientFunction, Rgb, Scene};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use vitrum_io::Volume;

/// A colour at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColorPoint {
    /// Scalar value.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Linear RGB: the reflectance of particles, or the transmittance of a layer as thick as the reference length.
    #[schemars(inner(range(min = 0, max = 1)), extend("x-unit" = "a share"))]
    pub color: Rgb,
}

/// An opacity at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OpacityPoint {
    /// Scalar value.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Opacity of a layer as thick as the reference length.
    #[schemars(range(min = 0, max = 1))]
    pub opacity: f32,
}

/// An index of refraction at a scalar value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IorPoint {
    /// Scalar value, of `ior_volume` where there is one.
    #[schemars(extend("x-unit" = "the volume's"))]
    pub value: f32,
    /// Index of refraction: 1 is air's, 1.33 water's, 1.5 that of glass. No light is bent where it is `surroundings.ior`.
    #[schemars(range(min = 0.2, max = 5))]
    pub ior: f32,
    /// Abbe number V_d: the smaller, the more blue bends than red, as crown glass (60) and flint glass (30) do. `ior` is
    /// then that of yellow light (587.6 nm). All colours bend alike if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 5, max = 1000))]
    pub abbe: Option<f32>,
    /// Coefficient B of Cauchy's η(λ) = A + B/λ², instead of `abbe`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 0.1), extend("x-unit" = "µm²"))]
    pub cauchy_b: Option<f32>,
}

/// Four piecewise linear functions over the scalar, each constant beyond its first and last point. Points are sorted by
/// `value`; two points at the same value make a step.
///
/// `color` and `opacity` describe pigment particles, `filter` the transmittance of the clear medium they float in (sweep §4.1). The
/// defaults for `ior` (1) and `filter` (white) make plain Porter–Duff volume rendering.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TransferFunction {
    /// Thickness of the layer that `opacity` and `filter` are stated for; the smallest voxel edge if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub reference_length: Option<f32>,
    /// Radius of a filter that takes noise out of the scalar that `ior` is looked up with, and leaves edges where they are; 0 takes the scalar as it is.
    /// If absent, the noise of a volume's file decides (`vitrum info` shows it): 0 below 0.75 % of the way from air to soft matter, 1 below 2 %, 2 below
    /// 5 %, else 3, and never less than `opacity_smoothing`. It is done once for a volume, and takes 2 bytes a voxel on the host (4 for floats), and 8 in
    /// place of 1 to 4 on the device, where both scalars are then floats; with the radius of `opacity_smoothing` there is one scalar, of 2 bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0, max = 8), extend("x-unit" = "voxels"))]
    pub ior_smoothing: Option<u32>,
    /// Radius of the same filter for the scalar that `color`, `opacity` and `filter` are looked up with.
    #[schemars(range(min = 0, max = 8), extend("x-unit" = "voxels"))]
    pub opacity_smoothing: u32,
    /// Visible parts of fewer voxels are left out, and get the value that lies beside them: specks of noise, and with a large number all but the body,
    /// such as a scanner's table. Voxels hang together by their faces, before they are smoothed.
    #[schemars(range(min = 0, max = 1_000_000_000), extend("x-unit" = "voxels"))]
    pub speck_size: u32,
    /// Reflectance of particles; white if empty.
    pub color: Vec<ColorPoint>,
    /// Opacity of particles; if empty 0 where there is an `isosurface`, else a ramp over the volume's range, outliers left out.
    pub opacity: Vec<OpacityPoint>,
    /// Index of refraction; `surroundings.ior` if empty.
    pub ior: Vec<IorPoint>,
    /// Transmittance of the clear medium that particles float in; white if empty.
    pub filter: Vec<ColorPoint>,
    /// The second dimension: factors of opacity and colour at the magnitude of the scalar's gradient. The voxels are then stored in 16 bits with four bytes
    /// of factors each, in one piece, and one scalar gives colour and index of refraction, smoothed by the larger of the two radii above.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gradient: Vec<GradientFunction>,
}

impl Scene {
    /// Whether opacity is a ramp over the volume's range, since nothing says what is shown.
    pub(crate) fn has_usual_opacity(&self) -> bool {
        self.transfer.opacity.is_empty() && self.isosurface.is_empty()
    }
}

impl TransferFunction {
    /// The reference length for `volume`, world units: `reference_length`, else the smallest voxel edge.
    pub(crate) fn reference_length_in(&self, volume: &Volume) -> f32 {
        self.reference_length.unwrap_or_else(|| volume.finest_spacing())
    }

    /// Whether colours bend differently somewhere.
    #[must_use]
    pub fn disperses(&self) -> bool {
        self.ior.iter().any(|point| point.cauchy_coefficient() != 0.0)
    }
}
