//! A row for each key: its name, its control, and a mark where it differs from its default.

use super::model::Panels;
use super::{button, control, values};
use eframe::egui::{Grid, RichText, Ui};
use toml::Table;
use vitrum::scene::Field;

/// Width of what is told beside a key.
const REFUSAL_WIDTH: f32 = 200.0;

/// What the rows look at, and the settings that they ask for.
pub struct View<'a> {
    pub panels: &'a Panels,
    pub settings: &'a mut Vec<String>,
}

impl View<'_> {
    /// Whether the key is one of those that are looked for.
    pub fn is_wanted(&self, path: &str, field: &Field) -> bool {
        let text = format!("{path} {}", field.meaning).to_lowercase();
        self.panels.filter.to_lowercase().split_whitespace().all(|word| text.contains(word))
    }

    pub fn is_filtered(&self) -> bool {
        !self.panels.filter.trim().is_empty()
    }

    pub fn ask(&mut self, setting: String) {
        self.settings.push(setting);
    }
}

/// The path of a key in the section at `path`.
pub fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
}

/// Shows a row for each of `fields`, whose values are in `table`, the section at `path`.
pub fn rows(ui: &mut Ui, view: &mut View<'_>, path: &str, fields: &[&Field], table: &Table) {
    let wanted: Vec<&Field> =
        fields.iter().copied().filter(|field| view.is_wanted(&join(path, &field.name), field)).collect();
    if wanted.is_empty() {
        return;
    }
    Grid::new(("rows", path)).num_columns(2).spacing([8.0, 4.0]).show(ui, |ui| {
        for field in wanted {
            let path = join(path, &field.name);
            let value = table.get(&field.name);
            let differs = values::differs(field, value);
            let name = RichText::new(field.name.replace('_', " "));
            ui.label(if differs { name.strong() } else { name }).on_hover_text(help(field));
            ui.horizontal(|ui| {
                control::show(ui, view, &path, field, value);
                if !field.unit.is_empty() && field.unit.len() < 12 && value.is_some() {
                    ui.label(RichText::new(&field.unit).small().weak());
                }
                if differs
                    && let Some(setting) = values::reset(field, &path)
                    && button::reset(ui, &format!("reset {path}")).clicked()
                {
                    view.ask(setting);
                }
            });
            ui.end_row();
            if let Some(refusal) = view.panels.refusal_of(&path) {
                ui.label("");
                // A grid's cell would not wrap it.
                ui.vertical(|ui| {
                    ui.set_max_width(REFUSAL_WIDTH);
                    ui.colored_label(ui.visuals().error_fg_color, refusal);
                });
                ui.end_row();
            }
        }
    });
}

/// What a key means, its range, its unit and its default.
pub fn help(field: &Field) -> String {
    let mut text = field.meaning.clone();
    let default = field.default.as_deref().filter(|default| !default.is_empty());
    let facts = [("Range", Some(field.range.as_str())), ("Unit", Some(field.unit.as_str())), ("Default", default)];
    for (name, fact) in facts {
        if let Some(fact) = fact.filter(|fact| !fact.is_empty()) {
            text += &format!("\n{name}: {}", fact.replace('`', ""));
        }
    }
    text
}
