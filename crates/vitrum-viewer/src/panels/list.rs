//! A list of sections, such as lights, which are added and removed.

use super::row::View;
use super::{button, section, values};
use eframe::egui::{CollapsingHeader, Ui};
use toml::{Table, Value};
use vitrum::scene::{Control, Field};

/// Shows the list at `path`, of at most `most` sections with the keys `fields`.
pub fn show(ui: &mut Ui, view: &mut View<'_>, path: &str, fields: &[Field], most: usize, value: Option<&Value>) {
    let items = value.and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    for (index, table) in items.iter().filter_map(Value::as_table).enumerate() {
        let item_path = format!("{path}.{index}");
        ui.horizontal_top(|ui| {
            if button::cross(ui, &format!("remove {item_path}")).clicked() {
                view.ask(format!("{path}={}", without(items, index)));
            }
            ui.vertical(|ui| {
                let open = view.is_filtered().then_some(true);
                let header = CollapsingHeader::new(title(index, fields, table)).id_salt(&item_path);
                header.default_open(items.len() == 1).open(open).show(ui, |ui| {
                    section::keys(ui, view, &item_path, fields, table);
                });
            });
        });
    }
    if items.len() < most && button::plus(ui, &format!("add to {path}")).clicked() {
        view.ask(format!("{path}.{}={}", items.len(), values::first_table(fields)));
    }
}

/// The number of an item, and the first word or number in it that says something about it.
fn title(index: usize, fields: &[Field], table: &Table) -> String {
    let says = |field: &Field| matches!(field.control, Control::Choice(_) | Control::Text) || field.is_required;
    let said = fields.iter().filter(|field| says(field)).find_map(|field| match table.get(&field.name)? {
        Value::String(text) => Some(text.replace('_', " ")),
        value => values::number(value).map(|number| number.to_string()),
    });
    match said {
        Some(said) => format!("{}: {said}", index + 1),
        None => (index + 1).to_string(),
    }
}

/// The list without one of its items.
fn without(items: &[Value], index: usize) -> String {
    let others = items.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, item)| item.clone());
    Value::Array(others.collect()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum::scene::{Clip, Isosurface, Light, Scene};

    #[test]
    fn an_item_is_removed_and_the_others_stay_as_they_are() {
        let mut scene = Scene {
            light: [1.3, 0.1, 7.7].map(|azimuth| Light { azimuth, ..Light::default() }).to_vec(),
            isosurface: vec![Isosurface::new(0.1)],
            clip: vec![Clip::default()],
            ..Scene::default()
        };
        let table = values::table(&scene);
        for (list, index) in [("light", 1), ("isosurface", 0), ("clip", 0)] {
            let items = table[list].as_array().expect("a list");
            scene.set(&format!("{list}={}", without(items, index))).expect("a setting");
        }
        assert_eq!(scene.light.iter().map(|light| light.azimuth).collect::<Vec<_>>(), [1.3, 7.7]);
        assert!(scene.isosurface.is_empty() && scene.clip.is_empty());
    }
}
