//! The program itself: without a display, and in a real window on a display in memory, driven by synthetic input.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use vitrum::scene::Scene;
use vitrum_viewer::Session;

const PROGRAM: &str = env!("CARGO_BIN_EXE_vitrum-viewer");

#[test]
fn without_a_display_a_sentence_says_so() {
    let mut command = Command::new(PROGRAM);
    command.arg("builtin:ball").env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    if cfg!(any(windows, target_os = "macos")) {
        return;
    }
    let output = command.output().expect("the program starts");
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(4), "{told}");
    assert!(told.contains("there is no display") && told.contains("vitrum render"), "{told}");
}

/// A process that ends with the test.
struct Ending(Child);

impl Drop for Ending {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A display in memory, and its name; `None` where this machine has no program for it.
fn display() -> Option<(Ending, String)> {
    let mut command = Command::new("Xvfb");
    command.args(["-displayfd", "1", "-screen", "0", "1000x700x24", "-nolisten", "tcp"]);
    let mut server = Ending(command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().ok()?);
    let mut name = String::new();
    BufReader::new(server.0.stdout.take()?).read_line(&mut name).ok()?;
    Some((server, format!(":{}", name.trim())))
}

/// Runs xdotool on a display; its output.
fn xdotool(display: &str, words: &[&str]) -> Option<String> {
    let output = Command::new("xdotool").env("DISPLAY", display).args(words).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Asks until there is an answer.
fn until<T>(what: &str, ask: impl Fn() -> Option<T>) -> T {
    let end = Instant::now() + Duration::from_secs(60);
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(Instant::now() < end, "{what} does not come");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// The scene that the program has saved by itself.
fn saved(file: &Path) -> Option<Scene> {
    Scene::from_toml(&Session::read(file).open?.scene, "the session").ok()
}

#[test]
fn a_real_window_is_driven_by_the_mouse() {
    let Some((_server, display)) = display() else {
        println!("[left out] the real window: Xvfb is missing");
        return;
    };
    if xdotool(&display, &["version"]).is_none() {
        println!("[left out] the real window: xdotool is missing");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = Command::new(PROGRAM);
    command.args(["builtin:ball", "--backend", "cpu"]).env("DISPLAY", &display).env_remove("WAYLAND_DISPLAY");
    command.env("XDG_DATA_HOME", folder.path()).env("XDG_RUNTIME_DIR", folder.path());
    let mut program = Ending(command.stderr(Stdio::null()).spawn().expect("the program starts"));
    let session = folder.path().join("vitrum").join("viewer.json");
    let before = until("the window's session", || saved(&session));
    let window = until("the window", || xdotool(&display, &["search", "--name", "Vitrum"]));
    let window = window.lines().next().unwrap_or_default();
    let turned = || saved(&session).filter(|scene| scene.camera.azimuth < before.camera.azimuth - 5.0);
    until("the turned scene", || {
        // On a busy machine a window may see all of a quick drag at once, which then is a click.
        xdotool(&display, &["mousemove", "--window", window, "200", "300", "mousedown", "1"])?;
        for _ in 0..8 {
            std::thread::sleep(Duration::from_millis(100));
            xdotool(&display, &["mousemove_relative", "--sync", "10", "0"])?;
        }
        xdotool(&display, &["mouseup", "1"])?;
        turned()
    });
    assert!(program.0.try_wait().expect("it is a child").is_none(), "the program has ended");
}
