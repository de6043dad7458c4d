//! Sampling a field of positions onto a regular grid.

use bytemuck::Pod;
use glam::Vec3;
use rayon::prelude::*;
use vitrum_io::{Error, Place, Shared, Volume, Voxels, require_memory};

/// Voxels along the longest edge that a procedural volume may have.
pub(super) const RESOLUTIONS: std::ops::RangeInclusive<u32> = 16..=2048;

/// A regular grid of cubic voxels, centred on the world's origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Grid {
    dimensions: [u32; 3],
    spacing: f32,
}

impl Grid {
    /// The grid of `resolution` voxels along the longest edge that covers `extent` world units.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where `resolution` is not among [`RESOLUTIONS`].
    pub fn covering(name: &str, extent: Vec3, resolution: u32) -> Result<Self, Error> {
        if !RESOLUTIONS.contains(&resolution) {
            return Err(Error::Invalid {
                file: format!("builtin:{name}"),
                place: Place::File,
                problem: format!("a resolution of {resolution} voxels was asked for"),
                advice: format!(
                    "ask for {} to {} voxels along the longest edge",
                    RESOLUTIONS.start(),
                    RESOLUTIONS.end()
                ),
            });
        }
        let spacing = extent.max_element() / resolution as f32;
        let dimensions = (extent / spacing).round().max(Vec3::ONE);
        Ok(Self { dimensions: dimensions.to_array().map(|size| size as u32), spacing })
    }

    /// The grid with the same number of voxels, whose edges are `spacing` world units long.
    pub fn with_spacing(self, spacing: f32) -> Self {
        Self { spacing, ..self }
    }

    /// Edge of a voxel in world units.
    pub fn spacing(&self) -> f32 {
        self.spacing
    }

    /// Number of voxels along each axis.
    pub fn dimensions(&self) -> [u32; 3] {
        self.dimensions
    }

    /// World position of a voxel's centre.
    pub fn position(&self, index: [u32; 3]) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|axis| {
            (index[axis] as f32 - 0.5 * (self.dimensions[axis] - 1) as f32) * self.spacing
        }))
    }

    /// Computes one number a voxel, in parallel; `value` is given the voxel's centre.
    ///
    /// # Errors
    ///
    /// [`Error::TooLarge`] where they would not fit the memory.
    pub fn sample<T: Pod + Default + Send>(&self, value: impl Fn(Vec3) -> T + Sync) -> Result<Vec<T>, Error> {
        self.sample_indices(|index| value(self.position(index)))
    }

    /// Like [`Self::sample`], but `value` is given the voxel's index.
    pub fn sample_indices<T: Pod + Default + Send>(
        &self,
        value: impl Fn([u32; 3]) -> T + Sync,
    ) -> Result<Vec<T>, Error> {
        self.sample_rows(|y, z, row| {
            for (x, voxel) in row.iter_mut().enumerate() {
                *voxel = value([x as u32, y, z]);
            }
        })
    }

    /// Like [`Self::sample_indices`] for a field that is symmetric in x: `value` is asked for x ≥ 0 only.
    pub fn sample_symmetric<T: Pod + Default + Send>(
        &self,
        value: impl Fn([u32; 3]) -> T + Sync,
    ) -> Result<Vec<T>, Error> {
        self.sample_rows(|y, z, row| {
            for x in row.len() / 2..row.len() {
                row[x] = value([x as u32, y, z]);
                row[row.len() - 1 - x] = row[x];
            }
        })
    }

    /// Fills the rows of voxels along x, given their y and z index, in parallel.
    fn sample_rows<T: Pod + Default + Send>(&self, fill: impl Fn(u32, u32, &mut [T]) + Sync) -> Result<Vec<T>, Error> {
        let [width, height, depth] = self.dimensions.map(|size| size as usize);
        let count = width * height * depth;
        require_memory("a built-in volume", (count * size_of::<T>()) as u64)?;
        // With room behind them they need not be moved to be shared.
        let mut voxels = vec![T::default(); Shared::<T>::room(count)];
        voxels.truncate(count);
        voxels
            .par_chunks_mut(width)
            .enumerate()
            .for_each(|(row, voxels)| fill((row % height) as u32, (row / height) as u32, voxels));
        Ok(voxels)
    }

    /// A volume on this grid that stores a field of values from 0 to 1 in 16 bits.
    pub fn unit_volume(&self, name: &str, value: impl Fn(Vec3) -> f32 + Sync) -> Result<Volume, Error> {
        self.volume_of(name, self.sample(|position| quantize_unit(value(position)))?)
    }

    /// A volume of the voxels that [`quantize_unit`] made.
    pub fn volume_of(&self, name: &str, voxels: Vec<u16>) -> Result<Volume, Error> {
        self.volume(name, Voxels::from(voxels))?.with_value_mapping(1.0 / UNIT, 0.0)
    }

    /// A volume on this grid that stores `voxels` as they are.
    pub fn volume(&self, name: &str, voxels: Voxels) -> Result<Volume, Error> {
        Volume::new(format!("builtin:{name}"), self.dimensions, [self.spacing; 3], voxels)
    }
}

/// The stored number that stands for 1.
const UNIT: f32 = u16::MAX as f32;

/// The stored number for a value from 0 to 1; values beyond are clamped.
pub(super) fn quantize_unit(value: f32) -> u16 {
    (value.clamp(0.0, 1.0) * UNIT + 0.5) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn longest_edge_has_the_resolution() {
        let grid = Grid::covering("test", Vec3::new(1.0, 0.5, 2.0), 64).unwrap();
        assert_eq!(grid.dimensions(), [32, 16, 64]);
        assert_eq!(grid.spacing(), 1.0 / 32.0);
    }

    #[test]
    fn positions_are_those_of_the_volume() {
        let grid = Grid::covering("test", Vec3::new(1.0, 0.5, 2.0), 16).unwrap();
        let volume = grid.unit_volume("test", |_| 0.0).unwrap();
        assert_eq!(grid.position([0; 3]).to_array(), volume.origin);
        assert_eq!(grid.position([0; 3]), -grid.position([7, 3, 15]));
    }

    #[test]
    fn unit_values_reach_both_ends() {
        let grid = Grid::covering("test", Vec3::ONE, 16).unwrap();
        let volume = grid.unit_volume("test", |position| 0.5 + 4.0 * position.x).unwrap();
        assert_eq!(volume.range, [0.0, 1.0]);
    }

    #[test]
    fn other_resolutions_are_refused_by_name() {
        for resolution in [0, 15, 2049] {
            let error = Grid::covering("ball", Vec3::ONE, resolution).unwrap_err().to_string();
            assert!(error.contains("builtin:ball") && error.contains("16 to 2048"), "{error}");
        }
    }
}
