//! `vitrum turntable`: a film of the camera going round.

use super::render::DeviceArguments;
use crate::failure::{Failure, Status};
use crate::input::{Prepared, SceneArguments};
use crate::interrupt;
use crate::progress::Bar;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use vitrum::backend;
use vitrum::io::{Animation, Picture, write_picture};
use vitrum::scene::Scene;
use vitrum::{Session, Wanted};

/// Render a film of the camera going round
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    pub scene: SceneArguments,

    /// A folder for numbered pictures, which is made if it is missing, or a film: .gif or .png (animated)
    #[arg(short, long, value_name = "FOLDER|FILE")]
    pub output: PathBuf,

    #[command(flatten)]
    pub device: DeviceArguments,

    /// Pictures of a whole turn
    #[arg(long, value_name = "N", default_value_t = 72, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: u32,

    /// How far the camera goes, in degrees; negative to the left
    #[arg(long, value_name = "DEGREES", default_value_t = 360.0, allow_negative_numbers = true)]
    pub turn: f32,

    /// Pictures a second in a film
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u16).range(1..=50))]
    pub rate: u16,

    /// In a folder: leave out the pictures that are there already
    #[arg(long)]
    pub resume: bool,

    /// No messages and no progress bar
    #[arg(short, long)]
    pub quiet: bool,
}

/// Where pictures go.
enum Target<'a> {
    Folder(&'a Path),
    Film(Box<Animation>),
}

impl<'a> Target<'a> {
    fn open(arguments: &'a Arguments, scene: &Scene) -> Result<Self, Failure> {
        let path = arguments.output.as_path();
        if path.extension().is_some() && !path.is_dir() {
            if arguments.resume {
                let message = "a film cannot be resumed";
                return Err(Failure::new(Status::WrongUse, message, "write to a folder, or leave out --resume"));
            }
            let size = [scene.film.width, scene.film.height];
            let film = Animation::create(path, size, arguments.frames, arguments.rate);
            return Ok(Self::Film(Box::new(film.map_err(|error| Failure::output(&error))?)));
        }
        fs::create_dir_all(path).map_err(|error| {
            let message = format!("{}: the folder cannot be made: {error}", path.display());
            Failure::new(Status::WrongUse, message, "choose another folder")
        })?;
        Ok(Self::Folder(path))
    }

    /// The file of a picture, where each has one of its own.
    fn file(&self, index: u32) -> Option<PathBuf> {
        match self {
            Self::Folder(folder) => Some(folder.join(format!("frame-{index:05}.png"))),
            Self::Film(_) => None,
        }
    }

    fn add(&mut self, index: u32, picture: &Picture) -> Result<(), Failure> {
        let written = match (self.file(index), self) {
            (Some(file), _) => write_picture(&file, picture, &[]),
            (None, Self::Film(film)) => film.push(picture),
            (None, Self::Folder(_)) => Ok(()),
        };
        written.map_err(|error| Failure::output(&error))
    }

    fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Folder(_) => Ok(()),
            Self::Film(film) => film.finish().map_err(|error| Failure::output(&error)),
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    interrupt::listen();
    let Prepared { mut scene, inputs, .. } = arguments.scene.prepare()?;
    if scene.camera.position.is_some() {
        let message = "the scene sets camera.position, which a turntable cannot turn";
        return Err(Failure::new(Status::WrongUse, message, "use camera.azimuth and camera.elevation instead"));
    }
    let mut target = Target::open(arguments, &scene)?;
    let device = &arguments.device;
    let mut backend = backend::open(device.backend.into(), device.adapter.as_deref(), device.threads.map(usize::from))?;
    if !arguments.quiet {
        eprintln!("rendering on {} ({})", backend.name(), backend.adapter());
    }
    let start = scene.camera.azimuth;
    let bar = Bar::new(arguments.frames, arguments.quiet);
    let mut session = Session::new(&inputs, backend.as_mut())?;
    for index in 0..arguments.frames {
        if arguments.resume && target.file(index).is_some_and(|file| file.exists()) {
            continue;
        }
        scene.camera.azimuth = start + arguments.turn * index as f32 / arguments.frames as f32;
        let frame = session.render(&scene, Wanted { light: false }, &mut |progress| {
            bar.update(index, &progress);
            !interrupt::requested()
        })?;
        target.add(index, &frame.picture())?;
    }
    target.finish()?;
    Ok(ExitCode::SUCCESS)
}
