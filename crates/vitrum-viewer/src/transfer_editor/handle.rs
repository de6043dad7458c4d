//! The handle of a point: dragged, selected, removed, and moved by the arrow keys.

use super::axis::number;
use super::function::Function;
use super::model::TransferEditor;
use super::spots::Spot;
use eframe::egui::{
    self, CursorIcon, EventFilter, Id, Key, PointerButton, Pos2, Rect, Response, Role, Sense, Ui, Vec2, WidgetInfo,
    vec2,
};
use vitrum::scene::Scene;

/// A point of a function, and where it stands in the window.
#[derive(Clone, Copy)]
pub struct Handle {
    pub function: Function,
    pub index: usize,
    pub spot: Spot,
    pub at: Pos2,
    pub size: Vec2,
}

/// From a point to its place in the window.
type Place<'a> = &'a dyn Fn(Spot) -> Pos2;

/// From a place in the window to a point; what cannot be read there is that of the point given.
type Read<'a> = &'a dyn Fn(Pos2, Spot) -> Spot;

impl Handle {
    /// Lets people move, select and remove the point.
    pub fn interact(
        self,
        ui: &Ui,
        id: Id,
        editor: &mut TransferEditor,
        scene: &mut Scene,
        place: Place<'_>,
        read: Read<'_>,
    ) -> Response {
        let Self { function, index, spot, at, size } = self;
        let response = ui.interact(Rect::from_center_size(at, size), id.with(index), Sense::click_and_drag());
        let response = response.on_hover_and_drag_cursor(CursorIcon::Grab);
        response.widget_info(|| {
            let label = format!("{} point {}", function.name(), index + 1);
            WidgetInfo {
                value: Some(f64::from(spot.value)),
                ..WidgetInfo::labeled(Role::Slider, ui.is_enabled(), label)
            }
        });
        if response.drag_started_by(PointerButton::Primary) {
            let origin = ui.input(|input| input.pointer.press_origin());
            editor.grabbed = origin.map(|origin| (spot, [origin.x, origin.y]));
            editor.selected = Some((function, index));
        }
        if response.clicked() || response.drag_started() {
            editor.selected = Some((function, index));
            response.request_focus();
        }
        if response.dragged_by(PointerButton::Primary) || response.drag_stopped_by(PointerButton::Primary) {
            let pointer = ui.input(|input| input.pointer.latest_pos());
            if let (Some((start, [x, y])), Some(pointer)) = (editor.grabbed, pointer) {
                let to = place(start) + (pointer - egui::pos2(x, y));
                // A click that trembles does not move the point.
                if pointer != egui::pos2(x, y) {
                    editor.move_to(scene, function, index, read(to, start));
                }
            }
        }
        if response.has_focus() {
            self.keys(ui, &response, editor, scene, place, read);
        }
        if response.secondary_clicked() {
            editor.remove(scene, function, index);
        }
        response
    }

    fn keys(
        self,
        ui: &Ui,
        response: &Response,
        editor: &mut TransferEditor,
        scene: &mut Scene,
        place: Place<'_>,
        read: Read<'_>,
    ) {
        let Self { function, index, spot, .. } = self;
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
        let (pressed, shift) = ui.input(|input| {
            let count = |key: Key| input.num_presses(key) as f32;
            let x = count(Key::ArrowRight) - count(Key::ArrowLeft);
            let y = count(Key::ArrowDown) - count(Key::ArrowUp);
            (vec2(x, y), input.modifiers.shift)
        });
        if pressed != Vec2::ZERO {
            let step = if shift { 10.0 } else { 1.0 };
            let to = read(place(spot) + pressed * step, spot);
            // A step in one direction leaves the other as it is.
            let value = if pressed.x == 0.0 { spot.value } else { to.value };
            let level = if pressed.y == 0.0 { spot.level } else { to.level };
            editor.move_to(scene, function, index, Spot { value, level });
        }
        if ui.input(|input| input.key_pressed(Key::Delete) || input.key_pressed(Key::Backspace)) {
            editor.remove(scene, function, index);
        }
    }
}

/// What a point says, for people.
pub fn described(function: Function, spot: Spot) -> String {
    let level = if function.is_of_color() { spot.level.map(number).join(", ") } else { number(spot.level[0]) };
    format!("{}: {} {level}", number(spot.value), function.name())
}
