//! A section, or a list of sections, below a heading that opens and closes it.

use super::row::{View, help, join, rows};
use super::{button, list, values};
use eframe::egui::{CollapsingHeader, Ui};
use toml::{Table, Value};
use vitrum::scene::{Control, Field};

/// Whether a key holds a section or a list of them.
pub fn is_section(field: &Field) -> bool {
    matches!(field.control, Control::Section(_) | Control::Sections { .. })
}

/// Whether something in the section is looked for.
pub fn has_wanted(view: &View<'_>, path: &str, field: &Field) -> bool {
    let (fields, path) = match &field.control {
        Control::Section(fields) => (fields, path.to_owned()),
        Control::Sections { item, .. } => (item, format!("{path}.0")),
        _ => return view.is_wanted(path, field),
    };
    view.is_wanted(&path, field) || fields.iter().any(|field| has_wanted(view, &join(&path, &field.name), field))
}

/// The heading of the section of a key.
pub fn title(field: &Field) -> String {
    let mut letters = field.name.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}", letters.as_str().replace('_', " "))
}

/// Shows the section of the key at `path`.
pub fn show(ui: &mut Ui, view: &mut View<'_>, path: &str, field: &Field, value: Option<&Value>) {
    if !has_wanted(view, path, field) {
        return;
    }
    let count = value.and_then(Value::as_array).map(Vec::len);
    let title = match (&field.control, count) {
        (Control::Sections { .. }, count) => format!("{} ({})", title(field), count.unwrap_or(0)),
        (_, None) if value.is_none() => format!("{} (none)", title(field)),
        _ => title(field),
    };
    // A refusal must be seen.
    let is_refused = view.panels.refusal().is_some_and(|(key, _)| key.split('.').next() == Some(path));
    let open = (view.is_filtered() || is_refused).then_some(true);
    let header = CollapsingHeader::new(title).id_salt(path).open(open).show(ui, |ui| match &field.control {
        Control::Sections { item, most } => list::show(ui, view, path, item, *most, value),
        Control::Section(fields) => inner(ui, view, path, field, fields, value),
        _ => {}
    });
    header.header_response.on_hover_text(help(field));
}

fn inner(ui: &mut Ui, view: &mut View<'_>, path: &str, field: &Field, fields: &[Field], value: Option<&Value>) {
    match value.and_then(Value::as_table) {
        Some(table) => {
            keys(ui, view, path, fields, table);
            if field.is_optional && ui.button("Remove").accessible_name(format!("remove {path}")).clicked() {
                view.ask(format!("{path}=none"));
            }
        }
        None => {
            if button::plus(ui, &format!("add {path}")).clicked() {
                view.ask(format!("{path}={}", values::first_table(fields)));
            }
        }
    }
}

/// Shows the keys of a section: those with values first, then the sections inside.
pub fn keys(ui: &mut Ui, view: &mut View<'_>, path: &str, fields: &[Field], table: &Table) {
    let (sections, alone): (Vec<&Field>, Vec<&Field>) = fields.iter().partition(|field| is_section(field));
    rows(ui, view, path, &alone, table);
    for field in sections {
        show(ui, view, &join(path, &field.name), field, table.get(&field.name));
    }
}
