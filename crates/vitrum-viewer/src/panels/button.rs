//! Small buttons with a sign, which have a name for screen readers and tests.

use eframe::egui::{Button, Response, RichText, Ui};

/// A button that removes something.
pub fn cross(ui: &mut Ui, name: &str) -> Response {
    sign(ui, "×", name)
}

/// A button that gives the default back.
pub fn reset(ui: &mut Ui, name: &str) -> Response {
    sign(ui, "reset", name)
}

/// A button that adds something.
pub fn plus(ui: &mut Ui, name: &str) -> Response {
    sign(ui, "+", name)
}

fn sign(ui: &mut Ui, sign: &str, name: &str) -> Response {
    ui.add(Button::new(RichText::new(sign)).small()).accessible_name(name).on_hover_text(name)
}
