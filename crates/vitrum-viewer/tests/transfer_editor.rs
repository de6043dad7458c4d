//! The editor of transfer functions, used as a person uses it.

use eframe::egui::{Key, Modifiers, PointerButton, Pos2, Rect, Theme, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use vitrum::Subject;
use vitrum::io::{Volume, Voxels};
use vitrum::scene::{ColorPoint, IorPoint, OpacityPoint, Scene};
use vitrum_viewer::transfer_editor::{Change, Function, Spot, TransferEditor, show};

/// Noise, a body and a dense core, in values from 0 to 255.
fn volume() -> Volume {
    const SIZE: u32 = 32;
    let voxels = (0..SIZE.pow(3)).map(|index| {
        let at = [index % SIZE, index / SIZE % SIZE, index / (SIZE * SIZE)];
        let distance = at.iter().map(|&i| (i as f32 - 15.5) * (i as f32 - 15.5)).sum::<f32>().sqrt();
        let noise = (index.wrapping_mul(2_654_435_761) >> 28) as u8;
        noise
            + if distance < 6.0 {
                200
            } else if distance < 12.0 {
                90
            } else {
                0
            }
    });
    Volume::new("a body", [SIZE; 3], [1.0; 3], Voxels::from(voxels.collect::<Vec<u8>>())).expect("a volume")
}

struct State {
    scene: Scene,
    editor: TransferEditor,
    last: Change,
    changes: usize,
}

impl State {
    fn new() -> Self {
        let mut scene = Scene::default();
        let opacity = |value, opacity| OpacityPoint { value, opacity };
        scene.transfer.opacity = vec![opacity(50.0, 0.0), opacity(100.0, 0.5), opacity(200.0, 0.8)];
        let color = |value, color| ColorPoint { value, color };
        scene.transfer.color = vec![color(50.0, [0.8, 0.2, 0.1]), color(200.0, [0.9, 0.85, 0.7])];
        scene.transfer.ior = vec![IorPoint::new(60.0, 1.0), IorPoint::new(150.0, 1.4)];
        let editor = TransferEditor::new(&scene, &Subject::from(volume()));
        Self { scene, editor, last: Change::default(), changes: 0 }
    }
}

fn harness(theme: Theme) -> Harness<'static, State> {
    let builder = Harness::builder().with_size(vec2(420.0, 460.0)).with_theme(theme).with_pixels_per_point(1.0);
    // Two clicks are a double click where they come soon after one another.
    let builder = builder.with_step_dt(0.02);
    let mut harness = builder.build_ui_state(
        |ui, state: &mut State| {
            let change = show(ui, &mut state.editor, &mut state.scene);
            state.changes += usize::from(change.changed);
            state.last = change;
        },
        State::new(),
    );
    harness.run();
    harness
}

fn press(harness: &Harness<'_, State>, pos: Pos2, button: PointerButton, pressed: bool) {
    harness.event(eframe::egui::Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE });
}

/// Drags from a place by a way, with a step in between.
fn drag(harness: &mut Harness<'_, State>, from: Pos2, way: Vec2, button: PointerButton) {
    harness.hover_at(from);
    harness.step();
    press(harness, from, button, true);
    harness.step();
    for share in [0.5, 1.0] {
        harness.hover_at(from + way * share);
        harness.step();
    }
    press(harness, from + way, button, false);
    harness.step();
    harness.remove_cursor();
    harness.run();
}

fn click(harness: &mut Harness<'_, State>, at: Pos2, times: usize, button: PointerButton) {
    // So long after the last click that this one is none of a row.
    harness.run_steps(50);
    harness.hover_at(at);
    harness.step();
    for _ in 0..times {
        press(harness, at, button, true);
        press(harness, at, button, false);
    }
    harness.step();
    harness.remove_cursor();
    harness.run();
}

fn rect(harness: &Harness<'_, State>, label: &str) -> Rect {
    harness.get_by_label(label).rect()
}

fn click_on(harness: &mut Harness<'_, State>, label: &str, button: PointerButton) {
    let at = rect(harness, label).center();
    click(harness, at, 1, button);
}

fn opacity(harness: &Harness<'_, State>) -> Vec<[f32; 2]> {
    harness.state().scene.transfer.opacity.iter().map(|point| [point.value, point.opacity]).collect()
}

#[test]
fn a_point_is_dragged_and_the_drag_is_one_step() {
    let mut harness = harness(Theme::Dark);
    let before = harness.state().scene.clone();
    let from = rect(&harness, "opacity point 2").center();
    drag(&mut harness, from, vec2(30.0, -20.0), PointerButton::Primary);
    let moved = rect(&harness, "opacity point 2").center();
    assert!((moved - from - vec2(30.0, -20.0)).length() < 0.6, "{from} to {moved}");
    let [_, [value, height], _] = opacity(&harness)[..] else { panic!("three points") };
    assert!((110.0..140.0).contains(&value) && (0.6..0.75).contains(&height), "{value} {height}");
    assert!(!harness.state().editor.is_dragging());
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(harness.state().scene, before);
    harness.get_by_label("Redo").click();
    harness.run();
    assert_eq!(opacity(&harness)[1], [value, height]);
    harness.state().scene.check_settings().expect("the scene stays valid");
}

#[test]
fn a_point_does_not_pass_its_neighbours() {
    let mut harness = harness(Theme::Dark);
    let from = rect(&harness, "opacity point 2").center();
    drag(&mut harness, from, vec2(300.0, 300.0), PointerButton::Primary);
    assert_eq!(opacity(&harness)[1], [200.0, 0.0]);
    harness.state().scene.check_settings().expect("a step is valid");
}

#[test]
fn points_are_added_on_the_curve_and_by_a_double_click_and_removed() {
    let mut harness = harness(Theme::Dark);
    let [second, third] = ["opacity point 2", "opacity point 3"].map(|label| rect(&harness, label).center());
    click(&mut harness, second.lerp(third, 0.5), 1, PointerButton::Primary);
    let points = opacity(&harness);
    assert!(
        points.len() == 4 && (points[2][0] - 150.0).abs() < 1.5 && (points[2][1] - 0.65).abs() < 0.01,
        "{points:?}"
    );
    let plot = rect(&harness, "plot of the opacity");
    click(&mut harness, plot.left_top() + vec2(24.0, 30.0), 2, PointerButton::Primary);
    let points = opacity(&harness);
    assert!(points.len() == 5 && points[0][1] > 0.7, "{points:?}");
    assert_eq!(harness.state().editor.selected, Some((Function::Opacity, 0)));
    click_on(&mut harness, "opacity point 1", PointerButton::Secondary);
    assert_eq!(opacity(&harness).len(), 4);
    click_on(&mut harness, "opacity point 3", PointerButton::Primary);
    harness.key_press(Key::Delete);
    harness.run();
    assert_eq!(opacity(&harness), [[50.0, 0.0], [100.0, 0.5], [200.0, 0.8]]);
    assert!(harness.state().changes >= 4);
}

#[test]
fn arrow_keys_move_the_point_that_has_the_focus() {
    let mut harness = harness(Theme::Dark);
    click_on(&mut harness, "opacity point 2", PointerButton::Primary);
    harness.key_press(Key::ArrowUp);
    harness.run();
    let [_, [value, height], _] = opacity(&harness)[..] else { panic!("three points") };
    assert!(value == 100.0 && height > 0.5 && height < 0.52, "{value} {height}");
}

#[test]
fn numbers_are_typed_exactly() {
    let mut harness = harness(Theme::Dark);
    click_on(&mut harness, "index of refraction point 2", PointerButton::Primary);
    for (label, text) in [("value of the point", "123.456"), ("index of refraction of the point", "1.333")] {
        harness.get_by_label(label).click();
        harness.run();
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(eframe::egui::Event::Text(text.to_owned()));
        harness.key_press(Key::Enter);
        harness.run();
    }
    let point = harness.state().scene.transfer.ior[1];
    assert_eq!((point.value, point.ior), (123.456, 1.333));
}

#[test]
fn the_window_is_stretched_by_its_ends_by_the_right_button_and_by_numbers() {
    let mut harness = harness(Theme::Dark);
    let from = rect(&harness, "high end of the window").center();
    drag(&mut harness, from, vec2(-40.0, 0.0), PointerButton::Primary);
    let [low, high] = harness.state().editor.window(&harness.state().scene);
    assert!((low - 50.0).abs() < 1e-3 && (160.0..185.0).contains(&high), "{low} {high}");
    harness.get_by_label("Undo").click();
    harness.run();
    let plot = rect(&harness, "plot of the opacity");
    drag(&mut harness, plot.left_top() + vec2(30.0, 40.0), vec2(50.0, 0.0), PointerButton::Secondary);
    let window = harness.state().editor.window(&harness.state().scene);
    assert!(window[0] > 70.0 && (window[1] - window[0] - 150.0).abs() < 1e-2, "{window:?}");
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(opacity(&harness), [[50.0, 0.0], [100.0, 0.5], [200.0, 0.8]]);
}

#[test]
fn presets_and_maps_of_colours_are_chosen_by_name() {
    let mut harness = harness(Theme::Dark);
    harness.state_mut().scene.camera.azimuth = 77.0;
    let before = harness.state().scene.clone();
    for (menu, name) in [("Presets", "haze"), ("Colours", "viridis")] {
        harness.get_by_label(menu).click();
        harness.run();
        harness.get_by_label(name).click();
        harness.run();
    }
    let scene = &harness.state().scene;
    assert!(scene.transfer.color.len() > 8 && scene.camera.azimuth == 77.0);
    assert_ne!(scene.transfer.opacity, before.transfer.opacity);
    scene.check_settings().expect("it is valid");
    for _ in 0..2 {
        harness.get_by_label("Undo").click();
        harness.run();
    }
    assert_eq!(harness.state().scene, before);
}

#[test]
fn a_preset_that_does_not_fit_is_told_and_changes_nothing() {
    let mut state = State::new();
    let before = state.scene.clone();
    assert!(!state.editor.apply_preset(&mut state.scene, "ct-bone"));
    assert!(state.editor.has_failed() && state.scene == before);
}

#[test]
fn functions_go_to_a_file_for_paraview_and_come_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("function.json");
    let mut state = State::new();
    assert!(state.editor.export(&state.scene, &file));
    let mut other = State::new();
    other.scene.transfer.opacity.clear();
    other.editor.follow(&other.scene);
    assert!(other.editor.import(&mut other.scene, &file));
    assert_eq!(other.scene.transfer.opacity, state.scene.transfer.opacity);
    assert!(!other.editor.import(&mut other.scene, &folder.path().join("none.vp")) && other.editor.has_failed());
    other.editor.undo(&mut other.scene);
    assert!(other.scene.transfer.opacity.is_empty());
    // Of 3D Slicer: six numbers, opacities, opacities of gradients, colours.
    let property = "1\n1\n0.9\n0.1\n0.2\n10\n4 0 0 100 0.5\n4 0 1 255 1\n8 0 0 0 0 100 1 0.5 0.2\n";
    let slicer = folder.path().join("skull.vp");
    std::fs::write(&slicer, property).expect("the folder is writable");
    state.editor.import(&mut state.scene, &slicer);
    assert!(!state.editor.has_failed());
}

#[test]
fn colours_of_a_strip_are_added_and_moved() {
    let mut harness = harness(Theme::Light);
    let strip = rect(&harness, "strip of the colour");
    click(&mut harness, strip.center_top() + vec2(0.0, 6.0), 2, PointerButton::Primary);
    assert_eq!(harness.state().scene.transfer.color.len(), 3);
    let from = rect(&harness, "colour point 2").center();
    drag(&mut harness, from, vec2(12.0, 0.0), PointerButton::Primary);
    assert!((rect(&harness, "colour point 2").center().x - from.x - 12.0).abs() < 0.6);
    // A filter that is white everywhere gets its ends, and the point between them.
    let strip = rect(&harness, "strip of the filter");
    click(&mut harness, strip.center_top() + vec2(0.0, 6.0), 2, PointerButton::Primary);
    let filter = Function::Filter.spots(&harness.state().scene.transfer);
    assert!(filter.len() == 3 && filter.iter().all(|Spot { level, .. }| *level == [1.0; 3]), "{filter:?}");
}

#[test]
fn a_change_from_elsewhere_is_a_step_of_its_own() {
    let mut harness = harness(Theme::Dark);
    harness.state_mut().scene.light[0].azimuth = 5.0;
    harness.run();
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(harness.state().scene.light[0].azimuth, Scene::default().light[0].azimuth);
}

#[test]
fn the_editor_is_there_in_both_themes() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut harness = harness(theme);
        click_on(&mut harness, "opacity point 2", PointerButton::Primary);
        assert!(harness.query_by_label("opacity point 2").is_some(), "{name}");
    }
}
