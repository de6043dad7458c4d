//! Saving an animation: a turntable, or a scene that changes along key frames.

use super::{Dialog, Exporting, Viewer};
use crate::chooser::{Chooser, Purpose};
use crate::trouble::Trouble;
use crate::worker::{AnimationExport, Export};
use eframe::egui::{DragValue, TextEdit, Ui};
use std::path::Path;
use vitrum::composition::read_text;
use vitrum::scene::{KeyFrames, Motion};

/// What an animation is to be.
#[derive(Debug, Clone, PartialEq)]
pub struct AnimationChoice {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Pictures of a turn.
    pub frames: u32,
    /// How far the camera goes round, in degrees.
    pub turn: f32,
    /// Pictures a second.
    pub rate: u16,
    /// A file of key frames, which takes the turn's place; none if it is empty.
    pub keys: String,
}

impl Default for AnimationChoice {
    fn default() -> Self {
        // As the command line's.
        Self { size: [512, 512], frames: 72, turn: 360.0, rate: 24, keys: String::new() }
    }
}

impl AnimationChoice {
    pub(super) fn show(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            let [width, height] = &mut self.size;
            ui.add(DragValue::new(width).range(1..=16384)).accessible_name("Pixels across");
            ui.label("×");
            ui.add(DragValue::new(height).range(1..=16384)).accessible_name("Pixels down");
            ui.weak("A new folder for numbered pictures, or .gif, .png (animated) or .mp4 (by ffmpeg)");
        });
        let turns = self.keys.trim().is_empty();
        ui.horizontal(|ui| {
            ui.add_enabled(turns, DragValue::new(&mut self.frames).range(1..=100_000)).accessible_name("Pictures");
            ui.label("pictures,");
            ui.add(DragValue::new(&mut self.rate).range(1..=240)).accessible_name("Pictures a second");
            ui.label("a second; the camera turns by");
            let turn = DragValue::new(&mut self.turn).range(-3600.0..=3600.0).suffix("°");
            ui.add_enabled(turns, turn).accessible_name("Turn");
        });
        ui.horizontal(|ui| {
            ui.label("key frames");
            let keys = TextEdit::singleline(&mut self.keys).hint_text("a file (.toml), instead of a turn");
            ui.add(keys.desired_width(f32::INFINITY)).accessible_name("Key frames");
        });
    }

    /// The motion, and the number of its pictures.
    fn motion(&self) -> Result<(Motion, u32), Trouble> {
        let keys = self.keys.trim();
        if keys.is_empty() {
            return Ok((Motion::Turn(self.turn), self.frames.max(1)));
        }
        let text = read_text(Path::new(keys), "key frames")?;
        let motion = Motion::Keys(KeyFrames::from_toml(&text, keys, f64::from(self.rate))?);
        let frames = motion.key_frames().unwrap_or(self.frames);
        Ok((motion, frames))
    }
}

impl Viewer {
    pub(super) fn ask_save_animation(&mut self) {
        let Some(document) = &self.document else { return };
        let film = &document.scene.film;
        let choice = AnimationChoice { size: [film.width, film.height], ..AnimationChoice::default() };
        let path = self.folder().join("turntable");
        self.dialog = Some(Dialog::SaveAnimation(Chooser::new("Save animation", Purpose::Save, &path), choice));
    }

    /// Renders an animation of the scene into a folder or a file.
    pub fn save_animation(&mut self, file: &Path, choice: &AnimationChoice) {
        let Some(document) = &self.document else { return };
        let (motion, frames) = match choice.motion() {
            Ok(motion) => motion,
            Err(trouble) => return self.fail(trouble),
        };
        let mut scene = document.scene.clone();
        [scene.film.width, scene.film.height] = choice.size;
        let file = file.to_owned();
        self.exporting = Some(Exporting { file: file.clone(), picture: None });
        let export = Export { scene, data: document.data.clone(), file, backend: self.backend };
        self.worker.animate(AnimationExport { export, motion, frames, rate: choice.rate });
    }

    /// Gives the picture or animation up that is being rendered into files.
    pub fn cancel_export(&mut self) {
        self.worker.cancel_export();
    }

    /// Whether something is being rendered into files.
    #[must_use]
    pub fn is_exporting(&self) -> bool {
        self.exporting.is_some()
    }
}
