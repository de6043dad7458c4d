//! The rendering of an animation into files.

use super::course::{Course, End};
use super::request::{AnimationExport, Reply};
use super::target::Target;
use crate::trouble::Trouble;
use std::sync::Arc;
use vitrum::{Layers, framed_all_round};
use vitrum_annotations::{Overlay, screen_picture};

impl Course {
    /// Renders the frames of an animation, the very pictures of `vitrum turntable`.
    pub(super) fn animate(&mut self, animation: &AnimationExport) -> Result<(), End> {
        let AnimationExport { export, motion, frames, rate } = animation;
        let (frames, assets) = (*frames, &export.data.assets);
        // The camera keeps its distance on its way.
        let start = framed_all_round(&export.scene, assets)?;
        if motion.key_frames().is_none() && start.camera.position.is_some() {
            let message = "the scene sets camera.position, which a turntable cannot turn";
            return Err(End::Failed(Trouble::new(message, "drag the picture, which puts the eye on an orbit")));
        }
        if motion.moves_meshes(&start) {
            let message = "these key frames move meshes from picture to picture";
            return Err(End::Failed(Trouble::new(
                message,
                "save the scene, and render it by `vitrum turntable --keys`",
            )));
        }
        // All before any work: an animation breaks off at no picture.
        for index in 0..frames {
            if self.mailbox.gives_export_up() {
                return Err(End::GivenUp);
            }
            vitrum::check(&motion.at(&start, index, frames)?, assets)?;
        }
        self.open(export.backend, &export.data)?;
        let size = [start.film.width, start.film.height];
        let mut target = Target::begin(&export.file, size, frames, *rate)?;
        for index in 0..frames {
            self.reply(Reply::Exporting { picture: index + 1, of: frames });
            let scene = motion.at(&start, index, frames)?;
            let mailbox = Arc::clone(&self.mailbox);
            let frame = self.frame(&scene, Layers::color(), move || !mailbox.gives_export_up())?;
            let overlay = Overlay::framed::<End>(&scene, assets)?;
            target.add(index, &screen_picture(frame, overlay.as_ref(), target.is_opaque())?)?;
        }
        // Between the last picture's end and here it may have been given up, too.
        if self.mailbox.gives_export_up() {
            return Err(End::GivenUp);
        }
        Ok(target.finish()?)
    }
}
