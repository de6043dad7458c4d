//! Execution of a pass list, part by part.

use super::Memory;
use super::asked::Asked;
use super::chunks::{BlockState, Written, follows, most_together};
use crate::backend::{BackendError, Pass, PassList, Write};
use std::collections::{HashMap, HashSet};
use vitrum_kernels::kernel::InstructionSet;

/// Passes that run together, and the writes before them.
pub(super) type Part<'a> = (&'a [Write], &'a [Pass]);

/// The parts of a list, in order.
pub(super) fn parts(passes: &PassList) -> impl Iterator<Item = Part<'_>> {
    passes.runs().flat_map(|(writes, run)| {
        let parts = run.chunk_by(follows).flat_map(|together| together.chunks(most_together(&together[0])));
        parts.enumerate().map(move |(index, part)| (if index == 0 { writes } else { &[] }, part))
    })
}

/// The state of a list between two of its parts.
pub(super) struct Executor<'a> {
    passes: &'a PassList,
    set: InstructionSet,
    /// Kernels that had a pass without any work.
    idle: HashSet<&'a str>,
    states: HashMap<Written, BlockState>,
    /// Writes that wait for the first pass that reads their buffer.
    waiting: Vec<&'a Write>,
    /// Whether the work is to go on.
    asked: &'a Asked<'a>,
}

/// Takes the kernels out of `idle` to which a pass of `kernel` gives new work.
fn wake(list: &PassList, kernel: &str, idle: &mut HashSet<&str>) {
    for part in list.while_busy.iter().filter(|part| part.until == Some(kernel)) {
        idle.remove(part.kernel);
    }
}

impl<'a> Executor<'a> {
    /// The state before the first part.
    pub(super) fn new(passes: &'a PassList, set: InstructionSet, asked: &'a Asked<'a>) -> Self {
        Self { passes, set, idle: HashSet::new(), states: HashMap::new(), waiting: Vec::new(), asked }
    }

    /// Runs a part, without the passes that may be left out.
    pub(super) fn run(&mut self, (writes, together): &Part<'a>, memory: &mut Memory) -> Result<(), BackendError> {
        self.waiting.extend(*writes);
        let list = self.passes;
        let mut idle = self.idle.clone();
        let together: Vec<&Pass> = together
            .iter()
            .filter(|pass| {
                let name = pass.kernel.declaration.name;
                wake(list, name, &mut idle);
                let parts = list.while_busy.iter().filter(|while_busy| idle.contains(while_busy.kernel));
                !parts.flat_map(|while_busy| &while_busy.passes).any(|other| *other == name)
            })
            .collect();
        if together.is_empty() {
            return Ok(());
        }
        let reads = |write: &&Write| together.iter().any(|pass| pass.buffers.contains(&write.buffer));
        let (now, later) = std::mem::take(&mut self.waiting).into_iter().partition(reads);
        self.waiting = later;
        for write in &now {
            self.states.retain(|(buffer, _), _| *buffer != write.buffer.number());
        }
        memory.write(now)?;
        let busy = memory.run_together(&together, self.set, &mut self.states, self.asked)?;
        if self.asked.is_cancelled() {
            return Err(BackendError::Cancelled);
        }
        for (pass, busy) in together.iter().zip(busy) {
            let name = pass.kernel.declaration.name;
            wake(list, name, &mut self.idle);
            if !busy {
                self.idle.insert(name);
            }
        }
        Ok(())
    }

    /// Performs the writes whose buffers no pass has read, for the passes of another list; none of them if the rest of the list was
    /// left out.
    pub(super) fn end(self, memory: &mut Memory) -> Result<(), BackendError> {
        if self.passes.while_busy.iter().any(|while_busy| self.idle.contains(while_busy.kernel)) {
            return Ok(());
        }
        memory.write(self.waiting)
    }
}
