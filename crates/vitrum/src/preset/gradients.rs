//! Magnitudes of a volume's gradient.

use glam::Vec3;
use rayon::prelude::*;
use vitrum_io::Volume;

/// Magnitudes of a volume's gradient, as [`GradientPoint`](crate::scene::GradientPoint) takes them.
#[derive(Debug)]
pub struct GradientMagnitudes<'a> {
    volume: &'a Volume,
    /// The mean edge of a voxel over the distance of two voxels along each axis.
    per_step: Vec3,
}

impl<'a> GradientMagnitudes<'a> {
    /// The magnitudes of a volume.
    #[must_use]
    pub fn new(volume: &'a Volume) -> Self {
        let spacing = Vec3::from(volume.spacing);
        let mean = (spacing.x + spacing.y + spacing.z) / 3.0;
        Self { volume, per_step: Vec3::splat(mean) / spacing }
    }

    /// The value of a voxel by its indices, which are inside the grid.
    #[must_use]
    pub fn value(&self, [x, y, z]: [usize; 3]) -> f32 {
        let [width, height, _] = self.volume.dimensions.map(|size| size as usize);
        let stored = self.volume.voxels.stored((z * height + y) * width + x).unwrap_or_default();
        stored * self.volume.value_scale + self.volume.value_offset
    }

    /// The magnitude at a voxel: the change of the value over the mean edge of a voxel, by central differences; at the border one-sided ones. The indices are inside the grid.
    #[must_use]
    pub fn at(&self, at: [usize; 3]) -> f32 {
        let along = |axis: usize| {
            let last = self.volume.dimensions[axis] as usize - 1;
            let (mut before, mut behind) = (at, at);
            before[axis] = at[axis].saturating_sub(1);
            behind[axis] = (at[axis] + 1).min(last);
            let steps = behind[axis] - before[axis];
            if steps == 0 { 0.0 } else { (self.value(behind) - self.value(before)) / steps as f32 }
        };
        (Vec3::new(along(0), along(1), along(2)) * self.per_step).length()
    }
}

/// The gradient magnitudes below which these shares of a volume's voxels are. Of large volumes a million voxels are looked at, evenly spread.
#[must_use]
pub fn gradient_percentiles<const N: usize>(volume: &Volume, shares: [f64; N]) -> [f32; N] {
    const MOST: usize = 1 << 20;
    let overview = volume.paged.is_some().then(|| volume.overview());
    let volume = overview.as_ref().unwrap_or(volume);
    let count = volume.voxel_count();
    let [width, height, _] = volume.dimensions.map(|size| size as usize);
    // An odd step meets voxels of all columns.
    let step = count.div_ceil(MOST) | 1;
    let magnitudes = GradientMagnitudes::new(volume);
    let place = |index: usize| [index % width, index / width % height, index / (width * height)];
    let mut found: Vec<f32> =
        (0..count.div_ceil(step)).into_par_iter().map(|n| magnitudes.at(place(n * step))).collect();
    found.par_sort_unstable_by(f32::total_cmp);
    shares.map(|share| found.get((share * (found.len() - 1) as f64) as usize).copied().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_io::Voxels;

    /// A ramp along x with 3 a voxel, on voxels that are twice as long along y.
    fn ramp() -> Volume {
        let voxels: Vec<f32> = (0..60).map(|index| (index % 5) as f32 * 3.0).collect();
        Volume::new("a ramp", [5, 4, 3], [1.0, 2.0, 1.0], Voxels::from(voxels)).expect("a volume")
    }

    #[test]
    fn magnitudes_are_changes_over_the_mean_edge_of_a_voxel() {
        let ramp = ramp();
        let magnitudes = GradientMagnitudes::new(&ramp);
        for at in [[0, 0, 0], [2, 1, 1], [4, 3, 2]] {
            assert!((magnitudes.at(at) - 4.0).abs() < 1e-5, "{at:?}: {}", magnitudes.at(at));
        }
    }

    #[test]
    fn shares_of_voxels_are_below_their_magnitudes() {
        let voxels: Vec<f32> = (0..1000).map(|index| if index % 10 < 4 { 0.0 } else { 7.0 }).collect();
        let volume = Volume::new("a step", [10; 3], [1.0; 3], Voxels::from(voxels)).expect("a volume");
        assert_eq!(gradient_percentiles(&volume, [0.0, 0.5, 0.75, 0.85, 1.0]), [0.0, 0.0, 0.0, 3.5, 3.5]);
    }
}
