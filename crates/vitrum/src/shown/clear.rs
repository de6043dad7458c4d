//! The scalars at which a scene shows nothing.

use super::visible::By;
use crate::scene::Scene;

/// A function of the scalar: its points, ascending, each with whether it shows nothing there.
type Points = Vec<(f32, bool)>;

/// The ranges of scalars at which nothing is shown, in ascending order, ends included: opacity 0, a white filter and the index of the surroundings. Between
/// scalars of one range nothing is shown either, and no isosurface lies. `range` is that of the volume, without outliers.
pub(crate) fn clear_ranges(scene: &Scene, by: By, range: impl FnOnce() -> [f32; 2]) -> Vec<[f32; 2]> {
    let transfer = &scene.transfer;
    let mut functions: Vec<Points> = Vec::new();
    let mut surfaces = Vec::new();
    if by != By::Bending {
        functions.push(if scene.has_usual_opacity() {
            let [low, high] = range();
            vec![(low, true), (high, low == high)]
        } else {
            transfer.opacity.iter().map(|point| (point.value, point.opacity == 0.0)).collect()
        });
        functions.push(transfer.filter.iter().map(|point| (point.value, point.color == [1.0; 3])).collect());
        surfaces =
            scene.isosurface.iter().filter(|surface| surface.opacity > 0.0).map(|surface| surface.value).collect();
    }
    if by != By::Absorption && scene.sweep.refraction {
        let around = scene.surroundings.ior;
        let like_it = |point: &crate::scene::IorPoint| point.ior == around && point.cauchy_coefficient() == 0.0;
        functions.push(transfer.ior.iter().map(|point| (point.value, like_it(point))).collect());
    }
    let whole = vec![[f32::NEG_INFINITY, f32::INFINITY]];
    let clear = functions.iter().fold(whole, |clear, points| common(&clear, &ranges(points)));
    let parted: Vec<[f32; 2]> = surfaces.iter().fold(clear, |clear, &value| parted(&clear, value));
    let Some(lowest) = surfaces.iter().copied().reduce(f32::min) else { return parted };
    // Matter with a surface is closed where something is hidden beside it, and not the space around it.
    let below: Vec<[f32; 2]> = parted.iter().copied().filter(|[_, high]| *high < lowest).collect();
    if below.is_empty() { parted } else { below }
}

/// The ranges over which a function shows nothing. At a step its later point holds.
fn ranges(points: &[(f32, bool)]) -> Vec<[f32; 2]> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return vec![[f32::NEG_INFINITY, f32::INFINITY]];
    };
    let mut ranges = Vec::new();
    let mut start = first.1.then_some(f32::NEG_INFINITY);
    for (index, &(value, clear)) in points.iter().enumerate() {
        let steps = points.get(index + 1).is_some_and(|next| next.0 == value);
        match (start, clear) {
            (Some(begun), false) => {
                // Up to the point before, or to a step.
                let before = index.checked_sub(1).and_then(|before| points.get(before));
                let end = before.map_or(value, |before| if before.0 == value { value.next_down() } else { before.0 });
                if end >= begun {
                    ranges.push([begun, end]);
                }
                start = None;
            }
            (None, true) if !steps => start = Some(value),
            _ => {}
        }
    }
    ranges.extend(start.filter(|_| last.1).map(|begun| [begun, f32::INFINITY]));
    ranges
}

/// What two lists of ranges have in common.
fn common(one: &[[f32; 2]], other: &[[f32; 2]]) -> Vec<[f32; 2]> {
    let pairs = one.iter().flat_map(|a| other.iter().map(move |b| [a[0].max(b[0]), a[1].min(b[1])]));
    pairs.filter(|[low, high]| low <= high).collect()
}

/// The ranges without a range that goes over `value`, which belongs to the scalars from it on.
fn parted(ranges: &[[f32; 2]], value: f32) -> Vec<[f32; 2]> {
    let below = value.next_down();
    let parts = |&[low, high]: &[f32; 2]| {
        if low <= below && high >= value { vec![[low, below], [value, high]] } else { vec![[low, high]] }
    };
    ranges.iter().flat_map(parts).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{IorPoint, Isosurface, OpacityPoint};

    const ALL: [f32; 2] = [f32::NEG_INFINITY, f32::INFINITY];

    fn opaque(points: &[(f32, f32)]) -> Scene {
        let opacity = points.iter().map(|&(value, opacity)| OpacityPoint { value, opacity }).collect();
        let mut scene = Scene::default();
        scene.transfer.opacity = opacity;
        scene
    }

    #[test]
    fn nothing_is_shown_where_no_function_shows_anything() {
        let clear = |scene: &Scene| clear_ranges(scene, By::Both, || [0.0, 9.0]);
        // A ramp stands for no function.
        assert_eq!(clear(&Scene::default()), [[f32::NEG_INFINITY, 0.0]]);
        assert_eq!(clear(&opaque(&[(1.0, 0.0)])), [ALL]);
        assert_eq!(clear(&opaque(&[(1.0, 0.5)])), [[0.0; 2]; 0]);
        let peak = opaque(&[(1.0, 0.0), (2.0, 1.0), (3.0, 0.0), (4.0, 0.0), (5.0, 1.0)]);
        assert_eq!(clear(&peak), [[f32::NEG_INFINITY, 1.0], [3.0, 4.0]]);
        // A box by steps: its ends belong to what follows.
        let steps = opaque(&[(2.0, 0.0), (2.0, 1.0), (4.0, 1.0), (4.0, 0.0)]);
        assert_eq!(clear(&steps), [[f32::NEG_INFINITY, 2.0_f32.next_down()], [4.0, f32::INFINITY]]);
        let mut bends = peak.clone();
        bends.transfer.ior = vec![IorPoint::new(0.0, 1.0), IorPoint::new(3.5, 1.2)];
        assert_eq!(clear(&bends), [[f32::NEG_INFINITY, 0.0]]);
        assert_eq!(clear_ranges(&bends, By::Absorption, || [0.0, 9.0]), clear(&peak));
        bends.sweep.refraction = false;
        assert_eq!(clear(&bends), clear(&peak));
    }

    #[test]
    fn isosurfaces_part_ranges() {
        let mut scene = opaque(&[]);
        scene.isosurface = vec![Isosurface::new(2.0), Isosurface { opacity: 0.0, ..Isosurface::new(1.0) }];
        let below = 2.0_f32.next_down();
        assert_eq!(clear_ranges(&scene, By::Both, || [0.0, 9.0]), [[f32::NEG_INFINITY, below]]);
        // Matter below the surface, and clear ranges above it alone.
        scene.transfer.opacity = opaque(&[(1.0, 1.0), (3.0, 0.0)]).transfer.opacity;
        scene.isosurface.push(Isosurface::new(7.0));
        let above = [[3.0, 7.0_f32.next_down()], [7.0, f32::INFINITY]];
        assert_eq!(clear_ranges(&scene, By::Both, || [0.0, 9.0]), above);
    }
}
