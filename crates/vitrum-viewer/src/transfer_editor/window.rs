//! The axis of values with the window on it: two ends and a bar between them, which are dragged.

use super::area::{Area, MARGIN};
use super::axis::{Axis, number};
use super::function::Function;
use super::model::TransferEditor;

use eframe::egui::{
    Align2, CursorIcon, FontId, PointerButton, Rect, Response, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use vitrum::scene::Scene;

/// The most numbers along an axis.
pub const MOST_TICKS: usize = 6;

/// Points of the window by which the right button is dragged up to make the values' window 2.7 times as wide.
const PER_FACTOR: f32 = 120.0;

/// Height of the bar of the window.
const BAR: f32 = 9.0;

/// Shows the axis of the shown volume's values, and the window.
pub fn show(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene, axis: Axis) {
    let (outer, response) = ui.allocate_exact_size(vec2(ui.available_width().max(120.0), BAR + 3.0), Sense::hover());
    let left = outer.left() + MARGIN;
    let width = outer.width() - 2.0 * MARGIN;
    let window = editor.window(scene);
    let [low, high] = window.map(|end| left + axis.share(end).clamp(-0.02, 1.02) * width);
    let middle = outer.top() + 0.5 * BAR + 1.0;
    let color = ui.visuals().selection.bg_fill;
    let painter = ui.painter();
    painter.hline(left..=left + width, middle, ui.visuals().widgets.noninteractive.bg_stroke);
    let bar =
        Rect::from_min_max(pos2(low + 5.0, middle - 0.5 * BAR), pos2((high - 5.0).max(low + 6.0), middle + 0.5 * BAR));
    painter.rect_filled(bar.shrink2(vec2(0.0, 2.0)), 2.0, color.gamma_multiply(0.6));
    let per_point = (axis.range[1] - axis.range[0]) / width;
    let parts = [
        (bar, "window", CursorIcon::Grab, [1.0, 1.0]),
        (end(low, middle), "low end of the window", CursorIcon::ResizeHorizontal, [1.0, 0.0]),
        (end(high, middle), "high end of the window", CursorIcon::ResizeHorizontal, [0.0, 1.0]),
    ];
    for (rect, label, cursor, follows) in parts {
        let part = ui.interact(rect, response.id.with(label), Sense::drag()).on_hover_and_drag_cursor(cursor);
        let value = f64::from(window[usize::from(follows == [0.0, 1.0])]);
        part.widget_info(|| WidgetInfo {
            value: Some(value),
            ..WidgetInfo::labeled(Role::Slider, ui.is_enabled(), label)
        });
        if follows != [1.0, 1.0] {
            let side = if follows[0] == 1.0 { 1.0 } else { -1.0 };
            let x = rect.center().x;
            let triangle = vec![
                pos2(x - 4.0 * side, middle - 5.5),
                pos2(x - 4.0 * side, middle + 5.5),
                pos2(x + 5.0 * side, middle),
            ];
            let edge = Stroke::new(1.0, ui.visuals().text_color());
            let fill = if part.hovered() || part.dragged() { ui.visuals().text_color() } else { color };
            painter.add(Shape::convex_polygon(triangle, fill, edge));
        }
        if let Some(moved) = moved(ui, &part, PointerButton::Primary) {
            let start = editor.stretch_began().unwrap_or(window);
            let shift = moved[0] * per_point;
            editor.stretch(scene, [start[0] + follows[0] * shift, start[1] + follows[1] * shift]);
        }
        if part.drag_stopped() {
            editor.end_stretch();
        }
        part.on_hover_text(format!(
            "The functions change from {} to {}. Drag an end, or the bar; or drag in a plot with the right button.",
            number(window[0]),
            number(window[1])
        ));
    }
    ticks(ui, axis, editor.unit(Function::Opacity));
}

fn end(x: f32, middle: f32) -> Rect {
    Rect::from_center_size(pos2(x, middle), vec2(12.0, BAR + 3.0))
}

/// How far the pointer has moved since `button` was pressed on what is dragged.
fn moved(ui: &Ui, response: &Response, button: PointerButton) -> Option<[f32; 2]> {
    if !response.dragged_by(button) {
        return None;
    }
    let (origin, now) = ui.input(|input| (input.pointer.press_origin(), input.pointer.latest_pos()));
    origin.zip(now).map(|(origin, now)| [now.x - origin.x, now.y - origin.y])
}

/// Shows round values along an axis, and their unit.
pub fn ticks(ui: &mut Ui, axis: Axis, unit: Option<&str>) {
    let (outer, _) = ui.allocate_exact_size(vec2(ui.available_width().max(120.0), 12.0), Sense::hover());
    let painter = ui.painter().with_clip_rect(outer.intersect(ui.clip_rect()));
    let (left, width) = (outer.left() + MARGIN, outer.width() - 2.0 * MARGIN);
    let color = ui.visuals().weak_text_color();
    let mut free_from = f32::NEG_INFINITY;
    for value in axis.ticks(MOST_TICKS) {
        let x = left + axis.share(value) * width;
        let galley = painter.layout_no_wrap(number(value), FontId::proportional(10.0), color);
        let at = (x - 0.5 * galley.size().x).clamp(outer.left(), (outer.right() - galley.size().x).max(outer.left()));
        if at > free_from + 4.0 {
            free_from = at + galley.size().x;
            painter.galley(pos2(at, outer.top()), galley, color);
        }
    }
    if let Some(unit) = unit {
        let galley = painter.layout_no_wrap(unit.to_owned(), FontId::proportional(10.0), color);
        let at = outer.right() - galley.size().x;
        if at > free_from + 4.0 {
            painter.text(pos2(outer.right(), outer.top()), Align2::RIGHT_TOP, unit, FontId::proportional(10.0), color);
        }
    }
}

/// Window and level by dragging the right button: to the sides for the level, up and down for the width.
pub fn drag_by_the_right_button(
    ui: &Ui,
    response: &Response,
    area: Area,
    editor: &mut TransferEditor,
    scene: &mut Scene,
) {
    if let Some([x, y]) = moved(ui, response, PointerButton::Secondary) {
        let [low, high] = editor.stretch_began().unwrap_or_else(|| editor.window(scene));
        let [first, last] = area.axis.range;
        let level = low.midpoint(high) + x / area.rect.width() * (last - first);
        let half = 0.5 * (high - low) * libm::expf(-y / PER_FACTOR);
        editor.stretch(scene, [level - half, level + half]);
    }
    if response.drag_stopped_by(PointerButton::Secondary) {
        editor.end_stretch();
    }
}

/// Zooms the axis around the pointer by Ctrl and the wheel, or by two fingers.
pub fn zoom(ui: &Ui, response: &Response, area: Area, editor: &mut TransferEditor, function: Function) {
    let Some(pointer) = response.hover_pos() else { return };
    let factor = ui.input(|input| input.zoom_delta());
    let is_shared = function != Function::Ior || !editor.has_ior_volume();
    if factor != 1.0 && is_shared {
        let share = (pointer.x - area.rect.left()) / area.rect.width();
        editor.zoom(Some(area.axis.zoomed(share.clamp(0.0, 1.0), 1.0 / factor)));
    }
}
