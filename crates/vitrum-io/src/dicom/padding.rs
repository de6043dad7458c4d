//! Pixel padding: pixels without a measurement, such as those outside of a scanner's round field of view.
//!
//! PS3.3, C.7.5.1.1.2: <https://dicom.nema.org/medical/dicom/current/output/chtml/part03/sect_C.7.5.html>.

use bytemuck::Pod;

use super::attributes;
use super::image::{Padding, Pixels, Slice};
use crate::samples::SampleType;
use crate::voxels::Voxels;
use dicom_object::InMemDicomObject;

/// The padding that a file names.
pub(super) fn of(object: &InMemDicomObject, pixels: Pixels) -> Option<Padding> {
    let number = |tag| {
        let number: i64 = object.get(tag)?.to_int().ok()?;
        Some(wrapped(number, pixels.sample))
    };
    let value = number(attributes::PADDING)?;
    let limit = number(attributes::PADDING_LIMIT).unwrap_or(value);
    Some(Padding { low: value.min(limit), high: value.max(limit) })
}

/// A padding value in the sign of the pixels: some files write -2000 as 63536 though the pixels are signed, and the other way round.
fn wrapped(number: i64, sample: SampleType) -> i64 {
    match sample {
        SampleType::U8 => i64::from(number as u8),
        SampleType::I8 => i64::from(number as i8),
        SampleType::U16 => i64::from(number as u16),
        SampleType::I16 => i64::from(number as i16),
        SampleType::I32 => i64::from(number as i32),
        _ => i64::from(number as u32),
    }
}

/// Gives padding a value that measured pixels have, so that it widens neither the range nor the histogram: the end of their range
/// that it lies beyond, and the least where it lies within. Where it is but the next stored number, such as 0 below the 1 of an MR, it
/// widens nothing that matters, and stays what other programs read. Returns a sentence about what was changed, if anything was.
///
/// `slices` are those of `voxels`, in their order; `uniform` says that these are stored values rather than physical ones.
pub(super) fn replace(slices: &[Slice], uniform: bool, voxels: &mut Voxels) -> Option<String> {
    slices.iter().find(|slice| slice.file.padding.is_some())?;
    let bounds: Vec<_> = slices.iter().map(|slice| bounds(slice, uniform)).collect();
    let slope = if uniform { slices[0].rescale[0] } else { 1.0 };
    let replaced = match voxels {
        Voxels::U8(voxels) => fill(voxels.make_mut(), &bounds, slope, 1.0),
        Voxels::U16(voxels) => fill(voxels.make_mut(), &bounds, slope, 1.0),
        Voxels::F32(voxels) => fill(voxels.make_mut(), &bounds, slope, 0.0),
    };
    let Replaced { count, values } = replaced?;
    let Some(values) = values else {
        return Some(format!("all {count} voxels are padding, by their Pixel Padding Value, and were kept"));
    };
    let [slope, intercept] = if uniform { slices[0].rescale } else { [1.0, 0.0] };
    let offset = if uniform { f64::from(slices[0].file.pixels.sample.value_offset()) } else { 0.0 };
    let mut values = values.map(|value| slope * (f64::from(value) + offset) + intercept);
    values.sort_by(f64::total_cmp);
    let value =
        if values[0] == values[1] { format!("{}", values[0]) } else { format!("{} or {}", values[0], values[1]) };
    Some(format!(
        "{count} voxels are padding, by their Pixel Padding Value, and hold no measurement: they were given {value}, the nearest end \
         of the measured values"
    ))
}

/// The ends of a slice's padding among the voxels.
fn bounds(slice: &Slice, uniform: bool) -> Option<[f32; 2]> {
    let Padding { low, high } = slice.file.padding?;
    let [slope, intercept] = slice.rescale;
    let offset = slice.file.pixels.sample.value_offset();
    // As the voxels are computed, so that equal ones are equal.
    let voxel = |number: i64| {
        if uniform { number as f32 - offset } else { (slope * number as f64 + intercept) as f32 }
    };
    let mut ends = [voxel(low), voxel(high)];
    ends.sort_by(f32::total_cmp);
    Some(ends)
}

struct Replaced {
    count: u64,
    /// The values below which and above which there is nothing, as far as they were used; `None` where all are padding.
    values: Option<[f32; 2]>,
}

/// Replaces padding among the voxels; a value at most `step` beyond the measured ones stays. `None` if nothing was replaced.
fn fill<T: Pod + Into<f32>>(voxels: &mut [T], bounds: &[Option<[f32; 2]>], slope: f64, step: f32) -> Option<Replaced> {
    let size = (voxels.len() / bounds.len()).max(1);
    let within = |voxel: T, [low, high]: [f32; 2]| (low..=high).contains(&voxel.into());
    let mut count = 0;
    let mut ends: Option<[T; 2]> = None;
    for (slice, bounds) in voxels.chunks(size).zip(bounds) {
        for &voxel in slice {
            if bounds.is_some_and(|bounds| within(voxel, bounds)) {
                count += 1;
                continue;
            }
            let [low, high] = ends.get_or_insert([voxel; 2]);
            if voxel.into() < (*low).into() {
                *low = voxel;
            }
            if voxel.into() > (*high).into() {
                *high = voxel;
            }
        }
    }
    if count == 0 {
        return None;
    }
    let Some([low, high]) = ends else { return Some(Replaced { count, values: None }) };
    let (least, most): (f32, f32) = (low.into(), high.into());
    let stays = |value: f32| value < least && least - value <= step || value > most && value - most <= step;
    let (mut count, mut used) = (0, [None; 2]);
    for (slice, bounds) in voxels.chunks_mut(size).zip(bounds) {
        let Some(bounds) = *bounds else { continue };
        for voxel in slice.iter_mut().filter(|voxel| within(**voxel, bounds)) {
            let value: f32 = (*voxel).into();
            if stays(value) {
                continue;
            }
            let above = value > most || slope < 0.0 && value > least;
            *voxel = if above { high } else { low };
            count += 1;
            used[usize::from(above)] = Some((*voxel).into());
        }
    }
    let [low, high] = used;
    let values = low.or(high).zip(high.or(low)).map(|(low, high)| [low, high])?;
    Some(Replaced { count, values: Some(values) })
}
