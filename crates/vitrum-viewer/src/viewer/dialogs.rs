//! Dialogs, and what went wrong.

use super::keys::KEYS;
use super::{Dialog, Viewer};
use crate::chooser::Choice;
use crate::trouble::Trouble;
use eframe::egui::{Context, DragValue, Frame, Grid, Rect, RichText, Ui, UiBuilder, Window, vec2};
use vitrum::backend;

/// Width of the panel of what went wrong, in points.
const WIDTH: f32 = 460.0;

impl Viewer {
    /// What went wrong, over a place, and what to do about it.
    pub(super) fn trouble_over(&mut self, ui: &mut Ui, place: Rect) {
        let Some(Trouble { message, help, .. }) = self.trouble.clone() else { return };
        let width = WIDTH.min(place.width() - 24.0).max(120.0);
        let corner = place.center_top() + vec2(-0.5 * width, 12.0);
        let rect = Rect::from_min_size(corner, vec2(width, place.height() - 24.0));
        let mut panel = ui.new_child(UiBuilder::new().max_rect(rect));
        Frame::popup(panel.style()).show(&mut panel, |ui| {
            ui.set_width(width - 16.0);
            ui.label(RichText::new(&message).color(ui.visuals().error_fg_color).strong());
            if !help.is_empty() {
                ui.label(format!("What to do: {help}."));
            }
            ui.horizontal(|ui| {
                if ui.button("Close").clicked() {
                    self.trouble = None;
                }
                let can_undo = self.document.as_ref().is_some_and(|document| document.history.can_undo());
                if can_undo && ui.button("Undo the last change").clicked() {
                    self.trouble = None;
                    self.undo();
                }
                if self.backend == backend::Choice::Gpu && ui.button("Render on the CPU").clicked() {
                    self.trouble = None;
                    self.backend = backend::Choice::Cpu;
                }
            });
        });
    }

    pub(super) fn dialogs(&mut self, context: &Context) {
        let Some(mut dialog) = self.dialog.take() else { return };
        let mut open = true;
        let choice = match &mut dialog {
            Dialog::Open(chooser) => {
                let folder = chooser.folder().to_owned();
                let mut whole = false;
                let choice = chooser.show(context, |ui| {
                    whole = ui.button("Open this folder").on_hover_text("A folder of DICOM or TIFF files").clicked();
                });
                if whole { Choice::Chosen(folder) } else { choice }
            }
            Dialog::SaveScene(chooser) => chooser.show(context, |ui| {
                ui.weak("A text file; `vitrum render` makes the same picture of it.");
            }),
            Dialog::SavePicture(chooser, size) => chooser.show(context, |ui| {
                ui.horizontal(|ui| {
                    let [width, height] = size;
                    ui.add(DragValue::new(width).range(1..=16384)).accessible_name("Pixels across");
                    ui.label("×");
                    ui.add(DragValue::new(height).range(1..=16384)).accessible_name("Pixels down");
                    ui.weak(".png, .jpg, .exr with all outputs, .hdr or .tif");
                });
            }),
            Dialog::SaveAnimation(chooser, animation) => chooser.show(context, |ui| animation.show(ui)),
            Dialog::Keys => {
                Window::new("Mouse and keys").collapsible(false).resizable(false).open(&mut open).show(context, keys);
                Choice::Open
            }
            Dialog::About => {
                Window::new("About Vitrum").collapsible(false).resizable(false).open(&mut open).show(context, |ui| {
                    ui.heading("Vitrum");
                    ui.label(format!("Version {}", env!("CARGO_PKG_VERSION")));
                    ui.label("Renders volumes with refraction, coloured transmission, soft shadows and caustics.");
                });
                Choice::Open
            }
        };
        match (choice, dialog) {
            (Choice::Open, dialog) => self.dialog = open.then_some(dialog),
            (Choice::Closed, _) => {}
            (Choice::Chosen(path), Dialog::Open(_)) => self.open(&path.display().to_string()),
            (Choice::Chosen(path), Dialog::SaveScene(_)) => self.save_scene(&path),
            (Choice::Chosen(path), Dialog::SavePicture(_, size)) => self.save_picture(&path, size),
            (Choice::Chosen(path), Dialog::SaveAnimation(_, animation)) => self.save_animation(&path, &animation),
            (Choice::Chosen(_), Dialog::Keys | Dialog::About) => {}
        }
    }
}

fn keys(ui: &mut Ui) {
    Grid::new("keys").striped(true).spacing([24.0, 4.0]).show(ui, |ui| {
        for (key, meaning) in KEYS {
            ui.strong(key);
            ui.label(meaning);
            ui.end_row();
        }
    });
}
