//! The outputs of frames of beams.

use super::passes::Frame;
use crate::backend::{Buffer, PassList};
use crate::film::{Output, PixelFilter, Statistics, rgb, rgba, xyz};
use crate::method::PreparedFrame;
use vitrum_kernels::abi::record::beam_pixel;

/// The outputs, by the components of [`beam_pixel`].
pub(super) const OUTPUTS: &[Output] = &[
    Output::color(rgba!(beam_pixel::COLOR, beam_pixel::COVERAGE)),
    Output::mean(
        "surfaces",
        rgb!(beam_pixel::SURFACES),
        "radiance of surfaces and of the environment, through bodies and medium",
    ),
    Output::mean(
        "airlight",
        rgb!(beam_pixel::AIRLIGHT),
        "radiance that the medium scatters out of the sources' light as if there were no body",
    ),
    Output::mean(
        "caustics",
        rgb!(beam_pixel::CAUSTICS),
        "volume caustics: radiance that the medium scatters out of light that bodies have refracted or reflected",
    ),
    Output::mean("shadow", rgb!(beam_pixel::SHADOW), "volumetric shadow: the part of the airlight that bodies take away"),
    Output::mean(
        "depth",
        &[("Z", beam_pixel::DEPTH)],
        "depth of the first surface along the viewing direction, world units; 0 where there is none",
    )
    .filtered(PixelFilter::Present),
    Output::directions(
        "normal",
        xyz!(beam_pixel::NORMAL),
        "unit normal at the first surface in view space, 0 where there is none",
    ),
];

impl PreparedFrame for Frame {
    fn passes(&self) -> &PassList {
        &self.passes
    }

    fn rays(&self) -> [u32; 2] {
        self.rays
    }

    fn film(&self) -> &Buffer {
        &self.film
    }

    fn statistics(&self, _film: &[f32], _statistics: &mut Statistics) {}
}
