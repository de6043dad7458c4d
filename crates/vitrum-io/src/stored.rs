//! Voxels as a reader hands them over: numbers, and the colours of photographed volumes.

use crate::shared::Shared;
use crate::voxels::Voxels;

/// Voxels, and a colour for each where the file has colours.
#[derive(Debug, Clone)]
pub(crate) struct Stored {
    pub voxels: Voxels,
    /// As [`crate::Volume::colors`].
    pub colors: Option<Shared<u32>>,
}

impl From<Voxels> for Stored {
    fn from(voxels: Voxels) -> Self {
        Self { voxels, colors: None }
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
        const OPAQUE: u32 = 0xff00_0000;
        if let Some(colors) = &mut self.colors
            && colors.iter().all(|color| color & OPAQUE == 0)
        {
            colors.make_mut().iter_mut().for_each(|color| *color |= OPAQUE);
        }
        self
    }
}

/// The word of a colour of three or four bytes, red in the lowest byte; without a fourth the voxel is as opaque as its scalar says.
pub(crate) fn color_word(red: u8, green: u8, blue: u8, alpha: u8) -> u32 {
    u32::from_le_bytes([red, green, blue, alpha])
}
