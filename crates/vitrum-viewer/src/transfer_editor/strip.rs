//! The strip of a function that is a colour, with a mark below it for each point.

use super::area::MARGIN;
use super::function::Function;
use super::handle::{Handle, described};
use super::model::TransferEditor;
use super::spots::{Spot, at};
use eframe::egui::epaint::Mesh;
use eframe::egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};
use vitrum::io::linear_to_srgb;
use vitrum::scene::{Rgb, Scene};

/// Height of the coloured band, and of the marks below it.
const HEIGHTS: [f32; 2] = [16.0, 11.0];

/// A colour as the screen shows it.
pub fn displayed(linear: Rgb) -> Color32 {
    let [r, g, b] = linear.map(|component| (linear_to_srgb(component.clamp(0.0, 1.0)) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// Shows the strip of `function`.
pub fn show(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene, function: Function) {
    let size = vec2(ui.available_width().max(120.0), HEIGHTS.iter().sum());
    let (outer, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Canvas, ui.is_enabled(), format!("strip of the {}", function.name()))
    });
    let band = Rect::from_min_max(
        pos2(outer.left() + MARGIN, outer.top()),
        pos2(outer.right() - MARGIN, outer.top() + HEIGHTS[0]),
    );
    let axis = editor.axis(function);
    let x = |value: f32| band.left() + axis.share(value).clamp(-10.0, 10.0) * band.width();
    let value_at = |x: f32| axis.value(((x - band.left()) / band.width()).clamp(0.0, 1.0));
    let spots = editor.shown_spots(scene, function);
    let painter = ui.painter().with_clip_rect(outer.intersect(ui.clip_rect()));
    paint_band(&painter, band, &spots, &value_at);
    painter.rect_stroke(band, 0.0, ui.visuals().widgets.noninteractive.bg_stroke, StrokeKind::Inside);
    name(&painter, band, &spots, function, &value_at);
    if let Some(pointer) = response.interact_pointer_pos()
        && response.double_clicked()
    {
        editor.add(scene, function, value_at(pointer.x), None);
    }
    for (index, spot) in function.spots(&scene.transfer).into_iter().enumerate() {
        let at_x = x(spot.value);
        if !(band.left() - 1.0..=band.right() + 1.0).contains(&at_x) {
            continue;
        }
        let middle = band.bottom() + 0.5 * HEIGHTS[1];
        let place = |spot: Spot| pos2(x(spot.value), middle);
        let read = |at: Pos2, spot: Spot| Spot { value: value_at(at.x), ..spot };
        let handle = Handle { function, index, spot, at: place(spot), size: vec2(10.0, HEIGHTS[1]) };
        let is_selected = editor.selected == Some((function, index));
        let touched = handle.interact(ui, response.id, editor, scene, &place, &read);
        let hot = is_selected || touched.hovered() || touched.has_focus();
        paint_mark(ui, &painter, at_x, band.bottom(), spot, hot);
        touched.on_hover_text(described(function, spot));
    }
    response.on_hover_text(format!("{} Double-click adds a point.", function.meaning()));
}

fn paint_band(painter: &Painter, band: Rect, spots: &[Spot], value_at: &dyn Fn(f32) -> f32) {
    let mut mesh = Mesh::default();
    let steps = (band.width() / 2.0).max(1.0) as u32;
    for step in 0..=steps {
        let x = band.left() + band.width() * step as f32 / steps as f32;
        let color = displayed(at(spots, value_at(x)).unwrap_or([1.0; 3]));
        mesh.colored_vertex(pos2(x, band.top()), color);
        mesh.colored_vertex(pos2(x, band.bottom()), color);
        if step > 0 {
            let last = 2 * step;
            mesh.add_triangle(last - 2, last - 1, last);
            mesh.add_triangle(last - 1, last, last + 1);
        }
    }
    painter.add(Shape::mesh(mesh));
}

/// Writes the strip's name in it, in black or white.
fn name(painter: &Painter, band: Rect, spots: &[Spot], function: Function, value_at: &dyn Fn(f32) -> f32) {
    let text = match function {
        Function::Filter => "Filter",
        _ => "Colour",
    };
    let [r, g, b] = at(spots, value_at(band.right() - 20.0)).unwrap_or([1.0; 3]);
    let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let color = if luminance > 0.18 { Color32::from_black_alpha(200) } else { Color32::from_white_alpha(220) };
    painter.text(band.right_center() - vec2(5.0, 0.0), Align2::RIGHT_CENTER, text, FontId::proportional(11.0), color);
}

/// A mark that points up to its place on the band.
fn paint_mark(ui: &Ui, painter: &Painter, x: f32, top: f32, spot: Spot, hot: bool) {
    let (width, height) = if hot { (5.5, 10.5) } else { (4.0, 9.0) };
    let outline = vec![
        pos2(x, top),
        pos2(x + width, top + 0.45 * height),
        pos2(x + width, top + height),
        pos2(x - width, top + height),
        pos2(x - width, top + 0.45 * height),
    ];
    let edge = Stroke::new(if hot { 2.0 } else { 1.0 }, ui.visuals().text_color());
    painter.add(Shape::convex_polygon(outline, displayed(spot.level), edge));
}
