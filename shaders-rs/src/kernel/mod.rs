//! The declaration of every kernel, and what is derived from it.
//!
//! [`list`] lists the kernels once: name, bindings, access, body. The SPIR-V entry points, the CPU dispatch, the GPU pipelines' layouts
//! and the manifest all come from that list.

#[macro_use]
mod declare;
#[cfg(target_arch = "spirv")]
#[macro_use]
mod entry_point;
#[cfg(not(target_arch = "spirv"))]
#[macro_use]
mod adaptor;
#[cfg(not(target_arch = "spirv"))]
#[macro_use]
mod host;

pub mod list;
pub mod record;
pub mod skip;
#[cfg(target_arch = "spirv")]
pub mod workgroups;

#[cfg(not(target_arch = "spirv"))]
mod chunk;
#[cfg(not(target_arch = "spirv"))]
mod declaration;
#[cfg(not(target_arch = "spirv"))]
mod drive;
#[cfg(not(target_arch = "spirv"))]
mod instruction_set;
#[cfg(not(target_arch = "spirv"))]
pub(crate) mod lanes;

#[cfg(not(target_arch = "spirv"))]
pub use chunk::{Chunk, LANES, Window};
#[cfg(not(target_arch = "spirv"))]
pub use declaration::{Access, Binding, Declaration, Element, Family, Kernel, Skip};
#[cfg(not(target_arch = "spirv"))]
pub use instruction_set::InstructionSet;
#[cfg(not(target_arch = "spirv"))]
pub use list::{self as kernels, ALL};

/// Invocations along each side of a workgroup.
pub const WORKGROUP: u32 = 8;

/// The last of a kernel's levels, which can do everything.
#[cfg(target_arch = "spirv")]
const fn last(levels: &[u32]) -> u32 {
    levels[levels.len() - 1]
}
