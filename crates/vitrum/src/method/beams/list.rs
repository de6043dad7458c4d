//! The pass list of a frame of beams while it is being written.

use crate::backend::{Buffer, Pass, START_ALIGNMENT};
use bytemuck::bytes_of;
use vitrum_kernels::abi::beams::BeamsUniforms;
use vitrum_kernels::abi::dispatch::Dispatch;
use vitrum_kernels::kernel::{Kernel, Window};

/// Columns of a dispatch at most: devices have a limit of 65,535 workgroups along each axis.
const COLUMNS: u32 = 1 << 18;

/// A list of passes that is being written.
pub(super) struct List {
    pub(super) block: BeamsUniforms,
    pub(super) passes: Vec<Pass>,
}

impl List {
    /// Adds a pass over `size` invocations, in a round; records are written from word `start` on.
    pub(super) fn add(
        &mut self,
        kernel: &'static Kernel,
        [width, height]: [u32; 2],
        (mode, round): (u32, u32),
        buffers: &[&Buffer],
        start: u64,
    ) {
        let mut block = self.block;
        block.dispatch = Dispatch { width, height, mode };
        block.limits.round = round;
        for first in (0..width).step_by(COLUMNS as usize) {
            self.passes.push(Pass {
                kernel,
                uniforms: bytes_of(&block).to_vec(),
                buffers: buffers.iter().map(|&buffer| buffer.clone()).collect(),
                width,
                height,
                start,
                window: Window { first: [first, 0], end: [width.min(first + COLUMNS), height] },
            });
        }
    }
}

/// Floats from one round's records to those of the next, for `size` records of `components`: a pass's records start at such a multiple.
pub(super) fn pitch([width, height]: [u32; 2], components: usize) -> u64 {
    (u64::from(width) * u64::from(height) * components as u64).next_multiple_of(START_ALIGNMENT)
}
