//! Looks by name and from files: presets, maps of colours, transfer functions of other programs.

use super::model::{TransferEditor, has_low_opacities};
use std::path::Path;
use vitrum::io::transfer;
use vitrum::preset::{self, Adjustments};
use vitrum::scene::Scene;

impl TransferEditor {
    /// Gives the particles the colours of a map over the window.
    pub fn color_by(&mut self, scene: &mut Scene, name: &str) {
        let adjustments = Adjustments { colormap: Some(name.to_owned()), ..Adjustments::default() };
        let Some(volume) = self.subject.volume() else { return };
        let done = preset::adjust(volume, &adjustments, scene);
        self.told = done.err().map(|error| (format!("{error}: {}", error.help()), true));
        self.selected = None;
        self.record(scene, None);
    }

    /// Gives the scene the look of a preset; whether it could.
    pub fn apply_preset(&mut self, scene: &mut Scene, name: &str) -> bool {
        let Some(volume) = self.subject.volume() else { return false };
        let done = preset::fit(name, volume, &Adjustments::default(), scene);
        self.tell(done.map_err(|error| format!("{error}: {}", error.help())));
        self.selected = None;
        self.magnified = has_low_opacities(scene);
        self.record(scene, None);
        !self.has_failed()
    }

    /// Takes colours and opacities of a file of 3D Slicer, ParaView or VTK; whether it could.
    pub fn import(&mut self, scene: &mut Scene, file: &Path) -> bool {
        let Some(volume) = self.subject.volume() else { return false };
        let read = transfer::read_transfer(file).map_err(|error| error.to_string());
        let done = read.and_then(|read| {
            preset::fit_file(&read, volume, &Adjustments::default(), false, scene)
                .map_err(|error| format!("{error}: {}", error.help()))
        });
        self.tell(done);
        self.selected = None;
        self.record(scene, None);
        !self.has_failed()
    }

    /// Writes colours and opacities for ParaView; whether it could.
    pub fn export(&mut self, scene: &Scene, file: &Path) -> bool {
        let Some(volume) = self.subject.volume() else { return false };
        let (function, mut told) = preset::transfer_file(scene, volume);
        let written = vitrum::io::write_text(file, &transfer::paraview_json(&function));
        told.insert(0, format!("written to {}", file.display()));
        self.tell(written.map(|()| told).map_err(|error| error.to_string()));
        !self.has_failed()
    }

    fn tell(&mut self, done: Result<Vec<String>, String>) {
        self.told = match done {
            Ok(notes) if notes.is_empty() => None,
            Ok(notes) => Some((notes.join("; "), false)),
            Err(error) => Some((error, true)),
        };
    }

    /// Whether the last preset or file could not be taken.
    #[must_use]
    pub fn has_failed(&self) -> bool {
        self.told.as_ref().is_some_and(|(_, is_error)| *is_error)
    }
}
