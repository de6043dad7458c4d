//! Signals and `--timeout`: end the work at the next plane, or at once where it has none, and leave no output half-written.

use crate::failure::{Failure, Status};
use std::str::FromStr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;
use vitrum::io;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static TIMED_OUT: AtomicBool = AtomicBool::new(false);

/// Whether the work has begun to ask for [`requested`], as it does from plane to plane; reading a file, it does not.
static ASKED: AtomicBool = AtomicBool::new(false);

/// Time after a signal or `--timeout` after which the program ends even where the work does not ask, such as in the middle of an
/// output.
const GRACE: Duration = Duration::from_secs(5);

/// A time of more than 0 seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timeout(Duration);

impl FromStr for Timeout {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let seconds: f64 = text.parse().map_err(|_| "expected a number of seconds, such as 30".to_owned())?;
        match Duration::try_from_secs_f64(seconds) {
            Ok(time) if !time.is_zero() => Ok(Self(time)),
            _ => Err("expected a number of seconds above 0".to_owned()),
        }
    }
}

/// Handles Ctrl-C, SIGTERM and SIGHUP from now on: they set [`requested`] where the work asks for it. Where the work does not ask
/// within [`GRACE`], and on a second signal, they end the program.
pub fn handle_signals() {
    let handler = || {
        if INTERRUPTED.swap(true, Ordering::Relaxed) || !ASKED.load(Ordering::Relaxed) {
            leave();
        }
        thread::spawn(leave_after_grace);
    };
    // Without a handler the signal ends the program, and outputs are still renamed into place only when whole.
    let _ = ctrlc::set_handler(handler);
}

/// Lets writing beyond the limit of file sizes fail as on a full disk, instead of ending the program in the middle of it. To be called
/// before any thread begins.
pub fn ignore_file_size_signal() {
    #[cfg(unix)]
    // SAFETY: no handler is installed, and no other thread is there that could install one meanwhile.
    unsafe {
        libc::signal(libc::SIGXFSZ, libc::SIG_IGN);
    }
}

/// Begins the time of `timeout`, whose end sets [`requested`], and ends the program as a signal does.
pub fn listen(timeout: Option<Timeout>) {
    if let Some(Timeout(time)) = timeout {
        thread::spawn(move || {
            thread::sleep(time);
            TIMED_OUT.store(true, Ordering::Relaxed);
            if ASKED.load(Ordering::Relaxed) {
                leave_after_grace();
            }
            leave();
        });
    }
}

fn leave_after_grace() {
    thread::sleep(GRACE);
    leave();
}

/// Ends the program without the help of the work, and leaves no unfinished file.
fn leave() -> ! {
    let failure = failure();
    io::remove_unfinished();
    failure.report();
    std::process::exit(failure.status() as i32);
}

/// Whether the work is to end.
pub fn requested() -> bool {
    ASKED.store(true, Ordering::Relaxed);
    INTERRUPTED.load(Ordering::Relaxed) || TIMED_OUT.load(Ordering::Relaxed)
}

/// Fails if the work is to end.
pub fn check() -> Result<(), Failure> {
    if requested() { Err(failure()) } else { Ok(()) }
}

/// Why the work ended early.
pub fn failure() -> Failure {
    if TIMED_OUT.load(Ordering::Relaxed) && !INTERRUPTED.load(Ordering::Relaxed) {
        let help =
            "give it more time, or less to do (a smaller --size or --resolution); no unfinished output was written";
        return Failure::new(Status::TimedOut, "the time of --timeout is over", help);
    }
    Failure::new(Status::Interrupted, "interrupted", "no unfinished output was written")
}

#[cfg(test)]
mod tests {
    use super::Timeout;

    #[test]
    fn a_timeout_is_above_zero_and_finite() {
        assert!("0.5".parse::<Timeout>().is_ok() && "86400".parse::<Timeout>().is_ok());
        for wrong in ["0", "-1", "nan", "inf", "1e300", "5s", ""] {
            assert!(wrong.parse::<Timeout>().is_err(), "{wrong}");
        }
    }
}
