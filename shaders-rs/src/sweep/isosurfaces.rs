//! The sweep's isosurfaces.

use crate::abi::sweep::{SweepUniforms, flag};

/// Whether isosurfaces are looked for. On a CPU always: where there are none the tables say so, and a branch around scattered reads is no vector code.
#[inline(always)]
pub fn are_looked_for(u: &SweepUniforms) -> bool {
    !cfg!(target_arch = "spirv") | (u.flags & flag::ISOSURFACES != 0)
}
