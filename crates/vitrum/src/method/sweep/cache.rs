//! Data that a sweep keeps from frame to frame: volumes, tables, the occupancy, the environment map.

use super::bodies::BodyVolume;
use super::kept::KeptLight;
use super::mesh_volumes::{MeshVolumes, Part};
use super::occupancy::Occupancy;
use super::tables::{Tables, TablesKey, tables_key};
use super::uploaded::UploadedVolumes;
use crate::assets::Assets;
use crate::backend::{Backend, BackendError, Buffer, Contents};
use crate::error::Error;
use crate::method::Tools;
use crate::method::cache::{Memo, Scratch};
use crate::method::view::pictures::UploadedPictures;
use crate::scene::Scene;
use crate::subject::Volumes;
use std::sync::Arc;
use vitrum_io::Volume;

/// Data of a sweep that the next frame of the same assets uses again.
#[derive(Default)]
pub(super) struct SweepCache {
    /// The volumes that were made of a mesh.
    pub(super) mesh: Option<MeshVolumes>,
    /// The volume that was made of the bodies within the scan.
    pub(super) bodies: Option<BodyVolume>,
    pub(super) frame: FrameCache,
}

/// Data of a sweep that belongs to its volumes.
#[derive(Default)]
pub(super) struct FrameCache {
    uploaded: Memo<(), Arc<UploadedVolumes>>,
    tables: Memo<TablesKey, Arc<Tables>>,
    tables_buffer: Memo<TablesKey, Buffer>,
    pub(super) occupancy: Memo<(TablesKey, [u32; 2], bool, Option<u32>), Occupancy>,
    pub(super) pictures: UploadedPictures,
    /// The light that wavefronts have carried.
    pub(super) light: KeptLight,
    pub(super) scratch: Scratch,
}

impl SweepCache {
    /// The volumes that the plane sweep renders in place of the scene's mesh; the volumes of the last frame where nothing changed them.
    ///
    /// # Errors
    /// As [`MeshVolumes::new`].
    pub(super) fn mesh(&mut self, scene: &Scene, assets: &Assets, tools: &mut Tools<'_>) -> Result<(), Error> {
        if let Some(made) = &self.mesh
            && made.fits(scene, assets)?
        {
            return Ok(());
        }
        *self = Self::default();
        self.mesh = Some(MeshVolumes::new(scene, assets, Part::All, tools)?);
        Ok(())
    }
}

impl SweepCache {
    /// The bodies within the scan `shown`; those of the last frame where nothing changed them.
    ///
    /// # Errors
    /// As [`BodyVolume::new`].
    pub(super) fn bodies(
        &mut self,
        scene: &Scene,
        shown: &Volume,
        assets: &Assets,
        tools: &mut Tools<'_>,
    ) -> Result<(), Error> {
        let fits = match (&self.bodies, &assets.bodies) {
            (None, None) => true,
            (Some(made), Some(mesh)) => made.fits(scene, shown, mesh)?,
            _ => false,
        };
        if !fits {
            *self = Self::default();
            let made = assets.bodies.as_ref().map(|mesh| BodyVolume::new(scene, shown, mesh, tools));
            self.bodies = made.transpose()?;
        }
        Ok(())
    }
}

impl FrameCache {
    /// A cache with volumes that are uploaded already.
    pub(super) fn holding(uploaded: Arc<UploadedVolumes>) -> Self {
        let mut cache = Self::default();
        cache.uploaded.of((), || uploaded);
        cache
    }

    /// The volumes on the backend.
    ///
    /// # Errors
    /// As [`UploadedVolumes::new`].
    pub(super) fn uploaded(
        &mut self,
        volumes: Volumes<'_>,
        backend: &mut dyn Backend,
    ) -> Result<Arc<UploadedVolumes>, Error> {
        self.uploaded.get((), || UploadedVolumes::new(volumes, backend).map(Arc::new)).cloned()
    }

    /// The tables of a scene's transfer functions.
    pub(super) fn tables(&mut self, scene: &Scene, volumes: Volumes<'_>) -> Arc<Tables> {
        Arc::clone(self.tables.of(tables_key(scene), || Arc::new(Tables::new(scene, volumes))))
    }

    /// The tables on the backend.
    ///
    /// # Errors
    /// As [`Backend::create`].
    pub(super) fn tables_buffer(
        &mut self,
        scene: &Scene,
        tables: &Tables,
        backend: &mut dyn Backend,
    ) -> Result<Buffer, BackendError> {
        let words = Contents::Bytes(bytemuck::cast_slice(&tables.words));
        self.tables_buffer.get(tables_key(scene), || backend.create("tables", words)).cloned()
    }
}
