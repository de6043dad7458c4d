//! Fields for exact numbers: of the selected point, and of the window.

use super::function::Function;
use super::model::TransferEditor;
use super::spots::Spot;
use eframe::egui::{DragValue, RichText, Ui};
use vitrum::scene::Scene;

/// A number field that shows all digits and takes what is typed when it is done.
pub fn exact(value: &mut f32, speed: f32) -> DragValue<'_> {
    DragValue::new(value)
        .speed(f64::from(speed))
        .update_while_editing(false)
        .custom_formatter(|number, _| (number as f32).to_string())
}

/// Shows the fields.
pub fn show(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene) {
    window(ui, editor, scene);
    let Some((function, index)) = editor.selected else {
        hint(ui);
        return;
    };
    let spots = function.spots(&scene.transfer);
    let Some(&spot) = spots.get(index) else { return };
    let mut changed = spot;
    let mut is_removed = false;
    let [first, last] = editor.axis(function).range;
    let title = format!("{} point {} of {}", function.name(), index + 1, spots.len());
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(title).strong());
        ui.label("at");
        ui.add(exact(&mut changed.value, (last - first) / 500.0))
            .on_hover_text("Value of the point")
            .accessible_name("value of the point");
        if function.is_of_color() {
            let button = ui.color_edit_button_rgb(&mut changed.level);
            if !button.changed() {
                // The picker's own arithmetic is no change.
                changed.level = spot.level;
            }
            button.on_hover_text(function.meaning()).accessible_name("colour of the point");
        } else {
            let [least, most] = function.limits();
            let field = exact(&mut changed.level[0], 0.002).range(least..=most);
            ui.add(field)
                .on_hover_text(function.meaning())
                .accessible_name(format!("{} of the point", function.name()));
        }
        is_removed = ui.button("Remove").on_hover_text("Delete, or a right click on the point").clicked();
    });
    if is_removed {
        editor.remove(scene, function, index);
    } else if changed != spot {
        editor.move_to(scene, function, index, Spot { level: function.limited(changed.level), ..changed });
    }
}

fn hint(ui: &mut Ui) {
    ui.label(
        RichText::new("A click on a curve adds a point, a right click removes it; drag with the right button for window and level.")
            .small()
            .weak(),
    );
}

fn window(ui: &mut Ui, editor: &mut TransferEditor, scene: &mut Scene) {
    let [low, high] = editor.window(scene);
    let (mut width, mut level) = (high - low, low.midpoint(high));
    let [first, last] = editor.axis(Function::Opacity).range;
    let speed = (last - first) / 500.0;
    ui.horizontal(|ui| {
        ui.label("Window");
        let wide = ui.add(exact(&mut width, speed).range(0.0..=f32::MAX)).accessible_name("width of the window");
        ui.label("level");
        let middle = ui.add(exact(&mut level, speed)).accessible_name("level of the window");
        if wide.changed() || middle.changed() {
            editor.stretch(scene, [level - 0.5 * width, level + 0.5 * width]);
            if !wide.dragged() && !middle.dragged() {
                editor.end_stretch();
            }
        }
        if wide.drag_stopped() || middle.drag_stopped() {
            editor.end_stretch();
        }
    });
}
