//! The question whether work is to go on, which any of the threads that work asks in passing.

use crate::backend::BackendError;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
use web_time::Instant;

/// Time between two questions within a pass.
const BETWEEN_QUESTIONS: Duration = Duration::from_millis(4);

/// The caller's function of progress, shared by the threads that work.
pub(super) struct Asked<'a> {
    /// Whether the caller has cancelled: what is still to do is of no use any more.
    cancelled: AtomicBool,
    caller: Mutex<Caller<'a>>,
}

struct Caller<'a> {
    progress: &'a mut (dyn FnMut(usize) -> bool + Send),
    /// Passes that are done.
    done: usize,
    asked: Instant,
}

impl<'a> Asked<'a> {
    pub(super) fn new(progress: &'a mut (dyn FnMut(usize) -> bool + Send)) -> Self {
        let caller = Caller { progress, done: 0, asked: Instant::now() };
        Self { cancelled: AtomicBool::new(false), caller: Mutex::new(caller) }
    }

    /// Tells the caller that so many passes are done.
    ///
    /// # Errors
    /// [`BackendError::Cancelled`] where the caller cancels, or has before.
    pub(super) fn report(&self, done: usize) -> Result<(), BackendError> {
        let mut caller = self.caller.lock().unwrap_or_else(PoisonError::into_inner);
        caller.done = done;
        self.ask(&mut caller);
        drop(caller);
        if self.cancelled.load(Ordering::Relaxed) { Err(BackendError::Cancelled) } else { Ok(()) }
    }

    /// Whether the caller has cancelled; the caller is asked where the last question is some time ago and no other thread is asking.
    pub(super) fn is_cancelled(&self) -> bool {
        if let Ok(mut caller) = self.caller.try_lock()
            && caller.asked.elapsed() > BETWEEN_QUESTIONS
        {
            self.ask(&mut caller);
        }
        self.cancelled.load(Ordering::Relaxed)
    }

    fn ask(&self, caller: &mut Caller<'_>) {
        if !(caller.progress)(caller.done) {
            self.cancelled.store(true, Ordering::Relaxed);
        }
        caller.asked = Instant::now();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_caller_is_asked_on_the_way_and_cancels_once_for_all() {
        let mut told = Vec::new();
        let mut progress = |done| {
            told.push(done);
            told.len() < 3
        };
        let asked = Asked::new(&mut progress);
        assert!(asked.report(0).is_ok() && asked.report(5).is_ok());
        // Any thread asks, when it is time again.
        std::thread::scope(|scope| scope.spawn(|| while !asked.is_cancelled() {}).join()).expect("it ends");
        assert!(asked.is_cancelled() && asked.report(6).is_err());
        assert_eq!(told, [0, 5, 5, 6]);
    }
}
