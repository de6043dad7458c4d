//! The panels on the right: preset, transfer functions, light, camera, and every other key.

use super::Viewer;
use crate::worker::{Sketch, SketchSubject};
use crate::{light_ball, navigation, panels, transfer_editor};
use eframe::egui::{Button, CollapsingHeader, ComboBox, DragValue, Panel, ScrollArea, Slider, TextureHandle, Ui};
use vitrum::preset;
use vitrum::scene::{Light, LightKind, Scene};

/// Width of the panels, in points.
const WIDTH: f32 = 340.0;

/// Pixels of a preset's picture, along an edge.
const EDGE: u32 = 112;

/// Most lights of a scene.
const MOST_LIGHTS: usize = 16;

impl Viewer {
    pub(super) fn side(&mut self, ui: &mut Ui) {
        Panel::right("side").default_size(WIDTH).show(ui, |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                CollapsingHeader::new("Preset").default_open(true).show(ui, |ui| self.preset_panel(ui));
                let Some(document) = &mut self.document else { return };
                if document.editor.has_volume() {
                    CollapsingHeader::new("Transfer functions").default_open(true).show(ui, |ui| {
                        let change = transfer_editor::show(ui, &mut document.editor, &mut document.scene);
                        if let Some(preset) = change.preset {
                            document.composition.preset = Some(preset.to_owned());
                        }
                    });
                }
                let bounds = document.bounds();
                let scene = &mut document.scene;
                CollapsingHeader::new("Light").default_open(true).show(ui, |ui| {
                    lights(ui, scene, &mut self.selected_light);
                });
                CollapsingHeader::new("Camera").default_open(true).show(ui, |ui| {
                    camera(ui, scene);
                    let mut projection = scene.camera.projection;
                    ui.horizontal(|ui| {
                        use vitrum::scene::Projection::{Orthographic, Perspective};
                        ui.radio_value(&mut projection, Perspective, "perspective");
                        ui.radio_value(&mut projection, Orthographic, "parallel rays");
                    });
                    navigation::project(scene, bounds, projection);
                });
                CollapsingHeader::new("All keys").show(ui, |ui| panels::show(ui, &mut self.panels, scene));
            });
        });
    }

    /// The looks that the library has for this kind of data, as pictures of this very data.
    fn preset_panel(&mut self, ui: &mut Ui) {
        self.ask_for_presets();
        let Some(document) = &mut self.document else { return };
        let chosen = if document.editor.has_volume() {
            let picture = |name: &str| self.sketches.get(&sketch_name(name))?.as_ref().map(TextureHandle::id);
            transfer_editor::show_presets(ui, &picture)
        } else {
            let current = document.composition.preset.as_deref();
            let names = |ui: &mut Ui| {
                let mut clicked = None;
                for (name, description) in preset::mesh_names() {
                    let label = ui.selectable_label(current == Some(name), *name);
                    clicked = label.on_hover_text(*description).clicked().then_some(*name).or(clicked);
                }
                clicked
            };
            ui.horizontal_wrapped(names).inner
        };
        let Some(name) = chosen else { return };
        match document.take_preset(name) {
            Ok(notes) => self.notes.extend(notes),
            Err(trouble) => self.fail(trouble),
        }
    }
}

impl Viewer {
    /// Asks for a picture of each preset, once.
    fn ask_for_presets(&mut self) {
        let Some(document) = self.document.as_ref().filter(|document| document.editor.has_volume()) else { return };
        if !self.sketches.is_empty() || !self.pictures.is_complete() {
            return;
        }
        let (scene, data) = (Box::new(document.scene.clone()), document.data.clone());
        for &(name, _) in preset::names() {
            let subject = SketchSubject::Preset(name, scene.clone(), data.clone());
            self.sketch(Sketch { name: sketch_name(name), size: [EDGE; 2], subject });
        }
    }
}

/// The name under which a preset's picture is known.
fn sketch_name(preset: &str) -> String {
    format!("preset {preset}")
}

/// The lights in a list; the ball turns the selected one.
fn lights(ui: &mut Ui, scene: &mut Scene, selected: &mut usize) {
    *selected = (*selected).min(scene.light.len().saturating_sub(1));
    ui.horizontal_wrapped(|ui| {
        for (index, light) in scene.light.iter().enumerate() {
            ui.selectable_value(selected, index, format!("{} {}", index + 1, light.kind.name()));
        }
        let more = scene.light.len() < MOST_LIGHTS;
        if ui.add_enabled(more, Button::new("+")).on_hover_text("Add a distant light").clicked() {
            scene.light.push(Light { shadows: false, intensity: 0.3, azimuth: 60.0, ..Light::default() });
            *selected = scene.light.len() - 1;
        }
        let any = !scene.light.is_empty();
        if ui.add_enabled(any, Button::new("−")).on_hover_text("Remove this light").clicked() {
            scene.light.remove(*selected);
            *selected = selected.saturating_sub(1);
        }
    });
    let Some(light) = scene.light.get_mut(*selected) else { return };
    ui.horizontal(|ui| {
        if light.kind == LightKind::Distant {
            let response = light_ball::show(ui, light.azimuth, light.elevation);
            if response.dragged() {
                navigation::turn_light(light, light_ball::in_radii(response.drag_delta()));
            }
        }
        ui.vertical(|ui| {
            if light.kind == LightKind::Distant {
                degrees(ui, "azimuth", &mut light.azimuth, -180.0..=180.0);
                degrees(ui, "elevation", &mut light.elevation, -90.0..=90.0);
                degrees(ui, "angular radius", &mut light.angular_radius, 0.0..=45.0);
            } else {
                ui.weak("Its place is among all keys.");
            }
            ui.horizontal(|ui| {
                let intensity = DragValue::new(&mut light.intensity).range(0.0..=1e6).speed(0.01);
                ui.add(intensity).accessible_name("intensity");
                ui.label("intensity");
            });
            ui.horizontal(|ui| {
                ui.color_edit_button_rgb(&mut light.color).accessible_name("colour of the light");
                ui.label("colour");
            });
            ui.checkbox(&mut light.shadows, "shadows");
        });
    });
}

fn camera(ui: &mut Ui, scene: &mut Scene) {
    let camera = &mut scene.camera;
    if camera.position.is_some() {
        ui.weak("The eye is at a place of its own; a drag puts it on an orbit.");
    } else {
        degrees(ui, "azimuth", &mut camera.azimuth, -180.0..=180.0);
        degrees(ui, "elevation", &mut camera.elevation, -89.0..=89.0);
    }
    degrees(ui, "roll", &mut camera.roll, -180.0..=180.0);
    ui.add(Slider::new(&mut camera.zoom, 0.1..=20.0).logarithmic(true).text("zoom"));
    degrees(ui, "field of view", &mut camera.field_of_view, 1.0..=120.0);
    ui.add(Slider::new(&mut scene.film.exposure, -5.0..=5.0).text("exposure, stops"));
    let mut rays = scene.film.refinement;
    ComboBox::from_label("smooth edges").selected_text(if rays > 1 { "on" } else { "off" }).show_ui(ui, |ui| {
        ui.selectable_value(&mut rays, 1, "off");
        ui.selectable_value(&mut rays, 3, "on");
        ui.selectable_value(&mut rays, 6, "best");
    });
    scene.film.refinement = rays;
}

fn degrees(ui: &mut Ui, name: &str, value: &mut f32, range: std::ops::RangeInclusive<f32>) {
    ui.horizontal(|ui| {
        ui.add(DragValue::new(value).range(range).speed(0.5).suffix("°").max_decimals(1)).accessible_name(name);
        ui.label(name);
    });
}
