//! The control of a key, by the kind of its value.

use super::row::{View, help};
use super::{button, values};
use crate::transfer_editor::exact_field;
use eframe::egui::{Checkbox, ComboBox, DragValue, Response, TextEdit, Ui};
use toml::Value;
use vitrum::scene::{Bounds, Control, Field};

/// Shows the control of the key at `path`.
pub fn show(ui: &mut Ui, view: &mut View<'_>, path: &str, field: &Field, value: Option<&Value>) {
    if let (Control::Text, value) = (&field.control, value) {
        text(ui, view, path, field, value.and_then(Value::as_str).unwrap_or_default());
        return;
    }
    let Some(value) = value else {
        if button::plus(ui, &format!("set {path}")).on_hover_text(help(field)).clicked() {
            view.ask(format!("{path}={}", values::first_value(field)));
        }
        ui.weak("automatic");
        return;
    };
    let asked = match &field.control {
        Control::Number(bounds) => number(ui, path, value, *bounds, field),
        Control::Numbers { each, count } => numbers(ui, path, value, *each, *count, field),
        Control::Color(bounds) => color(ui, path, value, *bounds, field),
        Control::Switch => switch(ui, path, value, field),
        Control::Choice(choices) => choice(ui, path, value, choices),
        Control::Text | Control::Section(_) | Control::Sections { .. } => None,
    };
    if let Some(text) = asked {
        view.ask(format!("{path}={text}"));
    }
}

fn speed(bounds: Bounds, value: f32) -> f32 {
    let width = bounds.most - bounds.least;
    if width.is_finite() && width < 1e5 { width / 400.0 } else { value.abs().max(0.1) / 100.0 }
}

fn named(response: Response, path: &str, field: &Field) -> Response {
    response.accessible_name(path).on_hover_text(help(field))
}

fn number(ui: &mut Ui, path: &str, value: &Value, bounds: Bounds, field: &Field) -> Option<String> {
    if bounds.whole {
        let mut whole = value.as_integer()?;
        let range = bounds.least.max(0.0) as i64..=bounds.most.min(4e9) as i64;
        let width = (range.end() - range.start()) as f64;
        let drag =
            DragValue::new(&mut whole).range(range).speed((width / 400.0).clamp(0.05, 4.0)).update_while_editing(false);
        return named(ui.add(drag), path, field).changed().then(|| whole.to_string());
    }
    let mut number = values::number(value)?;
    let speed = speed(bounds, number);
    let drag = exact_field(&mut number, speed).range(bounds.least..=bounds.most);
    named(ui.add(drag), path, field).changed().then(|| values::float(number))
}

fn numbers(
    ui: &mut Ui,
    path: &str,
    value: &Value,
    each: Bounds,
    count: Option<usize>,
    field: &Field,
) -> Option<String> {
    let mut numbers = values::numbers(value);
    let mut changed = false;
    for (index, number) in numbers.iter_mut().enumerate() {
        let speed = speed(each, *number);
        let drag = exact_field(number, speed).range(each.least..=each.most);
        changed |= named(ui.add(drag), &format!("{path}.{index}"), field).changed();
    }
    if count.is_none() {
        if button::plus(ui, &format!("add to {path}")).clicked() {
            numbers.push(each.least.max(1.0).min(each.most));
            changed = true;
        }
        if !numbers.is_empty() && button::cross(ui, &format!("remove the last of {path}")).clicked() {
            numbers.pop();
            changed = true;
        }
    }
    changed.then(|| values::floats(&numbers))
}

/// Colours brighter than white are shown as bright as white, and keep their brightness.
fn color(ui: &mut Ui, path: &str, value: &Value, bounds: Bounds, field: &Field) -> Option<String> {
    let [r, g, b] = values::numbers(value).try_into().ok()?;
    let brightness = [r, g, b].into_iter().fold(1.0, f32::max);
    let mut shown = [r, g, b].map(|component| component / brightness);
    let button = named(ui.color_edit_button_rgb(&mut shown), path, field);
    if button.changed() {
        let bounded = |component: f32| (component * brightness).max(bounds.least).min(bounds.most);
        return Some(values::floats(&shown.map(bounded)));
    }
    if bounds.most <= 1.0 {
        return None;
    }
    numbers(ui, path, value, bounds, Some(3), field)
}

fn switch(ui: &mut Ui, path: &str, value: &Value, field: &Field) -> Option<String> {
    let mut on = value.as_bool()?;
    named(ui.add(Checkbox::without_text(&mut on)), path, field).changed().then(|| on.to_string())
}

fn choice(ui: &mut Ui, path: &str, value: &Value, choices: &[(String, String)]) -> Option<String> {
    let present = value.as_str()?;
    let mut chosen = None;
    let combo = ComboBox::from_id_salt(path).selected_text(present.replace('_', " "));
    let shown = combo.show_ui(ui, |ui| {
        for (name, meaning) in choices {
            if ui.selectable_label(name == present, name.replace('_', " ")).on_hover_text(meaning).clicked() {
                chosen = Some(values::quoted(name));
            }
        }
    });
    shown.response.accessible_name(path);
    chosen
}

/// A text counts when its field is left; an empty one is no text.
fn text(ui: &mut Ui, view: &mut View<'_>, path: &str, field: &Field, present: &str) {
    let id = ui.make_persistent_id(path);
    let mut text = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| present.to_owned());
    let width = (ui.available_width() - 40.0).clamp(60.0, 220.0);
    let hint = if field.is_optional { "automatic" } else { "" };
    let response = ui.add(TextEdit::singleline(&mut text).hint_text(hint).desired_width(width));
    let response = named(response, path, field);
    if response.lost_focus() {
        ui.data_mut(|data| data.remove::<String>(id));
        if text != present {
            let value = if text.is_empty() && field.is_optional { "none".to_owned() } else { values::quoted(&text) };
            view.ask(format!("{path}={value}"));
        }
    } else if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text));
    }
}
