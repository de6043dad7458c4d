//! The plot of a function that is a number: opacity, or index of refraction, over the histogram.

use super::area::{Area, MARGIN};
use super::axis::{Axis, number};
use super::backdrop;
use super::function::Function;
use super::handle::{Handle, described};
use super::model::TransferEditor;
use super::spots::{Spot, at};
use super::{strip, window};
use eframe::egui::{
    Align2, Color32, FontId, Pos2, Rect, Response, Role, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};
use vitrum::scene::Scene;

/// Distance from the curve up to which a click is one on the curve, in points of the window.
const NEAR: f32 = 6.0;

/// Shows the plot of `function`.
pub fn show(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene, function: Function) {
    let height = if function == Function::Opacity { 132.0 } else { 92.0 };
    let (outer, response) =
        ui.allocate_exact_size(vec2(ui.available_width().max(120.0), height), Sense::click_and_drag());
    let rect = outer.shrink2(vec2(MARGIN, MARGIN));
    let (limits, power) = match function {
        Function::Ior => (editor.ior_limits, 1.0),
        _ => (function.limits(), if editor.magnified { 1.0 / 3.0 } else { 1.0 }),
    };
    let area = Area { rect, axis: editor.axis(function), limits, power };
    let spots = editor.shown_spots(scene, function);
    response
        .widget_info(|| WidgetInfo::labeled(Role::Canvas, ui.is_enabled(), format!("plot of the {}", function.name())));
    window::drag_by_the_right_button(ui, &response, area, editor, scene);
    window::zoom(ui, &response, area, editor, function);
    paint(ui, outer, area, editor, scene, function, &spots);
    background(&response, area, editor, scene, function, &spots);
    handles(ui, &response, area, editor, scene, function);
}

/// A double click adds a point where it is, a click on the curve adds one on it; a click elsewhere selects nothing.
fn background(
    response: &Response,
    area: Area,
    editor: &mut TransferEditor,
    scene: &mut Scene,
    function: Function,
    spots: &[Spot],
) {
    let Some(pointer) = response.interact_pointer_pos() else { return };
    let value = area.value(pointer.x);
    let on_curve = at(spots, value).map(|level| (area.place(value, level[0]).y - pointer.y).abs() <= NEAR);
    if response.double_clicked() {
        editor.add(scene, function, value, Some([area.level(pointer.y), 0.0, 0.0]));
    } else if response.clicked() && on_curve == Some(true) {
        editor.add(scene, function, value, None);
    } else if response.clicked() {
        editor.selected = None;
    }
}

fn handles(
    ui: &Ui,
    response: &Response,
    area: Area,
    editor: &mut TransferEditor,
    scene: &mut Scene,
    function: Function,
) {
    let painter = ui.painter();
    let spots = function.spots(&scene.transfer);
    let small = spots.len() > 24;
    let colors = editor.shown_spots(scene, Function::Color);
    let ring = curve_color(ui, function);
    for (index, spot) in spots.into_iter().enumerate() {
        let at_x = area.x(spot.value);
        if !(area.rect.left() - 1.0..=area.rect.right() + 1.0).contains(&at_x) {
            continue;
        }
        let place = |spot: Spot| area.place(spot.value, spot.level[0]);
        let read = |at: Pos2, _: Spot| Spot { value: area.value(at.x), level: [area.level(at.y), 0.0, 0.0] };
        let size = if small { 9.0 } else { 14.0 };
        let handle = Handle { function, index, spot, at: place(spot), size: vec2(size, size) };
        let is_selected = editor.selected == Some((function, index));
        let handle_response = handle.interact(ui, response.id, editor, scene, &place, &read);
        let hot = is_selected || handle_response.hovered() || handle_response.dragged() || handle_response.has_focus();
        let radius = if small { 3.0 } else { 4.5 } + if hot { 1.5 } else { 0.0 };
        let fill = match function {
            Function::Opacity => strip::displayed(at(&colors, spot.value).unwrap_or([1.0; 3])),
            _ => ui.visuals().extreme_bg_color,
        };
        painter.circle(handle.at, radius, fill, Stroke::new(if is_selected { 2.5 } else { 1.5 }, ring));
        handle_response.on_hover_text(described(function, spot));
    }
}

fn curve_color(ui: &Ui, function: Function) -> Color32 {
    match (function, ui.visuals().dark_mode) {
        (Function::Ior, true) => Color32::from_rgb(255, 176, 84),
        (Function::Ior, false) => Color32::from_rgb(178, 88, 0),
        (_, true) => Color32::from_rgb(150, 205, 255),
        (_, false) => Color32::from_rgb(0, 92, 170),
    }
}

fn paint(ui: &Ui, outer: Rect, area: Area, editor: &TransferEditor, scene: &Scene, function: Function, spots: &[Spot]) {
    let visuals = ui.visuals();
    let edge = visuals.widgets.noninteractive.bg_stroke;
    ui.painter().rect(outer, 4.0, visuals.extreme_bg_color, edge, StrokeKind::Inside);
    let painter = ui.painter().with_clip_rect(outer.intersect(ui.clip_rect()));
    let faint = edge.color.gamma_multiply(0.6);
    for value in area.axis.ticks(window::MOST_TICKS) {
        painter.vline(area.x(value), area.rect.y_range(), Stroke::new(1.0, faint));
    }
    let levels = levels(area);
    for &level in &levels {
        painter.hline(area.rect.x_range(), area.place(0.0, level).y, Stroke::new(1.0, faint));
    }
    let behind = visuals.weak_text_color().gamma_multiply(if visuals.dark_mode { 0.35 } else { 0.45 });
    match editor.gradients().filter(|_| editor.with_gradients && function == Function::Opacity) {
        Some(gradients) => backdrop::cells(&painter, area, gradients, visuals.weak_text_color()),
        None => backdrop::bars(&painter, area, editor, function, behind),
    }
    if function == Function::Opacity {
        backdrop::fill(&painter, area, spots, &editor.shown_spots(scene, Function::Color));
    }
    let implied = function.spots(&scene.transfer).is_empty();
    let stroke = Stroke::new(2.0, curve_color(ui, function));
    let curve = area.curve(spots);
    if implied {
        painter.extend(Shape::dashed_line(&curve, stroke, 5.0, 4.0));
    } else {
        painter.line(curve, stroke);
    }
    let font = FontId::proportional(10.0);
    for &level in &levels {
        let at = pos2(outer.left() + 3.0, area.place(0.0, level).y);
        let align = if level == levels[0] { Align2::LEFT_BOTTOM } else { Align2::LEFT_CENTER };
        painter.text(at, align, number(level), font.clone(), visuals.weak_text_color());
    }
    let title = match function {
        Function::Opacity => "Opacity",
        _ => "Index of refraction",
    };
    let hovered = ui.input(|input| input.pointer.hover_pos()).filter(|pointer| outer.contains(*pointer));
    let read = hovered.map(|pointer| under_pointer(area, editor, function, pointer));
    painter.text(
        pos2(outer.right() - 6.0, outer.top() + 4.0),
        Align2::RIGHT_TOP,
        title,
        FontId::proportional(12.0),
        visuals.text_color(),
    );
    if let Some(read) = read {
        painter.text(
            pos2(outer.right() - 6.0, outer.top() + 18.0),
            Align2::RIGHT_TOP,
            read,
            font,
            visuals.weak_text_color(),
        );
    }
}

fn under_pointer(area: Area, editor: &TransferEditor, function: Function, pointer: Pos2) -> String {
    let value = area.value(pointer.x);
    match editor.histogram(function).and_then(|histogram| histogram.count_at(value)) {
        Some(count) => format!("{}: {count} voxels", number(value)),
        None => number(value),
    }
}

/// The levels that have a line and a number.
fn levels(area: Area) -> Vec<f32> {
    if area.power == 1.0 {
        return Axis::over(area.limits).ticks(4);
    }
    vec![0.0, 0.01, 0.1, 1.0]
}
