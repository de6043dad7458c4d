//! The picture in the middle, and the hand on it.

use super::{Viewer, handles};
use crate::navigation::{self, Placed};
use eframe::egui::{
    Align2, CentralPanel, Color32, CursorIcon, FontId, Frame, Key, PointerButton, Pos2, Rect, Response, Role, Sense,
    Ui, Vec2, WidgetInfo, vec2,
};

/// Degrees that a drag across the picture's height rolls the camera.
const ROLLED: f32 = 180.0;

/// Points of scrolling that double the picture.
const DOUBLED: f32 = 220.0;

/// The largest picture that follows the window, in pixels along an edge.
const LARGEST: u32 = 4096;

impl Viewer {
    /// Shows the picture, and lets the hand turn it.
    pub(super) fn canvas(&mut self, ui: &mut Ui) {
        let frame = Frame::new().fill(ui.visuals().extreme_bg_color);
        CentralPanel::no_frame().frame(frame).show(ui, |ui| {
            let place = ui.available_rect_before_wrap();
            self.follow_window(place.size() * ui.pixels_per_point());
            let response = ui.allocate_rect(place, Sense::click_and_drag());
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "Picture"));
            let picture = self.picture_in(place);
            if let Some(texture) = self.pictures.texture() {
                let all = Rect::from_min_max(Pos2::ZERO, Pos2::new(1.0, 1.0));
                ui.painter().image(texture.id(), picture, all, Color32::WHITE);
            } else {
                let text = if self.pictures.is_waiting() { "The first picture is on its way …" } else { "" };
                let font = FontId::proportional(16.0);
                ui.painter().text(place.center(), Align2::CENTER_CENTER, text, font, ui.visuals().weak_text_color());
            }
            self.navigate(ui, &response, picture);
            if let Some(document) = self.document.as_mut().filter(|one| self.has_handles && one.editor.has_volume()) {
                let placed = Placed::new(&document.scene, document.bounds());
                handles::show(ui, &placed, picture, &mut document.scene);
            }
            self.trouble_over(ui, place);
        });
    }

    /// The picture is as large as its place, unless the user has chosen a size.
    fn follow_window(&mut self, place: Vec2) {
        let pixels = [place.x, place.y].map(|edge| (edge as u32).clamp(16, LARGEST));
        self.place = pixels;
        if let Some(document) = &mut self.document {
            let film = &mut document.scene.film;
            [film.width, film.height] = self.size.unwrap_or(pixels);
        }
    }

    /// The place of the picture: in the middle, as large as fits.
    fn picture_in(&self, place: Rect) -> Rect {
        let Some(document) = &self.document else { return place };
        let film = &document.scene.film;
        let size = vec2(film.width as f32, film.height as f32);
        let scale = (place.width() / size.x).min(place.height() / size.y);
        // A picture of the window's own size is shown pixel by pixel.
        if self.size.is_none() { place } else { Rect::from_center_size(place.center(), size * scale) }
    }

    fn navigate(&mut self, ui: &Ui, response: &Response, picture: Rect) {
        let Some(document) = &mut self.document else { return };
        let bounds = document.bounds();
        let (modifiers, rolls, lights) =
            ui.input(|input| (input.modifiers, input.key_down(Key::R), input.key_down(Key::L)));
        let scene = &mut document.scene;
        let delta = response.drag_delta();
        if delta != Vec2::ZERO {
            let shorter = picture.width().min(picture.height()).max(1.0);
            let across = [delta.x / shorter, delta.y / shorter];
            let pans = response.dragged_by(PointerButton::Secondary)
                || response.dragged_by(PointerButton::Middle)
                || modifiers.shift;
            let light = self.selected_light.min(scene.light.len().saturating_sub(1));
            if pans {
                navigation::pan(scene, bounds, [delta.x, delta.y].map(|points| points / picture.height().max(1.0)));
            } else if rolls || modifiers.command {
                navigation::roll(&mut scene.camera, -across[0] * ROLLED);
            } else if (lights || modifiers.alt) && !scene.light.is_empty() {
                navigation::turn_light(&mut scene.light[light], across.map(|share| share * 3.0));
            } else {
                navigation::orbit(scene, bounds, across);
            }
        }
        if response.hovered() {
            let (scrolled, pinched) = ui.input(|input| (input.smooth_scroll_delta(), input.zoom_delta()));
            let factor = libm::exp2f(scrolled.y / DOUBLED) * pinched;
            if factor != 1.0 {
                navigation::zoom(&mut scene.camera, factor);
            }
            if response.dragged() {
                ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
            }
        }
        if response.double_clicked() {
            scene.camera = document.home.camera.clone();
        }
    }
}
