//! Long work on a thread of its own: the interpreter's lock is free meanwhile, Ctrl-C and a callback are heard.

use crate::errors::Failure;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;
use vitrum::Progress;

/// Time between two looks at Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(20);

/// Runs `work` without the interpreter's lock. `callback` is called with the stage's name, the units done and all units; an exception of it gives the work
/// up, as Ctrl-C does. Work hears of it when it next tells its progress.
///
/// # Errors
/// The exception of the callback or of Ctrl-C; the failure of `work`.
pub fn run<T: Send>(
    py: Python<'_>,
    callback: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&mut (dyn FnMut(Progress) -> bool + Send)) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    let callback = callback.map(|callback| callback.clone().unbind());
    let given_up = AtomicBool::new(false);
    let given_up = &given_up;
    py.detach(|| {
        thread::scope(|scope| {
            let (sender, told) = channel();
            let worker = scope.spawn(move || {
                work(&mut |progress| {
                    // A receiver that is gone has nothing more to say.
                    let _ = sender.send(progress);
                    !given_up.load(Ordering::Relaxed)
                })
            });
            let mut exception = None;
            loop {
                let mut newest = match told.recv_timeout(PATIENCE) {
                    Ok(progress) => Some(progress),
                    Err(RecvTimeoutError::Timeout) => None,
                    Err(RecvTimeoutError::Disconnected) => break,
                };
                newest = told.try_iter().last().or(newest);
                if exception.is_some() {
                    continue;
                }
                let heard = Python::attach(|py| {
                    py.check_signals()?;
                    if let (Some(callback), Some(Progress { stage, done, total })) = (&callback, newest) {
                        callback.call1(py, (stage.name(), done, total))?;
                    }
                    Ok::<_, PyErr>(())
                });
                if let Err(error) = heard {
                    given_up.store(true, Ordering::Relaxed);
                    exception = Some(error);
                }
            }
            let outcome = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            match (outcome, exception) {
                (Err(failure), Some(error)) if failure.is_cancelled() => Err(error),
                (_, Some(error)) => Err(error),
                (outcome, None) => Ok(outcome?),
            }
        })
    })
}
