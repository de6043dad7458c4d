//! 9: a thin slab η = 1 + ε cos kx focuses parallel light: on-axis irradiance 1/(1 − Z/Z_f), Z_f = 1/(ε k² t).

use vitrum::backend::Backend;
use vitrum::scene::{Intensity, Transport, Wall};

use super::{cuboid, refracting, render_with_light};

const EPSILON: f64 = 0.04;
/// The slab fades in and out over its depth as sin², so that its faces do not bend light: half of it counts.
const DEPTH: f64 = 0.25;
const THICKNESS: f64 = 0.5 * DEPTH;
const PERIOD: f64 = 1.0;

/// Irradiance on a screen at `share` of the focal distance: on axis, half a period beside it, mean over the middle period.
///
/// # Panics
/// If the scene does not render.
pub fn irradiance(
    share: f64,
    resolution: f32,
    sample_distance: f32,
    intensity: Intensity,
    backend: &mut dyn Backend,
) -> (f64, f64, f64) {
    let k = std::f64::consts::TAU / PERIOD;
    let focus = 1.0 / (EPSILON * k * k * THICKNESS);
    // 3 periods wide, 64 voxels a period.
    let spacing = 1.0 / 64.0;
    let layers = (DEPTH * 64.0) as u32;
    let volume = cuboid([192, layers, 8], spacing, |[x, y, _]| {
        let fade = (std::f64::consts::PI * (y / DEPTH + 0.5)).sin().powi(2);
        1.0 + EPSILON * fade * (k * x).cos()
    });
    let mut scene = refracting(&volume, 64);
    // Light on texels alone has an intensity to correct, and planes up to the wall.
    scene.sweep.light = Transport::Texels;
    scene.sweep.intensity = intensity;
    scene.sweep.light = Transport::Texels;
    scene.sweep.light_resolution = resolution;
    scene.sweep.sample_distance = sample_distance;
    let distance = share * focus;
    scene.wall = Some(Wall { distance: Some(distance as f32), azimuth: 0.0, color: [1.0; 3] });
    let frame = render_with_light(&scene, &volume, backend);
    let light = frame.light.as_ref().expect("all outputs are wanted");
    let width = light.width as usize;
    let pixels = light.color();
    let row = light.height as usize / 2;
    // Texel positions: the grid is centred on the volume (light travels straight on, so there is no shear).
    let texel = PERIOD / texels(resolution);
    let at = |x: f64| {
        let position = x / texel + width as f64 * 0.5 - 0.5;
        let left = position.floor() as usize;
        let t = position - position.floor();
        f64::from(pixels[row * width + left][0]) * (1.0 - t) + f64::from(pixels[row * width + left + 1][0]) * t
    };
    let mean = (0..256).map(|i| at(-0.5 + (f64::from(i) + 0.5) / 256.0)).sum::<f64>() / 256.0;
    (at(0.0), at(0.5), mean)
}

/// The number of light texels in a period, at `resolution` texels per pixel edge.
#[must_use]
pub fn texels(resolution: f32) -> f64 {
    let radius = 0.5 * (3.0f64.powi(2) + DEPTH.powi(2) + (8.0 / 64.0f64).powi(2)).sqrt();
    PERIOD / (2.0 * 0.87 * radius / 64.0 / f64::from(resolution))
}
