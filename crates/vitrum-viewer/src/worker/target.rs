//! The place of an animation's pictures: a folder of numbered files, or one file.

use crate::trouble::Trouble;
use std::fs;
use std::path::{Path, PathBuf};
use vitrum::io::{Animation, Picture, WriteOptions, write_picture_with};

/// The place of an animation's pictures. It gets its name when all pictures are there; what is dropped before leaves nothing.
pub(super) enum Target {
    Folder(Unfinished),
    File { animation: Box<Animation>, is_opaque: bool },
}

/// A folder beside the one that is wanted, which it becomes.
pub(super) struct Unfinished {
    folder: PathBuf,
    wanted: PathBuf,
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        // Once it has its name there is nothing here any more.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

impl Target {
    /// Begins an animation of pictures of `size` pixels: a file where the path has an extension, else a folder, which must be new or empty.
    pub fn begin(path: &Path, size: [u32; 2], frames: u32, rate: u16) -> Result<Self, Trouble> {
        if path.extension().is_some() && !path.is_dir() {
            let animation = Box::new(Animation::create(path, size, frames, rate)?);
            let is_opaque = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("mp4"));
            return Ok(Self::File { animation, is_opaque });
        }
        if fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_some()) {
            let message = format!("{}: the folder is not empty", path.display());
            return Err(Trouble::new(message, "choose a new folder, or empty this one"));
        }
        let Some(name) = path.file_name() else {
            return Err(Trouble::new(format!("{}: this is no name of a folder", path.display()), "name a new folder"));
        };
        let mut beside = name.to_owned();
        beside.push(".unfinished");
        let folder = path.with_file_name(beside);
        let failed = |error: std::io::Error| {
            let message = format!("{}: the folder cannot be made: {error}", folder.display());
            Trouble::new(message, "delete what has this name, or choose another folder")
        };
        fs::create_dir(&folder).map_err(failed)?;
        Ok(Self::Folder(Unfinished { folder, wanted: path.to_owned() }))
    }

    /// Whether the pictures are to have no alpha, as those of a film.
    pub fn is_opaque(&self) -> bool {
        matches!(self, Self::File { is_opaque: true, .. })
    }

    /// Adds a picture.
    pub fn add(&mut self, index: u32, picture: &Picture) -> Result<(), Trouble> {
        match self {
            Self::Folder(unfinished) => {
                let file = Animation::frame_file(&unfinished.folder, index);
                Ok(write_picture_with(&file, picture, &[], &WriteOptions::default())?)
            }
            Self::File { animation, .. } => Ok(animation.push(picture)?),
        }
    }

    /// Puts the animation in its place.
    pub fn finish(self) -> Result<(), Trouble> {
        match self {
            Self::Folder(unfinished) => {
                // An empty folder of this name makes way; Windows does not rename onto one.
                let _ = fs::remove_dir(&unfinished.wanted);
                fs::rename(&unfinished.folder, &unfinished.wanted).map_err(|error| {
                    let message = format!("{}: the folder cannot be named: {error}", unfinished.wanted.display());
                    Trouble::new(message, "choose another folder")
                })
            }
            Self::File { animation, .. } => Ok(animation.finish()?),
        }
    }
}
