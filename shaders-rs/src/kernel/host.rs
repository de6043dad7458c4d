//! What a backend knows of a kernel.

#[cfg(target_endian = "big")]
compile_error!("kernels read packed voxels as little-endian words");

use super::marks::Marks;
use core::ops::Range;
use core::sync::atomic::AtomicU32;

/// The most invocations a block of the CPU dispatch has; one AVX-512 register of floats.
pub const LANES: usize = 16;

/// Passes that a block is left out of when there is nothing more to do.
pub const FOREVER: u32 = u32::MAX;

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

/// What is said once about a kernel.
#[derive(Clone, Copy, Debug)]
pub struct Declaration {
    /// Name of the kernel, of its SPIR-V entry point and of its `.spv` file.
    pub name: &'static str,
    /// Bytes of its uniform block.
    pub uniform_bytes: usize,
    /// Floats in a record of its output; words a place has, if it adds.
    pub components: usize,
    /// Whether blocks of invocations may rest for some passes, see [`Chunk::rests`].
    pub rests: bool,
    /// Whether it keeps unoccluded light as it is, see [`Chunk::marks`].
    pub keeps_unoccluded: bool,
    /// Bindings of group 0, in order.
    pub bindings: &'static [Binding],
}

/// Rows of a dispatch, for the CPU.
pub struct Chunk<'a> {
    /// The first row.
    pub first_row: u32,
    /// Rows in the chunk.
    pub rows: u32,
    /// Invocations in a row.
    pub width: u32,
    /// Its rows that are run, counted from its first.
    pub inside: Range<u32>,
    /// The columns that are run; the first is that of a block.
    pub columns: Range<u32>,
    /// The uniform block.
    pub uniforms: &'a [u8],
    /// The buffers that are read, in order of their bindings. Not empty.
    pub reads: &'a [&'a [u32]],
    /// For each component of the output, this chunk's part: `rows · width` floats. Empty for a kernel that adds.
    pub output: &'a mut [&'a mut [f32]],
    /// What a kernel adds to; empty for the others.
    pub sums: &'a [AtomicU32],
    /// For a kernel that rests, row by row for each block of [`LANES`] invocations the passes that it is to be left out of, from this
    /// one on, or [`FOREVER`]; the kernel keeps count. All 0 before its first pass over a record. Empty for the others.
    pub rests: &'a mut [u32],
    /// Where light is unoccluded, for a kernel that keeps it as it is.
    pub marks: Marks<'a>,
}

impl Chunk<'_> {
    /// The number of the block that begins at column `x` of the chunk's row `row`.
    #[inline(always)]
    pub(super) fn block(&self, row: u32, x: u32) -> usize {
        (row * self.width.div_ceil(LANES as u32) + x / LANES as u32) as usize
    }
}

/// The part of a dispatch's invocations that a pass runs over; what the others wrote before stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// The first column, a multiple of [`LANES`], and the first row.
    pub first: [u32; 2],
    /// The column, a multiple of [`LANES`] or the width, and the row before which it ends.
    pub end: [u32; 2],
}

impl Window {
    /// All of `width` × `height` invocations.
    #[must_use]
    pub fn whole(width: u32, height: u32) -> Self {
        Self { first: [0, 0], end: [width, height] }
    }
}

/// Instruction sets the CPU dispatch is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InstructionSet {
    /// What the target guarantees (SSE2 on x86-64, NEON on AArch64).
    Baseline,
    /// AVX2.
    Avx2,
    /// AVX-512 F, BW, CD, DQ, VL.
    Avx512,
}

impl InstructionSet {
    /// All of them, slowest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// Whether this machine has it.
    pub fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => std::arch::is_x86_feature_detected!("avx2"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                std::arch::is_x86_feature_detected!("avx512f")
                    && std::arch::is_x86_feature_detected!("avx512bw")
                    && std::arch::is_x86_feature_detected!("avx512cd")
                    && std::arch::is_x86_feature_detected!("avx512dq")
                    && std::arch::is_x86_feature_detected!("avx512vl")
            }
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The best this machine has.
    pub fn best() -> Self {
        Self::ALL.into_iter().rfind(|set| set.is_available()).unwrap_or(Self::Baseline)
    }
}

/// A kernel as the CPU runs it.
pub struct Kernel {
    /// What is said about it.
    pub declaration: Declaration,
    /// Runs it over a chunk; the instruction set must be available. Returns whether any invocation had work to do.
    pub run: fn(InstructionSet, &mut Chunk<'_>) -> bool,
}
