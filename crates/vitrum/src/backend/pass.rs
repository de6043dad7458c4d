//! Pass lists.

use super::BackendError;
use vitrum_kernels::kernel::{Access, Kernel};

/// A buffer of a backend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Buffer(pub(super) usize);

/// One dispatch of a kernel over `width` × `height` invocations.
#[derive(Clone)]
pub struct Pass {
    /// What runs.
    pub kernel: &'static Kernel,
    /// The uniform block's bytes.
    pub uniforms: Vec<u8>,
    /// A buffer for each binding from 1 on.
    pub buffers: Vec<Buffer>,
    /// Invocations across.
    pub width: u32,
    /// Invocations down.
    pub height: u32,
}

/// Passes that run in order.
#[derive(Clone, Default)]
pub struct PassList {
    /// The passes.
    pub passes: Vec<Pass>,
    /// Passes of these kernels only matter while some invocation of `Self::ends_with` has work to do: once a pass of that
    /// kernel was idle, a backend may leave the rest of them out. The results are the same.
    pub while_busy: Vec<&'static str>,
    /// The kernel whose idleness counts.
    pub ends_with: Option<&'static str>,
}

impl Pass {
    /// The buffer that the pass writes.
    pub fn output(&self) -> Option<Buffer> {
        let writes = |access: Access| matches!(access, Access::Write | Access::Update | Access::Add);
        let written = self.kernel.declaration.bindings[1..].iter().position(|binding| writes(binding.access))?;
        self.buffers.get(written).copied()
    }

    /// Checks that buffers fit the declaration: their number, that none is bound twice where one use writes, and that the
    /// written one holds a record for each invocation. `bytes` gives a buffer's size.
    pub(super) fn check(&self, bytes: impl Fn(Buffer) -> Option<u64>) -> Result<(), BackendError> {
        let declaration = &self.kernel.declaration;
        let wrong = |what: String| Err(BackendError::Misuse { kernel: declaration.name, what });
        if self.uniforms.len() != declaration.uniform_bytes {
            return wrong(format!(
                "{} bytes of uniforms where {} are declared",
                self.uniforms.len(),
                declaration.uniform_bytes
            ));
        }
        if self.buffers.len() + 1 != declaration.bindings.len() {
            return wrong(format!(
                "{} buffers where {} are declared",
                self.buffers.len(),
                declaration.bindings.len() - 1
            ));
        }
        for (buffer, binding) in self.buffers.iter().zip(&declaration.bindings[1..]) {
            let Some(size) = bytes(*buffer) else {
                return wrong(format!("binding {} ({}) is freed", binding.binding, binding.name));
            };
            let records = u64::from(self.width) * u64::from(self.height) * declaration.components as u64 * 4;
            // Sums have a place for a texel, not for an invocation; adding beyond the end does nothing.
            let needed = if binding.access == Access::Add { 4 } else { records };
            if matches!(binding.access, Access::Write | Access::Update | Access::Add) {
                if size < needed {
                    return wrong(format!("binding {} holds {size} bytes where {needed} are written", binding.binding));
                }
                if self.buffers.iter().filter(|other| *other == buffer).count() > 1 {
                    return wrong(format!("binding {} is read and written", binding.binding));
                }
            }
        }
        Ok(())
    }
}
