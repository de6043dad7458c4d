//! The progress of a voxelization.

use crate::backend::{Backend, PassList};
use crate::error::Error;
use crate::request::{Progress, Stage};

/// The progress of a voxelization: the work that is done, the work in all, and the caller's progress function.
pub(super) struct Work<'a> {
    pub(super) done: u64,
    pub(super) total: u64,
    pub(super) items: u64,
    pub(super) progress: &'a mut (dyn FnMut(Progress) -> bool + Send),
}

impl Work<'_> {
    /// Runs passes of `items` items that make up this part of the `work`.
    pub(super) fn run(
        &mut self,
        backend: &mut dyn Backend,
        passes: &PassList,
        work: u64,
        items: u64,
    ) -> Result<(), Error> {
        let (progress, done, total) = (&mut *self.progress, self.done, self.total);
        backend.run(passes, &mut |_| progress(Progress { stage: Stage::Voxelize, done, total }))?;
        self.done += work;
        self.items += items;
        Ok(())
    }
}
