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

    /// The number of threads.
    #[must_use]
    pub fn count(&self) -> usize {
        self.run(rayon::current_num_threads)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_runs_on_as_many_threads_as_were_started() {
        assert_eq!(Threads::start(Some(3)).expect("three threads").count(), 3);
        assert_eq!(Threads::start(Some(1)).expect("a thread").run(rayon::current_num_threads), 1);
    }
}
