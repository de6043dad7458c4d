//! Presets to choose from, by name or by pictures.

use eframe::egui::{self, Image, RichText, TextureId, Ui, vec2};
use vitrum::preset;

/// Edge of a preset's picture in the window.
const EDGE: f32 = 64.0;

/// Shows all presets of volumes: the pictures that `picture` has of them, in rows, then the names of the others; the one that was clicked.
pub fn show_presets(ui: &mut Ui, picture: &dyn Fn(&str) -> Option<TextureId>) -> Option<&'static str> {
    let mut chosen = None;
    let (pictured, named): (Vec<_>, Vec<_>) =
        preset::names().iter().copied().partition(|(name, _)| picture(name).is_some());
    let tile = EDGE + 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x;
    let across = ((ui.available_width() / tile) as usize).max(1);
    for row in pictured.chunks(across) {
        ui.horizontal(|ui| {
            for &(name, description) in row {
                let Some(texture) = picture(name) else { continue };
                ui.vertical(|ui| {
                    let button = egui::Button::image(Image::new((texture, vec2(EDGE, EDGE))));
                    if ui.add(button).on_hover_text(description).clicked() {
                        chosen = Some(name);
                    }
                    ui.label(RichText::new(name).small());
                });
            }
        });
    }
    ui.horizontal_wrapped(|ui| {
        for (name, description) in named {
            if ui.button(name).on_hover_text(description).clicked() {
                chosen = Some(name);
            }
        }
    });
    chosen
}
