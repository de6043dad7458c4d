//! Contents of the CPU backend's buffers.

use std::ops::Deref;
use vitrum_io::Words;

/// The contents of a buffer.
pub(super) enum Contents {
    Own(Vec<u32>),
    /// Memory that has another owner, too.
    Shared(Words),
}

impl Contents {
    /// The words, to be changed.
    pub(super) fn into_own(self) -> Vec<u32> {
        match self {
            Self::Own(words) => words,
            Self::Shared(words) => words.to_vec(),
        }
    }
}

impl Deref for Contents {
    type Target = [u32];

    fn deref(&self) -> &[u32] {
        match self {
            Self::Own(words) => words,
            Self::Shared(words) => words,
        }
    }
}
