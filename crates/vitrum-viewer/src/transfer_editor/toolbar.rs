//! The row of buttons and menus above the plots, and what files and presets have to tell below them.

use super::model::TransferEditor;
use eframe::egui::{Button, TextEdit, Ui};
use std::path::PathBuf;
use vitrum::preset;
use vitrum::scene::Scene;

/// Shows the buttons; the preset that was chosen.
pub fn show(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene) -> Option<&'static str> {
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        if ui
            .add_enabled(editor.can_undo(), Button::new("Undo"))
            .on_hover_text("Take the last change of the look back")
            .clicked()
        {
            editor.undo(scene);
        }
        if ui.add_enabled(editor.can_redo(), Button::new("Redo")).on_hover_text("Do it again").clicked() {
            editor.redo(scene);
        }
        ui.separator();
        ui.menu_button("Presets", |ui| {
            for (name, description) in preset::names() {
                if ui.button(*name).on_hover_text(*description).clicked() {
                    chosen = Some(*name);
                }
            }
        });
        ui.menu_button("Colours", |ui| {
            for (name, description) in preset::colormap_names() {
                if ui.button(*name).on_hover_text(*description).clicked() {
                    editor.color_by(scene, name);
                }
            }
        });
        ui.menu_button("Files", |ui| files(ui, editor, scene));
        let magnify = ui.toggle_value(&mut editor.magnified, "Magnify");
        magnify.on_hover_text("Draw low opacities higher than they are: the height is their cube root");
        let gradients = ui.toggle_value(&mut editor.with_gradients, "Gradients");
        gradients.on_hover_text("Show the gradient of each value behind the opacity, upwards: surfaces between two kinds of matter are arcs");
        let is_zoomed = editor.axis(super::Function::Opacity) != editor.whole_axis();
        if is_zoomed
            && ui.button("All values").on_hover_text("Show the whole axis again; Ctrl and the wheel zoom it").clicked()
        {
            editor.zoom(None);
        }
    });
    chosen.filter(|name| editor.apply_preset(scene, name))
}

fn files(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene) {
    ui.label("A file of transfer functions");
    let field = TextEdit::singleline(&mut editor.path).hint_text("skull.vp, map.json").desired_width(260.0);
    ui.add(field).accessible_name("path of the file");
    let path = PathBuf::from(editor.path.trim());
    let is_named = !editor.path.trim().is_empty();
    ui.horizontal(|ui| {
        let import = ui.add_enabled(is_named, Button::new("Import"));
        if import
            .on_hover_text("3D Slicer (.vp, .json, MRML), ParaView (.json, .xml, .pvsm), VTK, lists of numbers")
            .clicked()
        {
            editor.import(scene, &path);
            ui.close();
        }
        let export = ui.add_enabled(is_named, Button::new("Export"));
        if export.on_hover_text("Colours and opacities as ParaView imports them (.json)").clicked() {
            editor.export(scene, &path);
            ui.close();
        }
    });
}

/// Shows what the last preset or file had to tell.
pub fn message(ui: &mut Ui, editor: &mut TransferEditor) {
    let Some((text, is_error)) = editor.told.clone() else { return };
    let color = if is_error { ui.visuals().error_fg_color } else { ui.visuals().weak_text_color() };
    ui.horizontal_wrapped(|ui| {
        ui.colored_label(color, text);
        if ui.small_button("×").accessible_name("close the message").clicked() {
            editor.told = None;
        }
    });
}
