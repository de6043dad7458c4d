//! Spectral rendering: wavelengths that represent bands of the spectrum, with their weights in red, green and blue.

use crate::method::Exposure;
use crate::scene::YELLOW;

/// A band of the spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// The wavelength that represents the band, in micrometres.
    pub wavelength: f64,
    /// Weights of the band in linear red, green and blue; over all bands, the weights of each sum to 1.
    pub weights: [f64; 3],
}

/// The ends of the visible spectrum, in micrometres.
const VISIBLE: [f64; 2] = [0.40, 0.70];

/// The dominant wavelengths of the primaries of sRGB.
const PRIMARIES: [f64; 3] = [0.6114, 0.5491, 0.4642];

/// Bands of the spectrum, `count` of them: for 3, one for each primary of sRGB; for more, equal parts of the visible spectrum, weighted
/// by the CIE's 1931 colour-matching functions. Weights may be negative there, as pure spectral colours are outside of sRGB.
#[must_use]
pub fn bands(count: u32) -> Vec<Band> {
    if count <= 3 {
        let weights = |channel: usize| std::array::from_fn(|other| if other == channel { 1.0 } else { 0.0 });
        return (0..3).map(|channel| Band { wavelength: PRIMARIES[channel], weights: weights(channel) }).collect();
    }
    const SAMPLES: u32 = 64;
    let width = (VISIBLE[1] - VISIBLE[0]) / f64::from(count);
    let mut bands: Vec<Band> = (0..count)
        .map(|band| {
            let at = |share: f64| VISIBLE[0] + (f64::from(band) + share) * width;
            let mut weights = [0.0; 3];
            for sample in 0..SAMPLES {
                let rgb = color_matching(at((f64::from(sample) + 0.5) / f64::from(SAMPLES)));
                weights = std::array::from_fn(|channel| weights[channel] + rgb[channel]);
            }
            Band { wavelength: at(0.5), weights }
        })
        .collect();
    for channel in 0..3 {
        let sum: f64 = bands.iter().map(|band| band.weights[channel]).sum();
        bands.iter_mut().for_each(|band| band.weights[channel] /= sum);
    }
    bands
}

/// Of each exposure of a light one for each of `wavelengths` bands of the spectrum; the exposures as they are if there is no number,
/// since indices of refraction are the same for all wavelengths.
pub(super) fn split(exposures: Vec<Exposure>, wavelengths: Option<u32>) -> Vec<Exposure> {
    let Some(bands) = wavelengths.map(bands) else { return exposures };
    let of_band = |exposure: &Exposure, band: &Band| Exposure {
        scene: exposure.scene.at_wavelength(band.wavelength),
        weights: band.weights.map(|weight| weight as f32),
        // Indices are stated for yellow light.
        distance: (band.wavelength - YELLOW).abs(),
        part: exposure.part,
    };
    exposures.iter().flat_map(|exposure| bands.iter().map(move |band| of_band(exposure, band))).collect()
}

/// Linear sRGB of spectral light, from the fit of Wyman, Sloan and Shirley (2013, JCGT 2:2, Eq. 4) to the CIE's functions of 1931.
fn color_matching(wavelength: f64) -> [f64; 3] {
    let nanometres = wavelength * 1e3;
    let lobe = |centre: f64, below: f64, above: f64| {
        let width = if nanometres < centre { below } else { above };
        let deviations = (nanometres - centre) / width;
        libm::exp(-0.5 * (deviations * deviations))
    };
    let x = 1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2);
    let y = 0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1);
    let z = 1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8);
    [3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z, 0.0557 * x - 0.2040 * y + 1.0570 * z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_stays_white() {
        for count in [3, 4, 7, 32] {
            let bands = bands(count);
            assert_eq!(bands.len(), count as usize);
            for channel in 0..3 {
                let sum: f64 = bands.iter().map(|band| band.weights[channel]).sum();
                assert!((sum - 1.0).abs() < 1e-12, "{count}: {sum}");
            }
        }
    }

    #[test]
    fn colours_are_where_the_rainbow_has_them() {
        let bands = bands(30);
        let strongest = |nanometres: f64| {
            let off = |band: &&Band| (band.wavelength * 1e3 - nanometres).abs();
            let band = bands.iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
            (0..3).max_by(|&a, &b| band.weights[a].total_cmp(&band.weights[b])).unwrap()
        };
        assert_eq!([630.0, 530.0, 450.0].map(strongest), [0, 1, 2]);
    }
}
