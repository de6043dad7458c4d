//! Exposures to bands of the spectrum, put together.

use super::film::Exposure;
use super::spectrum::Band;
use crate::backend::times::merge;
use crate::scene::YELLOW;
use vitrum_kernels::abi::record::film;

/// What was put together so far.
#[derive(Default)]
pub(crate) struct Blend {
    pub exposure: Option<Exposure>,
    /// How far the band whose ray the film shows is from yellow, in micrometres.
    nearest: f64,
}

impl Blend {
    /// Adds an exposure to a band; without a band it is all there is.
    ///
    /// Colour, medium and light are weighted by channel, coverage and opacity by the mean weight. Depth, direction, position and
    /// status are those of the band nearest to the wavelength for which indices are stated.
    pub fn add(&mut self, band: Option<Band>, added: Exposure) {
        let Some(Band { wavelength, weights }) = band else {
            self.exposure = Some(added);
            return;
        };
        let weights = weights.map(|weight| weight as f32);
        let mean = (weights[0] + weights[1] + weights[2]) / 3.0;
        let rays = added.film.len() / film::SIZE;
        let off = (wavelength - YELLOW).abs();
        let is_nearest = self.exposure.is_none() || off < self.nearest;
        self.nearest = if is_nearest { off } else { self.nearest };
        let whole = self.exposure.get_or_insert_with(|| Exposure {
            film: vec![0.0; added.film.len()],
            light: added.light.as_ref().map(|light| vec![0.0; light.len()]),
            frame_ms: 0.0,
            kernels: Vec::new(),
        });
        let planes = whole.film.chunks_exact_mut(rays).zip(added.film.chunks_exact(rays));
        for (component, (whole, added)) in planes.enumerate() {
            match component {
                0..3 => weigh(whole, added, weights[component - film::COLOR]),
                3 | film::OPACITY => weigh(whole, added, mean),
                5..8 => weigh(whole, added, weights[component - film::MEDIUM]),
                _ if is_nearest => whole.copy_from_slice(added),
                _ => {}
            }
        }
        if let (Some(whole), Some(added)) = (&mut whole.light, &added.light) {
            let texels = added.len() / weights.len();
            let planes = whole.chunks_exact_mut(texels).zip(added.chunks_exact(texels));
            for ((whole, added), weight) in planes.zip(weights) {
                weigh(whole, added, weight);
            }
        }
        whole.frame_ms += added.frame_ms;
        merge(&mut whole.kernels, &added.kernels);
    }
}

fn weigh(whole: &mut [f32], added: &[f32], weight: f32) {
    for (whole, added) in whole.iter_mut().zip(added) {
        *whole += added * weight;
    }
}
