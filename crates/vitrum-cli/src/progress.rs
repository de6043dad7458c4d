//! The progress bar: on standard error, and only where that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use vitrum::{Progress, Stage};

/// Time after which the rest of the work is estimated, and from which estimate on it is told.
const LOOK: Duration = Duration::from_secs(2);
const LONG: Duration = Duration::from_secs(20);

/// Work done over all frames, and the time left.
pub struct Bar {
    bar: ProgressBar,
    frames: u32,
    warning: Option<Warning>,
}

/// What is to be said, once, of work that takes long.
struct Warning {
    /// What would make it faster.
    advice: String,
    /// When the first frame began.
    begun: OnceLock<Instant>,
    told: AtomicBool,
}

impl Bar {
    /// A bar for `frames` frames; invisible if `quiet`, or if standard error is not a terminal.
    pub fn new(frames: u32, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        let style = ProgressStyle::with_template("{wide_bar} {msg} {pos}/{len}, {eta} left");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, frames, warning: None }
    }

    /// The bar, which says how long the work takes, and `advice`, where the first planes show that it takes long.
    pub fn warning_of_long_work(mut self, quiet: bool, advice: String) -> Self {
        let warning = (!quiet).then(|| Warning { advice, begun: OnceLock::new(), told: AtomicBool::new(false) });
        self.warning = warning;
        self
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
            self.warn(progress.total * u64::from(frame) + progress.done, progress.total * u64::from(self.frames));
            self.bar.set_length(progress.total * u64::from(self.frames));
            self.bar.set_position(progress.total * u64::from(frame) + progress.done);
        } else {
            self.bar.set_length(progress.total);
            self.bar.set_position(progress.done);
        }
    }
}

impl Bar {
    /// Says how long the work takes, if that is long and was not said.
    fn warn(&self, done: u64, total: u64) {
        let Some(warning) = self.warning.as_ref().filter(|warning| !warning.told.load(Ordering::Relaxed)) else {
            return;
        };
        let elapsed = warning.begun.get_or_init(Instant::now).elapsed();
        if elapsed < LOOK || done == 0 {
            return;
        }
        warning.told.store(true, Ordering::Relaxed);
        let whole = elapsed.mul_f64(total as f64 / done as f64);
        if whole >= LONG {
            self.bar.suspend(|| eprintln!("this takes about {}; {}", words(whole), warning.advice));
        }
    }
}

/// A time as people say it.
fn words(time: Duration) -> String {
    let seconds = time.as_secs();
    match seconds {
        0..90 => format!("{seconds} seconds"),
        90..5400 => format!("{} minutes", (seconds + 30) / 60),
        5400..172_800 => format!("{} hours", (seconds + 1800) / 3600),
        _ => format!("{} days", (seconds + 43_200) / 86_400),
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::words;
    use std::time::Duration;

    #[test]
    fn times_are_round() {
        let told = [45, 100, 3600, 7300, 200_000].map(|seconds| words(Duration::from_secs(seconds)));
        assert_eq!(told, ["45 seconds", "2 minutes", "60 minutes", "2 hours", "2 days"]);
    }
}
