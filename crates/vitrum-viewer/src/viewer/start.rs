//! The first page: what can be opened.

use super::Viewer;
use crate::loader::Request;
use crate::worker::{Sketch, SketchSubject};
use eframe::egui::{CentralPanel, Frame, Image, RichText, ScrollArea, Sense, Ui, UiBuilder, Vec2, vec2};
use vitrum::builtin;

/// Size of a scene's picture, in points.
const PICTURE: Vec2 = vec2(176.0, 132.0);

/// Pixels of a scene's picture.
const PIXELS: [u32; 2] = [192, 144];

impl Viewer {
    pub(super) fn start(&mut self, ui: &mut Ui) {
        CentralPanel::default_margins().show(ui, |ui| {
            let place = ui.available_rect_before_wrap();
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                ui.add_space(12.0);
                ui.vertical_centered(|ui| {
                    ui.heading(RichText::new("Vitrum").size(30.0));
                    ui.label("Drop a volume, a mesh, a scene or a folder of DICOM files here, or choose:");
                    ui.add_space(6.0);
                    if ui.button(RichText::new("Open …").size(16.0)).clicked() {
                        self.ask_open();
                    }
                    self.offer_session(ui);
                });
                if !self.session.recent.is_empty() {
                    ui.add_space(8.0);
                    ui.strong("Recent");
                    for input in self.session.recent.clone() {
                        if ui.link(&input).clicked() {
                            self.open(&input);
                        }
                    }
                }
                ui.add_space(8.0);
                ui.strong("Built-in scenes");
                ui.add_space(4.0);
                self.gallery(ui);
            });
            self.trouble_over(ui, place);
        });
    }

    /// The document that was open when the program ended without being closed.
    fn offer_session(&mut self, ui: &mut Ui) {
        let Some(saved) = self.session.open.clone() else { return };
        ui.add_space(8.0);
        Frame::group(ui.style()).show(ui, |ui| {
            ui.label(format!("The last session was not closed. It showed {}.", saved.input));
            ui.horizontal(|ui| {
                if ui.button("Go on with it").clicked() {
                    self.load(Request::Restore { input: saved.input.clone(), scene: saved.scene.clone() });
                }
                if ui.button("Forget it").clicked() {
                    self.session.open = None;
                    self.write_session();
                }
            });
        });
    }

    fn gallery(&mut self, ui: &mut Ui) {
        if self.sketches.is_empty() && self.loading.is_none() {
            for (name, _) in builtin::names() {
                let subject = SketchSubject::BuiltIn(name);
                self.sketch(Sketch { name: sketch_name(name), size: PIXELS, subject });
            }
        }
        let mut chosen = None;
        ui.horizontal_wrapped(|ui| {
            for (name, description) in builtin::names() {
                let size = PICTURE + vec2(0.0, 22.0);
                let (rect, response) = ui.allocate_exact_size(size, Sense::click());
                let is_lit = response.hovered() || response.has_focus();
                response.widget_info(|| eframe::egui::WidgetInfo::labeled(eframe::egui::Role::Button, true, *name));
                let mut tile = ui.new_child(UiBuilder::new().max_rect(rect));
                let fill = if is_lit { ui.visuals().widgets.hovered.bg_fill } else { ui.visuals().faint_bg_color };
                tile.painter().rect_filled(rect, 4.0, fill);
                match self.sketches.get(&sketch_name(name)).and_then(Option::as_ref) {
                    Some(texture) => {
                        tile.add(Image::new(texture).fit_to_exact_size(PICTURE).alt_text(*name));
                    }
                    None => {
                        tile.allocate_space(PICTURE);
                    }
                }
                tile.vertical_centered(|ui| ui.add(eframe::egui::Label::new(*name).selectable(false)));
                if response.on_hover_text(*description).clicked() {
                    chosen = Some(*name);
                }
            }
        });
        if let Some(name) = chosen {
            self.open(&format!("builtin:{name}"));
        }
    }
}

/// The name under which a built-in scene's picture is known.
fn sketch_name(scene: &str) -> String {
    format!("scene {scene}")
}
