//! How far a voxelization is.

use crate::backend::{Backend, PassList};
use crate::error::Error;

/// Work done, and told.
pub(super) struct Stage<'a> {
    pub(super) done: u64,
    pub(super) total: u64,
    pub(super) items: u64,
    pub(super) progress: &'a mut dyn FnMut(u64, u64) -> bool,
}

impl Stage<'_> {
    /// Runs passes of `items` items that are so much of the `work`.
    pub(super) fn run(
        &mut self,
        backend: &mut dyn Backend,
        passes: &PassList,
        work: u64,
        items: u64,
    ) -> Result<(), Error> {
        let (progress, done, total) = (&mut *self.progress, self.done, self.total);
        backend.run(passes, &mut |_| progress(done, total))?;
        self.done += work;
        self.items += items;
        Ok(())
    }
}
