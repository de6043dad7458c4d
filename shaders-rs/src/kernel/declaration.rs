//! The declaration of a kernel, as backends read it.

use super::chunk::Chunk;
use super::instruction_set::InstructionSet;
use crate::abi::format::Format;

/// A buffer's element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// 32-bit words.
    U32,
    /// 32-bit floats.
    F32,
}

/// How a kernel uses a binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// A uniform block.
    Uniform,
    /// A storage buffer that is read anywhere.
    Read,
    /// A planar storage buffer, one record an invocation, written.
    Write,
    /// A planar storage buffer, one record an invocation, read and written.
    Update,
    /// Words that any invocation adds to (see [`crate::field::sums`]).
    Add,
    /// The numbers of workgroups of a later dispatch, which an invocation with work raises from 0. A GPU backend has them; no pass does.
    Workgroups,
}

/// One binding of bind group 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Number; dense from 0.
    pub binding: u32,
    /// The kernel's name for it.
    pub name: &'static str,
    /// Element type; [`Element::U32`] for the uniform block.
    pub element: Element,
    /// Use.
    pub access: Access,
}

/// Which blocks of invocations the CPU may leave out without a change of any bit, see [`super::skip`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skip {
    /// None.
    Never,
    /// Blocks that have nothing to do until a later pass.
    Until,
    /// Blocks around which all records are the one that the kernel keeps as it is.
    Same,
}

/// The declaration of a kernel.
#[derive(Clone, Copy, Debug)]
pub struct Declaration {
    /// Name of the kernel, of its SPIR-V entry point and of its `.spv` file.
    pub name: &'static str,
    /// Its declaration's name: of a family, the name that its kernels' names begin with.
    pub family: &'static str,
    /// Bytes of its uniform block.
    pub uniform_bytes: usize,
    /// Floats in a record of its output; words a place has, if it adds.
    pub components: usize,
    /// The names of a record's components; none if it adds.
    pub names: &'static [&'static str],
    /// Levels of work that have a body of their own on the CPU, each with all bits of those before; empty if there is but one body.
    pub levels: &'static [u32],
    /// Modes that it is run in.
    pub modes: &'static [u32],
    /// Which blocks the CPU may leave out.
    pub skip: Skip,
    /// Bindings of group 0, in order.
    pub bindings: &'static [Binding],
}

impl Declaration {
    /// The bindings for which a pass has a buffer each: all but the uniform block and [`Access::Workgroups`].
    #[must_use]
    pub fn buffers(&self) -> &'static [Binding] {
        let end = self.bindings.len() - usize::from(self.reports_work());
        &self.bindings[1..end]
    }

    /// Whether it tells a GPU if any invocation had work, see [`Access::Workgroups`]. On the CPU every kernel tells, see [`Kernel::run`].
    #[must_use]
    pub fn reports_work(&self) -> bool {
        self.bindings.last().is_some_and(|last| last.access == Access::Workgroups)
    }
}

/// A kernel as the CPU runs it.
pub struct Kernel {
    /// Its declaration.
    pub declaration: Declaration,
    /// Runs it over a chunk; the instruction set must be available. Returns whether any invocation had work to do.
    pub run: fn(InstructionSet, &mut Chunk<'_>) -> bool,
}

/// A kernel for each format of voxels.
pub struct Family(pub(super) &'static [&'static Kernel; Format::ALL.len()]);

impl Family {
    /// The kernel for voxels that are stored as `format`.
    #[must_use]
    pub fn get(&self, format: Format) -> &'static Kernel {
        self.0[format as usize]
    }
}
