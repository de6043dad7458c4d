//! Panels with a control for every key of a scene, made from the schema that the scene's documentation is made from.
//!
//! [`Panels`] is the model: it takes settings as `--set` does, and holds those back that do not fit the rest of the scene yet. [`show`] is the widget.

mod button;
mod command;
mod control;
mod list;
mod model;
mod row;
mod section;
mod values;

pub use command::command;
pub use model::Panels;

use eframe::egui::{self, RichText, TextEdit, Ui};
use vitrum::scene::{Control, Scene, form};

/// What the panels have done to the scene in a frame.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Change {
    /// Whether the scene is another one now.
    pub changed: bool,
    /// Whether something is being dragged: more changes are about to come.
    pub dragging: bool,
}

/// Shows all sections, and a field that finds keys in them.
pub fn show(ui: &mut Ui, panels: &mut Panels, scene: &mut Scene) -> Change {
    let names: Vec<&str> = form().iter().map(|field| field.name.as_str()).collect();
    ui.horizontal(|ui| {
        let find = TextEdit::singleline(&mut panels.filter).hint_text("Find a key: azimuth, shadow …");
        ui.add(find.desired_width((ui.available_width() - 30.0).max(80.0))).accessible_name("find a key");
        if !panels.filter.is_empty() && button::cross(ui, "find nothing").clicked() {
            panels.filter.clear();
        }
    });
    show_sections(ui, panels, scene, &names)
}

/// Shows the sections, and the keys outside of sections, that `names` names, in the order of the scene.
pub fn show_sections(ui: &mut Ui, panels: &mut Panels, scene: &mut Scene, names: &[&str]) -> Change {
    let before = scene.clone();
    ui.push_id("panels", |ui| {
        waiting(ui, panels);
        let fields = form().iter().filter(|field| names.contains(&field.name.as_str()));
        let (sections, alone): (Vec<_>, Vec<_>) =
            fields.partition(|field| matches!(field.control, Control::Section(_) | Control::Sections { .. }));
        let table = values::table(panels.shown(scene));
        let mut settings = Vec::new();
        {
            let mut view = row::View { panels, settings: &mut settings };
            row::rows(ui, &mut view, "", &alone, &table);
            for field in sections {
                section::show(ui, &mut view, &field.name, field, table.get(&field.name));
            }
        }
        for setting in settings {
            panels.set(scene, &setting);
        }
    });
    let changed = before != *scene;
    Change { changed, dragging: changed && ui.input(|input| input.pointer.any_down()) }
}

/// Says what holds changes back.
fn waiting(ui: &mut Ui, panels: &mut Panels) {
    let Some((key, text)) = panels.refusal() else { return };
    let text = if key.is_empty() { text.to_owned() } else { format!("{key}: {text}") };
    egui::Frame::group(ui.style()).show(ui, |ui| {
        let color = ui.visuals().error_fg_color;
        ui.label(RichText::new("Not in the picture yet").strong());
        ui.colored_label(color, text);
        if ui.button("Take back").on_hover_text("Forget the change that does not fit").clicked() {
            panels.take_back();
        }
    });
}
