//! Presets to choose from, by name or by pictures.

use eframe::egui::{self, Image, RichText, TextureId, Ui, vec2};
use vitrum::preset;

/// Edge of a preset's picture in the window.
const EDGE: f32 = 84.0;

/// Shows all presets of volumes: the picture that `picture` has of one, else its name; the one that was clicked.
pub fn show_presets(ui: &mut Ui, picture: &dyn Fn(&str) -> Option<TextureId>) -> Option<&'static str> {
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        for (name, description) in preset::names() {
            let clicked = match picture(name) {
                Some(texture) => {
                    ui.vertical(|ui| {
                        let image = Image::new((texture, vec2(EDGE, EDGE)));
                        let clicked = ui.add(egui::Button::image(image)).on_hover_text(*description).clicked();
                        ui.label(RichText::new(*name).small());
                        clicked
                    })
                    .inner
                }
                None => ui.button(*name).on_hover_text(*description).clicked(),
            };
            if clicked {
                chosen = Some(*name);
            }
        }
    });
    chosen
}
