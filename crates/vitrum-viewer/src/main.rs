//! The program `vitrum-viewer`: the live window.

use clap::{Parser, ValueEnum};
use eframe::egui::{Ui, ViewportBuilder};
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::backend::Choice;
use vitrum_viewer::worker::DeviceOptions;
use vitrum_viewer::{Options, Session, Viewer, measure};

/// The exit code where there is no display, no adapter for the window, or no device.
const NO_DEVICE: u8 = 4;

/// Open a volume, turn it, shape light and matter, keep the picture
#[derive(Debug, Parser)]
#[command(name = "vitrum-viewer", version)]
struct Arguments {
    /// A scene file (.toml), a volume file, a mesh, a folder of DICOM files, or builtin:NAME; a page to choose from without it
    input: Option<String>,

    /// Read the scene file again whenever it changes
    #[arg(long, value_name = "SCENE.toml", conflicts_with = "input")]
    watch: Option<PathBuf>,

    /// Where to render; auto takes a hardware GPU if there is one, else the CPU
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,

    /// Take the GPU whose name has this text in it (`vitrum devices` lists them)
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Option<String>,

    /// CPU threads; all cores if absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Neither read nor write what is kept from one run to the next: recent files, and the scene that was open
    #[arg(long)]
    no_session: bool,

    /// Open no window: measure how pictures of the input follow the hand on this machine, and print it
    #[arg(long, value_name = "WxH", requires = "input", num_args = 0..=1, require_equals = true, default_missing_value = "512x512", value_parser = size)]
    measure: Option<[u32; 2]>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Backend {
    Auto,
    Cpu,
    Gpu,
}

impl From<Backend> for Choice {
    fn from(backend: Backend) -> Self {
        match backend {
            Backend::Auto => Self::Auto,
            Backend::Cpu => Self::Cpu,
            Backend::Gpu => Self::Gpu,
        }
    }
}

/// Pixels across and down, such as 512x512.
fn size(text: &str) -> Result<[u32; 2], String> {
    let (width, height) = text.split_once('x').unwrap_or((text, text));
    let edge = |text: &str| text.parse().ok().filter(|edge| (1..=16384).contains(edge));
    edge(width)
        .zip(edge(height))
        .map(|(width, height)| [width, height])
        .ok_or_else(|| "expected such as 512x512".to_owned())
}

impl Arguments {
    fn options(self) -> Options {
        let watched = self.watch.map(|file| file.display().to_string());
        Options {
            watch: watched.is_some(),
            input: self.input.or(watched),
            backend: self.backend.into(),
            device: DeviceOptions { adapter: self.adapter, threads: self.threads.map(usize::from) },
            session_file: if self.no_session { None } else { Session::usual_file() },
            size: None,
        }
    }
}

/// The window's contents in a window.
struct Window(Viewer);

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.0.ui(ui);
    }

    fn on_exit(&mut self) {
        self.0.end();
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    if let (Some(size), Some(input)) = (arguments.measure, &arguments.input) {
        let input = input.clone();
        let options = arguments.options();
        return match measure(&input, size, options.backend, options.device) {
            Ok(text) => {
                print!("{text}");
                ExitCode::SUCCESS
            }
            Err(trouble) => fail(&trouble.message, &trouble.help),
        };
    }
    let options = arguments.options();
    if !has_display() {
        return fail("there is no display for a window", "set DISPLAY or WAYLAND_DISPLAY, or use `vitrum render`");
    }
    let viewport =
        ViewportBuilder::default().with_inner_size([1240.0, 800.0]).with_app_id("vitrum").with_title("Vitrum");
    let native = eframe::NativeOptions { viewport, ..eframe::NativeOptions::default() };
    let run = eframe::run_native(
        "Vitrum",
        native,
        Box::new(|created| {
            let viewer = Viewer::new(options, &created.egui_ctx).map_err(|trouble| trouble.message)?;
            Ok(Box::new(Window(viewer)))
        }),
    );
    match run {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(
            &format!("the window cannot be opened: {error}"),
            "the window needs a display and a driver for it (Debian: mesa-vulkan-drivers libvulkan1); `vitrum render` needs neither",
        ),
    }
}

/// Whether there is a display to open a window on, as far as that can be told.
fn has_display() -> bool {
    let unix = cfg!(all(unix, not(target_os = "macos")));
    !unix
        || ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"]
            .iter()
            .any(|name| std::env::var_os(name).is_some_and(|value| !value.is_empty()))
}

fn fail(message: &str, help: &str) -> ExitCode {
    eprintln!("error: {message}");
    eprintln!("help: {help}");
    ExitCode::from(NO_DEVICE)
}
