//! `vitrum turntable`: an animation of the camera going round, or along key frames.

mod over_time;
mod part;
mod record;
mod target;
mod timeline;

use crate::device::{DeviceArguments, MemoryArguments};
use crate::failure::Failure;
use crate::faster;
use crate::figure::{Figure, check_background};
use crate::input::SceneArguments;
use crate::interrupt::{self, Timeout};
use crate::output::{self, Bits};
use crate::progress::Bar;
use clap::Args;
use over_time::OverTime;
use part::Part;
use record::Record;
use serde_json::Value;
use std::path::PathBuf;
use std::process::ExitCode;
use target::Target;
use timeline::Timeline;
use vitrum::composition::Composed;
use vitrum::{Layers, MovingMeshes, OutputRequest, framed_all_round};

/// Render an animation of the camera going round, or of a scene that changes along key frames
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    pub scene: SceneArguments,

    /// A folder for numbered pictures, which is made if it is missing, or an animation: .gif, .png (animated) or .mp4 (by ffmpeg)
    #[arg(short, long, value_name = "FOLDER|FILE")]
    pub output: PathBuf,

    #[command(flatten)]
    pub device: DeviceArguments,

    #[command(flatten)]
    pub memory: MemoryArguments,

    /// Pictures of a whole turn, 72 if absent; with --keys all up to the last key frame; with --over-time one for each point in time
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: Option<u32>,

    /// How far the camera goes, in degrees; negative to the left; 360 if absent, and 0 with --over-time
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, conflicts_with = "keys")]
    pub turn: Option<f32>,

    /// Show a volume's points in time one after the other; the look is fitted to the one that --time names, or the first
    #[arg(long, conflicts_with = "keys")]
    pub over_time: bool,

    /// Key frames of any scene keys, interpolated smoothly; the camera does not turn by itself then
    #[arg(long, value_name = "FILE.toml")]
    pub keys: Option<PathBuf>,

    /// Pictures a second in an animation
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u16).range(1..=240))]
    pub rate: u16,

    /// Bits per channel of the pictures in a folder
    #[arg(long, value_enum, value_name = "8|16", hide_possible_values = true, default_value_t = Bits::Eight)]
    pub bits: Bits,

    /// In a folder: leave out the pictures that are there already
    #[arg(long)]
    pub resume: bool,

    /// In a folder: render every N-th picture alone, from the I-th, counted from 0; N calls, on any machines, make all of them
    #[arg(long, value_name = "I/N")]
    pub part: Option<Part>,

    /// Also write the statistics of every frame, with times, as JSON
    #[arg(long, value_name = "FILE.json")]
    pub stats: Option<PathBuf>,

    /// End with exit code 124 when it takes longer; an animation is not written then
    #[arg(long, value_name = "SECONDS")]
    pub timeout: Option<Timeout>,

    /// No messages and no progress bar
    #[arg(short, long)]
    pub quiet: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    interrupt::listen(arguments.timeout);
    arguments.device.limit_threads()?;
    // Before the volume: a slip in it should not cost the time to read one.
    let keys = arguments.keys.as_deref().map(|path| timeline::read_keys(path, arguments.rate)).transpose()?;
    let Composed { scene, assets, base, notes } = arguments.scene.compose()?;
    let input = (arguments.scene.input.as_str(), arguments.scene.volume.limit());
    let over_time = arguments.over_time.then(|| OverTime::new(input, &scene, &base, &assets)).transpose()?;
    output::tell(&arguments.scene.input, &notes, arguments.quiet);
    let mut meshes = MovingMeshes::new(base, arguments.scene.volume.limit());
    let points = over_time.as_ref().map(OverTime::frames);
    // The camera keeps its distance on its way.
    let scene = framed_all_round(&scene, &assets)?;
    let timeline = Timeline::new(arguments, scene, &assets, &mut meshes, keys, points)?;
    arguments.memory.check(timeline.start())?;
    check_background(timeline.start(), &arguments.output)?;
    let figure = Figure::new(timeline.start(), &assets)?;
    if !arguments.quiet {
        figure.tell(&arguments.output);
    }
    arguments.stats.as_deref().map_or(Ok(()), output::check_writable)?;
    let mut target = Target::open(arguments, timeline.start(), timeline.frames())?;
    let record = Record::of(&assets);
    let part = arguments.part.unwrap_or_default();
    let done = |index: u32, file: Option<PathBuf>| match file {
        _ if !part.has(index) => Ok(true),
        Some(file) if arguments.resume => record.is_done(&file, &timeline.scene(index)?),
        _ => Ok(false),
    };
    // All before any work: a picture of another scene may be the last one.
    let done = (0..timeline.frames()).map(|index| done(index, target.file(index))).collect::<Result<Vec<_>, _>>()?;
    let mut renderer = arguments.device.renderer(&assets, &arguments.memory, arguments.quiet)?;
    let advice = faster::advice(timeline.start(), renderer.backend().name());
    let bar = Bar::new(timeline.frames(), arguments.quiet).warning_of_long_work(arguments.quiet, advice);
    let mut statistics = Vec::new();
    for index in (0..).zip(&done).filter_map(|(index, done)| (!done).then_some(index)) {
        let scene = timeline.scene(index)?;
        if let Some(over_time) = &over_time {
            renderer.show(over_time.at(index, timeline.frames())?);
        }
        if timeline.moves_meshes() {
            renderer.deform(meshes.at(&scene.mesh)?);
        }
        let request = OutputRequest { light: false, layers: Layers::color(), ..OutputRequest::default() };
        let frame = renderer.render(&scene, request, &mut |progress| {
            bar.update(index, &progress);
            !interrupt::requested()
        })?;
        interrupt::check()?;
        let figure = Figure::new(&scene, renderer.assets())?;
        let of_picture = frame.statistics.clone();
        let picture = figure.screen_picture(frame, target.is_opaque())?;
        target.add(index, &picture, &[record.mark(&scene)?])?;
        let mut of_frame = serde_json::json!({ "frame": index });
        if let (Value::Object(of_frame), Ok(Value::Object(more))) = (&mut of_frame, serde_json::to_value(&of_picture)) {
            of_frame.extend(more);
        }
        statistics.push(of_frame);
    }
    target.finish()?;
    if let Some(file) = &arguments.stats {
        output::write_text(file, &output::json(&serde_json::json!({ "frames": statistics })))?;
    }
    Ok(ExitCode::SUCCESS)
}
