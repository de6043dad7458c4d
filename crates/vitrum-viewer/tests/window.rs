//! The window's main flows, without a window: opening, turning, undoing, switching the backend, and what goes wrong.

use eframe::egui::{Key, Modifiers, Pos2, Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::time::{Duration, Instant};
use vitrum::backend::Choice;
use vitrum::composition::{Composed, Composition};
use vitrum::scene::{Clip, Motion};
use vitrum_viewer::viewer::AnimationChoice;
use vitrum_viewer::worker::DeviceOptions;
use vitrum_viewer::{Options, Viewer};

type Window<'a> = Harness<'a, Option<Viewer>>;

/// A window that opens `input` with pictures of 64 × 48 pixels on the CPU.
fn window<'a>(input: Option<&str>) -> Window<'a> {
    let input = input.map(str::to_owned);
    let show = move |ui: &mut eframe::egui::Ui, viewer: &mut Option<Viewer>| {
        let options = || Options {
            input: input.clone(),
            backend: Choice::Cpu,
            device: DeviceOptions { threads: Some(1), ..DeviceOptions::default() },
            size: Some([64, 48]),
            ..Options::default()
        };
        viewer.get_or_insert_with(|| Viewer::new(options(), ui.ctx()).expect("a thread")).ui(ui);
    };
    Harness::builder().with_size(vec2(1000.0, 700.0)).build_ui_state(show, None)
}

fn viewer<'a>(window: &'a mut Window<'_>) -> &'a mut Viewer {
    window.state_mut().as_mut().expect("the first frame made it")
}

/// Steps until `done`, which a thread elsewhere brings about.
fn until(window: &mut Window<'_>, what: &str, done: impl Fn(&Viewer) -> bool) {
    let end = Instant::now() + Duration::from_secs(60);
    loop {
        window.step();
        if window.state().as_ref().is_some_and(&done) {
            return;
        }
        assert!(Instant::now() < end, "{what} does not come");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn is_complete(viewer: &Viewer) -> bool {
    !viewer.is_waiting() && viewer.standing().is_some_and(|standing| standing.complete)
}

/// A window with a complete picture of a small ball.
fn with_ball<'a>() -> Window<'a> {
    let mut window = window(Some("builtin:ball"));
    until(&mut window, "the ball's picture", is_complete);
    window
}

fn azimuth(window: &mut Window<'_>) -> f32 {
    viewer(window).document().expect("it is open").scene.camera.azimuth
}

/// Drags from the picture's middle.
fn drag(window: &mut Window<'_>, by: [f32; 2]) {
    let middle = window.get_by_label("Picture").rect().center();
    window.drag_at(middle);
    window.step();
    for part in 1..=4_u8 {
        window.hover_at(middle + vec2(by[0], by[1]) * f32::from(part) / 4.0);
        window.step();
    }
    window.drop_at(middle + vec2(by[0], by[1]));
    window.step();
}

#[test]
fn a_drag_turns_the_picture_and_is_undone_at_once() {
    let mut window = with_ball();
    let before = azimuth(&mut window);
    let first = viewer(&mut window).standing().expect("a picture").number;
    drag(&mut window, [80.0, 0.0]);
    assert!(azimuth(&mut window) < before - 5.0, "{}", azimuth(&mut window));
    until(&mut window, "the turned picture", |viewer| {
        viewer.standing().is_some_and(|standing| standing.complete && standing.number > first)
    });
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.step();
    assert_eq!(azimuth(&mut window), before);
    window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    window.step();
    assert!(azimuth(&mut window) < before - 5.0);
}

#[test]
fn keys_turn_the_camera_too() {
    let mut window = with_ball();
    let before = azimuth(&mut window);
    window.key_press(Key::ArrowRight);
    window.step();
    assert_eq!(azimuth(&mut window), before - 5.0);
    window.key_press(Key::Num3);
    window.step();
    assert_eq!(azimuth(&mut window), -90.0);
    window.key_press(Key::Home);
    window.step();
    assert_eq!(azimuth(&mut window), before);
}

#[test]
fn the_complete_picture_is_that_of_the_saved_scene() {
    let mut window = with_ball();
    drag(&mut window, [33.0, -21.0]);
    let azimuth = azimuth(&mut window);
    until(&mut window, "the turned picture", is_complete);
    let folder = tempfile::tempdir().expect("a folder");
    let (scene, picture) = (folder.path().join("scene.toml"), folder.path().join("picture.png"));
    viewer(&mut window).save_scene(&scene);
    viewer(&mut window).save_picture(&picture, [64, 48]);
    until(&mut window, "the file", |_| picture.exists());
    let composition = Composition { input: scene.display().to_string(), ..Composition::default() };
    let Composed { scene, assets, .. } = composition.compose().expect("the saved scene is one");
    assert_eq!(scene.camera.azimuth, azimuth);
    let mut backend = vitrum::backend::CpuBackend::new(Some(1)).expect("a thread");
    let frame = vitrum::render(&scene, &assets, &mut backend, &mut |_| true).expect("a frame");
    let exact = vitrum_annotations::screen_picture(frame, None, false).expect("a picture").to_srgb8();
    let standing = viewer(&mut window).standing().expect("a picture");
    assert!(standing.shown.pixels == exact, "the window and the library differ");
    let written = vitrum::io::read_picture(&picture).expect("it was written").to_srgb8();
    assert!(written == exact, "the file and the library differ");
}

#[test]
fn a_turntable_is_the_command_lines_and_one_that_is_given_up_leaves_nothing() {
    let mut window = with_ball();
    let folder = tempfile::tempdir().expect("a folder");
    let wanted = folder.path().join("turn");
    let choice = AnimationChoice { size: [32, 24], frames: 3, ..AnimationChoice::default() };
    viewer(&mut window).save_animation(&wanted, &choice);
    until(&mut window, "the animation", |viewer| !viewer.is_exporting());
    let document = viewer(&mut window).document().expect("it is open");
    let (mut scene, assets) = (document.scene.clone(), document.data.assets.clone());
    [scene.film.width, scene.film.height] = choice.size;
    let start = vitrum::framed_all_round(&scene, &assets).expect("a scene");
    let mut backend = vitrum::backend::CpuBackend::new(Some(1)).expect("a thread");
    for index in 0..3 {
        let scene = Motion::Turn(360.0).at(&start, index, 3).expect("a scene");
        let frame = vitrum::render(&scene, &assets, &mut backend, &mut |_| true).expect("a frame");
        let exact = vitrum_annotations::screen_picture(frame, None, false).expect("a picture").to_srgb8();
        let file = vitrum::io::Animation::frame_file(&wanted, index);
        let written = vitrum::io::read_picture(&file).expect("it was written").to_srgb8();
        assert!(written == exact, "picture {index} differs");
    }
    let given_up = folder.path().join("given up");
    viewer(&mut window).save_animation(&given_up, &AnimationChoice { frames: 100_000, ..choice.clone() });
    window.step();
    viewer(&mut window).cancel_export();
    until(&mut window, "the end", |viewer| !viewer.is_exporting());
    // What is there already is kept.
    viewer(&mut window).save_animation(&wanted, &choice);
    until(&mut window, "the message", |viewer| viewer.trouble().is_some());
    let names: Vec<_> = folder.path().read_dir().expect("a folder").flatten().map(|entry| entry.file_name()).collect();
    assert_eq!(names, ["turn"]);
}

#[test]
fn a_face_of_the_crop_box_and_a_plane_are_dragged_in_the_picture() {
    let mut window = with_ball();
    viewer(&mut window).document_mut().expect("it is open").scene.clip = vec![Clip::default()];
    viewer(&mut window).show_handles(true);
    window.run_steps(2);
    let drag = |window: &mut Window<'_>, name: &str, by: [f32; 2]| {
        let place = window.get_by_label(name).rect().center();
        window.drag_at(place);
        window.step();
        window.hover_at(place + vec2(by[0], by[1]));
        window.step();
        window.drop_at(place + vec2(by[0], by[1]));
        window.step();
        window.get_by_label(name).rect().center() - place
    };
    let before = azimuth(&mut window);
    // The handle goes along its axis, and no further than the hand.
    let moved = drag(&mut window, "Crop z high", [0.0, 60.0]);
    let scene = viewer(&mut window).document().expect("it is open").scene.clone();
    let crop = scene.crop.expect("a crop box");
    assert!(crop.max[2] < 0.95 && crop.max[..2] == [1.0; 2] && crop.min == [0.0; 3], "{crop:?}");
    assert!((moved.y - 60.0).abs() < 12.0, "{moved:?}");
    drag(&mut window, "Clipping plane 1", [30.0, 25.0]);
    let scene = viewer(&mut window).document().expect("it is open").scene.clone();
    assert_ne!(scene.clip[0].offset, 0.0);
    assert_eq!(azimuth(&mut window), before);
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.step();
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.step();
    assert_eq!(viewer(&mut window).document().expect("it is open").scene.crop, None);
}

#[test]
fn the_backend_is_switched_in_the_menu() {
    let mut window = with_ball();
    let first = viewer(&mut window).standing().expect("a picture").number;
    window.get_by_label("Backend").click();
    window.step();
    window.step();
    // The CPU, where there is no graphics card: pictures of both backends are compared elsewhere.
    window.get_by_label("Automatic").click();
    until(&mut window, "another picture", |viewer| {
        is_complete(viewer) && viewer.standing().is_some_and(|standing| standing.number > first)
    });
    assert_eq!(viewer(&mut window).backend(), Choice::Auto);
}

#[test]
fn what_goes_wrong_is_said_with_what_to_do() {
    let mut window = window(Some("no such file.nrrd"));
    until(&mut window, "the message", |viewer| viewer.trouble().is_some());
    window.step();
    assert!(window.query_by_label_contains("no such file.nrrd").is_some());
    assert!(window.query_by_label_contains("What to do:").is_some());
    window.get_by_label("Close").click();
    window.step();
    window.step();
    assert!(viewer(&mut window).trouble().is_none());
}

#[test]
fn a_preset_is_chosen_on_the_right() {
    let mut window = with_ball();
    let before = viewer(&mut window).document().expect("it is open").scene.transfer.clone();
    // Pictures of the presets take the place of their names.
    window.run_steps(3);
    until(&mut window, "the last thumbnail", |viewer| !viewer.is_sketching());
    window.run_steps(2);
    let picture = window.get_by_label("bone").rect().center_top() - vec2(0.0, 40.0);
    window.drag_at(picture);
    window.step();
    window.drop_at(picture);
    window.step();
    window.step();
    let document = viewer(&mut window).document().expect("it is open");
    assert_ne!(document.scene.transfer, before);
    assert!(viewer(&mut window).command().expect("a command").contains("--preset=bone"));
}

#[test]
fn the_first_page_offers_built_in_scenes() {
    let mut window = window(None);
    window.step();
    // It lies below the window's edge.
    window.get_by_role_and_label(Role::Button, "ball").scroll_to_me();
    window.run_steps(3);
    window.get_by_role_and_label(Role::Button, "ball").click();
    until(&mut window, "the ball's picture", is_complete);
    assert_eq!(viewer(&mut window).document().expect("it is open").input, "builtin:ball");
}

#[test]
fn a_session_that_was_not_closed_is_offered() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("viewer.json");
    let show = |file: std::path::PathBuf, input: Option<&str>| {
        let input = input.map(str::to_owned);
        let show = move |ui: &mut eframe::egui::Ui, viewer: &mut Option<Viewer>| {
            let options = || Options {
                input: input.clone(),
                backend: Choice::Cpu,
                session_file: Some(file.clone()),
                size: Some([32, 24]),
                ..Options::default()
            };
            viewer.get_or_insert_with(|| Viewer::new(options(), ui.ctx()).expect("a thread")).ui(ui);
        };
        Harness::builder().with_size(vec2(1000.0, 700.0)).build_ui_state(show, None)
    };
    let mut first = show(file.clone(), Some("builtin:ball"));
    until(&mut first, "the ball's picture", is_complete);
    viewer(&mut first).document_mut().expect("it is open").scene.camera.azimuth = 77.0;
    // Some seconds pass, after which it is saved by itself.
    first.run_steps(20);
    drop(first);
    let mut second = show(file.clone(), None);
    second.step();
    second.get_by_label("Go on with it").click();
    until(&mut second, "the ball's picture", is_complete);
    assert_eq!(azimuth(&mut second), 77.0);
    viewer(&mut second).end();
    let mut third = show(file, None);
    third.step();
    assert!(third.query_by_label("Go on with it").is_none());
}

/// A place in the window; kept so that a change of the layout is noticed where tests click.
#[test]
fn the_picture_is_in_the_middle() {
    let mut window = with_ball();
    window.step();
    let rect = window.get_by_label("Picture").rect();
    assert!(rect.contains(Pos2::new(330.0, 350.0)) && rect.width() > 500.0, "{rect:?}");
}
