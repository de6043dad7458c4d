//! The status bar at the bottom.

use super::{Exporting, Viewer};
use eframe::egui::{Align, Layout, Panel, ProgressBar, Ui};

impl Viewer {
    pub(super) fn status(&mut self, ui: &mut Ui) {
        Panel::bottom("status").show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.label(self.state());
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    if self.exporting.is_some() && ui.button("Cancel").clicked() {
                        self.cancel_export();
                    }
                    let busy = self.pictures.is_waiting() || self.exporting.is_some();
                    if let Some(progress) = self.worker.progress().filter(|_| busy) {
                        let share = progress.done as f32 / progress.total.max(1) as f32;
                        ui.add(ProgressBar::new(share).desired_width(120.0)).accessible_name("progress");
                        ui.label(progress.stage.name());
                        // The bar moves without anybody's hand.
                        ui.ctx().request_repaint_after(std::time::Duration::from_millis(100));
                    }
                    if let Some(note) = self.notes.last() {
                        ui.separator();
                        ui.label(note).on_hover_text(self.notes.join("\n"));
                    }
                });
            });
        });
    }

    /// The picture that is shown, in a line.
    fn state(&self) -> String {
        if let Some(loading) = &self.loading {
            return format!("Reading {} …", loading.name);
        }
        if let Some(Exporting { file, picture }) = &self.exporting {
            let part = picture.map_or_else(String::new, |[one, all]| format!(", picture {one} of {all}"));
            return format!("Rendering {}{part} …", file.display());
        }
        let Some(standing) = self.pictures.standing() else { return String::new() };
        let [width, height] = standing.shown.size;
        let milliseconds = standing.seconds * 1e3;
        let rate = 1.0 / standing.seconds.max(1e-6);
        let backend = standing.statistics.backend.to_uppercase();
        let whole = self
            .document
            .as_ref()
            .map_or([width, height], |document| [document.scene.film.width, document.scene.film.height]);
        let state = match standing.complete {
            true => "complete".to_owned(),
            false if [width, height] == whole => "refining".to_owned(),
            false => format!("of {} × {}", whole[0], whole[1]),
        };
        let speed = if milliseconds < 1000.0 {
            format!("{milliseconds:.0} ms, {rate:.0} a second")
        } else {
            format!("{:.1} s", standing.seconds)
        };
        format!("{width} × {height}, {state} · {speed} · {backend}: {}", standing.statistics.adapter)
    }
}
