//! Changes of a transfer function as a whole: a window, a threshold, a map of colours.

use super::colormap;
use crate::scene::piecewise::around;
use crate::scene::{ColorPoint, IorPoint, OpacityPoint, Scene, TransferFunction};
use vitrum_io::Volume;

/// The share of the function's range over which it rises behind a threshold: sharper than that, steps of voxels show.
const RISE: f32 = 0.02;

/// The first and the last scalar between which functions of the shown volume change; the volume's common range where none does.
pub(super) fn range(scene: &Scene, volume: &Volume) -> [f32; 2] {
    let values = scalars(&scene.transfer, scene.ior_volume.is_none());
    let [low, high] = values.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
    if low < high { [low, high] } else { volume.common_range() }
}

fn scalars(transfer: &TransferFunction, with_ior: bool) -> impl Iterator<Item = f32> {
    let TransferFunction { color, opacity, ior, filter, .. } = transfer;
    let colors = color.iter().chain(filter).map(|point| point.value);
    let ior = ior.iter().filter(move |_| with_ior).map(|point| point.value);
    colors.chain(opacity.iter().map(|point| point.value)).chain(ior)
}

/// Moves all points so that what was over `from` is over `to`.
pub(super) fn stretch(scene: &mut Scene, from: [f32; 2], to: [f32; 2]) {
    let scale = f64::from(to[1] - to[0]) / f64::from(from[1] - from[0]);
    let moved = |value: f32| (f64::from(to[0]) + (f64::from(value) - f64::from(from[0])) * scale) as f32;
    let with_ior = scene.ior_volume.is_none();
    let TransferFunction { color, opacity, ior, filter, .. } = &mut scene.transfer;
    color.iter_mut().chain(filter).for_each(|point| point.value = moved(point.value));
    opacity.iter_mut().for_each(|point| point.value = moved(point.value));
    ior.iter_mut().filter(|_| with_ior).for_each(|point| point.value = moved(point.value));
}

/// The ramp of opacity that an empty function stands for, as points.
pub(super) fn spell_out(scene: &mut Scene, volume: &Volume) {
    if scene.has_usual_opacity() {
        let [low, high] = volume.common_range();
        scene.transfer.opacity =
            vec![OpacityPoint { value: low, opacity: 0.0 }, OpacityPoint { value: high, opacity: 1.0 }];
    }
}

/// Makes nothing of all scalars below a threshold: no opacity, no filter and no refraction.
pub(super) fn cut(scene: &mut Scene, volume: &Volume, threshold: f32) {
    spell_out(scene, volume);
    let [low, high] = range(scene, volume);
    let rise = (RISE * (high - low)).max(threshold.abs() * 4.0 * f32::EPSILON).max(f32::MIN_POSITIVE);
    let full = threshold + rise;
    let with_ior = scene.ior_volume.is_none();
    let around = scene.surroundings.ior;
    let TransferFunction { opacity, ior, filter, .. } = &mut scene.transfer;
    if let Some(OpacityPoint { opacity: share, .. }) = cut_points(opacity, full, mix_opacity) {
        opacity.splice(
            0..0,
            [OpacityPoint { value: threshold, opacity: 0.0 }, OpacityPoint { value: full, opacity: share }],
        );
    }
    if let Some(ColorPoint { color, .. }) = cut_points(filter, full, mix_color) {
        filter.splice(0..0, [ColorPoint { value: threshold, color: [1.0; 3] }, ColorPoint { value: full, color }]);
    }
    if with_ior && let Some(point) = cut_points(ior, full, mix_ior) {
        ior.splice(0..0, [IorPoint::new(threshold, around), IorPoint { value: full, ..point }]);
    }
}

/// Replaces the colours by a map over a range. `None` where there is no map of the name.
pub(super) fn recolor(scene: &mut Scene, name: &str, range: [f32; 2]) -> Option<()> {
    scene.transfer.color = colormap::points(name, range)?;
    Some(())
}

trait Point: Copy {
    fn value(&self) -> f32;
}

impl Point for OpacityPoint {
    fn value(&self) -> f32 {
        self.value
    }
}

impl Point for ColorPoint {
    fn value(&self) -> f32 {
        self.value
    }
}

impl Point for IorPoint {
    fn value(&self) -> f32 {
        self.value
    }
}

/// Removes the points up to `value`; the function's point there, where there is a function.
fn cut_points<P: Point>(points: &mut Vec<P>, value: f32, mix: impl Fn(&P, &P, f32) -> P) -> Option<P> {
    let there = around(points, value, P::value).map(|(before, next, share)| mix(before, next, share));
    points.retain(|point| point.value() > value);
    there
}

fn mix_opacity(from: &OpacityPoint, to: &OpacityPoint, t: f32) -> OpacityPoint {
    OpacityPoint { opacity: from.opacity + (to.opacity - from.opacity) * t, ..*from }
}

fn mix_color(from: &ColorPoint, to: &ColorPoint, t: f32) -> ColorPoint {
    ColorPoint { color: std::array::from_fn(|i| from.color[i] + (to.color[i] - from.color[i]) * t), ..*from }
}

fn mix_ior(from: &IorPoint, to: &IorPoint, t: f32) -> IorPoint {
    IorPoint { ior: from.ior + (to.ior - from.ior) * t, ..*from }
}
