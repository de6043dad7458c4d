//! The progress bar: on standard error, and only where that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use vitrum::{Progress, Stage};

/// Work done over all frames, and the time left.
pub struct Bar {
    bar: ProgressBar,
    frames: u32,
}

impl Bar {
    /// A bar for `frames` frames; invisible if `quiet`, or if standard error is not a terminal.
    pub fn new(frames: u32, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        let style = ProgressStyle::with_template("{wide_bar} {msg} {pos}/{len}, {eta} left");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, frames }
    }

    /// A bar for work that is no frame; invisible as [`Self::new`]'s.
    pub fn of_work(quiet: bool) -> Self {
        let bar = Self::new(1, quiet);
        let style = ProgressStyle::with_template("{wide_bar} {percent} %, {eta} left");
        bar.bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar
    }

    /// Shows how much of the work is done.
    pub fn set(&self, progress: &Progress) {
        self.bar.set_length(progress.total);
        self.bar.set_position(progress.done);
    }

    /// Shows how far the frame with this index is.
    pub fn update(&self, frame: u32, progress: &Progress) {
        self.bar.set_message(progress.stage.name());
        if progress.stage == Stage::Render {
            self.bar.set_length(progress.total * u64::from(self.frames));
            self.bar.set_position(progress.total * u64::from(frame) + progress.done);
        } else {
            self.bar.set_length(progress.total);
            self.bar.set_position(progress.done);
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
