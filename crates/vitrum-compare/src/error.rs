/// Why two pictures or buffers could not be compared.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CompareError {
    /// The two do not hold the same number of pixels or values.
    #[error("the first holds {first} values and the second {second}: only equal sizes can be compared")]
    SizeMismatch {
        /// Pixels or values of the first.
        first: usize,
        /// Pixels or values of the second.
        second: usize,
    },
    /// The stated width and height do not give the number of pixels.
    #[error("{width} × {height} pixels were announced, but {pixels} were given")]
    Dimensions {
        /// The stated width.
        width: u32,
        /// The stated height.
        height: u32,
        /// The number of pixels given.
        pixels: usize,
    },
    /// Empty inputs, which must not pass for agreement.
    #[error("there is nothing to compare: both are empty")]
    Empty,
}

/// Equal and not empty, or the error that says which.
pub(crate) fn require_equal_lengths(first: usize, second: usize) -> Result<(), CompareError> {
    match (first, second) {
        (0, 0) => Err(CompareError::Empty),
        _ if first == second => Ok(()),
        _ => Err(CompareError::SizeMismatch { first, second }),
    }
}
