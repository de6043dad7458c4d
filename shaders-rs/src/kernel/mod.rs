//! The declaration of every kernel, and what is derived from it.
//!
//! [`for_each_kernel`](crate::for_each_kernel) lists the kernels once: name, bindings, access, body. The SPIR-V entry points, the
//! CPU dispatch, the GPU pipelines' layouts and the manifest all come from that list.

mod list;
pub mod record;

#[cfg(not(target_arch = "spirv"))]
mod dispatch;
#[cfg(not(target_arch = "spirv"))]
mod host;
#[cfg(not(target_arch = "spirv"))]
mod marks;

#[cfg(not(target_arch = "spirv"))]
pub use dispatch::{ALL, kernels};
#[cfg(not(target_arch = "spirv"))]
pub use host::{Access, Binding, Chunk, Declaration, Element, FOREVER, InstructionSet, Kernel, LANES, Window};
#[cfg(not(target_arch = "spirv"))]
pub use marks::Marks;

/// Invocations along each side of a workgroup.
pub const WORKGROUP: u32 = 8;
