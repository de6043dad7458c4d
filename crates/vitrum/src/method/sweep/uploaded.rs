//! The volumes of a frame on a backend.

use super::occupancy::Ranges;
use super::voxels::{chosen_format, fit, is_paged, upload};
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use crate::subject::Volumes;
use crate::unrenderable::Unrenderable;
use vitrum_kernels::abi::format::Format;

/// A frame's volumes on a backend, which stay the same while scene and camera change.
#[derive(Debug)]
pub struct UploadedVolumes {
    /// The voxels of the volume and of the second one, its colours or the bodies in it in place of that, or the same buffer twice; `None` if they are streamed.
    pub(super) voxels: Option<[Buffer; 2]>,
    pub(super) format: Format,
    /// Whether streamed voxels take the least memory, not as much as the limit allows.
    pub(super) tight: bool,
    pub(super) ranges: Ranges,
    /// The ranges of the second volume's bricks.
    pub(super) second_ranges: Option<Ranges>,
}

impl UploadedVolumes {
    /// Uploads the volumes, or prepares to stream them if they exceed the backend's limits.
    ///
    /// # Errors
    /// If the backend fails, or colours do not fit into it, which are not streamed.
    pub fn new(volumes: Volumes<'_>, backend: &mut dyn Backend) -> Result<Self, Error> {
        let Volumes { shown, ior: bending, bodies } = volumes;
        let format = chosen_format(volumes);
        if !fit(volumes, format, backend) {
            // Without a limit, voxels that do not fit into memory take as little of it as they can.
            let tight = is_paged(volumes) && backend.volume_limit() == u64::MAX;
            return Ok(Self { tight, ..Self::streamed(volumes)? });
        }
        let voxels = upload(shown, format, backend)?;
        let colors = bodies.unwrap_or(shown).colors.as_ref();
        let ior_voxels = match (bending, colors) {
            (Some(bending), _) => upload(bending, format, backend)?,
            (None, Some(colors)) => backend.create("colours", Contents::Bytes(bytemuck::cast_slice(colors)))?,
            (None, None) => voxels.clone(),
        };
        let second_ranges = volumes.second().map(Ranges::new);
        let ranges = Ranges::new(shown);
        Ok(Self { voxels: Some([voxels, ior_voxels]), format, tight: false, ranges, second_ranges })
    }

    /// Prepares to stream the volumes in the least memory, however small they are.
    ///
    /// # Errors
    /// [`Unrenderable::ColorsTooLarge`] of a volume with colours or bodies, which come in one piece.
    pub fn streamed(volumes: Volumes<'_>) -> Result<Self, Error> {
        let shown = volumes.shown;
        let Some(format) = chosen_format(volumes).paged() else {
            let words = volumes.bodies.unwrap_or(shown).voxel_count() as u64;
            let bytes = 4 * (shown.voxel_count() as u64 + words);
            return Err(Unrenderable::ColorsTooLarge { name: shown.name.clone(), bytes }.into());
        };
        let second_ranges = volumes.second().map(Ranges::new);
        Ok(Self { voxels: None, format, tight: true, ranges: Ranges::new(shown), second_ranges })
    }
}
