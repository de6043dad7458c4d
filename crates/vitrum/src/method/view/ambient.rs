//! Ambient light: spherical harmonics of an environment's radiance, up to the second order (Ramamoorthi & Hanrahan 2001).

use super::environment::pattern;
use crate::scene::{Environment, EnvironmentKind, Rgb};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use vitrum_io::Picture;
use vitrum_kernels::abi::ambient::Ambient;
use vitrum_kernels::abi::vector::Vec3;
use vitrum_kernels::optics::environment::environment as radiance_towards;

/// Samples of a pattern from the zenith to the nadir, uniform in height: the mean of the default gradient is met to 1e-4.
const ROWS: usize = 256;
/// Samples of a checkerboard along the longitude.
const COLUMNS: usize = 512;

/// Integrals of a radiance over all directions.
#[derive(Clone, Copy, Default)]
struct Moments {
    /// ∫ L dΩ.
    mean: f64,
    /// ∫ L ω dΩ.
    first: DVec3,
    /// ∫ L (ω ωᵀ − ⅓) dΩ: xx, yy, zz.
    squares: DVec3,
    /// The same: xy, xz, yz.
    products: DVec3,
}

impl Moments {
    fn add(&mut self, towards: DVec3, flux: f64) {
        let DVec3 { x, y, z } = towards;
        self.mean += flux;
        self.first += towards * flux;
        self.squares += (towards * towards - DVec3::splat(1.0 / 3.0)) * flux;
        self.products += DVec3::new(x * y, x * z, y * z) * flux;
    }
}

/// The irradiance over π by a surface's normal, in the environment's frame (z up), of an environment of intensity 1.
#[derive(Clone, Copy, Default)]
pub(in crate::method) struct Irradiance([Moments; 3]);

impl Irradiance {
    /// Of an equirectangular picture: rows by the solid angle that they cover.
    pub(super) fn of_map(picture: &Picture) -> Self {
        let (width, height) = (picture.width as usize, picture.height as usize);
        let texels = picture.color();
        let edge = |row: usize| libm::cos(PI * row as f64 / height as f64);
        let mut found = Self::default();
        for (row, texels) in texels.chunks_exact(width).enumerate() {
            let (top, bottom) = (edge(row), edge(row + 1));
            // Archimedes: the area of a zone of the unit sphere is 2π times its height.
            found.add_row(0.5 * (top + bottom), TAU * (top - bottom), texels);
        }
        found
    }

    /// Of a colour, a gradient or a checkerboard.
    fn of_pattern(environment: &Environment) -> Self {
        let block = pattern(environment);
        let columns = if environment.kind == EnvironmentKind::Checkerboard { COLUMNS } else { 1 };
        let mut found = Self::default();
        for row in 0..ROWS {
            let z = 1.0 - (2.0 * row as f64 + 1.0) / ROWS as f64;
            let angle = (TAU / COLUMNS as f64) as f32;
            let towards = |column| direction(z, column, columns).as_vec3().to_array().into();
            let colors = (0..columns).map(|column| radiance_towards(&block, &[], towards(column), angle).to_array());
            found.add_row(z, 2.0 * TAU / ROWS as f64, &colors.collect::<Vec<_>>());
        }
        found
    }

    /// Adds a zone of directions around height `z`, of some solid angle, whose radiances are `texels`.
    fn add_row(&mut self, z: f64, solid_angle: f64, texels: &[Rgb]) {
        // One colour all around has the moments of a circle.
        let around = if texels.len() == 1 { &[texels[0]; 8] } else { texels };
        for (column, texel) in around.iter().enumerate() {
            let towards = direction(z, column, around.len());
            for (moments, &radiance) in self.0.iter_mut().zip(texel) {
                let radiance = if radiance.is_finite() { f64::from(radiance.max(0.0)) } else { 0.0 };
                moments.add(towards, radiance * solid_angle / around.len() as f64);
            }
        }
    }
}

/// The unit direction at a height, in the middle of a column of several along the longitude, as an equirectangular map has it.
fn direction(z: f64, column: usize, columns: usize) -> DVec3 {
    let across = (1.0 - z * z).max(0.0).sqrt();
    let (side, middle) = libm::sincos(TAU * (0.5 - (column as f64 + 0.5) / columns as f64));
    DVec3::new(across * side, across * middle, z)
}

/// The ambient light of a scene: `constant` radiance from all sides, and what the environment has of it, whose map has the irradiance `map`.
pub(in crate::method) fn ambient(constant: Rgb, environment: &Environment, map: Option<&Irradiance>) -> Ambient {
    let factor = f64::from(environment.ambient) * f64::from(environment.intensity);
    if factor == 0.0 {
        return Ambient { mean: constant.into(), ..Ambient::default() };
    }
    let found = match (environment.kind, map) {
        (EnvironmentKind::Map, Some(map)) => *map,
        (EnvironmentKind::Map, None) => Irradiance::default(),
        _ => Irradiance::of_pattern(environment),
    };
    // Band l of the radiance has the factor (2l + 1)/4π of its reproducing kernel, and Lambert's cosine takes 1, ⅔, ¼ of it.
    let of =
        |value: &dyn Fn(&Moments) -> f64| -> Rgb { found.0.each_ref().map(|moments| (factor * value(moments)) as f32) };
    let first = |axis: usize| -> Vec3 { of(&|moments| moments.first[axis] / TAU).into() };
    let square = |axis: usize| -> Vec3 { of(&|moments| 15.0 / (32.0 * PI) * moments.squares[axis]).into() };
    let product = |axis: usize| -> Vec3 { of(&|moments| 15.0 / (16.0 * PI) * moments.products[axis]).into() };
    let mean = of(&|moments| moments.mean / (2.0 * TAU));
    Ambient {
        mean: std::array::from_fn::<f32, 3, _>(|channel| constant[channel] + mean[channel]).into(),
        x: first(0),
        y: first(1),
        z: first(2),
        xx: square(0),
        yy: square(1),
        zz: square(2),
        xy: product(0),
        xz: product(1),
        yz: product(2),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::abi::environment::Environment as Block;
    use vitrum_kernels::glam;
    use vitrum_kernels::optics::ambient::irradiance;

    /// The irradiance over π that kernels compute for a normal, in the environment's frame.
    fn on(environment: &Environment, map: Option<&Irradiance>, normal: DVec3) -> [f32; 3] {
        let [row_x, row_y, row_z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        let axes = Block { row_x, row_y, row_z, ..Block::default() };
        let normal: glam::Vec3 = normal.as_vec3().to_array().into();
        irradiance(&ambient([0.0; 3], environment, map), &axes, normal).to_array()
    }

    fn lit(kind: EnvironmentKind) -> Environment {
        Environment { kind, ambient: 1.0, ..Environment::default() }
    }

    #[test]
    fn one_colour_gives_its_radiance_to_all_normals() {
        let environment = Environment { color: [0.2, 0.5, 3.0], intensity: 2.0, ..lit(EnvironmentKind::Color) };
        for normal in [DVec3::Z, DVec3::X, DVec3::new(0.6, 0.0, -0.8)] {
            for (found, expected) in on(&environment, None, normal).into_iter().zip([0.4, 1.0, 6.0]) {
                assert!((found - expected).abs() < 1e-5 * expected, "{found} instead of {expected}");
            }
        }
    }

    #[test]
    fn a_bright_hemisphere_gives_what_the_integral_gives() {
        // White above the horizon: E/π = (1 + n_z)/2, which harmonics up to the second order have exactly, but for 1e-3 by rows.
        let picture = Picture::rgb(4, 512, (0..4 * 512).map(|at| [if at < 4 * 256 { 1.0 } else { 0.0 }; 3]).collect());
        let map = Irradiance::of_map(&picture);
        for z in [-1.0, -0.5, 0.0, 0.7, 1.0f64] {
            let found = on(&lit(EnvironmentKind::Map), Some(&map), DVec3::new((1.0 - z * z).sqrt(), 0.0, z))[1];
            assert!((f64::from(found) - 0.5 * (1.0 + z)).abs() < 1e-3, "{found} at {z}");
        }
    }

    #[test]
    fn a_gradient_gives_what_the_integral_gives() {
        let environment = lit(EnvironmentKind::Gradient);
        let block = pattern(&environment);
        for normal in [DVec3::Z, -DVec3::Z, DVec3::X, DVec3::new(0.0, 0.6, 0.8)] {
            // E/π = ∫ L max(n · ω, 0) dΩ / π.
            let mut sum = [0.0; 3];
            let (rows, columns) = (400, 400);
            for index in 0..rows * columns {
                let z = 1.0 - (2.0 * (index / columns) as f64 + 1.0) / rows as f64;
                let towards = direction(z, index % columns, columns);
                let radiance = radiance_towards(&block, &[], towards.as_vec3().to_array().into(), 0.0).to_array();
                let weight = towards.dot(normal).max(0.0) * 4.0 / (rows * columns) as f64;
                sum.iter_mut().zip(radiance).for_each(|(sum, radiance)| *sum += weight * f64::from(radiance));
            }
            for (found, expected) in on(&environment, None, normal).into_iter().zip(sum) {
                // The fourth order and above: 1.2 % of the light was measured.
                assert!(
                    (f64::from(found) - expected).abs() < 0.02 * expected,
                    "{found} instead of {expected}, {normal}"
                );
            }
        }
    }
}
