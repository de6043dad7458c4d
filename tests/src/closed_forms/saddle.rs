//! A thin slab η = 1 + a·x·y shears parallel light: (x, y) on a screen at Z comes from a parallelogram, and the irradiance is
//! 1/(1 − (Z/f)²) everywhere, 1/f = a·t for the thickness t.

use vitrum::backend::Backend;
use vitrum::scene::{Intensity, Wall};

use super::{cuboid, refracting, render};

/// The slab fades in and out over its depth as sin², so that its faces do not bend light: half of it counts.
const DEPTH: f64 = 0.25;
/// Where the screen stands, world units.
const DISTANCE: f64 = 2.0;
/// The edge of a voxel.
const SPACING: f64 = 1.0 / 32.0;
/// Distance of the planes, in voxels: two in the slab, which is enough for a sine squared.
const SAMPLE_DISTANCE: f32 = 4.0;
/// How much farther apart planes are behind the volume than within.
const STRIDE_BEHIND: f64 = 4.0;

/// The shear from plane to plane behind a slab of strength `a`, and the mean irradiance over the middle of the screen, over the
/// truth.
///
/// # Panics
/// If the scene does not render.
pub fn flux(strength: f64, intensity: Intensity, backend: &mut dyn Backend) -> (f64, f64) {
    let layers = (DEPTH / SPACING) as u32;
    let volume = cuboid([64, layers, 64], SPACING as f32, |[x, y, z]| {
        let fade = (std::f64::consts::PI * (y / DEPTH + 0.5)).sin().powi(2);
        1.0 + strength * fade * x * z
    });
    let mut scene = refracting(&volume, 64);
    scene.sweep.intensity = intensity;
    scene.sweep.sample_distance = SAMPLE_DISTANCE;
    scene.wall = Some(Wall { distance: Some(DISTANCE as f32), azimuth: 0.0, color: [1.0; 3] });
    let frame = render(&scene, &volume, backend);
    let light = frame.light.as_ref().expect("all outputs are wanted");
    let (width, height) = (light.width as usize, light.height as usize);
    let pixels = light.color();
    let middle = |n: usize| n * 2 / 5..n * 3 / 5;
    let values = middle(height).flat_map(|y| middle(width).map(move |x| (x, y)));
    let (sum, count) =
        values.fold((0.0, 0.0), |(sum, count), (x, y)| (sum + f64::from(pixels[y * width + x][0]), count + 1.0));
    let focus = 1.0 / (strength * 0.5 * DEPTH);
    let truth = 1.0 / (1.0 - (DISTANCE / focus).powi(2));
    (STRIDE_BEHIND * f64::from(SAMPLE_DISTANCE) * SPACING / focus, sum / count / truth)
}
