//! The target of the pictures: a folder, or an animation.

use super::Arguments;
use crate::failure::{Failure, Status};
use crate::output::{self, Bits};
use std::fs;
use std::path::{Path, PathBuf};
use vitrum::io::{Animation, Picture, WriteOptions, write_picture_with};
use vitrum::scene::Scene;

pub enum Target<'a> {
    Folder(&'a Path, WriteOptions),
    Animation { animation: Box<Animation>, opaque: bool },
}

impl<'a> Target<'a> {
    pub fn open(arguments: &'a Arguments, scene: &Scene, frames: u32) -> Result<Self, Failure> {
        let path = arguments.output.as_path();
        if path.extension().is_some() && !path.is_dir() {
            let refuse = |message: &str, help: &str| Err(Failure::new(Status::WrongUse, message, help));
            if arguments.resume {
                return refuse("an animation cannot be resumed", "write to a folder, or leave out --resume");
            }
            if arguments.part.is_some() {
                return refuse("an animation cannot be made in parts", "write to a folder, or leave out --part");
            }
            if arguments.bits != Bits::Eight {
                return refuse("an animation has 8 bits per channel", "write to a folder, or leave out --bits");
            }
            let size = [scene.film.width, scene.film.height];
            let animation = Animation::create(path, size, frames, arguments.rate);
            let animation = Box::new(animation.map_err(|error| Failure::output(&error))?);
            output::check(path, |_| Ok(()))?;
            let opaque = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("mp4"));
            return Ok(Self::Animation { animation, opaque });
        }
        fs::create_dir_all(path).map_err(|error| {
            let message = format!("{}: the folder cannot be made: {error}", path.display());
            Failure::new(Status::WrongUse, message, "choose another folder")
        })?;
        Ok(Self::Folder(path, arguments.bits.options()))
    }

    /// The file of a picture, where each has one of its own.
    pub fn file(&self, index: u32) -> Option<PathBuf> {
        match self {
            Self::Folder(folder, _) => Some(Animation::frame_file(folder, index)),
            Self::Animation { .. } => None,
        }
    }

    /// Whether the pictures are to have no alpha, as those of a film.
    pub fn is_opaque(&self) -> bool {
        matches!(self, Self::Animation { opaque: true, .. })
    }

    /// Adds a picture; files of their own keep `metadata`.
    pub fn add(&mut self, index: u32, picture: &Picture, metadata: &[(String, String)]) -> Result<(), Failure> {
        let written = match (self.file(index), self) {
            (Some(file), Self::Folder(_, options)) => write_picture_with(&file, picture, metadata, options),
            (_, Self::Animation { animation, .. }) => animation.push(picture),
            (None, Self::Folder(..)) => Ok(()),
        };
        written.map_err(|error| Failure::output(&error))
    }

    pub fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Folder(..) => Ok(()),
            Self::Animation { animation, .. } => animation.finish().map_err(|error| Failure::output(&error)),
        }
    }
}
