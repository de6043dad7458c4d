//! The window's contents.

mod animation;
mod canvas;
mod dialogs;
mod files;
mod handles;
mod keys;
mod marks;
mod menu;
mod pictures;
mod side;
mod start;
mod status;

pub use animation::AnimationChoice;
pub use pictures::Standing;

use crate::chooser::Chooser;
use crate::document::Document;
use crate::loader::Loading;
use crate::panels::Panels;
use crate::session::Session;
use crate::trouble::Trouble;
use crate::worker::{DeviceOptions, Sketch, Wake, Worker};
use eframe::egui::{Context, TextureHandle, Ui};
use files::Watch;
use pictures::Pictures;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use vitrum::backend::Choice;

/// Options of the window.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// The input to open.
    pub input: Option<String>,
    /// Whether the input is a scene file that is read again whenever it changes.
    pub watch: bool,
    /// The backend to render on.
    pub backend: Choice,
    /// Options of its device.
    pub device: DeviceOptions,
    /// The file of the session; nothing is kept without it.
    pub session_file: Option<PathBuf>,
    /// Pixels of the picture; as many as the window has if absent.
    pub size: Option<[u32; 2]>,
}

/// The window's contents: a document, its picture, and all that changes it.
pub struct Viewer {
    worker: Worker,
    wake: Wake,
    document: Option<Document>,
    pictures: Pictures,
    backend: Choice,
    /// The size of pictures that the user has chosen; the window's if `None`.
    size: Option<[u32; 2]>,
    /// Whether that size is a scene file's, and no choice for the next file.
    size_is_of_scene: bool,
    /// Pixels of the place for the picture.
    place: [u32; 2],
    loading: Option<Loading>,
    session: Session,
    session_file: Option<PathBuf>,
    /// The moment of the last saving, in the context's seconds.
    saved_at: f64,
    watch: Option<Watch>,
    trouble: Option<Trouble>,
    /// Whether it ends with the next picture.
    trouble_is_of_picture: bool,
    notes: Vec<String>,
    sketches: BTreeMap<String, Option<TextureHandle>>,
    /// How many of them are still to come.
    sketching: usize,
    dialog: Option<Dialog>,
    exporting: Option<Exporting>,
    selected_light: usize,
    /// Whether the crop box and clipping planes have handles in the picture.
    has_handles: bool,
    /// The panels of all keys.
    panels: Panels,
    /// The document's scene as data was last read for it.
    read_for: Option<vitrum::scene::Scene>,
}

/// What is rendered into files.
struct Exporting {
    file: PathBuf,
    /// The picture of an animation that is being made, counted from 1, and the number of all.
    picture: Option<[u32; 2]>,
}

/// A dialog that is open.
enum Dialog {
    Open(Chooser),
    SaveScene(Chooser),
    /// The size of the picture stands beside.
    SavePicture(Chooser, [u32; 2]),
    SaveAnimation(Chooser, AnimationChoice),
    Keys,
    About,
}

impl Viewer {
    /// The contents of a window whose context is `context`, which is woken whenever there is something new to show.
    ///
    /// # Errors
    /// Where the system starts no thread.
    pub fn new(options: Options, context: &Context) -> Result<Self, Trouble> {
        let woken = context.clone();
        let wake: Wake = Arc::new(move || woken.request_repaint());
        let worker = Worker::start(options.device, Arc::clone(&wake))
            .map_err(|error| Trouble::new(format!("no thread can be started: {error}"), "close other programs"))?;
        let session = options.session_file.as_deref().map(Session::read).unwrap_or_default();
        let mut viewer = Self {
            worker,
            wake,
            document: None,
            pictures: Pictures::default(),
            backend: options.backend,
            size: options.size,
            size_is_of_scene: false,
            place: [512, 512],
            loading: None,
            session,
            session_file: options.session_file,
            saved_at: 0.0,
            watch: None,
            trouble: None,
            trouble_is_of_picture: false,
            notes: Vec::new(),
            sketches: BTreeMap::new(),
            sketching: 0,
            dialog: None,
            exporting: None,
            selected_light: 0,
            has_handles: false,
            panels: Panels::default(),
            read_for: None,
        };
        if let Some(input) = options.input {
            if options.watch {
                viewer.watch = Some(Watch::new(PathBuf::from(&input)));
            }
            viewer.open(&input);
        }
        Ok(viewer)
    }

    /// Shows everything, and takes what the user does.
    pub fn ui(&mut self, ui: &mut Ui) {
        let context = ui.ctx().clone();
        self.take_replies(&context);
        self.take_loaded(&context);
        self.take_dropped(&context);
        self.take_watched(&context);
        self.take_shortcuts(&context);
        self.menu(ui);
        self.status(ui);
        if self.document.is_some() {
            self.side(ui);
            self.canvas(ui);
        } else {
            self.start(ui);
        }
        self.dialogs(&context);
        self.read_changed_data();
        self.note_change(&context);
        self.request_picture(&context);
        self.save_session(&context);
    }

    /// The document that is open.
    #[must_use]
    pub fn document(&self) -> Option<&Document> {
        self.document.as_ref()
    }

    /// As [`Self::document`], to be changed.
    pub fn document_mut(&mut self) -> Option<&mut Document> {
        self.document.as_mut()
    }

    /// What went wrong last, if it is still shown.
    #[must_use]
    pub fn trouble(&self) -> Option<&Trouble> {
        self.trouble.as_ref()
    }

    /// The picture that is shown.
    #[must_use]
    pub fn standing(&self) -> Option<&Standing> {
        self.pictures.standing()
    }

    /// Whether a better picture of the scene is to come.
    #[must_use]
    pub fn is_waiting(&self) -> bool {
        self.pictures.is_waiting()
    }

    /// The backend that the user has chosen.
    #[must_use]
    pub fn backend(&self) -> Choice {
        self.backend
    }

    /// Whether thumbnails are still to come.
    #[must_use]
    pub fn is_sketching(&self) -> bool {
        self.sketching > 0
    }

    /// Whether a file is being read.
    #[must_use]
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// Shows or hides the handles of the crop box and the clipping planes.
    pub fn show_handles(&mut self, shown: bool) {
        self.has_handles = shown;
    }

    /// Whether a dialog is open.
    #[must_use]
    pub fn has_dialog(&self) -> bool {
        self.dialog.is_some()
    }

    /// Closes the dialog that is open.
    pub fn close_dialog(&mut self) {
        self.dialog = None;
    }

    /// Asks for a thumbnail.
    fn sketch(&mut self, sketch: Sketch) {
        self.sketches.insert(sketch.name.clone(), None);
        self.sketching += 1;
        self.worker.sketch(sketch);
    }

    /// Forgets all thumbnails.
    fn forget_sketches(&mut self) {
        self.worker.forget_sketches();
        self.sketches.clear();
        self.sketching = 0;
    }

    /// Shows what went wrong.
    fn fail(&mut self, trouble: impl Into<Trouble>) {
        self.trouble = Some(trouble.into());
        self.trouble_is_of_picture = false;
    }

    /// Takes note of the scene for undoing, once nothing is held any more.
    fn note_change(&mut self, context: &Context) {
        let held = context.input(|input| input.pointer.any_down());
        if let Some(document) = &mut self.document
            && !held
        {
            document.history.note(&document.scene);
        }
    }
}
