//! The threads on which kernels and the work of the host run.

use super::BackendError;

/// Threads for kernels on the CPU and for the work of the host: threads of their own, or the process's.
#[derive(Debug, Clone, Default)]
pub struct Threads {
    #[cfg(feature = "threads")]
    pool: Option<std::sync::Arc<rayon::ThreadPool>>,
}

impl Threads {
    /// Starts `count` threads, or one for each processor. In a build without the feature `threads` all work runs on the thread that
    /// calls.
    ///
    /// # Errors
    /// [`BackendError::Threads`] where the threads cannot be started.
    pub fn start(count: Option<usize>) -> Result<Self, BackendError> {
        #[cfg(feature = "threads")]
        {
            let threads = count.unwrap_or(0);
            let named = |index| format!("vitrum-{index}");
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).thread_name(named).build();
            let pool = pool.map_err(|error| BackendError::Threads { threads, reason: error.to_string() })?;
            Ok(Self { pool: Some(std::sync::Arc::new(pool)) })
        }
        #[cfg(not(feature = "threads"))]
        match count {
            None | Some(0 | 1) => Ok(Self::default()),
            Some(threads) => {
                let reason = "this build has no threads of its own".to_owned();
                Err(BackendError::Threads { threads, reason })
            }
        }
    }

    /// Limits the process's own threads, on which work runs that belongs to no backend, such as reading files. It can be said once, and
    /// only before any such work.
    ///
    /// # Errors
    /// [`BackendError::Threads`] where it was said before, or the threads cannot be started.
    pub fn limit_process(threads: usize) -> Result<(), BackendError> {
        #[cfg(feature = "threads")]
        {
            let limited = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
            limited.map_err(|error| BackendError::Threads { threads, reason: error.to_string() })
        }
        #[cfg(not(feature = "threads"))]
        Self::start(Some(threads)).map(|_| ())
    }

    /// Runs `work` on these threads: parallel loops in it are shared out among them.
    pub fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        #[cfg(feature = "threads")]
        if let Some(pool) = &self.pool {
            return pool.install(work);
        }
        work()
    }

    /// Runs `work` on these threads, as [`Self::run`] does, and has the calling thread call `ask` from time to time meanwhile. Work that
    /// is called for by one of these threads, or by a build without threads, runs without being asked about.
    pub(crate) fn run_asked<T: Send>(&self, work: impl FnOnce() -> T + Send, ask: impl FnMut()) -> T {
        #[cfg(feature = "threads")]
        if let Some(pool) = &self.pool
            && rayon::current_thread_index().is_none()
        {
            return run_asked(pool, work, ask);
        }
        let _ = ask;
        self.run(work)
    }

    /// The number of threads.
    #[must_use]
    pub fn count(&self) -> usize {
        self.run(rayon::current_num_threads)
    }
}

/// Time between two questions.
#[cfg(feature = "threads")]
const BETWEEN_QUESTIONS: std::time::Duration = std::time::Duration::from_millis(4);

/// Runs `work` on the threads of `pool`, while the calling thread, which is none of them, calls `ask`.
#[cfg(feature = "threads")]
fn run_asked<T: Send>(pool: &rayon::ThreadPool, work: impl FnOnce() -> T + Send, mut ask: impl FnMut()) -> T {
    use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
    use std::sync::mpsc::{RecvTimeoutError, sync_channel};
    let (sender, receiver) = sync_channel(1);
    let outcome = pool.in_place_scope(|scope| {
        // A panic goes through the channel, so that there is an answer in any case.
        scope.spawn(move |_| drop(sender.send(catch_unwind(AssertUnwindSafe(work)))));
        loop {
            match receiver.recv_timeout(BETWEEN_QUESTIONS) {
                Err(RecvTimeoutError::Timeout) => ask(),
                Ok(outcome) => break outcome,
                Err(RecvTimeoutError::Disconnected) => break Err(Box::new("the work has no outcome")),
            }
        }
    });
    outcome.unwrap_or_else(|panic| resume_unwind(panic))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_runs_on_as_many_threads_as_were_started() {
        assert_eq!(Threads::start(Some(3)).expect("three threads").count(), 3);
        assert_eq!(Threads::start(Some(1)).expect("a thread").run(rayon::current_num_threads), 1);
    }

    #[test]
    fn the_calling_thread_is_asked_while_work_runs() {
        use std::sync::atomic::{AtomicBool, Ordering};
        let threads = Threads::start(Some(1)).expect("a thread");
        let stop = AtomicBool::new(false);
        // Work that only an answer ends.
        let work = || {
            while !stop.load(Ordering::Relaxed) {
                std::thread::yield_now();
            }
            7
        };
        assert_eq!(threads.run_asked(work, || stop.store(true, Ordering::Relaxed)), 7);
        // A thread of the pool does not wait for itself.
        assert_eq!(threads.run(|| threads.run_asked(|| 8, || ())), 8);
    }
}
