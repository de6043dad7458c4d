//! Choosing a file: folders and files in a list, in the window itself.

use eframe::egui::{Context, Key, ScrollArea, TextEdit, Ui, Window};
use std::path::{Path, PathBuf};

/// What a file is chosen for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To be opened; a folder may be, too.
    Open,
    /// To be written.
    Save,
}

/// A dialog in which a file is chosen.
#[derive(Debug, Clone)]
pub struct Chooser {
    title: &'static str,
    purpose: Purpose,
    folder: PathBuf,
    /// The path as it is typed.
    path: String,
    entries: Vec<(String, bool)>,
    /// Why the folder cannot be read.
    problem: Option<String>,
}

/// What happened in a dialog.
pub enum Choice {
    /// Nothing yet.
    Open,
    /// The dialog was closed.
    Closed,
    /// A path was chosen.
    Chosen(PathBuf),
}

impl Chooser {
    /// A dialog that starts at `path`: a folder, or a file that is to be written.
    pub fn new(title: &'static str, purpose: Purpose, path: &Path) -> Self {
        let folder = if path.is_dir() { path.to_owned() } else { path.parent().unwrap_or(path).to_owned() };
        let mut chooser =
            Self { title, purpose, folder, path: path.display().to_string(), entries: Vec::new(), problem: None };
        chooser.read();
        chooser
    }

    /// The folder that is shown.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    fn read(&mut self) {
        self.entries.clear();
        self.problem = None;
        match std::fs::read_dir(&self.folder) {
            Err(error) => self.problem = Some(format!("{}: {error}", self.folder.display())),
            Ok(found) => {
                let entries = found.flatten().filter_map(|entry| {
                    let name = entry.file_name().to_string_lossy().into_owned();
                    (!name.starts_with('.')).then(|| (name, entry.path().is_dir()))
                });
                self.entries = entries.collect();
                self.entries.sort_by_key(|(name, is_folder)| (!is_folder, name.to_lowercase()));
            }
        }
    }

    fn go(&mut self, folder: PathBuf) {
        let name = match self.purpose {
            Purpose::Open => None,
            // The file's name stays while another folder is looked for.
            Purpose::Save => Path::new(&self.path).file_name().map(ToOwned::to_owned),
        };
        self.path = name.map_or_else(|| folder.clone(), |name| folder.join(name)).display().to_string();
        self.folder = folder;
        self.read();
    }

    /// Shows the dialog; `more` adds to it, above its buttons.
    pub fn show(&mut self, context: &Context, more: impl FnOnce(&mut Ui)) -> Choice {
        let mut choice = Choice::Open;
        let mut open = true;
        let window = Window::new(self.title).collapsible(false).open(&mut open).default_size([520.0, 420.0]);
        window.show(context, |ui| {
            ui.horizontal(|ui| {
                if let Some(parent) = self.folder.parent().map(Path::to_owned)
                    && ui.button("Up").on_hover_text("The folder above").clicked()
                {
                    self.go(parent);
                }
                let edit = TextEdit::singleline(&mut self.path).desired_width(f32::INFINITY);
                let response = ui.add(edit).accessible_name("Path");
                if response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
                    choice = self.enter();
                }
            });
            if let Some(problem) = &self.problem {
                ui.colored_label(ui.visuals().error_fg_color, problem);
            }
            let mut next = None;
            ScrollArea::vertical().max_height(260.0).auto_shrink(false).show(ui, |ui| {
                for (name, is_folder) in &self.entries {
                    let path = self.folder.join(name);
                    let text = if *is_folder { format!("{name}/") } else { name.clone() };
                    let response = ui.selectable_label(Path::new(&self.path) == path, text);
                    if response.double_clicked() && !is_folder {
                        choice = Choice::Chosen(path);
                    } else if response.clicked() {
                        next = Some((path, *is_folder));
                    }
                }
            });
            match next {
                Some((folder, true)) => self.go(folder),
                Some((file, false)) => self.path = file.display().to_string(),
                None => {}
            }
            ui.separator();
            more(ui);
            ui.horizontal(|ui| {
                let name = if self.purpose == Purpose::Open { "Open" } else { "Save" };
                if ui.button(name).clicked() {
                    choice = Choice::Chosen(PathBuf::from(&self.path));
                }
                if ui.button("Cancel").clicked() {
                    choice = Choice::Closed;
                }
            });
        });
        if !open || context.input(|input| input.key_pressed(Key::Escape)) {
            return Choice::Closed;
        }
        choice
    }

    /// The Enter key behind the path: a folder is shown, a file chosen.
    fn enter(&mut self) -> Choice {
        let path = PathBuf::from(&self.path);
        if path.is_dir() {
            self.go(path);
            return Choice::Open;
        }
        Choice::Chosen(path)
    }
}
