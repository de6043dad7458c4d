//! The outputs of frames of beams.

use super::frame::Frame;
use crate::backend::{Backend, BackendError, Buffer, PassList};
use crate::film::{FluxShares, Output, PixelFilter, Statistics, rgb, rgba, xyz};
use crate::method::PreparedFrame;
use vitrum_kernels::abi::record::{beam_pixel, pencil};

/// The outputs, by the components of [`beam_pixel`].
pub(super) const OUTPUTS: &[Output] = &[
    Output::color(rgba!(beam_pixel::COLOR, beam_pixel::COVERAGE)),
    Output::radiance(
        "surfaces",
        rgb!(beam_pixel::SURFACES),
        "radiance of surfaces and of the environment, through bodies and medium",
    ),
    Output::radiance(
        "airlight",
        rgb!(beam_pixel::AIRLIGHT),
        "radiance that the medium scatters out of the sources' light as if there were no body",
    ),
    Output::radiance(
        "caustics",
        rgb!(beam_pixel::CAUSTICS),
        "volume caustics: radiance that the medium scatters out of light that bodies have refracted or reflected",
    ),
    Output::radiance(
        "shadow",
        rgb!(beam_pixel::SHADOW),
        "volumetric shadow: the part of the airlight that bodies take away",
    ),
    Output::radiance(
        "multiple",
        rgb!(beam_pixel::MULTIPLE),
        "multiple scattering: radiance that the medium scatters out of light that it has scattered before, an estimate",
    ),
    Output::mean(
        "depth",
        &[("Z", beam_pixel::DEPTH)],
        "depth of the first surface along the viewing direction, world units; 0 where there is none",
    )
    .filtered(PixelFilter::Present)
    .lengths(),
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

    fn statistics(&self, backend: &mut dyn Backend, statistics: &mut Statistics) -> Result<(), BackendError> {
        statistics.flux = flux(&self.pencils(backend)?);
        Ok(())
    }
}

/// The shares of the flux of pencils, over those that have come into the box around all bodies; none if there are none.
fn flux(pencils: &[f32]) -> Option<FluxShares> {
    let count = pencils.len() / pencil::SIZE;
    let component = |component: usize| &pencils[component * count..(component + 1) * count];
    // One that has not has no piece.
    let met: Vec<usize> = (0..count).filter(|&at| component(pencil::PIECES)[at] > 0.0).collect();
    let mean = |from: usize| met.iter().map(|&at| f64::from(component(from)[at])).sum::<f64>() / met.len() as f64;
    let [escaped, received, absorbed, extinguished] =
        [pencil::ESCAPED, pencil::RECEIVED, pencil::ABSORBED, pencil::EXTINGUISHED].map(mean);
    // Ways that had not begun when the last piece was reached are lost, too.
    let lost = 1.0 - (escaped + received + absorbed + extinguished);
    (!met.is_empty()).then_some(FluxShares { escaped, received, absorbed, extinguished, lost })
}
