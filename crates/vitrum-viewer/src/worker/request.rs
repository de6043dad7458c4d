//! Requests to the rendering thread, and its replies.

use super::picture::Shown;
use crate::trouble::Trouble;
use std::path::PathBuf;
use std::sync::Arc;
use vitrum::scene::{Motion, Scene};
use vitrum::{Assets, Statistics};

/// Called behind each reply, so that the window looks at it.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// The data of a document, with a number by which the thread tells whether it is still the same.
#[derive(Debug, Clone)]
pub struct Data {
    /// The data.
    pub assets: Assets,
    /// A number of its own for each data that was opened.
    pub number: u64,
}

/// A view: everything that the window's picture depends on.
#[derive(Debug, Clone)]
pub struct View {
    /// Number of the request, which its replies repeat.
    pub number: u64,
    /// The scene, at the size that the whole picture has.
    pub scene: Scene,
    /// The scene's data.
    pub data: Data,
    /// Whether the view is about to change again, as while it is dragged: the picture is then made as fast as it must be, and not refined.
    pub moving: bool,
    /// The backend to render on.
    pub backend: vitrum::backend::Choice,
}

/// A small picture of a scene: a thumbnail.
#[derive(Debug, Clone)]
pub struct Sketch {
    /// Name by which the reply is known.
    pub name: String,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// The picture's subject.
    pub subject: SketchSubject,
}

/// The subject of a thumbnail.
#[derive(Debug, Clone)]
pub enum SketchSubject {
    /// A built-in scene, by its name.
    BuiltIn(&'static str),
    /// A scene of data that is there, in the look of a preset.
    Preset(&'static str, Box<Scene>, Data),
}

/// A picture in a file.
#[derive(Debug, Clone)]
pub struct Export {
    /// The scene, with the size of the picture.
    pub scene: Scene,
    /// The scene's data.
    pub data: Data,
    /// The file; its extension names the format.
    pub file: PathBuf,
    /// The backend to render on.
    pub backend: vitrum::backend::Choice,
}

/// An animation in a folder of numbered pictures, or in a file.
#[derive(Debug, Clone)]
pub struct AnimationExport {
    /// Its scene and data, and the folder or file.
    pub export: Export,
    /// The motion.
    pub motion: Motion,
    /// The number of pictures.
    pub frames: u32,
    /// Pictures a second, in a file.
    pub rate: u16,
}

/// What the thread says.
#[derive(Debug)]
pub enum Reply {
    /// A picture of a view.
    Picture {
        /// Number of the request.
        number: u64,
        /// The picture.
        shown: Shown,
        /// Statistics of its frame.
        statistics: Box<Statistics>,
        /// Seconds from the beginning of this picture to its end.
        seconds: f64,
        /// Whether this is the picture that the scene describes, and nothing better comes.
        complete: bool,
    },
    /// A view of which there is no picture.
    Failed {
        /// Number of the request.
        number: u64,
        /// The reason.
        trouble: Trouble,
    },
    /// A thumbnail; `None` where there is none.
    Sketched {
        /// Name of the request.
        name: String,
        /// The picture.
        shown: Option<Shown>,
    },
    /// A picture of an animation is begun.
    Exporting {
        /// The picture, counted from 1.
        picture: u32,
        /// The number of all.
        of: u32,
    },
    /// A picture is in its file.
    Exported {
        /// The file.
        file: PathBuf,
    },
    /// A picture for a file was given up, or failed.
    NotExported {
        /// The reason; `None` where the user gave it up.
        trouble: Option<Trouble>,
    },
    /// Something that the user should know.
    Note(String),
}
