//! Panels of keys, used as a person uses them.

use eframe::egui::{Key, Modifiers, ScrollArea, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use vitrum::composition::Composition;
use vitrum::scene::{Annotation, Light, LightKind, Scene};
use vitrum_viewer::panels::{Panels, command, show};

#[derive(Default)]
struct State {
    scene: Scene,
    panels: Panels,
}

fn harness(theme: Theme, height: f32) -> Harness<'static, State> {
    let builder = Harness::builder().with_size(vec2(420.0, height)).with_theme(theme).with_pixels_per_point(1.0);
    let mut harness = builder.build_ui_state(
        |ui, state: &mut State| {
            ScrollArea::vertical().show(ui, |ui| show(ui, &mut state.panels, &mut state.scene));
        },
        State::default(),
    );
    harness.run();
    harness
}

fn click(harness: &mut Harness<'_, State>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn type_into(harness: &mut Harness<'_, State>, label: &str, text: &str) {
    click(harness, label);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(eframe::egui::Event::Text(text.to_owned()));
    harness.key_press(Key::Enter);
    harness.run();
}

#[test]
fn sections_are_closed_at_first_and_a_key_is_typed_and_reset() {
    let mut harness = harness(Theme::Dark, 900.0);
    assert!(harness.query_by_label("camera.azimuth").is_none());
    click(&mut harness, "Camera");
    type_into(&mut harness, "camera.azimuth", "12.5");
    assert_eq!(harness.state().scene.camera.azimuth, 12.5);
    click(&mut harness, "reset camera.azimuth");
    assert_eq!(harness.state().scene, Scene::default());
}

#[test]
fn the_filter_opens_the_sections_of_what_it_finds() {
    let mut harness = harness(Theme::Dark, 900.0);
    harness.state_mut().panels.filter = "supersampling".to_owned();
    harness.run();
    assert!(harness.query_by_label("film.supersampling").is_some());
    assert!(harness.query_by_label("film.width").is_none() && harness.query_by_label("Camera").is_none());
}

#[test]
fn numbers_stay_in_their_range() {
    let mut harness = harness(Theme::Dark, 900.0);
    harness.state_mut().panels.filter = "film.width".to_owned();
    harness.run();
    type_into(&mut harness, "film.width", "99999999");
    assert_eq!(harness.state().scene.film.width, 16384);
    harness.state().scene.check_settings().expect("it is valid");
}

#[test]
fn lists_get_longer_and_shorter() {
    let mut harness = harness(Theme::Dark, 900.0);
    click(&mut harness, "Light (1)");
    click(&mut harness, "add to light");
    assert_eq!(harness.state().scene.light, [Light::default(), Light::default()]);
    click(&mut harness, "remove light.0");
    assert_eq!(harness.state().scene.light.len(), 1);
    click(&mut harness, "Isosurface (0)");
    click(&mut harness, "add to isosurface");
    assert_eq!(harness.state().scene.isosurface.len(), 1);
}

#[test]
fn optional_sections_come_and_go_and_switches_switch() {
    let mut harness = harness(Theme::Dark, 900.0);
    click(&mut harness, "Ground (none)");
    click(&mut harness, "add ground");
    assert!(harness.state().scene.ground.is_some());
    click(&mut harness, "remove ground");
    assert_eq!(harness.state().scene.ground, None);
    click(&mut harness, "Environment");
    click(&mut harness, "environment.visible");
    assert!(!harness.state().scene.environment.visible);
}

#[test]
fn a_choice_that_needs_another_key_waits_for_it_and_says_so() {
    let mut harness = harness(Theme::Dark, 1100.0);
    harness.state_mut().panels.filter = "light".to_owned();
    harness.run();
    let State { scene, panels } = harness.state_mut();
    panels.set(scene, "light.0.kind=point");
    harness.run();
    assert!(harness.query_by_label("Not in the picture yet").is_some());
    assert_eq!(harness.state().scene.light[0].kind, LightKind::Distant);
    click(&mut harness, "Take back");
    assert!(harness.query_by_label("Not in the picture yet").is_none());
    assert_eq!(harness.state().scene, Scene::default());
}

#[test]
fn every_section_of_every_kind_is_shown_without_a_panic() {
    let mut harness = harness(Theme::Light, 6000.0);
    let scene = &mut harness.state_mut().scene;
    for setting in [
        "ground={}",
        "wall={}",
        "medium={}",
        "crop={}",
        "clip=[{}]",
        "isosurface=[{value=3}]",
        "material=[{}]",
        "mesh=[{}]",
    ] {
        // Some keys do not go with others; they are shown all the same.
        let _ = scene.set(setting);
    }
    scene.annotation = vec![Annotation::default()];
    // Everything has a letter in its name.
    harness.state_mut().panels.filter = "e".to_owned();
    harness.run();
    for label in ["ground.color", "wall.azimuth", "isosurface.0.value", "annotation.0.size", "sweep.sample_distance"] {
        assert!(harness.query_all_by_label(label).next().is_some(), "{label}");
    }
}

#[test]
fn the_panels_are_there_in_both_themes() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut harness = harness(theme, 900.0);
        click(&mut harness, "Light (1)");
        click(&mut harness, "Ground (none)");
        click(&mut harness, "add ground");
        let State { scene, panels } = harness.state_mut();
        panels.set(scene, "light.0.azimuth=20");
        panels.set(scene, "light.0.radius=2");
        harness.run();
        assert!(harness.query_all_by_label_contains("radius").next().is_some(), "{name}");
    }
}

#[test]
fn the_command_of_a_changed_scene_composes_it_again() {
    let composition = Composition {
        input: "builtin:ball".to_owned(),
        preset: Some("haze".to_owned()),
        settings: vec!["volume.resolution=16".to_owned()],
        ..Composition::default()
    };
    let composed = composition.compose().expect("a built-in scene");
    let mut scene = composed.scene;
    let mut panels = Panels::default();
    for setting in ["camera.azimuth=70", "light.1={}", "shading.specular=0.5"] {
        assert!(panels.set(&mut scene, setting), "{setting}");
    }
    let text = command(&composition, &scene, &composed.assets, "a picture.png").expect("it is one");
    assert!(text.starts_with("vitrum render builtin:ball '--output=a picture.png' --preset=haze"), "{text}");
    let leading = composition.leading_to(&scene, &composed.assets).expect("settings lead to it");
    assert_eq!(leading.compose().expect("it is valid").scene, scene);
}
