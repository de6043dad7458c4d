//! The process's own threads. A process that was made by `fork` has none of its parent's, and work handed to those would never end.

use crate::errors::Failure;
use std::process;
use std::sync::{Mutex, PoisonError};
use vitrum::backend::{Choice, Threads};

/// Threads, and the process that they belong to.
static THREADS: Mutex<Option<(u32, Threads)>> = Mutex::new(None);

/// Threads of this process for work that belongs to no session.
pub fn threads() -> Result<Threads, Failure> {
    let here = process::id();
    let mut known = THREADS.lock().unwrap_or_else(PoisonError::into_inner);
    match &*known {
        Some((owner, threads)) if *owner == here => Ok(threads.clone()),
        foreign => {
            let threads = Threads::start(None)?;
            if foreign.is_some() {
                // Ending a parent's threads would wait for what is not there.
                std::mem::forget(known.take());
            }
            *known = Some((here, threads.clone()));
            Ok(threads)
        }
    }
}

/// The backend of that name: `auto`, `cpu` or `gpu`.
pub fn choice(name: &str) -> Result<Choice, Failure> {
    match name {
        "auto" => Ok(Choice::Auto),
        "cpu" => Ok(Choice::Cpu),
        "gpu" => Ok(Choice::Gpu),
        other => {
            let message = format!("there is no backend {other:?}");
            Err(Failure::value(message, "the backends are \"auto\", \"cpu\" and \"gpu\""))
        }
    }
}
