//! The progress bar: on standard error, and only where that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use vitrum::Progress;

/// Planes done over all frames, and the time left.
pub struct Bar {
    bar: ProgressBar,
    frames: u32,
}

impl Bar {
    /// A bar for `frames` frames; invisible if `quiet`, or if standard error is not a terminal.
    pub fn new(frames: u32, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} planes, {eta} left");
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
    pub fn set(&self, done: u64, total: u64) {
        self.bar.set_length(total);
        self.bar.set_position(done);
    }

    /// Shows how far the frame with this index is.
    pub fn update(&self, frame: u32, progress: &Progress) {
        let total = u64::from(progress.total);
        self.bar.set_length(total * u64::from(self.frames));
        self.bar.set_position(total * u64::from(frame) + u64::from(progress.done));
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
