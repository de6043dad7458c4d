//! The numbers of workgroups of a later dispatch, which a GPU takes from a buffer: none until an invocation of an earlier dispatch has work.
//!
//! The buffer is x, y and z, 0 before. All dispatches that depend on one another have the same size, so that a kernel raises its own.

use super::WORKGROUP;
use crate::abi::dispatch::Region;
use spirv_std::arch::{IndexUnchecked as _, atomic_load, atomic_store};
use spirv_std::memory::{Scope, Semantics};

const SCOPE: u32 = Scope::QueueFamily as u32;
const SEMANTICS: u32 = Semantics::NONE.bits();
/// Words.
const SIZE: usize = 3;

/// Workgroups along an axis that has `count` invocations.
#[inline(always)]
fn groups(count: u32) -> u32 {
    (count + (WORKGROUP - 1)) / WORKGROUP
}

/// Raises the numbers to those of a dispatch over `region`.
#[inline(always)]
pub fn raise(workgroups: &mut [u32], region: Region) {
    if workgroups.len() >= SIZE {
        let across = groups(region.end_column - region.first_column);
        let down = groups(region.end_row - region.first_row);
        // SAFETY: the indices are below the length; while the kernel runs, the words are only read and written atomically, and all
        // invocations write the same numbers.
        unsafe {
            // A look first: most invocations find that another one was there before.
            if atomic_load::<u32, SCOPE, SEMANTICS>(workgroups.index_unchecked(0)) == 0 {
                atomic_store::<u32, SCOPE, SEMANTICS>(workgroups.index_unchecked_mut(0), across);
                atomic_store::<u32, SCOPE, SEMANTICS>(workgroups.index_unchecked_mut(1), down);
                atomic_store::<u32, SCOPE, SEMANTICS>(workgroups.index_unchecked_mut(2), 1);
            }
        }
    }
}
