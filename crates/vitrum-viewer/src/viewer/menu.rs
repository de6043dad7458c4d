//! The menu at the top.

use super::{Dialog, Viewer, marks};
use crate::navigation;
use crate::scene_history::SceneHistory;
use eframe::egui::{Button, MenuBar, Panel, ThemePreference, Ui, ViewportCommand};
use vitrum::backend::Choice;
use vitrum::builtin;
use vitrum::composition::Side;
use vitrum::io::Orientation;
use vitrum::scene::Projection;

/// Sizes of pictures to choose from.
const SIZES: [[u32; 2]; 5] = [[256, 256], [512, 512], [1024, 1024], [1280, 720], [1920, 1080]];

impl Viewer {
    pub(super) fn menu(&mut self, ui: &mut Ui) {
        Panel::top("menu").show(ui, |ui| {
            MenuBar::new().ui(ui, |ui| {
                ui.menu_button("File", |ui| self.file_menu(ui));
                ui.menu_button("Edit", |ui| self.edit_menu(ui));
                ui.menu_button("View", |ui| self.view_menu(ui));
                ui.menu_button("Backend", |ui| self.backend_menu(ui));
                ui.menu_button("Help", |ui| {
                    if ui.button("Mouse and keys").clicked() {
                        self.dialog = Some(Dialog::Keys);
                    }
                    if ui.button("About Vitrum").clicked() {
                        self.dialog = Some(Dialog::About);
                    }
                });
            });
        });
    }

    fn file_menu(&mut self, ui: &mut Ui) {
        let is_open = self.document.is_some();
        if ui.add(Button::new("Open …").shortcut_text("Ctrl+O")).clicked() {
            self.ask_open();
        }
        ui.menu_button("Open recent", |ui| {
            if self.session.recent.is_empty() {
                ui.weak("nothing yet");
            }
            for input in self.session.recent.clone() {
                if ui.button(&input).clicked() {
                    self.open(&input);
                }
            }
        });
        ui.menu_button("Built-in scenes", |ui| {
            for (name, description) in builtin::names() {
                if ui.button(*name).on_hover_text(*description).clicked() {
                    self.open(&format!("builtin:{name}"));
                }
            }
        });
        ui.separator();
        if ui.add_enabled(is_open, Button::new("Save picture …").shortcut_text("Ctrl+E")).clicked() {
            self.ask_save_picture();
        }
        if ui.add_enabled(is_open, Button::new("Save animation …")).clicked() {
            self.ask_save_animation();
        }
        if ui.add_enabled(is_open, Button::new("Save scene …").shortcut_text("Ctrl+S")).clicked() {
            self.ask_save_scene();
        }
        let copy = Button::new("Copy command").shortcut_text("Ctrl+Shift+C");
        if ui.add_enabled(is_open, copy).on_hover_text("The command that renders this very picture").clicked() {
            self.copy_command(ui.ctx());
        }
        ui.separator();
        if ui.add_enabled(is_open, Button::new("Close")).clicked() {
            self.close();
        }
        if ui.button("Quit").clicked() {
            ui.ctx().send_viewport_cmd(ViewportCommand::Close);
        }
    }

    fn edit_menu(&mut self, ui: &mut Ui) {
        let history = self.document.as_ref().map(|document| &document.history);
        let can_undo = history.is_some_and(SceneHistory::can_undo);
        let can_redo = history.is_some_and(SceneHistory::can_redo);
        if ui.add_enabled(can_undo, Button::new("Undo").shortcut_text("Ctrl+Z")).clicked() {
            self.undo();
        }
        if ui.add_enabled(can_redo, Button::new("Redo").shortcut_text("Ctrl+Shift+Z")).clicked() {
            self.redo();
        }
    }

    fn view_menu(&mut self, ui: &mut Ui) {
        if self.document.is_some() {
            if ui.add(Button::new("First view").shortcut_text("Home")).clicked() {
                self.reset_camera();
            }
            if ui.add(Button::new("Fit what is visible").shortcut_text("F")).clicked() {
                self.fit();
            }
            self.camera_menu(ui);
            ui.separator();
        }
        ui.menu_button("Size of the picture", |ui| {
            if ui.selectable_label(self.size.is_none(), "As the window").clicked() {
                (self.size, self.size_is_of_scene) = (None, false);
            }
            for size in SIZES {
                let [width, height] = size;
                if ui.selectable_label(self.size == Some(size), format!("{width} × {height}")).clicked() {
                    (self.size, self.size_is_of_scene) = (Some(size), false);
                }
            }
        });
        ui.separator();
        // Not egui's own buttons: the font lacks their signs.
        let mut theme = ui.ctx().options(|options| options.theme_preference);
        for (choice, name) in [
            (ThemePreference::System, "As the system"),
            (ThemePreference::Light, "Light"),
            (ThemePreference::Dark, "Dark"),
        ] {
            ui.radio_value(&mut theme, choice, name);
        }
        ui.ctx().set_theme(theme);
    }

    fn camera_menu(&mut self, ui: &mut Ui) {
        let Some(document) = &mut self.document else { return };
        let bounds = document.bounds();
        let is_patient =
            document.data.assets.subject.volume().map(|volume| volume.orientation) == Some(Orientation::Patient);
        if document.editor.has_volume() {
            ui.checkbox(&mut self.has_handles, "Handles of crop box and planes");
        }
        let scene = &mut document.scene;
        ui.menu_button("Look from", |ui| {
            for side in Side::ALL {
                if ui.button(name(side, is_patient)).clicked() {
                    side.look(scene);
                }
            }
        });
        let mut projection = scene.camera.projection;
        ui.radio_value(&mut projection, Projection::Perspective, "Perspective");
        ui.radio_value(&mut projection, Projection::Orthographic, "Parallel rays");
        navigation::project(scene, bounds, projection);
        ui.separator();
        marks::show(ui, scene);
    }

    fn backend_menu(&mut self, ui: &mut Ui) {
        for (choice, name, help) in [
            (Choice::Auto, "Automatic", "A graphics card if there is one, else the CPU"),
            (Choice::Cpu, "CPU", "All processor cores"),
            (Choice::Gpu, "GPU", "A graphics adapter, by Vulkan, Metal or Direct3D 12"),
        ] {
            ui.radio_value(&mut self.backend, choice, name).on_hover_text(help);
        }
    }
}

/// Name of a side: the patient's, or the world's.
pub fn name(side: Side, is_patient: bool) -> &'static str {
    match (side, is_patient) {
        (Side::Anterior, true) => "Anterior",
        (Side::Posterior, true) => "Posterior",
        (Side::Left, true) => "Left",
        (Side::Right, true) => "Right",
        (Side::Superior, true) => "Superior",
        (Side::Inferior, true) => "Inferior",
        (Side::Anterior, false) => "Front (+y)",
        (Side::Posterior, false) => "Back (−y)",
        (Side::Left, false) => "−x",
        (Side::Right, false) => "+x",
        (Side::Superior, false) => "Above (+z)",
        (Side::Inferior, false) => "Below (−z)",
    }
}
