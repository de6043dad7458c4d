//! Indices of refraction that depend on the wavelength.

use super::{IorPoint, Scene};

/// The wavelength, in micrometres, for which indices of refraction are stated: helium's d line.
pub const YELLOW: f64 = 0.587_56;
/// Hydrogen's F line, in micrometres.
const BLUE: f64 = 0.486_13;
/// Hydrogen's C line, in micrometres.
const RED: f64 = 0.656_27;

impl IorPoint {
    /// A point of which all colours bend alike.
    #[must_use]
    pub const fn new(value: f32, ior: f32) -> Self {
        Self { value, ior, abbe: None, cauchy_b: None }
    }

    /// Cauchy's B in µm². Of an Abbe number V = (η_d − 1) / (η_F − η_C) it is (η_d − 1) / (V (1/λ_F² − 1/λ_C²)).
    #[must_use]
    pub fn cauchy_coefficient(&self) -> f64 {
        match (self.cauchy_b, self.abbe) {
            (Some(b), _) => f64::from(b),
            (None, Some(abbe)) => {
                let spread = 1.0 / (BLUE * BLUE) - 1.0 / (RED * RED);
                (f64::from(self.ior) - 1.0) / (f64::from(abbe) * spread)
            }
            (None, None) => 0.0,
        }
    }

    /// η for light of a wavelength in micrometres: Cauchy's η(λ) = A + B/λ².
    #[must_use]
    pub fn ior_at(&self, wavelength: f64) -> f64 {
        let difference = 1.0 / (wavelength * wavelength) - 1.0 / (YELLOW * YELLOW);
        f64::from(self.ior) + self.cauchy_coefficient() * difference
    }
}

impl Scene {
    /// The scene as light of one wavelength, in micrometres, meets it: the same with other indices of refraction, and no dispersion.
    #[must_use]
    pub fn at_wavelength(&self, wavelength: f64) -> Self {
        let mut scene = self.clone();
        for point in &mut scene.transfer.ior {
            *point = IorPoint::new(point.value, point.ior_at(wavelength) as f32);
        }
        scene
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Schott's catalogue: N-BK7 and N-SF6.
    #[test]
    fn an_abbe_number_gives_the_indices_of_catalogued_glass() {
        for (ior, abbe, blue, red) in [(1.5168, 64.17, 1.522_38, 1.514_32), (1.805_18, 25.36, 1.827_83, 1.796_08)] {
            let point = IorPoint { abbe: Some(abbe), ..IorPoint::new(1.0, ior) };
            let (found_blue, found_red) = (point.ior_at(BLUE), point.ior_at(RED));
            // The difference is the definition; Cauchy's two terms share it between the ends to within a tenth of itself.
            assert!((found_blue - found_red - (f64::from(ior) - 1.0) / f64::from(abbe)).abs() < 1e-9);
            let tenth = 0.1 * (blue - red);
            assert!((found_blue - blue).abs() < tenth && (found_red - red).abs() < tenth, "{found_blue} {found_red}");
        }
    }

    #[test]
    fn nothing_changes_where_all_colours_bend_alike() {
        let point = IorPoint::new(1.0, 1.5);
        assert_eq!(point.ior_at(0.4), 1.5);
        assert_eq!(IorPoint { cauchy_b: Some(0.004), ..point }.ior_at(YELLOW), 1.5);
    }
}
