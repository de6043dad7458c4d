//! A scalar volume in memory, as the kernels take it.

use std::sync::Arc;

use crate::common_range::common_extremes;
use crate::error::{Error, Place, Report};
use crate::orientation::Orientation;
use crate::paged::Paged;
use crate::samples::SampleType;
use crate::shared::Shared;
use crate::source::{Assumptions, Source};
use crate::stored::Stored;
use crate::voxels::Voxels;

/// A scalar field on a regular grid, placed in the world.
#[derive(Debug, Clone, PartialEq)]
pub struct Volume {
    /// Name for messages: the file's path as it was given, or `builtin:NAME`.
    pub name: String,
    /// Voxels along x, y and z, each at least 1.
    pub dimensions: [u32; 3],
    /// The stored voxels.
    pub voxels: Voxels,
    /// All voxels, where they stay in a file: `voxels` are then the few of its overview ([`Self::overview`]).
    pub paged: Option<Arc<Paged>>,
    /// The colour of each voxel in sRGB, x fastest, where a volume has colours: red in the lowest byte of a word, green, blue, and in the highest
    /// byte the factor of its extinction over 255. It is a factor of the colour that a transfer function gives.
    pub colors: Option<Shared<u32>>,
    /// `physical = stored * value_scale + value_offset`.
    pub value_scale: f32,
    /// See [`Self::value_scale`].
    pub value_offset: f32,
    /// Distance between voxel centres along each index axis, in world units, above 0: millimetres
    /// where the file names a unit.
    pub spacing: [f32; 3],
    /// World position of the centre of voxel (0, 0, 0).
    pub origin: [f32; 3],
    /// Unit direction of each index axis in the world: `axes[0]` is the direction of +x.
    pub axes: [[f32; 3]; 3],
    /// Kind of the world in which `origin` and `axes` are given.
    pub orientation: Orientation,
    /// Smallest and largest physical value over the voxels, both finite.
    pub range: [f32; 2],
    /// Origin of the volume.
    pub source: Source,
}

impl Volume {
    /// A volume centred on the world's origin with its axes along the world's, whose physical
    /// values are the stored ones. NaN is nothing: it takes the least finite value, as which presets show nothing; infinities take
    /// the ends of the finite range. Both are told among the assumptions.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where the voxels are not as many as `dimensions` says, or none; where a
    /// spacing is not finite and above 0, or an extent above 1e18; where no voxel is finite.
    pub fn new(
        name: impl Into<String>,
        dimensions: [u32; 3],
        spacing: [f32; 3],
        voxels: Voxels,
    ) -> Result<Self, Error> {
        Self::of_slope(name.into(), dimensions, spacing, voxels, 1.0)
    }

    /// As [`Self::new`], for voxels that get a value mapping of this slope: the least physical value is the greatest stored one where it is
    /// negative.
    pub(crate) fn of_slope(
        name: String,
        dimensions: [u32; 3],
        spacing: [f32; 3],
        voxels: impl Into<Stored>,
        slope: f32,
    ) -> Result<Self, Error> {
        let Stored { voxels, colors, paged } = voxels.into().seen();
        let report = Report::new(&name);
        if paged.is_none() {
            check_count(report, dimensions, &voxels)?;
        }
        check_spacing(report, spacing)?;
        check_extent(report, dimensions, spacing)?;
        let (voxels, mut assumptions) = finite(report, voxels, slope < 0.0)?;
        if paged.is_some() {
            assumptions.push(
                "the voxels stay in the file: presets, histograms and ranges without outliers are told by every few of them".to_owned(),
            );
        }
        // `check_count` refuses an empty volume, so the extremes are always there.
        let extremes = paged.as_ref().map(|paged| paged.extremes);
        let range = extremes.or_else(|| voxels.extremes()).unwrap_or_default();
        let origin = std::array::from_fn(|axis| -0.5 * (dimensions[axis] - 1) as f32 * spacing[axis]);
        Ok(Self {
            dimensions,
            voxels,
            paged,
            colors,
            value_scale: 1.0,
            value_offset: 0.0,
            spacing,
            origin,
            axes: IDENTITY,
            orientation: Orientation::World,
            range,
            source: Source { assumptions, ..Source::default() },
            name,
        })
    }

    /// As [`Self::new`], for voxels of a file's sample type: signed ones are stored shifted, and the offset undoes that. How the
    /// grid lies is left to say.
    pub(crate) fn of_samples(
        name: String,
        dimensions: [u32; 3],
        spacing: [f32; 3],
        voxels: impl Into<Stored>,
        sample: SampleType,
    ) -> Result<Self, Error> {
        let volume = Self::of_slope(name, dimensions, spacing, voxels, 1.0)?;
        let volume = Self { orientation: Orientation::Unknown, ..volume };
        let offset = sample.value_offset();
        if offset == 0.0 { Ok(volume) } else { volume.with_value_mapping(1.0, offset) }
    }

    /// The volume with a colour for each voxel, as [`Self::colors`] has them.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where the colours are not as many as the voxels.
    pub fn with_colors(self, colors: Vec<u32>) -> Result<Self, Error> {
        if colors.len() != self.voxels.len() {
            let problem = format!("{} colours for {} voxels", colors.len(), self.voxels.len());
            return Err(Report::new(&self.name).invalid(Place::File, problem, "give a colour for each voxel"));
        }
        Ok(Self { colors: Some(colors.into()), ..self })
    }

    /// The volume with other physical values, `physical = stored * scale + offset`.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where `scale` is 0, or where either number or a physical value is not
    /// finite.
    pub fn with_value_mapping(mut self, scale: f32, offset: f32) -> Result<Self, Error> {
        let mut range = self.extremes().map(|end| end * scale + offset);
        range.sort_by(f32::total_cmp);
        if scale == 0.0 || !scale.is_finite() || range.iter().any(|end| !end.is_finite()) {
            return Err(Report::new(&self.name).invalid(
                Place::File,
                format!("value scale {scale} and offset {offset} do not give finite, distinct values"),
                "give a finite scale other than 0 and a finite offset",
            ));
        }
        self.value_scale = scale;
        self.value_offset = offset;
        self.range = range;
        Ok(self)
    }

    /// The volume with other distances between voxels; the middle of the grid stays where it is.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where a distance is not finite and above 0, or an extent above 1e18.
    pub fn with_spacing(mut self, spacing: [f32; 3]) -> Result<Self, Error> {
        let report = Report::new(&self.name);
        check_spacing(report, spacing)?;
        check_extent(report, self.dimensions, spacing)?;
        for (axis, direction) in self.axes.iter().enumerate() {
            let growth = 0.5 * (self.dimensions[axis] - 1) as f32 * (spacing[axis] - self.spacing[axis]);
            self.origin.iter_mut().zip(direction).for_each(|(origin, component)| *origin -= growth * component);
        }
        if self.spacing != spacing {
            let [x, y, z] = self.spacing;
            self.source.assumptions.replace_origin("spacing", "what was asked for");
            self.source.assumptions.push(format!("the spacing was given, in place of {x} x {y} x {z}"));
        }
        self.spacing = spacing;
        Ok(self)
    }

    /// The volume with the origin that its reader found; what was told of the volume before stays told.
    pub(crate) fn with_source(mut self, source: Source) -> Self {
        let told = std::mem::replace(&mut self.source, source).assumptions;
        self.source.assumptions.extend(told);
        self
    }

    /// The least and the greatest stored value.
    fn extremes(&self) -> [f32; 2] {
        let of_all = self.paged.as_ref().map(|paged| paged.extremes);
        of_all.or_else(|| self.voxels.extremes()).unwrap_or_default()
    }

    /// Number of voxels in memory.
    #[must_use]
    pub fn voxel_count(&self) -> usize {
        self.voxels.len()
    }

    /// Bytes of memory that the voxels take, and their colours.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.voxels.bytes() + self.colors.as_ref().map_or(0, |colors| size_of_val(&**colors))
    }

    /// Size of the grid in the world along each index axis, `dimensions * spacing`: from the outer face of the first voxel to the outer
    /// face of the last.
    #[must_use]
    pub fn extent(&self) -> [f32; 3] {
        std::array::from_fn(|axis| self.dimensions[axis] as f32 * self.spacing[axis])
    }

    /// The physical value at a voxel; an index beyond the grid takes the last voxel of its axis.
    ///
    /// NaN only where the public fields were made to contradict each other.
    #[must_use]
    pub fn value(&self, x: u32, y: u32, z: u32) -> f32 {
        if self.paged.is_some() {
            return self.paged_value([x, y, z]);
        }
        let [width, height, depth] = self.dimensions;
        let inside = |index: u32, size: u32| index.min(size.saturating_sub(1)) as usize;
        let slice = width as usize * height as usize;
        let index = inside(x, width) + inside(y, height) * width as usize + inside(z, depth) * slice;
        self.voxels.stored(index).map_or(f32::NAN, |stored| stored * self.value_scale + self.value_offset)
    }

    /// The smallest edge of a voxel, in the volume's unit of length.
    #[must_use]
    pub fn finest_spacing(&self) -> f32 {
        self.spacing.into_iter().fold(f32::INFINITY, f32::min)
    }

    /// [`Self::range`] without outliers: up to a thousandth of the voxels at either end is left out, where it is farther away from the other
    /// voxels' values than four times their range. Where nearly all voxels are equal, none is an outlier.
    #[must_use]
    pub fn common_range(&self) -> [f32; 2] {
        let extremes = self.extremes();
        let common = common_extremes(&self.voxels, extremes);
        if common == extremes {
            return self.range;
        }
        let mut range = common.map(|end| end * self.value_scale + self.value_offset);
        range.sort_by(f32::total_cmp);
        range
    }

    /// A histogram: the number of voxels in each of `bins` equal parts of [`Self::range`].
    ///
    /// The largest value counts to the last part. Where all voxels are equal, all count to the
    /// first.
    #[must_use]
    pub fn histogram(&self, bins: usize) -> Vec<u64> {
        self.histogram_over(self.range, bins)
    }

    /// As [`Self::histogram`], over `range`: values below count to the first part, values above to the last.
    #[must_use]
    pub fn histogram_over(&self, range: [f32; 2], bins: usize) -> Vec<u64> {
        let mut counts = vec![0; bins];
        if bins == 0 {
            return counts;
        }
        let [low, high] = range.map(f64::from);
        let per_unit = if high > low { bins as f64 / (high - low) } else { 0.0 };
        let (scale, offset) = (f64::from(self.value_scale), f64::from(self.value_offset));
        // The cast saturates, so that rounding below the range still counts to the first part.
        let bin = |stored: f64| (((stored * scale + offset - low) * per_unit) as usize).min(bins - 1);
        match &self.voxels {
            Voxels::U8(voxels) => {
                voxels.iter().for_each(|&voxel| counts[bin(f64::from(voxel))] += 1);
            }
            Voxels::U16(voxels) => {
                voxels.iter().for_each(|&voxel| counts[bin(f64::from(voxel))] += 1);
            }
            Voxels::F32(voxels) => {
                voxels.iter().for_each(|&voxel| counts[bin(f64::from(voxel))] += 1);
            }
        }
        counts
    }
}

pub(crate) const IDENTITY: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn check_count(report: Report, dimensions: [u32; 3], voxels: &Voxels) -> Result<(), Error> {
    let expected: u128 = dimensions.into_iter().map(u128::from).product();
    if expected == 0 || expected != voxels.len() as u128 {
        let [x, y, z] = dimensions;
        return Err(report.invalid(
            Place::File,
            format!("{x} x {y} x {z} voxels are {expected}, and {} were given", voxels.len()),
            "give at least one voxel, and as many as the dimensions say",
        ));
    }
    Ok(())
}

pub(crate) fn check_spacing(report: Report, spacing: [f32; 3]) -> Result<(), Error> {
    for (axis, value) in ["x", "y", "z"].into_iter().zip(spacing) {
        if !(value.is_finite() && value > 0.0) {
            return Err(report.invalid(
                Place::File,
                format!("the spacing along {axis} is {value}, not a finite number above 0"),
                "correct the spacing",
            ));
        }
    }
    Ok(())
}

/// Far below the end of float32, so that no sum or square root of positions overflows.
pub(crate) fn check_extent(report: Report, dimensions: [u32; 3], spacing: [f32; 3]) -> Result<(), Error> {
    const LARGEST: f32 = 1e18;
    let extents = dimensions.iter().zip(spacing).map(|(&size, spacing)| size as f32 * spacing);
    let largest = extents.fold(0.0, f32::max);
    if largest > LARGEST {
        return Err(report.invalid(
            Place::File,
            format!("the volume is {largest:e} long, and {LARGEST:e} is the most"),
            "correct the spacing or its unit",
        ));
    }
    Ok(())
}

/// The voxels with finite values alone, and what was told of others. Fails where none is finite. With `falling` the greatest is the least.
fn finite(report: Report, mut voxels: Voxels, falling: bool) -> Result<(Voxels, Assumptions), Error> {
    let mut assumptions = Assumptions::default();
    let Voxels::F32(floats) = &mut voxels else { return Ok((voxels, assumptions)) };
    if floats.iter().all(|voxel| voxel.is_finite()) {
        return Ok((voxels, assumptions));
    }
    let ends = [f32::INFINITY, f32::NEG_INFINITY];
    let is_finite = floats.iter().filter(|voxel| voxel.is_finite());
    let [low, high] = is_finite.fold(ends, |[low, high], &voxel| [low.min(voxel), high.max(voxel)]);
    let count = floats.len();
    if low > high {
        return Err(report.invalid(
            Place::File,
            format!("all of the {count} voxels are NaN, infinite or beyond float32"),
            "write finite values where something was measured",
        ));
    }
    let (mut nothing, mut infinite) = (0_u64, 0_u64);
    for voxel in floats.make_mut().iter_mut().filter(|voxel| !voxel.is_finite()) {
        let counter = if voxel.is_nan() { &mut nothing } else { &mut infinite };
        *counter += 1;
        *voxel = match () {
            () if *voxel == f32::INFINITY => high,
            () if *voxel == f32::NEG_INFINITY => low,
            () if falling => high,
            () => low,
        };
    }
    if nothing > 0 {
        let fact = format!("{nothing} of {count} voxels are NaN, which is nothing: they were given the least value");
        assumptions.push(fact);
    }
    if infinite > 0 {
        assumptions.push(format!(
            "{infinite} of {count} voxels are infinite or beyond float32: they were given the ends of the finite range"
        ));
    }
    Ok((voxels, assumptions))
}
