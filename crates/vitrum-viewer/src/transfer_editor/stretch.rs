//! The window of values, and its stretching.

use super::function::Function;
use super::model::TransferEditor;
use vitrum::preset::{self, Adjustments};
use vitrum::scene::{Scene, TransferFunction};

/// Where a drag of the window began: the function, and the range over which it changed.
#[derive(Debug, Clone)]
pub struct Stretched {
    transfer: TransferFunction,
    range: [f32; 2],
}

impl TransferEditor {
    /// The window: the range over which the functions change.
    #[must_use]
    pub fn window(&self, scene: &Scene) -> [f32; 2] {
        let with_ior = !self.has_ior_volume();
        let functions = Function::ALL.into_iter().filter(|function| with_ior || *function != Function::Ior);
        let values = functions.flat_map(|function| function.spots(&scene.transfer)).map(|spot| spot.value);
        let range = self.histogram.as_ref().map_or([0.0, 1.0], |histogram| histogram.range);
        // No points of opacity stand for a ramp over the range.
        let is_ramp = scene.transfer.opacity.is_empty() && scene.isosurface.is_empty();
        let values = values.chain(range.into_iter().filter(|_| is_ramp));
        let [low, high] = values.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        if low < high { [low, high] } else { range }
    }

    /// Stretches all functions of the volume to another window. All that follow until [`Self::end_stretch`] begin at the same function and are one step, so
    /// that nothing is lost by rounding.
    pub fn stretch(&mut self, scene: &mut Scene, [low, high]: [f32; 2]) {
        let range = self.window(scene);
        let start = self.stretched.get_or_insert_with(|| Stretched { transfer: scene.transfer.clone(), range });
        // Narrower than this the points would fall together.
        let least = 1e-3 * (start.range[1] - start.range[0]);
        if !(high - low >= least && low.is_finite() && high.is_finite()) {
            return;
        }
        if [low, high] == start.range {
            scene.transfer = start.transfer.clone();
            self.record(scene, Some("stretch"));
            return;
        }
        let mut stretched = Scene { transfer: start.transfer.clone(), ..scene.clone() };
        let adjustments = Adjustments { window: Some([high - low, low.midpoint(high)]), ..Adjustments::default() };
        let Some(volume) = self.subject.volume() else { return };
        if preset::adjust(volume, &adjustments, &mut stretched).is_ok() {
            scene.transfer = stretched.transfer;
            self.record(scene, Some("stretch"));
        }
    }

    /// The window at which a stretch that goes on has begun.
    #[must_use]
    pub fn stretch_began(&self) -> Option<[f32; 2]> {
        self.stretched.as_ref().map(|stretched| stretched.range)
    }

    /// Ends a stretch.
    pub fn end_stretch(&mut self) {
        self.stretched = None;
        self.history.end_gesture();
    }
}
