//! The progress of a voxelization.

use crate::backend::{Backend, PassList};
use crate::error::Error;
use crate::request::{Progress, Stage};

/// The work of a voxelization: how much is done, how much there is, and who is told.
pub(super) struct Work<'a> {
    pub(super) done: u64,
    pub(super) total: u64,
    pub(super) items: u64,
    pub(super) progress: &'a mut (dyn FnMut(Progress) -> bool + Send),
}

impl Work<'_> {
    /// Runs passes of `items` items that are so much of the `work`.
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
