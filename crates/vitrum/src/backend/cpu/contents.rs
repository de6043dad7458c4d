//! What buffers of the CPU backend hold.

use std::ops::Deref;
use vitrum_io::Words;

/// What a buffer holds.
pub(super) enum Contents {
    Own(Vec<u32>),
    /// Memory of somebody else, too.
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
