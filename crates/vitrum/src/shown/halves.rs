//! Floats as integers of 16 bits, beside which colours are stored.

use crate::error::Error;
use crate::scene::Scene;
use rayon::prelude::*;
use vitrum_io::{Shared, Volume, Voxels, require_memory};

/// The values that a scene tells apart, of a volume with this range and this one without outliers: the common ones, and those that its transfer functions and
/// isosurfaces name.
pub(super) fn told_apart(scene: &Scene, [least, most]: [f32; 2], common: [f32; 2]) -> [f32; 2] {
    let transfer = &scene.transfer;
    let colors = transfer.color.iter().chain(&transfer.filter).map(|point| point.value);
    let opacities = transfer.opacity.iter().map(|point| point.value);
    let iors = transfer.ior.iter().map(|point| point.value);
    let surfaces = scene.isosurface.iter().map(|surface| surface.value);
    let named = colors.chain(opacities).chain(iors).chain(surfaces);
    let [low, high] = named.fold(common, |[low, high], value| [low.min(value), high.max(value)]);
    [low.max(least), high.min(most)]
}

/// The volume with values of 16 bits, `low` to `high`; others take the nearer end.
///
/// # Errors
/// Where the memory does not suffice.
pub(super) fn in_halves(volume: &Volume, [low, high]: [f32; 2]) -> Result<Volume, Error> {
    let Voxels::F32(values) = &volume.voxels else { return Ok(volume.clone()) };
    require_memory(&format!("{}, in 16 bits", volume.name), values.len() as u64 * 2)?;
    let Volume { value_scale, value_offset, .. } = *volume;
    let step = if low < high { (high - low) / f32::from(u16::MAX) } else { 1.0 };
    let mut halves: Vec<u16> = Vec::with_capacity(Shared::<u16>::room(values.len()));
    halves.resize(values.len(), 0);
    halves.par_iter_mut().zip(&**values).for_each(|(half, &stored)| {
        *half = ((stored * value_scale + value_offset - low) / step).round() as u16;
    });
    Ok(Volume { voxels: Voxels::from(halves), value_scale: step, value_offset: low, ..volume.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::OpacityPoint;

    #[test]
    fn values_stay_within_a_step_and_outliers_take_an_end() {
        let values: Vec<f32> = (0..8000).map(|index| if index == 9 { 1e9 } else { index as f32 * 0.5 }).collect();
        let volume = Volume::new("floats", [20; 3], [1.0; 3], Voxels::from(values.clone())).expect("a volume");
        let mut scene = Scene::default();
        scene.transfer.opacity = vec![OpacityPoint { value: 5000.0, opacity: 1.0 }];
        let ends = told_apart(&scene, volume.range, volume.common_range());
        assert_eq!(ends[1], 5000.0);
        let made = in_halves(&volume, ends).expect("there is memory");
        for (index, &value) in values.iter().enumerate() {
            let found = made.voxels.stored(index).expect("a voxel") * made.value_scale + made.value_offset;
            assert!((found - value.min(5000.0)).abs() < 0.05, "{value} became {found}");
        }
    }
}
