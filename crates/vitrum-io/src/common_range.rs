//! The range of a volume's values without outliers, such as metal in a scan or a hot pixel.

use crate::voxels::Voxels;

/// The share of the voxels at either end that may be outliers.
const SHARE: f64 = 1e-3;
/// How far beyond the other voxels' range they then are, in widths of it.
const DISTANCE: f64 = 4.0;

/// The least and the greatest stored value, but for those few that are much farther away from the others than these from one another.
pub(crate) fn common_extremes(voxels: &Voxels, extremes: [f32; 2]) -> [f32; 2] {
    match voxels {
        Voxels::U8(voxels) => common(voxels, extremes, |voxel| (u16::from(voxel), f32::from(voxel)), f32::from),
        Voxels::U16(voxels) => common(voxels, extremes, |voxel| (voxel, f32::from(voxel)), f32::from),
        Voxels::F32(voxels) => common(voxels, extremes, |voxel| (class(voxel), voxel), least_of_class),
    }
}

/// The number of a class of floats that are alike in their first sixteen bits, in the order of their values.
fn class(value: f32) -> u16 {
    let bits = value.to_bits();
    let ordered = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
    (ordered >> 16) as u16
}

/// The least float of a class.
fn least_of_class(class: u16) -> f32 {
    let ordered = u32::from(class) << 16;
    f32::from_bits(if ordered >> 31 == 1 { ordered & !(1 << 31) } else { !ordered })
}

fn common<T: Copy>(
    voxels: &[T],
    [least, greatest]: [f32; 2],
    class: impl Fn(T) -> (u16, f32),
    value: impl Fn(u16) -> f32,
) -> [f32; 2] {
    let mut counts = vec![0_u64; 1 << 16];
    voxels.iter().for_each(|&voxel| counts[usize::from(class(voxel).0)] += 1);
    let few = (voxels.len() as f64 * SHARE) as u64;
    // The class up to which there are more than a few voxels, from either end.
    let mut below = 0;
    let mut above = 0;
    let first = (0..counts.len()).find(|&class| exceeds(&mut below, counts[class], few));
    let last = (0..counts.len()).rev().find(|&class| exceeds(&mut above, counts[class], few));
    let [low, high] = [first, last].map(|class| f64::from(value(class.unwrap_or_default() as u16)));
    let far = DISTANCE * (high - low);
    let is_common = |value: f32| f64::from(value) >= low - far && f64::from(value) <= high + far;
    if high <= low || (is_common(least) && is_common(greatest)) {
        return [least, greatest];
    }
    let values = voxels.iter().map(|&voxel| class(voxel).1).filter(|&value| is_common(value));
    values.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// Adds `count` to `sum`, and tells whether that is more than `few`.
fn exceeds(sum: &mut u64, count: u64, few: u64) -> bool {
    *sum += count;
    *sum > few
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(voxels: &Voxels) -> [f32; 2] {
        common_extremes(voxels, voxels.extremes().expect("there are voxels"))
    }

    #[test]
    fn classes_are_in_the_order_of_their_values() {
        let values = [f32::MIN, -2.0, -1.0, -1e-30, 0.0, 1e-30, 1.0, 1.5, f32::MAX];
        assert!(values.is_sorted_by_key(|&value| class(value)));
        assert!(values.iter().all(|&value| least_of_class(class(value)) <= value));
        assert_eq!([0.0, 1.0, -2.0].map(|value| least_of_class(class(value))), [0.0, 1.0, -2.015_624_8]);
    }

    #[test]
    fn few_far_away_are_left_out() {
        let usual: Vec<f32> = (0..5000).map(|i| (i % 100) as f32 * 0.01 - 0.3).collect();
        let range = of(&Voxels::from(usual.clone()));
        assert_eq!(range, [-0.3, 99.0 * 0.01 - 0.3]);
        for outlier in [1e6, -1e6, f32::MAX] {
            let mut voxels = usual.clone();
            voxels[77] = outlier;
            assert_eq!(of(&Voxels::from(voxels)), range);
        }
        // Not so few, or not so far away.
        let mut many = usual.clone();
        many[..20].fill(1e6);
        assert_eq!(of(&Voxels::from(many))[1], 1e6);
        let mut near = usual;
        near[3] = 3.0;
        assert_eq!(of(&Voxels::from(near))[1], 3.0);
        let mut metal: Vec<u16> = (0..8000).map(|i| i % 3000).collect();
        metal[5] = 60_000;
        assert_eq!(of(&Voxels::from(metal)), [0.0, 2999.0]);
    }

    #[test]
    fn a_small_thing_in_the_void_is_no_outlier() {
        let mut voxels = vec![0_u8; 10_000];
        voxels[1] = 255;
        assert_eq!(of(&Voxels::from(voxels)), [0.0, 255.0]);
    }
}
