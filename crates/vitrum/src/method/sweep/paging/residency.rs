//! The residency of pages: the planes between which a frame reads each page of a volume.

use crate::method::sweep::occupancy::{OccupancyQuery, widen};
use crate::method::sweep::planes::Planes;
use crate::method::sweep::voxels::pages;
use crate::method::view::{View, vector, voxel_steps};
use crate::scene::Scene;
use glam::DVec3;
use rayon::prelude::*;
use vitrum_io::Volume;
use vitrum_kernels::abi::format::page;

/// The most values for which there is a slot that the value fills.
const MOST_FILLS: usize = 256;

/// The error of the position of a look-up, in voxels, besides the rounding of large coordinates.
const ROUNDING: f64 = 0.25;

/// The positions among the voxels of the look-ups between two planes.
#[derive(Debug, Clone, Copy)]
pub(in crate::method::sweep) struct Sampling {
    /// The depth of voxel (0, 0, 0).
    depth: f64,
    /// Change of the depth from voxel to voxel along each axis of the volume.
    growth: DVec3,
    /// The longest step from plane to plane along each axis, in voxels.
    step: DVec3,
    /// How far beside the way from plane to plane look-ups are, world units.
    reach: f64,
    /// The largest voxel coordinate in a computation.
    largest: f64,
    /// Whether there are borders within the volume.
    cropped: bool,
}

/// A sweep over planes in which pages are looked at: one of several that follow one another in a frame.
#[derive(Debug, Clone, Copy)]
pub(in crate::method::sweep) struct Swept<'a> {
    pub(in crate::method::sweep) sampling: Sampling,
    pub(in crate::method::sweep) planes: &'a Planes,
    /// The first plane on the way to which pages are looked at.
    pub(in crate::method::sweep) first: u32,
    /// The number of the sweep's plane 0 among the planes of the frame.
    pub(in crate::method::sweep) offset: u32,
}

/// A page that must be on the device, and the planes between which it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ResidentPage {
    /// The number of the page, x fastest.
    pub(super) page: u32,
    /// The first plane on the way to which the page is read.
    pub(super) first: u32,
    /// The last such plane.
    pub(super) last: u32,
}

/// The pages of a volume that a frame reads.
#[derive(Debug)]
pub(in crate::method::sweep) struct Residency {
    /// Pages along each axis.
    pub(super) pages: [u32; 3],
    /// The pages that must be on the device, in the order of their numbers.
    pub(super) needed: Vec<ResidentPage>,
    /// The stored values of the pages that one value fills.
    pub(super) fills: Vec<f32>,
    /// The index into `fills` of each page; 0 for the pages in `needed` and those that no ray reads.
    pub(super) filled: Vec<u16>,
}

/// The contents of a page, as far as storage is concerned.
enum Kind {
    /// An empty page, in which and a step around which nothing happens to a ray: any value between these two gives the same picture.
    Empty(f32, f32),
    /// Voxels that all have this value.
    Constant(f32),
    /// Voxels of different values.
    Various,
}

impl Residency {
    /// The residency of the pages of `query`'s volume in `sweeps` that follow one another. A page comes for each of them.
    pub(in crate::method::sweep) fn new(query: &OccupancyQuery, sweeps: &[Swept]) -> Self {
        let dimensions = query.volume.dimensions;
        let pages = pages(dimensions);
        let longest = sweeps.iter().map(|sweep| sweep.sampling.step).fold(DVec3::ZERO, DVec3::max);
        let kinds = kinds(query, longest, pages);
        let mut residency = Self { pages, needed: Vec::new(), fills: Vec::new(), filled: vec![0; kinds.len()] };
        let mut recent = [0; 2];
        for (number, kind) in kinds.into_iter().enumerate() {
            let fill = match kind {
                Kind::Constant(value) => residency.fill(&mut recent[0], |known| known == value, value),
                Kind::Empty(low, high) => {
                    let suits = |known: f32| query.is_empty(known.min(low), known.max(high));
                    residency.fill(&mut recent[1], suits, low)
                }
                Kind::Various => None,
            };
            let at = [0, 1, 2].map(|axis| number as u32 / pages[..axis].iter().product::<u32>() % pages[axis]);
            if let Some(fill) = fill {
                residency.filled[number] = fill;
                continue;
            }
            for &Swept { sampling, planes, first, offset } in sweeps {
                let (from, to) = sampling.planes(at, pages, dimensions, planes);
                let from = from.max(first);
                if from <= to {
                    let page = number as u32;
                    residency.needed.push(ResidentPage { page, first: offset + from, last: offset + to });
                }
            }
        }
        // The first one is for those that nobody looks at.
        if residency.fills.is_empty() {
            residency.fills.push(0.0);
        }
        residency
    }

    /// The index of a fill that `suits`, the `recent` one first, or of a new fill of `value` if the limit allows one.
    fn fill(&mut self, recent: &mut usize, suits: impl Fn(f32) -> bool, value: f32) -> Option<u16> {
        let same = self.fills.get(*recent).filter(|&&fill| suits(fill)).map(|_| *recent);
        let known = same.or_else(|| self.fills.iter().position(|&fill| suits(fill)));
        let fill = known.or_else(|| {
            (self.fills.len() < MOST_FILLS).then(|| {
                self.fills.push(value);
                self.fills.len() - 1
            })
        })?;
        *recent = fill;
        Some(fill as u16)
    }
}

/// The kind of each page; steps are at most `longest` voxels long along each axis.
fn kinds(query: &OccupancyQuery, longest: DVec3, pages: [u32; 3]) -> Vec<Kind> {
    let dimensions = query.volume.dimensions;
    let all: u32 = pages.iter().product();
    let ranges: Vec<(f32, f32)> = (0..all)
        .into_par_iter()
        .map(|number| {
            let at = |axis: usize| number / pages[..axis].iter().product::<u32>() % pages[axis];
            let first = |axis: usize| (at(axis) * page::EDGE as u32).saturating_sub(1 + page::BEFORE as u32);
            let low: [u32; 3] = [0, 1, 2].map(|axis| first(axis).min(dimensions[axis] - 1));
            let high =
                [0, 1, 2].map(|axis| (at(axis) * page::EDGE as u32 + page::EDGE as u32).min(dimensions[axis] - 1));
            query.ranges.within(query.volume, low, high)
        })
        .collect();
    // A ray may come from a page into one a step away, and go on from there.
    let beyond = longest.to_array().map(|step| ((step + 2.0) / f64::from(page::EDGE)).ceil() as usize);
    let sizes = pages.map(|n| n as usize);
    let widened = widen(&ranges, sizes, 0, beyond[0]);
    let widened = widen(&widened, sizes, 1, beyond[1]);
    let widened = widen(&widened, sizes, 2, beyond[2]);
    ranges
        .into_par_iter()
        .zip(widened)
        .map(|((low, high), (lowest, highest))| match () {
            () if low == high => Kind::Constant(low),
            () if query.is_empty(lowest, highest) => Kind::Empty(lowest, highest),
            () => Kind::Various,
        })
        .collect()
}

impl Sampling {
    /// The look-ups in `volume` of rays with a slope of at most `steepest` (distance across over depth), which look up to `reach` world units aside, too.
    pub(in crate::method::sweep) fn new(
        scene: &Scene,
        volume: &Volume,
        view: &View,
        planes: &Planes,
        (steepest, reach): (f64, f64),
    ) -> Self {
        let steps = voxel_steps(volume);
        let along = steps.inverse() * view.axes;
        let eye = view.eye - vector(volume.origin);
        let step = |axis: usize| {
            let row = along.row(axis);
            (row.truncate().length() * steepest + row.z.abs()) * planes.distance + row.length() * reach
        };
        let sizes = DVec3::from_array(volume.dimensions.map(f64::from));
        Self {
            depth: -view.axes.z_axis.dot(eye),
            growth: steps.transpose() * view.axes.z_axis,
            step: DVec3::new(step(0), step(1), step(2)),
            largest: ((steps.inverse() * eye).abs() + sizes).max_element(),
            reach,
            cropped: scene.crop.is_some(),
        }
    }

    /// The first and the last plane on the way to which page `at` is looked at.
    ///
    /// Within the volume look-ups lie between the plane behind and the plane, however oblique the step is. A look-up outside takes the
    /// nearest voxel, which lies on the volume's border and up to a step away in depth; it counts where the step, or the next one, goes
    /// through the volume.
    fn planes(&self, at: [u32; 3], pages: [u32; 3], dimensions: [u32; 3], planes: &Planes) -> (u32, u32) {
        let mut range = [self.depth; 2];
        for axis in 0..3 {
            let first = f64::from(at[axis]) * f64::from(page::EDGE) - 1.0;
            let far = f64::from(dimensions[axis]) - 0.5;
            let ends = [first.max(-0.5), (first + f64::from(page::EDGE)).min(far)].map(|end| end * self.growth[axis]);
            range = [range[0] + ends[0].min(ends[1]), range[1] + ends[0].max(ends[1])];
        }
        let growth = self.growth.abs();
        let rounding = growth.element_sum() * (ROUNDING + 2e-6 * self.largest);
        let border = self.cropped || (0..3).any(|axis| at[axis] == 0 || at[axis] + 1 == pages[axis]);
        let margin = rounding + self.reach + if border { growth.dot(self.step) + planes.distance } else { 0.0 };
        let index = |depth: f64| (depth - planes.first_depth) / planes.distance;
        let limit = |index: f64| index.clamp(0.0, f64::from(planes.behind) + 1.0) as u32;
        // Planes behind the volume look at nothing.
        (
            limit(index(range[0] - margin).ceil()).max(1),
            limit(index(range[1] + margin).floor() + 1.0).min(planes.behind),
        )
    }
}
