//! Changes to a volume before it is written or shown: parts of it, other grids, smoother values, masks.
//!
//! Every change keeps each voxel at its place in the world.

use std::ops::Range;

use crate::error::{Error, Place, Report};
use crate::filter::{Taps, filtered};
use crate::memory;
use crate::shared::Shared;
use crate::volume::{Volume, check_spacing};
use crate::voxels::Voxels;

impl Volume {
    /// The voxels whose indices are in these ranges, whose ends are not included.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where a range is empty or goes beyond the volume, [`Error::TooLarge`] where the memory does not suffice.
    pub fn cropped(self, ranges: &[Range<u32>; 3]) -> Result<Self, Error> {
        self.require_whole("a change of voxels")?;
        let report = Report::new(&self.name);
        for (axis, range) in ranges.iter().enumerate() {
            let size = self.dimensions[axis];
            if range.start >= range.end || range.end > size {
                let (name, Range { start, end }) = (["x", "y", "z"][axis], range);
                let problem =
                    format!("voxels {start} to {end} along {name} are no part of the volume, which has {size}");
                return Err(report.invalid(Place::File, problem, format!("choose a part of 0 to {size}")));
            }
        }
        let dimensions = [0, 1, 2].map(|axis| ranges[axis].end - ranges[axis].start);
        memory::check(report, count(dimensions) * (self.bytes() as u64 / count(self.dimensions).max(1)), None)?;
        let voxels = match &self.voxels {
            Voxels::U8(voxels) => Voxels::U8(part(voxels, self.dimensions, ranges)),
            Voxels::U16(voxels) => Voxels::U16(part(voxels, self.dimensions, ranges)),
            Voxels::F32(voxels) => Voxels::F32(part(voxels, self.dimensions, ranges)),
        };
        let colors = self.colors.as_ref().map(|colors| part(colors, self.dimensions, ranges));
        let first = [0, 1, 2].map(|axis| f64::from(ranges[axis].start));
        let spacing = self.spacing;
        let (scale, offset) = (self.value_scale, self.value_offset);
        let volume = self.with(dimensions, spacing, first, voxels)?;
        Self { colors, ..volume }.with_value_mapping(scale, offset)
    }

    /// The volume on a grid of so many voxels at these distances, around the same middle: linear in between, and averaged over the new
    /// voxels where these are larger. Beyond the outer voxels' centres their values go on.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where a distance is not finite and above 0 or a number of voxels is 0, [`Error::TooLarge`] where the memory
    /// does not suffice.
    pub fn resampled(self, dimensions: [u32; 3], spacing: [f32; 3]) -> Result<Self, Error> {
        self.on_grid(dimensions, spacing, Taps::linear)
    }

    /// As [`Self::resampled`], with the value of the nearest voxel, for labels, between which there is nothing.
    ///
    /// # Errors
    ///
    /// Those of [`Self::resampled`].
    pub fn resampled_nearest(self, dimensions: [u32; 3], spacing: [f32; 3]) -> Result<Self, Error> {
        self.on_grid(dimensions, spacing, Taps::nearest)
    }

    fn on_grid(
        self,
        dimensions: [u32; 3],
        spacing: [f32; 3],
        taps: fn(from: usize, to: usize, step: f64) -> Taps,
    ) -> Result<Self, Error> {
        self.require_whole("a change of voxels")?;
        let report = Report::new(&self.name);
        check_spacing(report, spacing)?;
        memory::check(report, 8 * (count(dimensions) + count(self.dimensions)), None)?;
        let step = [0, 1, 2].map(|axis| f64::from(spacing[axis]) / f64::from(self.spacing[axis]));
        let taps = [0, 1, 2].map(|axis| taps(self.dimensions[axis] as usize, dimensions[axis] as usize, step[axis]));
        let values = filtered(self.values(), self.dimensions.map(|size| size as usize), &taps);
        // The index, in the old grid, of the first of the new voxels.
        let middle = |size: u32| 0.5 * (f64::from(size) - 1.0);
        let first = [0, 1, 2].map(|axis| middle(self.dimensions[axis]) - middle(dimensions[axis]) * step[axis]);
        self.with(dimensions, spacing, first, values.into())
    }

    /// The volume blurred by a Gaussian of this standard deviation, in voxels along each axis.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where `sigma` is not above 0 or above 1000, [`Error::TooLarge`] where the memory does not suffice.
    pub fn blurred(self, sigma: f32) -> Result<Self, Error> {
        self.require_whole("a change of voxels")?;
        const WIDEST: f32 = 1000.0;
        let report = Report::new(&self.name);
        if !(sigma > 0.0 && sigma <= WIDEST) {
            let problem = format!("a blur of {sigma} voxels is none");
            return Err(report.invalid(Place::File, problem, format!("choose one above 0, to {WIDEST}")));
        }
        memory::check(report, 16 * count(self.dimensions), None)?;
        let sizes = self.dimensions.map(|size| size as usize);
        let values = filtered(self.values(), sizes, &sizes.map(|size| Taps::gaussian(size, f64::from(sigma))));
        let (dimensions, spacing) = (self.dimensions, self.spacing);
        self.with(dimensions, spacing, [0.0; 3], values.into())
    }

    /// A mask: 1 where the value is in the range, ends included, and 0 elsewhere.
    ///
    /// # Errors
    ///
    /// [`Error::TooLarge`] where the memory does not suffice.
    pub fn thresholded(self, low: f32, high: f32) -> Result<Self, Error> {
        self.require_whole("a change of voxels")?;
        memory::check(Report::new(&self.name), count(self.dimensions), None)?;
        let mask: Vec<u8> = self.iter().map(|value| u8::from(value >= low && value <= high)).collect();
        let (dimensions, spacing) = (self.dimensions, self.spacing);
        self.with(dimensions, spacing, [0.0; 3], mask.into())
    }

    /// The volume with 0 in place of all values but these, such as labels of a segmentation.
    ///
    /// # Errors
    ///
    /// [`Error::TooLarge`] where the memory does not suffice.
    pub fn picked(self, labels: &[f32]) -> Result<Self, Error> {
        self.require_whole("a change of voxels")?;
        memory::check(Report::new(&self.name), 4 * count(self.dimensions), None)?;
        let pick = |value: f32| if labels.contains(&value) { value } else { 0.0 };
        let narrow = |limit: f32| labels.iter().all(|&label| (0.0..=limit).contains(&label) && label.fract() == 0.0);
        let picked = self.iter().map(pick);
        let voxels: Voxels = if narrow(f32::from(u8::MAX)) {
            picked.map(|value| value as u8).collect::<Vec<_>>().into()
        } else if narrow(f32::from(u16::MAX)) {
            picked.map(|value| value as u16).collect::<Vec<_>>().into()
        } else {
            picked.collect::<Vec<f32>>().into()
        };
        let (dimensions, spacing) = (self.dimensions, self.spacing);
        self.with(dimensions, spacing, [0.0; 3], voxels)
    }

    /// The physical values, x fastest.
    fn iter(&self) -> impl Iterator<Item = f32> {
        let (scale, offset) = (self.value_scale, self.value_offset);
        (0..self.voxels.len()).map(move |index| self.voxels.stored(index).unwrap_or_default() * scale + offset)
    }

    fn values(&self) -> Vec<f32> {
        self.iter().collect()
    }

    /// A volume of other voxels in the same world, whose first one lies at `first`, in indices of this volume.
    fn with(self, dimensions: [u32; 3], spacing: [f32; 3], first: [f64; 3], voxels: Voxels) -> Result<Self, Error> {
        let mut volume = Self::new(self.name, dimensions, spacing, voxels)?;
        let along = [0, 1, 2].map(|axis| first[axis] * f64::from(self.spacing[axis]));
        volume.origin = [0, 1, 2].map(|row| {
            let shift: f64 = (0..3).map(|axis| along[axis] * f64::from(self.axes[axis][row])).sum();
            (f64::from(self.origin[row]) + shift) as f32
        });
        (volume.axes, volume.orientation, volume.source) = (self.axes, self.orientation, self.source);
        Ok(volume)
    }
}

fn count(dimensions: [u32; 3]) -> u64 {
    dimensions.into_iter().map(u64::from).product()
}

/// The voxels in the ranges.
fn part<T: Copy + bytemuck::Pod>(voxels: &[T], [width, height, _]: [u32; 3], ranges: &[Range<u32>; 3]) -> Shared<T> {
    let [x, y, z] = ranges.clone().map(|range| range.start as usize..range.end as usize);
    let (width, height) = (width as usize, height as usize);
    let rows = z.flat_map(|z| y.clone().map(move |y| (z * height + y) * width));
    rows.flat_map(|row| voxels[row + x.start..row + x.end].iter().copied()).collect()
}
