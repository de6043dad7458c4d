//! The editor of transfer functions: curves of opacity and index of refraction over the volume's histogram, strips of colour and filter.
//!
//! [`TransferEditor`] is the model, which knows nothing of windows: points, window, presets, maps of colours, files, undo and redo. [`show`] is its
//! widget.

mod area;
mod axis;
mod backdrop;
mod files;
mod function;
mod gradients;
mod handle;
mod histogram;
mod look;
mod model;
mod plot;
mod presets;
mod selected;
mod spots;
mod stretch;
mod strip;
mod toolbar;
mod window;

pub use axis::{Axis, number};
pub use function::Function;
pub use histogram::Histogram;
pub use model::TransferEditor;
pub use presets::show_presets;
pub(crate) use selected::exact as exact_field;
pub use spots::Spot;

use eframe::egui;
use vitrum::scene::Scene;

/// What the editor has done to the scene in a frame.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Change {
    /// Whether the scene is another one now.
    pub changed: bool,
    /// Whether something is being dragged: more changes are about to come.
    pub dragging: bool,
    /// The preset that was chosen, which has changed the whole look.
    pub preset: Option<&'static str>,
}

/// Shows the editor, as wide as there is room, and lets it change the scene's look.
pub fn show(ui: &mut egui::Ui, editor: &mut TransferEditor, scene: &mut Scene) -> Change {
    if !editor.has_volume() {
        ui.label("A mesh has no transfer function: its materials say what it looks like.");
        return Change::default();
    }
    let before = scene.clone();
    let mut change = Change::default();
    editor.follow(scene);
    ui.push_id("transfer editor", |ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        change.preset = toolbar::show(ui, editor, scene);
        let shown = editor.axis(Function::Opacity);
        plot::show(ui, editor, scene, Function::Opacity);
        window::show(ui, editor, scene, shown);
        strip::show(ui, editor, scene, Function::Color);
        plot::show(ui, editor, scene, Function::Ior);
        if editor.has_ior_volume() {
            window::ticks(ui, editor.axis(Function::Ior), editor.unit(Function::Ior));
        }
        strip::show(ui, editor, scene, Function::Filter);
        selected::show(ui, editor, scene);
        toolbar::message(ui, editor);
    });
    let is_held = ui.input(|input| input.pointer.any_down());
    if !is_held {
        editor.grabbed = None;
        editor.end_stretch();
    }
    change.changed = before != *scene;
    change.dragging = editor.is_dragging() || (change.changed && is_held);
    change
}
