//! A volume whose voxels stay in their file, where it is looked at as others are.

use crate::error::{Error, Place, Report};
use crate::volume::Volume;

impl Volume {
    /// The number of the grid's voxels, wherever they are.
    #[must_use]
    pub fn grid_count(&self) -> u64 {
        self.dimensions.into_iter().map(u64::from).product()
    }

    /// The physical value at a voxel that is read from the file; NaN where that fails.
    pub(crate) fn paged_value(&self, at: [u32; 3]) -> f32 {
        let at = [0, 1, 2].map(|axis| at[axis].min(self.dimensions[axis].saturating_sub(1)));
        let read = self.paged.as_ref().and_then(|paged| paged.read(at, [1; 3]));
        let stored = read.and_then(|voxels| voxels.stored(0));
        stored.map_or(f32::NAN, |stored| stored * self.value_scale + self.value_offset)
    }

    /// The volume as it is, or where its voxels stay in a file, its overview: every few voxels along each axis, all in memory, on a grid of
    /// its own with the same first voxel.
    #[must_use]
    pub fn overview(&self) -> Self {
        let Some(paged) = &self.paged else { return self.clone() };
        let stride = paged.stride;
        Self {
            dimensions: self.dimensions.map(|n| n.div_ceil(stride)),
            spacing: self.spacing.map(|spacing| spacing * stride as f32),
            paged: None,
            ..self.clone()
        }
    }

    /// Fails where the voxels stay in a file: `what` needs all of them in memory.
    ///
    /// # Errors
    ///
    /// [`Error::Unsupported`] of a paged volume.
    pub fn require_whole(&self, what: &str) -> Result<(), Error> {
        if self.paged.is_none() {
            return Ok(());
        }
        Err(Report::new(&self.name).unsupported(
            Place::File,
            format!("{what} needs all voxels in memory, and they stay in the file"),
            "leave that out, allow more memory, or crop or downsample the data first",
        ))
    }
}
