//! The quality of a picture, in one word.

use crate::scene::{Film, MethodName};

/// How many viewing rays a picture has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quality {
    /// One ray for each pixel.
    Draft,
    /// As many rays as the scene says, and 3 × 3 where neighbouring pixels differ (method `sweep`).
    Good,
    /// 2 × 2 rays for each pixel, and 6 × 6 where neighbouring pixels differ; 3 × 3 by methods that render no pixel anew.
    Best,
}

impl Quality {
    /// Sets the rays of a film that `method` renders.
    pub fn apply(self, film: &mut Film, method: MethodName) {
        let refines = method == MethodName::Sweep;
        (film.supersampling, film.refinement) = match self {
            Self::Draft => (1, 1),
            Self::Good => (film.supersampling, film.refinement.max(3)),
            Self::Best => (film.supersampling.max(if refines { 2 } else { 3 }), film.refinement.max(6)),
        };
    }
}
