//! Errors of backends.

/// Why a backend could not do its work.
#[derive(Debug, thiserror::Error)]
pub enum BackendError {
    /// A machine without a usable adapter.
    #[error("no usable graphics adapter: {reason}")]
    NoAdapter {
        /// The reason: the adapters that were found, or the lack of a driver.
        reason: String,
    },
    /// The adapter lacks something.
    #[error("adapter {adapter} lacks {what}")]
    Unsupported {
        /// The adapter.
        adapter: String,
        /// The missing capability.
        what: String,
    },
    /// A buffer is larger than the device allows.
    #[error("{label} needs {needed} bytes; {adapter} allows {limit} in one buffer")]
    TooLarge {
        /// The label of the buffer.
        label: String,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
        /// The adapter.
        adapter: String,
    },
    /// Volumes are streamed, and what one plane needs of them is more than they may take.
    #[error(
        "{whole} bytes of voxels are streamed ({adapter}): {needed} bytes are needed at once, and {limit} are allowed"
    )]
    VolumeLimit {
        /// Bytes of the whole volumes.
        whole: u64,
        /// Bytes needed at once.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
        /// Whether that is what was asked for by [`Backend::set_volume_limit`](super::Backend::set_volume_limit); else it is the device's.
        asked_for: bool,
        /// The adapter.
        adapter: String,
    },
    /// The device has no memory left.
    #[error("{adapter} is out of memory: {what}")]
    OutOfMemory {
        /// The adapter.
        adapter: String,
        /// The object that was being made.
        what: String,
    },
    /// The device stopped working.
    #[error("{adapter} failed: {reason}")]
    DeviceLost {
        /// The adapter.
        adapter: String,
        /// The message of the driver.
        reason: String,
    },
    /// A pass does not fit its kernel's declaration: a mistake in a method.
    #[error("pass of kernel {kernel}: {what}")]
    Misuse {
        /// The kernel.
        kernel: &'static str,
        /// The argument that does not fit the declaration.
        what: String,
    },
    /// Worker threads could not be started.
    #[error("{threads} threads cannot be started: {reason}")]
    Threads {
        /// Threads asked for.
        threads: usize,
        /// The message of the operating system.
        reason: String,
    },
    /// The caller cancelled the run.
    #[error("cancelled")]
    Cancelled,
}

impl BackendError {
    /// Whether another device could do the same work: this one cannot be used, failed, or has too little memory.
    pub fn is_device_error(&self) -> bool {
        matches!(
            self,
            Self::NoAdapter { .. }
                | Self::Unsupported { .. }
                | Self::DeviceLost { .. }
                | Self::OutOfMemory { .. }
                | Self::TooLarge { .. }
                | Self::VolumeLimit { asked_for: false, .. }
        )
    }

    /// Whether the error is one of usage and not of the device: a requested memory limit is too low.
    pub fn is_usage_error(&self) -> bool {
        matches!(self, Self::VolumeLimit { asked_for: true, .. })
    }
}
