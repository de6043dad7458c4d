//! Pictures of the whole window, in light and dark. With `VITRUM_SCREENSHOTS=FOLDER` they are left there, to be looked at and shown.

use eframe::egui::{Theme, vec2};
use egui_kittest::Harness;
use std::path::Path;
use std::time::{Duration, Instant};
use vitrum::backend::Choice;
use vitrum::io::{Picture, srgb_to_linear, write_picture};
use vitrum_viewer::{Options, Viewer};

/// The window with a scene and its complete picture.
fn screen(theme: Theme, input: &str, name: &str) {
    if !vitrum::backend::devices().iter().any(|device| device.backend == "gpu") {
        assert_ne!(std::env::var("VITRUM_REQUIRE_GPU").as_deref(), Ok("1"), "there is no graphics adapter");
        println!("[left out] pictures of the window: there is no graphics adapter");
        return;
    }
    let input = input.to_owned();
    let show = move |ui: &mut eframe::egui::Ui, viewer: &mut Option<Viewer>| {
        let options = || Options { input: Some(input.clone()), backend: Choice::Cpu, ..Options::default() };
        viewer.get_or_insert_with(|| Viewer::new(options(), ui.ctx()).expect("a thread")).ui(ui);
    };
    let builder = Harness::builder().with_size(vec2(1100.0, 720.0)).with_theme(theme).wgpu();
    let mut window = builder.build_ui_state(show, None::<Viewer>);
    let end = Instant::now() + Duration::from_secs(120);
    let mut until = |what: &str, done: &dyn Fn(&Viewer) -> bool| {
        while !window.state().as_ref().is_some_and(done) {
            assert!(Instant::now() < end, "{what} does not come");
            window.step();
            std::thread::sleep(Duration::from_millis(10));
        }
        // What came shows in the next frame, which asks for thumbnails.
        window.run_steps(2);
    };
    until("the picture", &|viewer| viewer.standing().is_some_and(|standing| standing.complete));
    until("the last thumbnail", &|viewer| !viewer.is_sketching());
    let image = window.render().expect("the window is drawn");
    let linear = |code: u8| srgb_to_linear(f32::from(code) / 255.0);
    let pixels: Vec<[f32; 3]> = image.pixels().map(|pixel| [0, 1, 2].map(|channel| linear(pixel.0[channel]))).collect();
    let middle = |x: usize, y: usize| pixels[y * image.width() as usize + x];
    let row: Vec<_> = (200..600).map(|x| middle(x, 360)).collect();
    assert!(row.iter().any(|pixel| *pixel != row[0]), "the picture's place is empty");
    if let Some(folder) = std::env::var_os("VITRUM_SCREENSHOTS") {
        let picture = Picture::rgb(image.width(), image.height(), pixels);
        write_picture(&Path::new(&folder).join(format!("{name}.png")), &picture, &[]).expect("it is written");
    }
}

#[test]
fn in_the_dark() {
    screen(Theme::Dark, "builtin:ball", "dark");
}

#[test]
fn in_the_light() {
    screen(Theme::Light, "builtin:vase", "light");
}
