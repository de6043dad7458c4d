//! Pictures as the screen shows them: straight alpha, and annotations over them.

use crate::failure::{Failure, Status};
use std::path::Path;
use vitrum::io::{Picture, Staged, stage_text};
use vitrum::scene::{Background, Scene};
use vitrum::{Assets, Frame, Layers};
use vitrum_annotations::{AnnotationError, Overlay, file_picture, is_of_screens, is_opaque, layers_of, screen_picture};

/// What goes over the pictures of a scene.
pub struct Figure {
    overlay: Option<Overlay>,
}

impl Figure {
    /// The annotations of a scene.
    pub fn new(scene: &Scene, assets: &Assets) -> Result<Self, Failure> {
        Ok(Self { overlay: Overlay::framed::<Failure>(scene, assets)? })
    }

    /// The frame's picture as a file gets it: formats of the screen with straight alpha and annotations, others linear and complete.
    pub fn picture(&self, frame: Frame, file: &Path) -> Result<Picture, Failure> {
        Ok(file_picture(frame, self.overlay.as_ref(), file)?)
    }

    /// The frame's picture for a screen; `opaque` for a format without alpha, in which what is clear is black.
    pub fn screen_picture(&self, frame: Frame, opaque: bool) -> Result<Picture, Failure> {
        Ok(screen_picture(frame, self.overlay.as_ref(), opaque)?)
    }

    /// The outputs that a file's picture has.
    pub fn layers(file: &Path) -> Layers {
        layers_of(file)
    }

    /// The SVG document, beside its place until the other files are there, too.
    pub fn stage_svg(&self, file: &Path) -> Result<Staged, Failure> {
        match &self.overlay {
            Some(overlay) => stage_text(file, overlay.svg()).map_err(|error| Failure::output(&error)),
            None => {
                let help = "give the scene an `[[annotation]]`, such as by --set annotation.0.kind=scale_bar";
                Err(Failure::new(Status::WrongUse, "there are no annotations to write", help))
            }
        }
    }

    /// Whether the scene has annotations.
    pub fn is_annotated(&self) -> bool {
        self.overlay.is_some()
    }

    /// Tells what a reader of the picture should know.
    pub fn tell(&self, file: &Path) {
        let Some(overlay) = &self.overlay else { return };
        for note in overlay.notes() {
            eprintln!("note: {note}");
        }
        let is_linear = !is_of_screens(file) && !file.is_dir() && file.extension().is_some();
        if is_linear {
            let name = file.display();
            eprintln!("note: {name} is linear and has no annotations; --annotations FILE.svg writes them apart");
        }
    }
}

/// Fails where a transparent background is asked for in a format without alpha.
pub fn check_background(scene: &Scene, file: &Path) -> Result<(), Failure> {
    let transparent = scene.background.as_deref().and_then(Background::parse) == Some(Background::Transparent);
    if !transparent || !is_opaque(file) {
        return Ok(());
    }
    let message = format!("{}: this format has no transparency, and `background` is transparent", file.display());
    Err(Failure::new(Status::WrongUse, message, "write a .png or .exr, or set background=white"))
}

impl From<AnnotationError> for Failure {
    fn from(error: AnnotationError) -> Self {
        Self::new(Status::WrongUse, error.to_string(), error.advice())
    }
}
