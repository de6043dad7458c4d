//! Dispatches: passes that the device runs in one call.
//!
//! A dispatch has a cost of its own: the device waits until the one before it is done, then has to be filled with work again. Where passes
//! change the same records, and each looks at nothing that the others write but its own one, an invocation can go through all of them.

use crate::backend::Pass;
use std::num::NonZeroU64;
use vitrum_kernels::kernel::Skip;

/// The most passes of one dispatch: devices stop dispatches that take too long.
const MOST: usize = 16;

/// Whether `next` can run in the dispatch of `pass`.
fn follows(pass: &Pass, next: &Pass) -> bool {
    let same = (&next.buffers, next.start, next.width, next.height, next.window)
        == (&pass.buffers, pass.start, pass.width, pass.height, pass.window);
    let kernel = &pass.kernel.declaration;
    kernel.skip == Skip::Until && kernel.name == next.kernel.declaration.name && same
}

/// The passes of a list, dispatch by dispatch.
pub(super) fn dispatches(passes: &[Pass]) -> impl Iterator<Item = &[Pass]> {
    passes.chunk_by(follows).flat_map(|together| together.chunks(MOST))
}

/// Bytes of a dispatch's uniform blocks, one behind the other.
pub(super) fn block_bytes(dispatch: &[Pass]) -> Option<NonZeroU64> {
    NonZeroU64::new(dispatch.iter().map(|pass| pass.uniforms.len() as u64).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_kernels::kernel::{Kernel, Window, kernels};

    fn pass(kernel: &'static Kernel, width: u32) -> Pass {
        Pass {
            kernel,
            uniforms: vec![0; 8],
            buffers: Vec::new(),
            start: 0,
            width,
            height: 1,
            window: Window::whole(width, 1),
        }
    }

    #[test]
    fn passes_of_resting_kernels_over_the_same_records_run_together() {
        let rays = || pass(&kernels::sweep_propagate_rays_u8, 4);
        let light = || pass(&kernels::sweep_filter_light, 4);
        let part = Pass { window: Window { first: [0, 0], end: [0, 1] }, ..rays() };
        let list =
            [light(), light(), rays(), rays(), rays(), pass(&kernels::sweep_propagate_rays_u16, 4), part, light()];
        let sizes: Vec<usize> = dispatches(&list).map(<[Pass]>::len).collect();
        assert_eq!(sizes, [1, 1, 3, 1, 1, 1]);
        assert_eq!(block_bytes(&list[2..5]).map(NonZeroU64::get), Some(24));
        let many: Vec<Pass> = (0..MOST + 3).map(|_| rays()).collect();
        assert_eq!(dispatches(&many).map(<[Pass]>::len).collect::<Vec<_>>(), [MOST, 3]);
    }
}
