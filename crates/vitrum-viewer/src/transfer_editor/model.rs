//! The model of the editor: what is edited and how, without a window.

use super::axis::Axis;
use super::function::Function;
use super::gradients::Gradients;
use super::histogram::Histogram;
use super::look::{look_of, with_look_of};
use super::spots::{Spot, at};
use super::stretch::Stretched;
use crate::history::History;
use std::sync::Arc;
use vitrum::Subject;
use vitrum::io::Volume;
use vitrum::scene::Scene;

/// The editor of a scene's transfer functions over the volume's histogram, with undo and redo.
///
/// Making one takes as long as counting the volume's voxels; it may be made on another thread.
#[derive(Debug, Clone)]
pub struct TransferEditor {
    pub(super) subject: Subject,
    pub(super) histogram: Option<Histogram>,
    ior_histogram: Option<Histogram>,
    gradients: Option<Gradients>,
    pub(super) history: History<Scene>,
    axes: [Axis; 2],
    zoomed: Option<Axis>,
    pub(super) stretched: Option<Stretched>,
    /// The point that number fields and keys are about.
    pub selected: Option<(Function, usize)>,
    /// The point of which a drag goes on, as it was at the beginning, and the pointer's place then.
    pub(super) grabbed: Option<(Spot, [f32; 2])>,
    /// Limits of the plot of the index of refraction, which stay while a point is dragged.
    pub(super) ior_limits: [f32; 2],
    /// Whether low opacities are drawn higher than they are.
    pub(super) magnified: bool,
    /// Whether gradients are drawn behind the opacity.
    pub(super) with_gradients: bool,
    /// The path that is written in the menu of files.
    pub(super) path: String,
    /// What the last file or preset had to tell, and whether it is an error.
    pub(super) told: Option<(String, bool)>,
}

impl TransferEditor {
    /// An editor for `scene`, which shows `subject`.
    #[must_use]
    pub fn new(scene: &Scene, subject: &Subject) -> Self {
        let volumes = subject.volumes();
        let histogram = volumes.map(|volumes| Histogram::of(volumes.shown));
        let ior_histogram = volumes.and_then(|volumes| volumes.ior).map(Histogram::of);
        let mut editor = Self {
            subject: subject.clone(),
            histogram,
            ior_histogram,
            gradients: volumes.map(|volumes| Gradients::of(volumes.shown)),
            history: History::new(look_of(scene)),
            axes: [Axis::over([0.0, 1.0]); 2],
            zoomed: None,
            stretched: None,
            selected: None,
            grabbed: None,
            ior_limits: [1.0, 1.5],
            magnified: has_low_opacities(scene),
            with_gradients: false,
            path: String::new(),
            told: None,
        };
        editor.fit_axes(scene);
        editor
    }

    /// Whether there is a volume, and with it a transfer function.
    #[must_use]
    pub fn has_volume(&self) -> bool {
        self.subject.volumes().is_some()
    }

    /// Whether the index of refraction is one of another volume's values.
    #[must_use]
    pub fn has_ior_volume(&self) -> bool {
        self.ior_histogram.is_some()
    }

    fn volume(&self, function: Function) -> Option<&Volume> {
        let volumes = self.subject.volumes()?;
        Some(if function == Function::Ior { volumes.bending() } else { volumes.shown })
    }

    /// The histogram of the values that a function is over.
    #[must_use]
    pub fn histogram(&self, function: Function) -> Option<&Histogram> {
        let of_ior = self.ior_histogram.as_ref().filter(|_| function == Function::Ior);
        of_ior.or(self.histogram.as_ref())
    }

    /// The histogram over value and gradient of the shown volume.
    pub(super) fn gradients(&self) -> Option<&Gradients> {
        self.gradients.as_ref()
    }

    /// The unit of a function's values, where the volume's file says it.
    #[must_use]
    pub fn unit(&self, function: Function) -> Option<&str> {
        let facts = self.volume(function)?.source.assumptions.stated();
        facts.iter().find(|fact| fact.name == "values").map(|fact| fact.value.as_str())
    }

    /// The axis of a function's values.
    #[must_use]
    pub fn axis(&self, function: Function) -> Axis {
        if function == Function::Ior && self.has_ior_volume() {
            return self.axes[1];
        }
        self.zoomed.unwrap_or(self.axes[0])
    }

    /// The axis of all values of the shown volume.
    pub(super) fn whole_axis(&self) -> Axis {
        self.axes[0]
    }

    /// Shows a part of the values; all of them by `None`.
    pub fn zoom(&mut self, axis: Option<Axis>) {
        let [low, high] = self.axes[0].range;
        let whole = |axis: &Axis| axis.range[0] <= low && axis.range[1] >= high;
        self.zoomed = axis.filter(|axis| !whole(axis));
    }

    /// Whether a point or the window is being dragged.
    #[must_use]
    pub fn is_dragging(&self) -> bool {
        self.grabbed.is_some() || self.stretched.is_some()
    }

    /// Whether there is a step to take back.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        self.history.can_undo()
    }

    /// Whether there is a step to do again.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    /// Takes notice of a look that has been changed elsewhere: it is a step of its own, all such changes in a row together.
    pub fn follow(&mut self, scene: &Scene) {
        self.history.record(look_of(scene), Some("elsewhere"));
        if !self.is_dragging() {
            self.fit_axes(scene);
        }
        let is_there = |(function, index): &(Function, usize)| *index < function.spots(&scene.transfer).len();
        self.selected = self.selected.filter(is_there);
    }

    /// Lets the axes reach over all points.
    fn fit_axes(&mut self, scene: &Scene) {
        let hull = |histogram: Option<&Histogram>, functions: &[Function]| {
            let [low, high] = histogram.map_or([0.0, 1.0], |histogram| histogram.range);
            let points = functions.iter().flat_map(|function| function.spots(&scene.transfer));
            let ends = points.fold([low, high], |[low, high], spot| [low.min(spot.value), high.max(spot.value)]);
            Axis::over(ends)
        };
        let of_shown = [Function::Opacity, Function::Color, Function::Filter];
        let all = if self.has_ior_volume() { &of_shown[..] } else { &Function::ALL[..] };
        self.axes = [hull(self.histogram.as_ref(), all), hull(self.ior_histogram.as_ref(), &[Function::Ior])];
        let levels = Function::Ior.spots(&scene.transfer).into_iter().map(|spot| spot.level[0]);
        let [low, high] = levels.fold([1.0_f32, 1.5_f32], |[low, high], level| [low.min(level), high.max(level)]);
        self.ior_limits = [(low * 10.0 - 0.5).floor() / 10.0, (high * 10.0 + 0.5).ceil() / 10.0];
    }

    /// The points of a function, or those that an empty list stands for.
    #[must_use]
    pub fn shown_spots(&self, scene: &Scene, function: Function) -> Vec<Spot> {
        let spots = function.spots(&scene.transfer);
        if !spots.is_empty() {
            return spots;
        }
        let [low, high] = self.histogram(function).map_or([0.0, 1.0], |histogram| histogram.range);
        let [first, last] = match function {
            Function::Opacity if scene.isosurface.is_empty() => [[0.0; 3], [1.0, 0.0, 0.0]],
            Function::Opacity => [[0.0; 3]; 2],
            Function::Ior => [[scene.surroundings.ior, 0.0, 0.0]; 2],
            Function::Color | Function::Filter => [[1.0; 3]; 2],
        };
        vec![Spot { value: low, level: first }, Spot { value: high, level: last }]
    }

    /// What a function is at a value.
    #[must_use]
    pub fn level(&self, scene: &Scene, function: Function, value: f32) -> [f32; 3] {
        at(&self.shown_spots(scene, function), value).unwrap_or_default()
    }

    pub(super) fn record(&mut self, scene: &Scene, gesture: Option<&'static str>) {
        self.history.record(look_of(scene), gesture);
    }

    /// Adds a point, on the function where no level is given, and selects it.
    pub fn add(&mut self, scene: &mut Scene, function: Function, value: f32, level: Option<[f32; 3]>) {
        let level = level.unwrap_or_else(|| self.level(scene, function, value));
        if function.spots(&scene.transfer).is_empty() {
            let ends = self.shown_spots(scene, function);
            function.set_spots(&mut scene.transfer, &ends);
        }
        let index = function.add(&mut scene.transfer, Spot { value, level });
        self.selected = Some((function, index));
        self.record(scene, None);
    }

    /// Moves a point within its limits, and selects it. All moves until the drag ends are one step.
    pub fn move_to(&mut self, scene: &mut Scene, function: Function, index: usize, spot: Spot) {
        if function.move_to(&mut scene.transfer, index, spot).is_some() {
            self.selected = Some((function, index));
            self.record(scene, Some("move a point"));
        }
    }

    /// Removes a point.
    pub fn remove(&mut self, scene: &mut Scene, function: Function, index: usize) {
        if function.remove(&mut scene.transfer, index) {
            self.selected = None;
            self.grabbed = None;
            self.record(scene, None);
        }
    }

    /// Takes the last step back.
    pub fn undo(&mut self, scene: &mut Scene) {
        if let Some(look) = self.history.undo() {
            *scene = with_look_of(look, scene);
        }
        self.follow(scene);
    }

    /// Does the step again that was taken back last.
    pub fn redo(&mut self, scene: &mut Scene) {
        if let Some(look) = self.history.redo() {
            *scene = with_look_of(look, scene);
        }
        self.follow(scene);
    }

    /// The shown volume, shared.
    #[must_use]
    pub fn shared_volume(&self) -> Option<Arc<Volume>> {
        match &self.subject {
            Subject::Volume(shown) | Subject::Volumes { shown, .. } => Some(Arc::clone(shown)),
            Subject::Mesh(_) => None,
        }
    }
}

/// Whether all opacities are so low that a plot up to 1 does not show their course, as those of fog.
pub(super) fn has_low_opacities(scene: &Scene) -> bool {
    let most = scene.transfer.opacity.iter().map(|point| point.opacity).fold(0.0, f32::max);
    most > 0.0 && most < 0.25
}
