//! `labels`: the parts of a segmentation, each in a colour of its own.

use super::subject::{Subject, color, opacity};
use super::{Preset, plain};
use crate::scene::{ColorPoint, Interpolation, OpacityPoint, Rgb, Scene, TransferFunction};
use vitrum_io::{Volume, srgb_to_linear};

pub(super) const PRESET: Preset = Preset {
    of_labels: true,
    ..Preset::fitted("labels", "each part of a segmentation in a colour of its own, unmixed", apply)
};

/// More parts than these are not told apart by eye.
const MOST: usize = 256;
/// Opacity of a part, for a layer of the reference length.
const OPACITY: f32 = 0.9;
/// The golden angle in turns: hues of successive parts are far apart, however many there are.
const GOLDEN: f32 = 0.381_966;

/// Light and ground are those of opaque surfaces.
fn apply(subject: &Subject, scene: &mut Scene) {
    (plain::PRESET.apply)(subject, scene);
    scene.volume.interpolation = Interpolation::Nearest;
}

/// The parts of a volume, in ascending order: those that its file names, else its whole numbers but the least, which is the background. `None` of
/// other values.
pub(super) fn parts(volume: &Volume) -> Option<Vec<(f32, Option<Rgb>)>> {
    if let Some(labels) = volume.source.labels().filter(|labels| !labels.list.is_empty()) {
        let linear = |color: [f64; 3]| color.map(|code| srgb_to_linear(code as f32));
        let mut parts: Vec<_> = labels.list.iter().map(|label| (label.value, label.color.map(linear))).collect();
        parts.sort_by(|a, b| a.0.total_cmp(&b.0));
        parts.dedup_by(|a, b| a.0 == b.0);
        return Some(parts);
    }
    let [low, high] = volume.range;
    if low.fract() != 0.0 || high.fract() != 0.0 || high - low >= MOST as f32 || low == high {
        return None;
    }
    let [width, height, depth] = volume.dimensions;
    let rows = (0..depth).flat_map(|z| (0..height).map(move |y| (y, z)));
    let mut seen = [false; MOST];
    for (y, z) in rows {
        for x in 0..width {
            let value = volume.value(x, y, z);
            if value.fract() != 0.0 {
                return None;
            }
            seen[(value - low) as usize] = true;
        }
    }
    let found = seen.iter().enumerate().skip(1).filter(|(_, seen)| **seen);
    Some(found.map(|(above, _)| (low + above as f32, None)).collect())
}

/// A colour for part `number` that no file names, linear RGB.
fn hue(number: usize) -> Rgb {
    let turn = (number as f32 * GOLDEN + 0.05).fract() * 6.0;
    // Half saturated, so that shading shows.
    [5.0f32, 3.0, 1.0].map(|channel| {
        let away = (turn + channel) % 6.0;
        let share = (away.min(4.0 - away)).clamp(0.0, 1.0);
        srgb_to_linear(0.92 * (1.0 - 0.6 * share))
    })
}

/// Colours [`parts`].
pub(super) fn color_parts(parts: &[(f32, Option<Rgb>)], scene: &mut Scene) {
    // Values are as they are in voxels: functions change halfway between two of them, where no voxel is.
    let mut colors: Vec<ColorPoint> = Vec::new();
    let mut opacities: Vec<OpacityPoint> = Vec::new();
    for (number, (value, named)) in parts.iter().enumerate() {
        let start = number.checked_sub(1).map_or(value - 0.5, |before| f32::midpoint(parts[before].0, *value));
        let share = if *value == 0.0 { 0.0 } else { OPACITY };
        let paint = named.unwrap_or_else(|| hue(number));
        if let (Some(last), Some(share_before)) = (colors.last().copied(), opacities.last().copied()) {
            colors.push(color(start, last.color));
            opacities.push(opacity(start, share_before.opacity));
        } else {
            opacities.push(opacity(start, 0.0));
        }
        colors.push(color(start, paint));
        opacities.push(opacity(start, share));
        colors.push(color(*value, paint));
        opacities.push(opacity(*value, share));
    }
    let reference_length = scene.transfer.reference_length;
    scene.transfer =
        TransferFunction { reference_length, color: colors, opacity: opacities, ..TransferFunction::default() };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_parts_and_measurements_are_none() {
        let volume = |voxels: Vec<f32>| Volume::new("test", [2, 2, 2], [1.0; 3], voxels.into()).expect("a volume");
        let found = parts(&volume(vec![0.0, 0.0, 3.0, 3.0, 7.0, 7.0, 0.0, 3.0])).expect("labels");
        assert_eq!(found, [(3.0, None), (7.0, None)]);
        assert_eq!(parts(&volume(vec![0.0, 0.5, 3.0, 3.0, 7.0, 7.0, 0.0, 3.0])), None);
    }

    #[test]
    fn hues_of_neighbours_differ() {
        for number in 0..32 {
            let [a, b] = [hue(number), hue(number + 1)];
            let apart: f32 = a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum();
            assert!(apart > 0.2, "{number}: {a:?}, {b:?}");
            assert!(a.iter().all(|channel| (0.0..=1.0).contains(channel)));
        }
    }
}
