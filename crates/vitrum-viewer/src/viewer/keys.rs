//! Keys: everything that the mouse does to the camera, and the menu's commands.

use super::{Dialog, Viewer};
use crate::navigation;
use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};
use vitrum::composition::Side;
use vitrum::scene::Projection;

/// Share of the picture that an arrow key moves by.
const STEP: f32 = 1.0 / 36.0;

/// Factor of a key that zooms.
const CLOSER: f32 = 1.1;

/// Degrees of a key that rolls.
const ROLL: f32 = 5.0;

/// Keys and what they do, for people: the dialog shows them.
pub const KEYS: [(&str, &str); 18] = [
    ("Drag", "turn"),
    ("Right drag, Shift + drag", "move"),
    ("Wheel, pinch", "zoom"),
    ("R + drag, Ctrl + drag", "roll"),
    ("L + drag, Alt + drag", "turn the light"),
    ("Double click, Home", "back to the first view"),
    ("F", "fit what is visible into the picture"),
    ("Arrow keys", "turn; with Shift move"),
    ("+  −", "zoom"),
    (",  .", "roll"),
    ("1  3  7", "from the front, the right, above; with Shift from the back, the left, below"),
    ("P", "perspective or parallel rays"),
    ("Ctrl + O", "open"),
    ("Ctrl + S", "save the scene"),
    ("Ctrl + E", "save the picture"),
    ("Ctrl + Shift + C", "copy the command that renders this picture"),
    ("Ctrl + Z, Ctrl + Shift + Z", "undo, redo"),
    ("F1", "this list"),
];

const CTRL: Modifiers = Modifiers::COMMAND;

impl Viewer {
    /// Takes the keys that nothing else has taken.
    pub(super) fn take_shortcuts(&mut self, context: &Context) {
        let pressed =
            |modifiers, key| context.input_mut(|input| input.consume_shortcut(&KeyboardShortcut::new(modifiers, key)));
        if pressed(CTRL, Key::O) {
            self.ask_open();
        }
        if pressed(Modifiers::NONE, Key::F1) {
            self.dialog = Some(Dialog::Keys);
        }
        if self.document.is_none() {
            return;
        }
        if pressed(CTRL | Modifiers::SHIFT, Key::C) {
            self.copy_command(context);
        }
        if pressed(CTRL, Key::S) {
            self.ask_save_scene();
        }
        if pressed(CTRL, Key::E) {
            self.ask_save_picture();
        }
        // A text that is being edited has its own undo and its own letters.
        if context.egui_wants_keyboard_input() {
            return;
        }
        if pressed(CTRL | Modifiers::SHIFT, Key::Z) || pressed(CTRL, Key::Y) {
            self.redo();
        }
        if pressed(CTRL, Key::Z) {
            self.undo();
        }
        if pressed(Modifiers::NONE, Key::Home) {
            self.reset_camera();
        }
        if pressed(Modifiers::NONE, Key::F) {
            self.fit();
        }
        self.take_camera_keys(context);
    }

    fn take_camera_keys(&mut self, context: &Context) {
        let Some(document) = &mut self.document else { return };
        // A widget that has the focus has the arrows, too.
        if context.memory(|memory| memory.focused()).is_some() {
            return;
        }
        let bounds = document.bounds();
        let scene = &mut document.scene;
        let count = |key| context.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key)) as f32;
        let shifted = |key| context.input_mut(|input| input.count_and_consume_key(Modifiers::SHIFT, key)) as f32;
        let arrows = |count: &dyn Fn(Key) -> f32| {
            let across = count(Key::ArrowRight) - count(Key::ArrowLeft);
            [across * STEP, (count(Key::ArrowDown) - count(Key::ArrowUp)) * STEP]
        };
        // The more exact combination first: the other one ignores Shift.
        let moved = arrows(&shifted);
        if moved != [0.0; 2] {
            navigation::pan(scene, bounds, moved);
        }
        let turned = arrows(&count);
        if turned != [0.0; 2] {
            navigation::orbit(scene, bounds, turned);
        }
        for (key, factor) in [(Key::Plus, CLOSER), (Key::Equals, CLOSER), (Key::Minus, 1.0 / CLOSER)] {
            if shifted(key) + count(key) > 0.0 {
                navigation::zoom(&mut scene.camera, factor);
            }
        }
        let rolled = count(Key::Period) - count(Key::Comma);
        if rolled != 0.0 {
            navigation::roll(&mut scene.camera, rolled * ROLL);
        }
        for (key, side, opposite) in [
            (Key::Num1, Side::Anterior, Side::Posterior),
            (Key::Num3, Side::Right, Side::Left),
            (Key::Num7, Side::Superior, Side::Inferior),
        ] {
            if shifted(key) > 0.0 {
                opposite.look(scene);
            } else if count(key) > 0.0 {
                side.look(scene);
            }
        }
        if count(Key::P) > 0.0 {
            let other = match scene.camera.projection {
                Projection::Perspective => Projection::Orthographic,
                Projection::Orthographic => Projection::Perspective,
            };
            navigation::project(scene, bounds, other);
        }
    }

    /// Undoes the last change.
    pub fn undo(&mut self) {
        if let Some(document) = &mut self.document {
            document.history.note(&document.scene);
            document.history.undo(&mut document.scene);
        }
    }

    /// Does again what was undone.
    pub fn redo(&mut self) {
        if let Some(document) = &mut self.document {
            document.history.redo(&mut document.scene);
        }
    }

    /// Goes back to the view that the document was opened with.
    pub fn reset_camera(&mut self) {
        if let Some(document) = &mut self.document {
            document.scene.camera = document.home.camera.clone();
        }
    }

    /// Fits the camera to what is visible.
    pub fn fit(&mut self) {
        let outcome = self.document.as_mut().map_or(Ok(()), crate::document::Document::fit);
        if let Err(trouble) = outcome {
            self.fail(trouble);
        }
    }
}
