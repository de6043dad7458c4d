//! Indices of refraction that depend on the wavelength.

use super::{IorPoint, Material, Scene};

/// The wavelength, in micrometres, for which indices of refraction are stated: helium's d line.
pub const YELLOW: f64 = 0.587_56;
/// Hydrogen's F line, in micrometres.
const BLUE: f64 = 0.486_13;
/// Hydrogen's C line, in micrometres.
const RED: f64 = 0.656_27;

/// An index of refraction for yellow light, and one of the two measures of its dispersion, or none.
#[derive(Clone, Copy)]
struct Dispersion {
    ior: f32,
    abbe: Option<f32>,
    cauchy_b: Option<f32>,
}

impl Dispersion {
    /// Cauchy's B in µm². Of an Abbe number V = (η_d − 1) / (η_F − η_C) it is (η_d − 1) / (V (1/λ_F² − 1/λ_C²)).
    fn cauchy_coefficient(self) -> f64 {
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
    fn ior_at(self, wavelength: f64) -> f64 {
        let difference = 1.0 / (wavelength * wavelength) - 1.0 / (YELLOW * YELLOW);
        f64::from(self.ior) + self.cauchy_coefficient() * difference
    }
}

impl IorPoint {
    /// A point of which all colours bend alike.
    #[must_use]
    pub const fn new(value: f32, ior: f32) -> Self {
        Self { value, ior, abbe: None, cauchy_b: None }
    }

    const fn dispersion(&self) -> Dispersion {
        Dispersion { ior: self.ior, abbe: self.abbe, cauchy_b: self.cauchy_b }
    }

    /// Cauchy's B in µm².
    #[must_use]
    pub fn cauchy_coefficient(&self) -> f64 {
        self.dispersion().cauchy_coefficient()
    }

    /// η for light of a wavelength in micrometres.
    #[must_use]
    pub fn ior_at(&self, wavelength: f64) -> f64 {
        self.dispersion().ior_at(wavelength)
    }
}

impl Material {
    const fn dispersion(&self) -> Dispersion {
        Dispersion { ior: self.ior, abbe: self.abbe, cauchy_b: self.cauchy_b }
    }

    /// Cauchy's B in µm².
    #[must_use]
    pub fn cauchy_coefficient(&self) -> f64 {
        self.dispersion().cauchy_coefficient()
    }

    /// η for light of a wavelength in micrometres.
    #[must_use]
    pub fn ior_at(&self, wavelength: f64) -> f64 {
        self.dispersion().ior_at(wavelength)
    }

    /// Whether a clear body of it bends colours differently.
    #[must_use]
    pub fn disperses(&self) -> bool {
        !self.opaque && !self.mirror && self.cauchy_coefficient() != 0.0
    }
}

impl Scene {
    /// The scene as light of one wavelength, in micrometres, meets it: the same with other indices of refraction of the volume and of
    /// meshes, and no dispersion.
    #[must_use]
    pub fn at_wavelength(&self, wavelength: f64) -> Self {
        let mut scene = self.clone();
        for point in &mut scene.transfer.ior {
            *point = IorPoint::new(point.value, point.ior_at(wavelength) as f32);
        }
        for material in &mut scene.material {
            material.ior = material.ior_at(wavelength) as f32;
            (material.abbe, material.cauchy_b) = (None, None);
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

    #[test]
    fn materials_of_a_mesh_disperse_as_a_volume_does() {
        let diamond = Material { ior: 2.417, abbe: Some(55.3), ..Material::default() };
        let point = IorPoint { abbe: Some(55.3), ..IorPoint::new(1.0, 2.417) };
        let glass = Material { cauchy_b: Some(0.004), ..Material::default() };
        let mirror = Material { mirror: true, ..diamond.clone() };
        assert!(diamond.disperses() && glass.disperses() && !mirror.disperses() && !Material::default().disperses());
        let scene = Scene { material: vec![diamond, glass, Material::default()], ..Scene::default() };
        let blue = scene.at_wavelength(BLUE);
        assert_eq!(blue.material[0].ior, point.ior_at(BLUE) as f32);
        assert_eq!(
            blue.material[1].ior,
            IorPoint { cauchy_b: Some(0.004), ..IorPoint::new(1.0, 1.5) }.ior_at(BLUE) as f32
        );
        assert_eq!(blue.material[2], Material::default());
        assert!(blue.material.iter().all(|material| !material.disperses()));
    }
}
