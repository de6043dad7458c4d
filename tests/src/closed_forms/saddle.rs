//! A thin slab η = 1 + a·x·y shears parallel light: the irradiance at Z behind it is 1/(1 − (Z/f)²) everywhere, 1/f = a·t for the
//! thickness t.

use vitrum::backend::Backend;
use vitrum::method::sweep::Sweep;
use vitrum::scene::{Intensity, Transport, Wall};
use vitrum::{Assets, OutputRequest};

use super::{cuboid, refracting};
use crate::Failure;

/// The slab fades in and out over its depth as sin², so that its faces do not bend light: half of it counts.
const DEPTH: f64 = 0.25;
/// The edge of a voxel.
const SPACING: f64 = 1.0 / 64.0;
/// Distance of the planes, in voxels: two in the slab, which is enough for a sine squared.
const SAMPLE_DISTANCE: f32 = 8.0;

/// The shear from plane to plane behind a slab of strength `a`, and the mean irradiance over the middle of the last plane, over the
/// truth there.
///
/// # Errors
/// If the backend fails.
pub fn flux(strength: f64, intensity: Intensity, backend: &mut dyn Backend) -> Result<(f64, f64), Failure> {
    let layers = (DEPTH / SPACING) as u32;
    let volume = cuboid([32, layers, 32], SPACING as f32, |[x, y, z]| {
        let fade = (std::f64::consts::PI * (y / DEPTH + 0.5)).sin().powi(2);
        1.0 + strength * fade * x * z
    });
    let mut scene = refracting(&volume, 64);
    scene.sweep.light = Transport::Texels;
    scene.sweep.intensity = intensity;
    scene.sweep.sample_distance = SAMPLE_DISTANCE;
    scene.wall = Some(Wall { distance: Some(1.0), azimuth: 0.0, color: [1.0; 3] });
    let assets = Assets::from(volume);
    let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend)?;
    sweep.run(backend, &mut |_| true)?;
    let light = sweep.irradiance(backend)?;
    let (planes, [width, height]) = (sweep.planes, sweep.light_grid.size.map(|n| n as usize));
    let middle = |n: usize| n * 2 / 5..n * 3 / 5;
    let texels = middle(height).flat_map(|y| middle(width).map(move |x| y * width + x));
    let (sum, count) = texels.fold((0.0, 0.0), |(sum, count), texel| (sum + f64::from(light[texel]), count + 1.0));
    let [near, far] = planes.volume_depths;
    let distance = planes.depth(planes.count - 1) - 0.5 * (near + far);
    let focus = 1.0 / (strength * 0.5 * DEPTH);
    let truth = 1.0 / (1.0 - (distance / focus).powi(2));
    Ok((planes.step(planes.count - 1) / focus, sum / count / truth))
}
