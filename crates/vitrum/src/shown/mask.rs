//! A volume without the parts that a mask hides.
//!
//! What is hidden gets a value at which nothing is shown. Values are interpolated between voxels: beside a part that is shown they go through all that lie between
//! its own and the hidden one's, and through those that show something else, such as skin between bone and air. The nearer the two, the less of that is
//! seen. So a hidden voxel keeps its value if that shows nothing, and else gets the nearest one that does, out of one range of such values for all: between two
//! ranges there would be something to be seen again.

use crate::error::Error;
use crate::method::view::point_between_voxels;
use crate::scene::{Hides, Mask};
use crate::unrenderable::Unrenderable;
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use vitrum_io::{Shared, Volume, Voxels};

/// What a mask hides, and the ranges of scalars at which nothing is shown.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Hidden {
    labels: Vec<f32>,
    hides: Hides,
    /// Of the volume that gives colour and opacity.
    pub(crate) shown: Vec<[f32; 2]>,
    /// Of the volume that gives the index of refraction.
    pub(crate) bending: Vec<[f32; 2]>,
}

impl Hidden {
    pub(crate) fn new(mask: &Mask, [shown, bending]: [Vec<[f32; 2]>; 2]) -> Self {
        Self { labels: mask.labels.clone(), hides: mask.hides, shown, bending }
    }

    fn hides(&self, label: f32) -> bool {
        let is_part = if self.labels.is_empty() { label != 0.0 } else { self.labels.contains(&label) };
        is_part == (self.hides == Hides::Inside)
    }
}

/// The largest distance, in voxels, at which places on two grids are the same but for the precision of files.
const SAME: f64 = 0.05;

/// The voxels of a mask that belong to those of a volume.
struct Placement {
    /// The mask's voxel coordinates of the volume's voxel 0, 0, 0.
    start: DVec3,
    /// The steps of these along the volume's axes.
    steps: DMat3,
}

fn steps(volume: &Volume) -> DMat3 {
    let start = point_between_voxels(volume, DVec3::ZERO);
    let step = |axis| point_between_voxels(volume, axis) - start;
    DMat3::from_cols(step(DVec3::X), step(DVec3::Y), step(DVec3::Z))
}

impl Placement {
    const SAME: Self = Self { start: DVec3::ZERO, steps: DMat3::IDENTITY };

    fn of(volume: &Volume, mask: &Volume) -> Self {
        let is_placed =
            mask.source.format.is_empty() || mask.source.assumptions.stated().iter().any(|fact| fact.name == "spacing");
        if volume.dimensions == mask.dimensions && !is_placed {
            return Self::SAME;
        }
        let inverse = steps(mask).inverse();
        let [start, origin] = [volume, mask].map(|grid| point_between_voxels(grid, DVec3::ZERO));
        let placement = Self { start: inverse * (start - origin), steps: inverse * steps(volume) };
        if placement.is_same(volume, mask) { Self::SAME } else { placement }
    }

    /// Whether voxels of the two belong together by their indices.
    fn is_same(&self, volume: &Volume, mask: &Volume) -> bool {
        let ends = volume.dimensions.map(|size| f64::from(size - 1));
        let off = (0..8_usize).map(|corner| {
            let at =
                DVec3::from_array(std::array::from_fn(|axis| if corner >> axis & 1 == 1 { ends[axis] } else { 0.0 }));
            (self.start + self.steps * at - at).abs().max_element()
        });
        volume.dimensions == mask.dimensions && off.fold(0.0, f64::max) <= SAME
    }
}

/// A statement about a mask on another grid than the volume's.
pub(crate) fn told(volume: &Volume, mask: &Volume) -> Option<String> {
    let placement = Placement::of(volume, mask);
    (!placement.is_same(volume, mask)).then(|| {
        let [x, y, z] = mask.dimensions;
        format!(
            "the mask {} is on another grid, of {x} x {y} x {z} voxels: the nearest of these tells what is hidden",
            mask.name
        )
    })
}

/// The mask as the volume's voxels see it.
struct Seen<'a> {
    mask: &'a Volume,
    placement: Placement,
    /// Whether a stored value hides; of floats it is asked.
    table: Vec<bool>,
    hidden: &'a Hidden,
}

impl<'a> Seen<'a> {
    fn new(volume: &Volume, mask: &'a Volume, hidden: &'a Hidden) -> Self {
        let most = match mask.voxels {
            Voxels::U8(_) => 1 << 8,
            Voxels::U16(_) => 1 << 16,
            Voxels::F32(_) => 0,
        };
        let hides = |stored: u32| hidden.hides(stored as f32 * mask.value_scale + mask.value_offset);
        Self { mask, placement: Placement::of(volume, mask), table: (0..most).map(hides).collect(), hidden }
    }

    /// The index of the mask's voxel nearest to a voxel of the volume; `None` beyond the mask.
    fn nearest(&self, at: DVec3) -> Option<usize> {
        let [width, height, depth] = self.mask.dimensions.map(f64::from);
        let at = (self.placement.start + self.placement.steps * at + 0.5).floor();
        let inside = at.cmpge(DVec3::ZERO).all() && at.x < width && at.y < height && at.z < depth;
        inside.then(|| at.x as usize + width as usize * (at.y as usize + height as usize * at.z as usize))
    }

    fn hides(&self, at: DVec3) -> bool {
        let Some(index) = self.nearest(at) else { return self.hidden.hides(0.0) };
        match &self.mask.voxels {
            Voxels::U8(labels) => self.table[usize::from(labels[index])],
            Voxels::U16(labels) => self.table[usize::from(labels[index])],
            Voxels::F32(labels) => self.hidden.hides(labels[index] * self.mask.value_scale + self.mask.value_offset),
        }
    }

    /// Which voxels of a volume's row are hidden.
    fn row(&self, row: usize, [width, height, _]: [u32; 3]) -> impl Iterator<Item = bool> + '_ {
        let (y, z) = ((row % height as usize) as f64, (row / height as usize) as f64);
        (0..width).map(move |x| self.hides(DVec3::new(f64::from(x), y, z)))
    }
}

/// The volume with what `mask` hides made invisible; `clear` has the ranges of scalars at which nothing is shown.
///
/// # Errors
/// Where the two do not overlap, where all of it is hidden, or where no scalar is invisible.
pub(crate) fn masked(volume: &Volume, mask: &Volume, hidden: &Hidden, clear: &[[f32; 2]]) -> Result<Volume, Error> {
    let seen = Seen::new(volume, mask, hidden);
    check(volume, &seen)?;
    let mut counts = counts(volume, &seen, clear);
    let mut made = volume.clone();
    let stored = |range: &[f32; 2]| {
        let mut ends =
            range.map(|end| (f64::from(end) - f64::from(volume.value_offset)) / f64::from(volume.value_scale));
        ends.sort_by(f64::total_cmp);
        ends
    };
    // Integers have no value for some ranges.
    let holds = |most: f64, range: &[f32; 2]| {
        let [low, high] = stored(range);
        low.ceil().max(0.0) <= high.floor().min(most)
    };
    let most = match volume.voxels {
        Voxels::U8(_) => f64::from(u8::MAX),
        Voxels::U16(_) => f64::from(u16::MAX),
        Voxels::F32(_) => f64::INFINITY,
    };
    let is_integer = most.is_finite();
    let any = clear.iter().any(|range| !is_integer || holds(most, range));
    if any && is_integer {
        counts.iter_mut().zip(clear).filter(|(_, range)| !holds(most, range)).for_each(|(count, _)| *count = None);
    }
    let best = counts.iter().enumerate().rev().max_by_key(|(_, count)| **count).map(|(index, _)| index);
    let Some(range) = best.and_then(|index| clear.get(index)) else {
        return Err(Unrenderable::NothingInvisible { name: volume.name.clone() }.into());
    };
    let [low, high] = stored(range);
    if !any && let Some(floats) = as_floats(&made.voxels) {
        made.voxels = floats;
    }
    let size = volume.dimensions;
    match &mut made.voxels {
        Voxels::U8(voxels) => hide(voxels, size, &seen, |voxel| f64::from(voxel).clamp(low.ceil(), high.floor()) as u8),
        Voxels::U16(voxels) => {
            hide(voxels, size, &seen, |voxel| f64::from(voxel).clamp(low.ceil(), high.floor()) as u16);
        }
        Voxels::F32(voxels) => hide(voxels, size, &seen, |voxel| inside(voxel, [low, high])),
    }
    Ok(made)
}

/// The stored float nearest to `voxel` between two ends.
fn inside(voxel: f32, [low, high]: [f64; 2]) -> f32 {
    let nearest = f64::from(voxel).clamp(low, high);
    let stored = nearest as f32;
    // Rounding must not lead out again.
    match (f64::from(stored) < low, f64::from(stored) > high) {
        (true, _) => stored.next_up(),
        (_, true) => stored.next_down(),
        _ => stored,
    }
}

/// Sets each hidden voxel to what `value` makes of it.
fn hide<T: bytemuck::Pod + Send + Sync>(
    voxels: &mut Shared<T>,
    size: [u32; 3],
    seen: &Seen<'_>,
    value: impl Fn(T) -> T + Sync,
) {
    voxels.make_mut().par_chunks_mut(size[0] as usize).enumerate().for_each(|(row, voxels)| {
        let hidden = voxels.iter_mut().zip(seen.row(row, size)).filter(|(_, hidden)| *hidden);
        hidden.for_each(|(voxel, _)| *voxel = value(*voxel));
    });
}

/// The voxels as floats; `None` where they are such.
fn as_floats(voxels: &Voxels) -> Option<Voxels> {
    match voxels {
        Voxels::U8(voxels) => {
            Some(Voxels::F32(voxels.par_iter().map(|&voxel| f32::from(voxel)).collect::<Vec<_>>().into()))
        }
        Voxels::U16(voxels) => {
            Some(Voxels::F32(voxels.par_iter().map(|&voxel| f32::from(voxel)).collect::<Vec<_>>().into()))
        }
        Voxels::F32(_) => None,
    }
}

/// How many hidden voxels have values in each of the ranges.
fn counts(volume: &Volume, seen: &Seen<'_>, clear: &[[f32; 2]]) -> Vec<Option<u64>> {
    let [width, height, depth] = volume.dimensions;
    let physical =
        |index: usize| volume.voxels.stored(index).unwrap_or_default() * volume.value_scale + volume.value_offset;
    let of_row = |row: usize| {
        let mut counts = vec![0; clear.len()];
        for (x, _) in seen.row(row, volume.dimensions).enumerate().filter(|(_, hidden)| *hidden) {
            let value = physical(row * width as usize + x);
            if let Some(range) = clear.iter().position(|[low, high]| value >= *low && value <= *high) {
                counts[range] += 1;
            }
        }
        counts
    };
    let sum = |one: Vec<u64>, other: Vec<u64>| one.iter().zip(&other).map(|(a, b)| a + b).collect::<Vec<_>>();
    let rows = height as usize * depth as usize;
    let all = (0..rows).into_par_iter().map(of_row).reduce(|| vec![0; clear.len()], sum);
    all.into_iter().map(Some).collect()
}

/// Refuses a mask beside the volume, and one that hides everything.
fn check(volume: &Volume, seen: &Seen<'_>) -> Result<(), Error> {
    let [_, height, depth] = volume.dimensions;
    let rows = height as usize * depth as usize;
    let name = || seen.mask.name.clone();
    if (0..rows).into_par_iter().any(|row| seen.row(row, volume.dimensions).any(|hidden| !hidden)) {
        return Ok(());
    }
    let [width, ..] = volume.dimensions;
    let row_overlaps = |row: usize| {
        let (y, z) = ((row % height as usize) as f64, (row / height as usize) as f64);
        (0..width).any(|x| seen.nearest(DVec3::new(f64::from(x), y, z)).is_some())
    };
    if !(0..rows).into_par_iter().any(row_overlaps) {
        return Err(Unrenderable::MaskBeside { name: name() }.into());
    }
    Err(Unrenderable::MaskHidesAll { name: name(), labels: labels(seen.mask) }.into())
}

/// The labels of a mask, for messages: as many as fit.
fn labels(mask: &Volume) -> String {
    const MOST: usize = 12;
    let mut found: Vec<f32> = Vec::new();
    for index in 0..mask.voxel_count() {
        let label = mask.voxels.stored(index).unwrap_or_default() * mask.value_scale + mask.value_offset;
        if found.len() <= MOST && !found.contains(&label) {
            found.push(label);
        }
    }
    found.sort_by(f32::total_cmp);
    let more = if found.len() > MOST { ", ..." } else { "" };
    let list: Vec<String> = found.iter().take(MOST).map(ToString::to_string).collect();
    format!("{}{more}", list.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 3] = [4, 3, 2];

    fn volume(voxels: impl Into<Voxels>) -> Volume {
        Volume::new("scan", SIZE, [1.0; 3], voxels.into()).expect("a volume")
    }

    /// A mask whose voxels with x ≥ 2 have label 3, and the others 1.
    fn halves() -> Volume {
        let labels: Vec<u8> = (0..24).map(|index| if index % 4 >= 2 { 3 } else { 1 }).collect();
        volume(labels)
    }

    fn hidden(labels: &[f32], hides: Hides) -> Hidden {
        Hidden { labels: labels.to_vec(), hides, shown: Vec::new(), bending: Vec::new() }
    }

    /// The first row of the volume when the mask has been at it.
    fn row(volume: &Volume, mask: &Volume, hidden: &Hidden, clear: &[[f32; 2]]) -> Vec<f32> {
        let made = masked(volume, mask, hidden, clear).expect("a volume");
        (0..4).map(|x| made.value(x, 0, 0)).collect()
    }

    #[test]
    fn what_is_hidden_gets_the_nearest_value_that_shows_nothing() {
        let scan = volume((0..24).map(|index| [10_u8, 40, 60, 90][index % 4]).collect::<Vec<_>>());
        let clear = [[f32::NEG_INFINITY, 20.5], [80.0, 100.0]];
        assert_eq!(row(&scan, &halves(), &hidden(&[3.0], Hides::Outside), &clear), [10.0, 20.0, 60.0, 90.0]);
        assert_eq!(row(&scan, &halves(), &hidden(&[3.0], Hides::Inside), &clear), [10.0, 40.0, 80.0, 90.0]);
        assert_eq!(row(&scan, &halves(), &hidden(&[], Hides::Outside), &clear), [10.0, 40.0, 60.0, 90.0]);
        // No byte shows nothing: floats do.
        let above = [[255.5, f32::INFINITY]];
        assert_eq!(row(&scan, &halves(), &hidden(&[3.0], Hides::Outside), &above), [255.5, 255.5, 60.0, 90.0]);
        assert!(masked(&scan, &halves(), &hidden(&[3.0], Hides::Outside), &[]).is_err());
    }

    #[test]
    fn masks_on_other_grids_are_looked_up_by_place() {
        let scan = volume(vec![50_u8; 24]);
        let clear = [[0.0, 0.0]];
        let left = hidden(&[1.0], Hides::Outside);
        assert_eq!((told(&scan, &halves()), row(&scan, &halves(), &left, &clear)), (None, vec![50.0, 50.0, 0.0, 0.0]));
        // The same matter, stored from right to left.
        let labels: Vec<u8> = (0..24).map(|index| if index % 4 < 2 { 3 } else { 1 }).collect();
        let turned = Volume {
            axes: [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            origin: [1.5, -1.0, -0.5],
            ..volume(labels)
        };
        assert_eq!(row(&scan, &turned, &left, &clear), [50.0, 50.0, 0.0, 0.0]);
        assert!(told(&scan, &turned).is_some());
        // Half of it, in voxels of twice the edge; beyond it there is no part.
        let coarse = Volume::new("coarse", [1, 3, 2], [2.0, 1.0, 1.0], Voxels::from(vec![1_u8; 6])).expect("a volume");
        let coarse = Volume { origin: [-1.0, -1.0, -0.5], ..coarse };
        assert_eq!(row(&scan, &coarse, &left, &clear), [50.0, 50.0, 0.0, 0.0]);
        let beside = Volume { origin: [90.0, 0.0, 0.0], ..halves() };
        let refused = |mask: &Volume, labels: &[f32]| {
            masked(&scan, mask, &hidden(labels, Hides::Outside), &clear).expect_err("nothing is left").to_string()
        };
        assert!(refused(&beside, &[1.0]).contains("do not overlap"));
        assert!(refused(&halves(), &[2.0]).contains("values are 1, 3"), "{}", refused(&halves(), &[2.0]));
        // A file that does not say where its voxels lie.
        let mut unplaced = beside;
        unplaced.source.format = "raw";
        assert_eq!(row(&scan, &unplaced, &left, &clear), [50.0, 50.0, 0.0, 0.0]);
    }
}
