//! Over which invocations a pass runs, and how.

/// The size and the mode of a dispatch.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Dispatch {
    /// Columns of invocations.
    pub width: u32,
    /// Rows of invocations.
    pub height: u32,
    /// Mode, one of the kernel's.
    pub mode: u32,
}

/// The invocations of a dispatch that a pass runs over.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(not(target_arch = "spirv"), derive(bytemuck::Pod, bytemuck::Zeroable))]
pub struct Region {
    /// The first column.
    pub first_column: u32,
    /// The first row.
    pub first_row: u32,
    /// The column before which it ends.
    pub end_column: u32,
    /// The row before which it ends.
    pub end_row: u32,
}

/// A kernel's uniform block, as the dispatch reads it.
pub trait Dispatched {
    /// Its size and mode.
    fn dispatch(&self) -> Dispatch;

    /// The invocations that are run: all, if the block does not say otherwise.
    #[inline(always)]
    fn region(&self) -> Region {
        let Dispatch { width, height, .. } = self.dispatch();
        Region { first_column: 0, first_row: 0, end_column: width, end_row: height }
    }

    /// The position of the pass among passes that follow one another, and how far it is from there to the next one.
    #[inline(always)]
    fn position(&self) -> (f32, f32) {
        (0.0, 0.0)
    }
}
