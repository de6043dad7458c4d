//! The volumes of a frame on a backend.

use super::occupancy::Ranges;
use super::voxels::{chosen_format, fit, upload};
use crate::backend::{Backend, Buffer};
use crate::error::Error;
use crate::subject::Volumes;
use vitrum_kernels::abi::format::Format;

/// A frame's volumes on a backend, which stay the same while scene and camera change.
#[derive(Debug)]
pub struct UploadedVolumes {
    /// The voxels of the volume and of the second one, or the same buffer twice; `None` if they are streamed.
    pub(super) voxels: Option<[Buffer; 2]>,
    pub(super) format: Format,
    /// Whether streamed voxels take the least memory, not as much as the limit allows.
    pub(super) tight: bool,
    pub(super) ranges: Ranges,
    /// The ranges of the second volume's bricks.
    pub(super) ior_ranges: Option<Ranges>,
}

impl UploadedVolumes {
    /// Uploads the volumes, or prepares to stream them if they exceed the backend's limits.
    ///
    /// # Errors
    /// If the backend fails.
    pub fn new(volumes: Volumes<'_>, backend: &mut dyn Backend) -> Result<Self, Error> {
        let Volumes { shown, ior: bending } = volumes;
        let format = chosen_format(shown, bending);
        if !fit(volumes, format, backend) {
            return Ok(Self { tight: false, ..Self::streamed(volumes) });
        }
        let voxels = upload(shown, format, backend)?;
        let ior_voxels = match bending {
            None => voxels.clone(),
            Some(bending) => upload(bending, format, backend)?,
        };
        let ior_ranges = bending.map(Ranges::new);
        let ranges = Ranges::new(shown);
        Ok(Self { voxels: Some([voxels, ior_voxels]), format, tight: false, ranges, ior_ranges })
    }

    /// Prepares to stream the volumes in the least memory, however small they are.
    #[must_use]
    pub fn streamed(volumes: Volumes<'_>) -> Self {
        let Volumes { shown, ior: bending } = volumes;
        let format = chosen_format(shown, bending).paged();
        Self { voxels: None, format, tight: true, ranges: Ranges::new(shown), ior_ranges: bending.map(Ranges::new) }
    }
}
