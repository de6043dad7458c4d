//! Files: opening, dropping, watching, saving, and what is saved by itself.

use super::{Dialog, Exporting, Viewer};
use crate::chooser::{Chooser, Purpose};
use crate::document::{Document, sources};
use crate::loader::{Loaded, Loading, Request};
use crate::panels::{Panels, command};
use crate::session::Saved;
use crate::transfer_editor::TransferEditor;
use crate::trouble::Trouble;
use crate::worker::Export;
use eframe::egui::{Context, ViewportCommand};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, SystemTime};
use vitrum::composition::is_scene_file;

/// Seconds between two savings of the session.
const SAVING: f64 = 3.0;

/// Time between two looks at a file that is watched.
const LOOKING: Duration = Duration::from_millis(300);

/// A file that is read again whenever it changes.
pub struct Watch {
    file: PathBuf,
    seen: Option<SystemTime>,
}

impl Watch {
    pub fn new(file: PathBuf) -> Self {
        let seen = changed(&file);
        Self { file, seen }
    }

    /// Whether the file has changed since the last look.
    fn has_changed(&mut self) -> bool {
        let now = changed(&self.file);
        // A file that is being written anew may be away for a moment.
        let has = now.is_some() && now != self.seen;
        if has {
            self.seen = now;
        }
        has
    }
}

fn changed(file: &Path) -> Option<SystemTime> {
    std::fs::metadata(file).and_then(|file| file.modified()).ok()
}

impl Viewer {
    /// Opens an input: a file, a folder of DICOM files, or `builtin:NAME`.
    pub fn open(&mut self, input: &str) {
        let size = self.size.filter(|_| !self.size_is_of_scene).unwrap_or(self.place);
        let size = (!is_scene_file(Path::new(input))).then_some(size);
        self.load(Request::Open(input.to_owned(), size));
    }

    /// Starts to read.
    pub(super) fn load(&mut self, request: Request) {
        self.trouble = None;
        match Loading::start(request, Arc::clone(&self.wake)) {
            Ok(loading) => self.loading = Some(loading),
            Err(trouble) => self.fail(trouble),
        }
    }

    /// Closes the document.
    pub fn close(&mut self) {
        self.document = None;
        self.forget_sketches();
        self.pictures.forget();
        (self.trouble, self.watch) = (None, None);
        self.notes.clear();
        self.session.open = None;
        self.write_session();
    }

    /// Takes what was read.
    pub(super) fn take_loaded(&mut self, context: &Context) {
        let Some(outcome) = self.loading.as_ref().and_then(Loading::poll) else { return };
        self.loading = None;
        match outcome {
            Ok(Loaded::Document(document)) => {
                self.forget_sketches();
                self.pictures.forget();
                self.notes.clone_from(&document.notes);
                self.session.remember(&document.input);
                self.read_for = Some(sources(&document.scene));
                context.send_viewport_cmd(ViewportCommand::Title(format!("{} – Vitrum", document.input)));
                self.take_size(&document);
                self.document = Some(*document);
                self.selected_light = 0;
                self.panels = Panels::default();
                self.saved_at = f64::NEG_INFINITY;
            }
            Ok(Loaded::Data(data)) => {
                if let Some(document) = &mut self.document {
                    document.data = data;
                    document.editor = TransferEditor::new(&document.scene, &document.data.assets.subject);
                }
            }
            Err(trouble) => self.fail(trouble),
        }
    }

    /// The pictures of a scene file have the size that it says; those of other inputs the window's, or the user's choice.
    fn take_size(&mut self, document: &Document) {
        let film = &document.scene.film;
        if is_scene_file(Path::new(&document.input)) {
            (self.size, self.size_is_of_scene) = (Some([film.width, film.height]), true);
        } else if std::mem::take(&mut self.size_is_of_scene) {
            self.size = None;
        }
    }

    /// Opens what was dropped on the window.
    pub(super) fn take_dropped(&mut self, context: &Context) {
        let dropped = context.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()));
        if let Some(path) = dropped {
            self.open(&path.display().to_string());
        }
    }

    /// Reads a watched file again where it has changed.
    pub(super) fn take_watched(&mut self, context: &Context) {
        let Some(watch) = &mut self.watch else { return };
        if watch.has_changed() {
            let input = watch.file.display().to_string();
            self.open(&input);
        }
        context.request_repaint_after(LOOKING);
    }

    /// Reads data anew where the scene names other data than before.
    pub(super) fn read_changed_data(&mut self) {
        let Some(document) = &self.document else { return };
        let named = sources(&document.scene);
        if self.loading.is_some() || self.read_for.as_ref() == Some(&named) {
            return;
        }
        let scene = Box::new(document.scene.clone());
        self.read_for = Some(named);
        self.load(Request::Data(scene));
    }

    /// The folder that dialogs start at.
    pub(super) fn folder(&self) -> PathBuf {
        let of_input = self.session.recent.iter().map(Path::new).find(|path| path.exists()).and_then(Path::parent);
        let here = || std::env::current_dir().unwrap_or_default();
        of_input.filter(|folder| folder.is_dir()).map_or_else(here, Path::to_owned)
    }

    pub(super) fn ask_open(&mut self) {
        self.dialog = Some(Dialog::Open(Chooser::new("Open", Purpose::Open, &self.folder())));
    }

    pub(super) fn ask_save_scene(&mut self) {
        let path = self.folder().join("scene.toml");
        self.dialog = Some(Dialog::SaveScene(Chooser::new("Save scene", Purpose::Save, &path)));
    }

    pub(super) fn ask_save_picture(&mut self) {
        let Some(document) = &self.document else { return };
        let size = [document.scene.film.width, document.scene.film.height];
        let path = self.folder().join("picture.png");
        self.dialog = Some(Dialog::SavePicture(Chooser::new("Save picture", Purpose::Save, &path), size));
    }

    /// Writes the scene, whole or not at all.
    pub fn save_scene(&mut self, file: &Path) {
        let Some(document) = &self.document else { return };
        let text = document.scene.to_toml().map_err(Trouble::from);
        let written = text.and_then(|text| Ok(vitrum::io::write_text(file, &text)?));
        match written {
            Ok(()) => self.notes.push(format!("the scene is in {}", file.display())),
            Err(trouble) => self.fail(trouble),
        }
    }

    /// Renders the scene into a file, with pictures of this size.
    pub fn save_picture(&mut self, file: &Path, size: [u32; 2]) {
        let Some(document) = &self.document else { return };
        if let Err(error) = vitrum::io::check_writable(file) {
            self.fail(error);
            return;
        }
        let mut scene = document.scene.clone();
        [scene.film.width, scene.film.height] = size;
        let file = file.to_owned();
        self.exporting = Some(Exporting { file: file.clone(), picture: None });
        self.worker.export(Export { scene, data: document.data.clone(), file, backend: self.backend });
    }

    /// The command that renders this very picture.
    ///
    /// # Errors
    /// Where the scene cannot be written as settings.
    pub fn command(&self) -> Result<String, Trouble> {
        let Some(document) = &self.document else {
            return Err(Trouble::new("nothing is open", "open a file first"));
        };
        Ok(command(&document.composition, &document.scene, &document.data.assets, "picture.png")?)
    }

    pub(super) fn copy_command(&mut self, context: &Context) {
        match self.command() {
            Ok(command) => {
                context.copy_text(command);
                self.notes.push("the command is in the clipboard".to_owned());
            }
            Err(trouble) => self.fail(trouble),
        }
    }

    /// Saves the session from time to time.
    pub(super) fn save_session(&mut self, context: &Context) {
        let now = context.input(|input| input.time);
        if self.session_file.is_none() || now - self.saved_at < SAVING {
            return;
        }
        let Some(document) = &self.document else { return };
        let Ok(scene) = document.scene.to_toml() else { return };
        let open = Some(Saved { input: document.input.clone(), scene });
        self.saved_at = now;
        if open != self.session.open {
            self.session.open = open;
            self.write_session();
        }
    }

    pub(super) fn write_session(&mut self) {
        let Some(file) = &self.session_file else { return };
        if let Err(trouble) = self.session.write(file) {
            // Once: it would fail again in a moment.
            self.session_file = None;
            self.notes.push(format!("the session is not saved: {}", trouble.message));
        }
    }

    /// The window was closed as usual: there is nothing to restore.
    pub fn end(&mut self) {
        self.session.open = None;
        self.write_session();
    }
}
