//! What is drawn behind the curve of a function: histograms, and the particles' colours.

use super::area::Area;
use super::function::Function;
use super::gradients::Gradients;
use super::model::TransferEditor;
use super::spots::{Spot, at};
use super::strip;
use eframe::egui::epaint::Mesh;
use eframe::egui::{Color32, Painter, Rect, Shape, pos2};

/// Draws the histogram of the values that a function is over.
pub fn bars(painter: &Painter, area: Area, editor: &TransferEditor, function: Function, color: Color32) {
    let Some(histogram) = editor.histogram(function) else { return };
    let mut mesh = Mesh::default();
    for ([from, to], share) in histogram.bars().filter(|(_, share)| *share > 0.0) {
        let (left, right) = (area.x(from), area.x(to));
        if right >= area.rect.left() && left <= area.rect.right() {
            // Bars are at least a point wide, so that a few in a wide range are seen.
            let top = area.rect.bottom() - 0.92 * share * area.rect.height();
            let bar = Rect::from_min_max(pos2(left, top), pos2(right.max(left + 1.0), area.rect.bottom()));
            mesh.add_colored_rect(bar.intersect(area.rect), color);
        }
    }
    painter.add(Shape::mesh(mesh));
}

/// Fills the area below the curve with the particles' colours.
pub fn fill(painter: &Painter, area: Area, spots: &[Spot], colors: &[Spot]) {
    const OPACITY: f32 = 0.5;
    let mut mesh = Mesh::default();
    let steps = (area.rect.width() / 2.0).max(1.0) as u32;
    for step in 0..=steps {
        let x = area.rect.left() + area.rect.width() * step as f32 / steps as f32;
        let value = area.value(x);
        let level = at(spots, value).unwrap_or_default()[0];
        let color = strip::displayed(at(colors, value).unwrap_or([1.0; 3])).gamma_multiply(OPACITY);
        mesh.colored_vertex(pos2(x, area.place(value, level).y), color);
        mesh.colored_vertex(pos2(x, area.rect.bottom()), color);
        if step > 0 {
            let last = 2 * step;
            mesh.add_triangle(last - 2, last - 1, last);
            mesh.add_triangle(last - 1, last, last + 1);
        }
    }
    painter.add(Shape::mesh(mesh));
}

/// Draws the histogram over value and gradient, steep gradients at the top.
pub fn cells(painter: &Painter, area: Area, gradients: &Gradients, color: Color32) {
    let [columns, rows] = Gradients::BINS.map(|bins| bins as f32);
    let [low, high] = gradients.range;
    let mut mesh = Mesh::default();
    for (column, row, share) in gradients.cells() {
        let x = |column: f32| area.x(low + (high - low) * column / columns);
        let y = |row: f32| area.rect.bottom() - area.rect.height() * row / rows;
        let (column, row) = (column as f32, row as f32);
        let cell = Rect::from_min_max(pos2(x(column), y(row + 1.0)), pos2(x(column + 1.0), y(row)));
        if cell.intersects(area.rect) {
            mesh.add_colored_rect(cell.intersect(area.rect), color.gamma_multiply(share));
        }
    }
    painter.add(Shape::mesh(mesh));
}
