//! The scalars at which a scene shows something.

use crate::scene::Scene;

/// The share of light that must be taken away for matter to be seen.
const LEAST_OPACITY: f32 = 0.02;

/// Matter is that much long where [`LEAST_OPACITY`] is taken away, as a share of the volume's longest edge.
const LENGTH: f32 = 1.0 / 64.0;

/// The difference of indices of refraction that is seen.
const LEAST_CONTRAST: f32 = 2e-3;

/// The scalars at which a scene shows something: ranges in ascending order, ends included.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Visible(Vec<[f32; 2]>);

/// The parts of a scene that show scalars.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum By {
    /// Opacity and filter.
    Absorption,
    /// The index of refraction.
    Bending,
    /// All of them.
    Both,
}

impl Visible {
    /// The scalars that show in a volume of this extent and range, whose smallest voxel edge is `finest`.
    pub(crate) fn new(scene: &Scene, by: By, (extent, range, finest): ([f32; 3], [f32; 2], f32)) -> Self {
        let transfer = &scene.transfer;
        let longest = extent.into_iter().fold(0.0, f32::max);
        let reference = transfer.reference_length.unwrap_or(finest);
        // Taken away by one reference length.
        let least = 1.0 - libm::powf(1.0 - LEAST_OPACITY, reference / (longest * LENGTH));
        let mut ranges = Vec::new();
        if by != By::Bending {
            let mut opacity: Vec<_> = transfer.opacity.iter().map(|point| [point.value, point.opacity]).collect();
            if scene.has_usual_opacity() {
                opacity = vec![[range[0], 0.0], [range[1], 1.0]];
            }
            above(&opacity, least, &mut ranges);
            // Of matter with a surface the inside is taken, which is where its scalars are larger.
            let seen = scene.isosurface.iter().filter(|surface| surface.opacity > LEAST_OPACITY);
            ranges.extend(seen.map(|surface| [surface.value, f32::INFINITY]));
            for channel in 0..3 {
                let taken = |point: &crate::scene::ColorPoint| [point.value, 1.0 - point.color[channel]];
                above(&transfer.filter.iter().map(taken).collect::<Vec<_>>(), least, &mut ranges);
            }
        }
        if by != By::Absorption && scene.sweep.refraction {
            for sign in [-1.0, 1.0] {
                let contrast =
                    |point: &crate::scene::IorPoint| [point.value, sign * (point.ior - scene.surroundings.ior)];
                above(&transfer.ior.iter().map(contrast).collect::<Vec<_>>(), LEAST_CONTRAST, &mut ranges);
            }
        }
        Self(merged(ranges))
    }

    /// Whether a scalar shows.
    pub(crate) fn holds(&self, scalar: f32) -> bool {
        self.0.iter().any(|&[low, high]| scalar >= low && scalar <= high)
    }
}

/// Adds the ranges over which the line through `points` is above `least`; beyond its ends it goes on level.
fn above(points: &[[f32; 2]], least: f32, ranges: &mut Vec<[f32; 2]>) {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
    if first[1] > least {
        ranges.push([f32::NEG_INFINITY, first[0]]);
    }
    if last[1] > least {
        ranges.push([last[0], f32::INFINITY]);
    }
    for pair in points.windows(2) {
        let [[from, low], [to, high]] = [pair[0], pair[1]];
        let crossing = || from + (to - from) * ((least - low) / (high - low));
        match (low > least, high > least) {
            (true, true) => ranges.push([from, to]),
            (true, false) => ranges.push([from, crossing()]),
            (false, true) => ranges.push([crossing(), to]),
            (false, false) => {}
        }
    }
}

fn merged(mut ranges: Vec<[f32; 2]>) -> Vec<[f32; 2]> {
    ranges.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut merged: Vec<[f32; 2]> = Vec::new();
    for [low, high] in ranges {
        match merged.last_mut() {
            Some(last) if low <= last[1] => last[1] = last[1].max(high),
            _ => merged.push([low, high]),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{IorPoint, OpacityPoint};

    #[test]
    fn scalars_show_where_they_take_light_or_bend_it() {
        let mut scene = Scene::default();
        scene.transfer.reference_length = Some(1.0);
        let opacity = |value, opacity| OpacityPoint { value, opacity };
        scene.transfer.opacity = vec![opacity(0.0, 0.0), opacity(10.0, 0.0), opacity(20.0, 1.0), opacity(20.0, 0.0)];
        let volume = ([64.0; 3], [0.0, 100.0], 1.0);
        let shows = |scene: &Scene, by| {
            let visible = Visible::new(scene, by, volume);
            [-5.0, 5.0, 10.1, 10.3, 19.0, 21.0, 60.0, 90.0].map(|scalar| visible.holds(scalar))
        };
        let opaque = [false, false, false, true, true, false, false, false];
        assert_eq!(shows(&scene, By::Both), opaque);
        scene.transfer.ior = vec![IorPoint::new(50.0, 1.0), IorPoint::new(55.0, 1.3), IorPoint::new(80.0, 1.0)];
        assert_eq!(shows(&scene, By::Absorption), opaque);
        assert_eq!(shows(&scene, By::Bending), [false, false, false, false, false, false, true, false]);
        scene.sweep.refraction = false;
        assert_eq!(shows(&scene, By::Both), opaque);
        // An empty function is a ramp.
        scene.transfer.opacity.clear();
        assert_eq!(shows(&scene, By::Both), [false, true, true, true, true, true, true, true]);
    }
}
