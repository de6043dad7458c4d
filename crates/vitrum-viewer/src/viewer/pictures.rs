//! The pictures of the document: what is asked for, and what is shown.

use super::Viewer;
use crate::worker::{Reply, Shown, View};
use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};
use std::time::Duration;
use vitrum::Statistics;
use vitrum::backend::Choice;
use vitrum::scene::Scene;

/// Seconds after the last change from which on a view is at rest.
const REST: f64 = 0.15;

/// The request that was sent last.
struct Sent {
    number: u64,
    scene: Scene,
    data: u64,
    backend: Choice,
    moving: bool,
}

/// The picture that is shown, and how it was made.
pub struct Standing {
    /// Its pixels.
    pub shown: Shown,
    /// Statistics of its frame.
    pub statistics: Box<Statistics>,
    /// Seconds that it took.
    pub seconds: f64,
    /// Whether it is the picture that the scene describes.
    pub complete: bool,
    /// Number of its request.
    pub number: u64,
}

/// The pictures of the document.
#[derive(Default)]
pub struct Pictures {
    sent: Option<Sent>,
    /// Numbers of earlier documents' requests are not above it.
    before: u64,
    last_number: u64,
    changed_at: f64,
    standing: Option<Standing>,
    texture: Option<TextureHandle>,
    /// Whether the picture that was asked for last failed.
    failed: bool,
}

impl Pictures {
    /// Forgets everything: another document is open.
    pub fn forget(&mut self) {
        *self = Self { before: self.last_number, last_number: self.last_number, ..Self::default() };
    }

    /// The picture that is shown.
    pub fn standing(&self) -> Option<&Standing> {
        self.standing.as_ref()
    }

    /// Its texture.
    pub fn texture(&self) -> Option<&TextureHandle> {
        self.texture.as_ref()
    }

    /// Whether a better picture of the scene is to come.
    pub fn is_waiting(&self) -> bool {
        let done = |sent: &Sent| self.standing.as_ref().is_some_and(|one| one.number == sent.number && one.complete);
        !self.failed && self.sent.as_ref().is_some_and(|sent| !done(sent))
    }

    /// Whether the picture that the scene describes is there.
    pub fn is_complete(&self) -> bool {
        self.standing.as_ref().is_some_and(|standing| standing.complete)
    }

    fn show(&mut self, context: &Context, standing: Standing) {
        let image = image(&standing.shown);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(context.load_texture("picture", image, TextureOptions::LINEAR)),
        }
        self.standing = Some(standing);
    }
}

/// A picture as the window's library has it.
pub fn image(shown: &Shown) -> ColorImage {
    ColorImage::from_rgba_unmultiplied(shown.size.map(|edge| edge as usize), shown.pixels.as_flattened())
}

impl Viewer {
    /// Asks for a picture where the scene has changed, and for a better one where it has come to rest.
    pub(super) fn request_picture(&mut self, context: &Context) {
        let Some(document) = &self.document else { return };
        let now = context.input(|input| input.time);
        let held = context.input(|input| input.pointer.any_down());
        let pictures = &mut self.pictures;
        let is_new = pictures.sent.as_ref().is_none_or(|sent| {
            sent.scene != document.scene || sent.data != document.data.number || sent.backend != self.backend
        });
        if is_new {
            pictures.changed_at = now;
        }
        let rested = now - pictures.changed_at > REST || (!is_new && !held);
        let waits = pictures.sent.as_ref().is_some_and(|sent| sent.moving);
        if !(is_new || waits && rested) {
            if waits {
                context.request_repaint_after(Duration::from_secs_f64(REST));
            }
            return;
        }
        pictures.last_number += 1;
        pictures.failed = false;
        let number = pictures.last_number;
        // The first picture of a change comes fast, and a better one follows.
        let moving = is_new;
        let (scene, data) = (document.scene.clone(), document.data.clone());
        pictures.sent = Some(Sent { number, scene: scene.clone(), data: data.number, backend: self.backend, moving });
        self.worker.show(View { number, scene, data, moving, backend: self.backend });
        if moving {
            context.request_repaint_after(Duration::from_secs_f64(REST));
        }
    }

    /// Takes what the rendering thread says.
    pub(super) fn take_replies(&mut self, context: &Context) {
        while let Some(reply) = self.worker.poll() {
            match reply {
                Reply::Picture { number, shown, statistics, seconds, complete } => {
                    if number > self.pictures.before {
                        self.pictures.show(context, Standing { shown, statistics, seconds, complete, number });
                        if number == self.pictures.last_number && std::mem::take(&mut self.trouble_is_of_picture) {
                            self.trouble = None;
                        }
                    }
                }
                Reply::Failed { number, trouble } => {
                    if number == self.pictures.last_number {
                        self.pictures.failed = true;
                        self.fail(trouble);
                        self.trouble_is_of_picture = true;
                    }
                }
                Reply::Sketched { name, shown } => {
                    let texture = shown.map(|shown| context.load_texture(&name, image(&shown), TextureOptions::LINEAR));
                    // One of an earlier document may come late.
                    if let Some(place) = self.sketches.get_mut(&name) {
                        *place = texture;
                        self.sketching = self.sketching.saturating_sub(1);
                    }
                }
                Reply::Exporting { picture, of } => {
                    if let Some(exporting) = &mut self.exporting {
                        exporting.picture = Some([picture, of]);
                    }
                }
                Reply::Exported { file } => {
                    self.exporting = None;
                    self.notes.push(format!("what was rendered is in {}", file.display()));
                }
                Reply::NotExported { trouble } => {
                    self.exporting = None;
                    if let Some(trouble) = trouble {
                        self.fail(trouble);
                    }
                }
                Reply::Note(note) => self.notes.push(note),
            }
        }
    }
}
