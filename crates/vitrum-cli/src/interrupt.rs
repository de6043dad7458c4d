//! Ctrl-C: ends the work at the next plane, so that no output is left half-written.

use std::sync::atomic::{AtomicBool, Ordering};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C, SIGTERM and SIGHUP set [`requested`]; a second one ends the program at once.
pub fn listen() {
    let handler = || {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    };
    // Without a handler the signal ends the program, and outputs are still renamed into place only when whole.
    let _ = ctrlc::set_handler(handler);
}

/// Whether the user wants the work to end.
pub fn requested() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
