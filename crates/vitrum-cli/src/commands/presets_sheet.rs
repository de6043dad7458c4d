//! `vitrum presets INPUT -o SHEET`: every preset on one input.

use crate::device::{DeviceArguments, MemoryArguments};
use crate::failure::{Failure, Status};
use crate::figure::Figure;
use crate::interrupt::{self, Timeout};
use crate::output;
use crate::progress::Bar;
use crate::size::Size;
use crate::volume::VolumeArguments;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;
use vitrum::composition::{Composed, Composition, Quality, Side};
use vitrum::io::{WriteOptions, check_writable, write_picture_with};
use vitrum::preset::PresetError;
use vitrum::scene::Scene;
use vitrum::{Assets, Layers, OutputRequest, preset};
use vitrum_annotations::{Tile, contact_sheet};

/// Pixels across and down of a small picture.
const TILE: Size = Size { width: 256, height: 256 };

/// Pictures in a row.
const COLUMNS: usize = 3;

/// The input of a contact sheet, and how it is shown.
#[derive(Debug, Args)]
pub struct SheetArguments {
    /// A volume or a mesh, as for `vitrum render`: show each preset on it
    #[arg(requires = "output")]
    pub input: Option<String>,

    /// The contact sheet: .png or another picture
    #[arg(short, long, value_name = "FILE", requires = "input")]
    output: Option<PathBuf>,

    #[command(flatten)]
    volume: VolumeArguments,

    /// Look at the patient from a side: anterior, posterior, left, right, superior or inferior; before --set
    #[arg(long, value_name = "SIDE")]
    view: Option<Side>,

    /// Set a scene key of every picture, such as camera.azimuth=60; repeatable
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,

    /// Pixels across and down of each picture, 256x256 if absent
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,

    #[command(flatten)]
    device: DeviceArguments,

    #[command(flatten)]
    memory: MemoryArguments,

    /// End with exit code 124 and without output when it takes longer
    #[arg(long, value_name = "SECONDS")]
    timeout: Option<Timeout>,

    /// No messages and no progress bar
    #[arg(short, long)]
    quiet: bool,
}

pub fn run(input: &str, arguments: &SheetArguments) -> Result<ExitCode, Failure> {
    interrupt::listen(arguments.timeout);
    arguments.device.limit_threads()?;
    // Clap has seen to it that there is one.
    let file = arguments.output.clone().unwrap_or_else(|| PathBuf::from("presets.png"));
    output::check(&file, check_writable)?;
    let Size { width, height } = arguments.size.unwrap_or(TILE);
    let composition = Composition {
        input: input.to_owned(),
        // Small pictures for a first look, and many of them.
        quality: Some(Quality::Draft),
        size: Some([width, height]),
        source: arguments.volume.source(),
        side: arguments.view,
        settings: arguments.set.clone(),
        max_bytes: arguments.volume.limit(),
        ..Composition::default()
    };
    let Composed { scene, assets, .. } = composition.compose()?;
    arguments.memory.check(&scene)?;
    let scenes = looks(&composition, &scene, &assets)?;
    let mut renderer = arguments.device.renderer(&assets, &arguments.memory, arguments.quiet)?;
    let bar = Bar::new(scenes.len() as u32, arguments.quiet);
    let mut tiles = Vec::new();
    for (index, (name, scene)) in (0..).zip(&scenes) {
        let figure = Figure::new(scene, &assets)?;
        let request = OutputRequest { light: false, layers: Layers::color(), ..OutputRequest::default() };
        let frame = renderer.render(scene, request, &mut |progress| {
            bar.update(index, &progress);
            !interrupt::requested()
        })?;
        tiles.push(Tile { label: (*name).to_owned(), picture: figure.screen_picture(frame, true)? });
    }
    interrupt::check()?;
    let sheet = contact_sheet(input, &tiles, COLUMNS)?;
    write_picture_with(&file, &sheet, &[], &WriteOptions::default()).map_err(|error| Failure::output(&error))?;
    Ok(ExitCode::SUCCESS)
}

/// The scene in each preset for its kind of data; all share the data.
fn looks(composition: &Composition, scene: &Scene, assets: &Assets) -> Result<Vec<(&'static str, Scene)>, Failure> {
    let names = if assets.subject.volume().is_some() { preset::names() } else { preset::mesh_names() };
    let mut scenes = Vec::new();
    for (name, _) in names {
        let mut look = scene.clone();
        match assets.subject.volume() {
            // A preset for other values than these has no picture.
            Some(volume) => match preset::apply(name, volume, &mut look) {
                Err(PresetError::NotHounsfield { .. } | PresetError::NoLabels { .. }) => continue,
                applied => applied?,
            },
            None => preset::apply_to_mesh(name, &mut look)?,
        }
        // A side and settings go before what a preset says.
        composition.change_again(&mut look)?;
        vitrum::check(&look, assets).map_err(|error| Failure::from(error).at(&format!("preset {name}")))?;
        scenes.push((*name, look));
    }
    if scenes.is_empty() {
        return Err(Failure::new(Status::WrongUse, "there are no presets", "use `vitrum render`"));
    }
    Ok(scenes)
}
