//! The radiance of an environment, integrated over small cells of all directions.

use crate::method::view::environment::pattern;
use crate::scene::{Environment, EnvironmentKind};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use vitrum_io::Picture;
use vitrum_kernels::optics::environment::environment as radiance_towards;

/// Cells from the zenith to the nadir.
pub(super) const ROWS: usize = 64;
/// Cells along the longitude.
pub(super) const COLUMNS: usize = 2 * ROWS;
/// Samples of a pattern, and the fewest of a picture, from the zenith to the nadir: the mean of the gradient is met to 3e-5.
const SAMPLES: usize = 512;

/// Luminance of linear sRGB.
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// Integrals over the directions of a cell, or of several, in the environment's frame (z up), of an environment of intensity 1.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Cell {
    /// Solid angle.
    pub(super) solid_angle: f64,
    /// Radiance, linear RGB.
    pub(super) flux: [f64; 3],
    /// Luminance.
    pub(super) luminance: f64,
    /// Luminance times the unit direction.
    pub(super) moment: DVec3,
}

impl Cell {
    /// Adds the integrals of another cell.
    pub(super) fn add(&mut self, other: &Self) {
        self.solid_angle += other.solid_angle;
        for (sum, flux) in self.flux.iter_mut().zip(other.flux) {
            *sum += flux;
        }
        self.luminance += other.luminance;
        self.moment += other.moment;
    }
}

/// An equirectangular picture of an environment, each texel of one radiance.
struct Texels {
    width: usize,
    height: usize,
    colors: Vec<[f32; 3]>,
}

/// The picture of an environment whose map is `picture`; `None` for a map without a picture.
fn texels(environment: &Environment, picture: Option<&Picture>) -> Option<Texels> {
    if environment.kind == EnvironmentKind::Map {
        let picture = picture?;
        return Some(Texels {
            width: picture.width as usize,
            height: picture.height as usize,
            colors: picture.color(),
        });
    }
    // Only a checkerboard depends on the longitude, and only a colour not on the latitude.
    let [width, height] = match environment.kind {
        EnvironmentKind::Color => [1, 1],
        EnvironmentKind::Gradient => [1, SAMPLES],
        EnvironmentKind::Checkerboard | EnvironmentKind::Map => [2 * SAMPLES, SAMPLES],
    };
    let block = pattern(environment);
    let color = |index: usize| {
        let towards = direction((index / width) as f64 + 0.5, height, (index % width) as f64 + 0.5, width);
        radiance_towards(&block, &[], towards.as_vec3().to_array().into(), (PI / SAMPLES as f64) as f32).to_array()
    };
    Some(Texels { width, height, colors: (0..width * height).map(color).collect() })
}

/// The unit direction of a point of an equirectangular picture, in texels from its top left corner.
pub(super) fn direction(y: f64, height: usize, x: f64, width: usize) -> DVec3 {
    let (z, across) = libm::sincos(PI * (0.5 - y / height as f64));
    let (side, middle) = libm::sincos(TAU * (0.5 - x / width as f64));
    DVec3::new(across * side, across * middle, z)
}

/// The cells of an environment, row by row from the zenith; empty for a map without a picture.
pub(super) fn cells(environment: &Environment, picture: Option<&Picture>) -> Vec<Cell> {
    let Some(Texels { width, height, colors }) = texels(environment, picture) else { return Vec::new() };
    if colors.len() != width * height || colors.is_empty() {
        return Vec::new();
    }
    // A texel that is large has several samples.
    let (down, across) = (SAMPLES.div_ceil(height), (2 * SAMPLES).div_ceil(width));
    let (rows, columns) = (height * down, width * across);
    let longitudes: Vec<(f64, f64)> =
        (0..columns).map(|x| libm::sincos(TAU * (0.5 - (x as f64 + 0.5) / columns as f64))).collect();
    let edge = |row: usize| libm::cos(PI * row as f64 / rows as f64);
    let mut cells = vec![Cell::default(); ROWS * COLUMNS];
    for y in 0..rows {
        let (top, bottom) = (edge(y), edge(y + 1));
        // Archimedes: the area of a zone of the unit sphere is 2π times its height.
        let solid_angle = TAU * (top - bottom) / columns as f64;
        let z = 0.5 * (top + bottom);
        let level = (1.0 - z * z).sqrt();
        let texels = &colors[y / down * width..][..width];
        for (x, &(side, middle)) in longitudes.iter().enumerate() {
            // What is no radiance, in a picture, is none.
            let radiance =
                texels[x / across].map(|value| if value.is_finite() { f64::from(value.max(0.0)) } else { 0.0 });
            let flux = radiance.map(|value| value * solid_angle);
            let luminance = (0..3).map(|channel| LUMINANCE[channel] * flux[channel]).sum::<f64>();
            let moment = DVec3::new(level * side, level * middle, z) * luminance;
            cells[y * ROWS / rows * COLUMNS + x * COLUMNS / columns].add(&Cell {
                solid_angle,
                flux,
                luminance,
                moment,
            });
        }
    }
    cells
}
