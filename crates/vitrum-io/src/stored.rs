//! Voxels as a reader hands them over: numbers, and the colours of photographed volumes.

use std::sync::Arc;

use crate::paged::Paged;
use crate::shared::Shared;
use crate::voxels::Voxels;

/// Voxels, and a colour for each where the file has colours.
#[derive(Debug, Clone)]
pub(crate) struct Stored {
    pub voxels: Voxels,
    /// As [`crate::Volume::colors`].
    pub colors: Option<Shared<u32>>,
    /// All voxels, where `voxels` are an overview of them.
    pub paged: Option<Arc<Paged>>,
}

/// The word of black, opaque.
pub(crate) const OPAQUE: u32 = 0xff00_0000;

impl From<Voxels> for Stored {
    fn from(voxels: Voxels) -> Self {
        Self { voxels, colors: None, paged: None }
    }
}

impl<T> From<Vec<T>> for Stored
where
    Voxels: From<Vec<T>>,
{
    fn from(voxels: Vec<T>) -> Self {
        Voxels::from(voxels).into()
    }
}

impl Stored {
    /// The voxels, all of them opaque where their colours say that none is seen at all: a fourth byte that nobody filled in.
    pub fn seen(mut self) -> Self {
        if let Some(colors) = &mut self.colors
            && colors.iter().all(|color| color & OPAQUE == 0)
        {
            colors.make_mut().iter_mut().for_each(|color| *color |= OPAQUE);
        }
        self
    }
}
