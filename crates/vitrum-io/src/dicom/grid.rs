//! The slices of a series as a grid: their order, their distance, and where they lie in the world.

use bytemuck::Pod;
use glam::DVec3;

use super::distances::{check_distances, check_line, uneven};
use super::image::{Slice, normal};
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::placement::{Placement, unoriented};
use crate::setting::Setting;
use crate::shared::Shared;
use crate::source::{Assumption, Assumptions};
use crate::voxels::Voxels;

/// A grid of slices in the world.
pub(super) struct Grid {
    pub placement: Placement,
    /// The indices of the slices, from the lowest.
    order: Vec<usize>,
    /// For each slice of the even grid, its position among the slices of the files; empty where those are evenly spaced already.
    uneven: Vec<f64>,
}

impl Grid {
    pub fn new(
        report: Report,
        slices: &[Slice],
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Self, Error> {
        let first = &slices[0];
        if slices.iter().any(|slice| slice.file.inverted) {
            assumptions.push("the smallest value is meant to be white: values were kept as they are".to_owned());
        }
        let spacing = first.file.spacing.unwrap_or_else(|| {
            if options.spacing.is_none() {
                let fact = "the files say no distance of pixels: 1 was taken";
                assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
            }
            [1.0; 2]
        });
        if slices.iter().any(|slice| slice.file.palette) {
            let fact = "values are indices of a palette of colours: they were kept as numbers, without their colours";
            assumptions.push(fact.to_owned());
        }
        // Written with a few digits, equal distances differ in the last.
        let differs = |slice: &&Slice| {
            let other = slice.file.spacing.unwrap_or([1.0; 2]);
            other.iter().zip(&spacing).any(|(a, b)| (a - b).abs() > 1e-3 * b)
        };
        if let Some(other) = slices.iter().find(differs).filter(|_| options.spacing.is_none()) {
            return Err(Report::new(&other.file.name).invalid(
                Place::File,
                format!("the pixels lie at other distances than those of {}", first.file.short_name()),
                "put only the slices of one volume into the series",
            ));
        }
        let along_z = |assumptions: &mut Assumptions| {
            first.file.step.unwrap_or_else(|| {
                if options.spacing.is_none() {
                    let fact = "the files say no distance of slices: 1 was taken";
                    assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
                }
                1.0
            })
        };
        let placed = slices.iter().all(|slice| slice.position.is_some() && slice.orientation.is_some());
        if !placed {
            return Self::unplaced(slices, spacing, along_z(assumptions), assumptions);
        }
        let orientation = orientation(slices)?;
        let (order, positions, heights) = sorted(slices, normal(orientation));
        check_distances(slices, &order, &heights)?;
        check_line(slices, &order, &positions, &heights, spacing)?;
        let steps = (order.len() - 1).max(1) as f64;
        let [start, end] = [positions[0], positions[positions.len() - 1]];
        let step = if order.len() > 1 {
            [0, 1, 2].map(|axis| (end[axis] - start[axis]) / steps)
        } else {
            let distance = along_z(assumptions);
            normal(orientation).map(|component| component * distance)
        };
        let [a, b, c, d, e, f] = orientation;
        let columns = [[a, b, c].map(|value| value * spacing[1]), [d, e, f].map(|value| value * spacing[0]), step];
        // The files' world points to the patient's left, posterior, superior; ours to the right, anterior, superior.
        let to_world = |[x, y, z]: [f64; 3]| [-x, -y, z];
        let placement = Placement::from_columns(columns.map(to_world), Some(to_world(start)), Orientation::Patient)
            .map_err(|problem| report.invalid(Place::File, problem, "correct the positions and orientations"))?;
        let uneven = uneven(&heights, assumptions);
        Ok(Self { placement, order, uneven })
    }

    /// Frames of one file without a place: in their order.
    fn unplaced(slices: &[Slice], spacing: [f64; 2], step: f64, assumptions: &mut Assumptions) -> Result<Self, Error> {
        if let Some(other) = slices.iter().find(|slice| slice.index[0] > 0) {
            let lost = slices.iter().find(|slice| slice.position.is_none() || slice.orientation.is_none());
            return Err(Report::new(&lost.unwrap_or(other).file.name).unsupported(
                Place::File,
                "the slice says no Image Position or no Image Orientation (Patient), so its place is not known",
                "leave out such files, or convert the series by a program that knows it",
            ));
        }
        if slices.len() > 1 {
            assumptions.push("the frames say no place: they were taken for slices in their order".to_owned());
        }
        assumptions.push(unoriented());
        let columns = [[spacing[1], 0.0, 0.0], [0.0, spacing[0], 0.0], [0.0, 0.0, step]];
        let placement = Placement::from_columns(columns, None, Orientation::Unknown).map_err(|problem| {
            Report::new(&slices[0].file.name).invalid(Place::File, problem, "correct the distances of pixels")
        })?;
        Ok(Self { placement, order: (0..slices.len()).collect(), uneven: Vec::new() })
    }

    /// The slices from the lowest on.
    pub fn order<'a>(&self, slices: &[Slice<'a>]) -> Vec<Slice<'a>> {
        self.order.iter().map(|&index| slices[index].clone()).collect()
    }

    pub fn uneven(&self) -> bool {
        !self.uneven.is_empty()
    }

    /// Slices at even distances, each between two of the file's.
    pub fn resample(&self, report: Report, voxels: Voxels, dimensions: [u32; 3]) -> Result<Voxels, Error> {
        if !self.uneven() {
            return Ok(voxels);
        }
        let slice = dimensions[0] as usize * dimensions[1] as usize;
        Ok(match voxels {
            Voxels::U8(voxels) => Voxels::from(self.mix(report, &voxels, slice, |value| value.round() as u8)?),
            Voxels::U16(voxels) => Voxels::from(self.mix(report, &voxels, slice, |value| value.round() as u16)?),
            Voxels::F32(voxels) => Voxels::from(self.mix(report, &voxels, slice, |value| value)?),
        })
    }

    fn mix<T: Pod + Into<f32>>(
        &self,
        report: Report,
        voxels: &[T],
        slice: usize,
        store: impl Fn(f32) -> T,
    ) -> Result<Vec<T>, Error> {
        let mut mixed = memory::reserve(report, Shared::<T>::room(voxels.len()))?;
        for place in &self.uneven {
            let below = (*place as usize).min(self.uneven.len().saturating_sub(2));
            let share = (place - below as f64) as f32;
            let [low, high] = [below, below + 1].map(|index| &voxels[index * slice..(index + 1) * slice]);
            let value = |(&low, &high): (&T, &T)| {
                let (low, high): (f32, f32) = (low.into(), high.into());
                store(low + share * (high - low))
            };
            mixed.extend(low.iter().zip(high).map(value));
        }
        Ok(mixed)
    }
}

/// The orientation of all slices, checked to be two directions at right angles.
fn orientation(slices: &[Slice]) -> Result<[f64; 6], Error> {
    let first = &slices[0];
    let six = first.orientation.unwrap_or_default();
    let [row, column] = [DVec3::new(six[0], six[1], six[2]), DVec3::new(six[3], six[4], six[5])];
    // Directions with two digits are off by about as much.
    let unit = |vector: DVec3| (vector.length_squared() - 1.0).abs() < 0.03;
    if !(unit(row) && unit(column) && row.dot(column).abs() < 0.02) {
        return Err(Report::new(&first.file.name).invalid(
            Place::File,
            format!("Image Orientation (Patient) {six:?} is not two directions of length 1 at right angles"),
            "correct it",
        ));
    }
    // Rounded to 6 digits, as it is written, it differs by less; a tilt that shows differs by more.
    let differs =
        |slice: &&Slice| slice.orientation.unwrap_or_default().iter().zip(six).any(|(a, b)| (a - b).abs() > 1e-3);
    if let Some(other) = slices.iter().find(differs) {
        return Err(Report::new(&other.file.name).invalid(
            Place::File,
            format!("this slice is turned against {} of the same series", first.file.short_name()),
            "leave out the slices that do not lie behind one another, such as scouts",
        ));
    }
    let [row, column] = [row, column].map(|vector| vector.normalize().to_array());
    Ok([row[0], row[1], row[2], column[0], column[1], column[2]])
}

/// The order of the slices along `normal`, their positions, and how far each lies along it.
fn sorted(slices: &[Slice], normal: [f64; 3]) -> (Vec<usize>, Vec<[f64; 3]>, Vec<f64>) {
    let position = |index: usize| slices[index].position.unwrap_or_default();
    let mut order: Vec<usize> = (0..slices.len()).collect();
    let height = |position: [f64; 3]| DVec3::from(position).dot(DVec3::from(normal));
    order.sort_by(|&a, &b| height(position(a)).total_cmp(&height(position(b))));
    let positions: Vec<_> = order.iter().map(|&index| position(index)).collect();
    let heights = positions.iter().map(|&position| height(position)).collect();
    (order, positions, heights)
}
