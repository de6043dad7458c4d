//! The data that a picture shows: one volume, two volumes, or a mesh.

use std::sync::Arc;
use vitrum_io::{Mesh, Volume};

/// The data that a picture shows. It is shared, not copied: a clone is the same data.
#[derive(Debug, Clone)]
pub enum Subject {
    /// A volume, whose scalar gives colour, opacity, filter and index of refraction.
    Volume(Arc<Volume>),
    /// Two volumes.
    Volumes {
        /// The volume whose scalar gives colour, opacity and filter.
        shown: Arc<Volume>,
        /// The volume whose scalar gives the index of refraction (Magnus & Bruckner 2017, Figs. 11e and 12e).
        ior: Arc<Volume>,
    },
    /// A mesh.
    Mesh(Arc<Mesh>),
}

/// The volumes that a sweep goes through.
#[derive(Debug, Clone, Copy)]
pub struct Volumes<'a> {
    /// The volume whose scalar gives colour, opacity and filter.
    pub shown: &'a Volume,
    /// The volume whose scalar gives the index of refraction, if that is another one.
    pub ior: Option<&'a Volume>,
    /// The opaque bodies within the volume, if there are any, on a grid of their own: values from 0 to 255 are the share of a voxel that they fill, and each voxel's
    /// colour is their reflectance in sRGB, with that share in the highest byte.
    pub bodies: Option<&'a Volume>,
}

impl<'a> Volumes<'a> {
    /// The volume whose scalar gives the index of refraction.
    #[must_use]
    pub fn bending(self) -> &'a Volume {
        self.ior.unwrap_or(self.shown)
    }

    /// The volume beside the shown one, if there are two: the one that gives the index of refraction, or the bodies.
    #[must_use]
    pub fn second(self) -> Option<&'a Volume> {
        self.ior.or(self.bodies)
    }

    /// The volumes: the shown one, then the other one if there are two.
    pub fn iter(self) -> impl Iterator<Item = &'a Volume> + Clone {
        std::iter::once(self.shown).chain(self.second())
    }
}

impl Subject {
    /// Fails where voxels that stay in a file could not be read since the last call: what was made of them is wrong.
    ///
    /// # Errors
    /// That of the read.
    pub(crate) fn check_read(&self) -> Result<(), vitrum_io::Error> {
        let volumes = self.volumes();
        let mut paged = volumes.iter().flat_map(|volumes| volumes.iter()).filter_map(|volume| volume.paged.as_ref());
        paged.find_map(|paged| paged.take_failure()).map_or(Ok(()), Err)
    }

    /// The volumes; `None` for a mesh.
    #[must_use]
    pub fn volumes(&self) -> Option<Volumes<'_>> {
        match self {
            Self::Volume(shown) => Some(Volumes { shown, ior: None, bodies: None }),
            Self::Volumes { shown, ior } => Some(Volumes { shown, ior: Some(ior), bodies: None }),
            Self::Mesh(_) => None,
        }
    }

    /// The shown volume; `None` for a mesh.
    #[must_use]
    pub fn volume(&self) -> Option<&Volume> {
        self.volumes().map(|volumes| volumes.shown)
    }

    /// The mesh; `None` for volumes.
    #[must_use]
    pub fn mesh(&self) -> Option<&Mesh> {
        self.shared_mesh().map(|mesh| &**mesh)
    }

    /// As [`Self::mesh`], shared.
    pub(crate) fn shared_mesh(&self) -> Option<&Arc<Mesh>> {
        match self {
            Self::Mesh(mesh) => Some(mesh),
            Self::Volume(_) | Self::Volumes { .. } => None,
        }
    }
}

impl From<Volume> for Subject {
    fn from(volume: Volume) -> Self {
        Self::Volume(Arc::new(volume))
    }
}

impl From<Mesh> for Subject {
    fn from(mesh: Mesh) -> Self {
        Self::Mesh(Arc::new(mesh))
    }
}
