//! Data that rays through a mesh keep from frame to frame: voxels, trees, shadow maps, looks, the environment map.

use super::looks::{Looks, looks};
use super::uploaded::UploadedMesh;
use crate::backend::{Backend, BackendError, Buffer, Contents};
use crate::method::cache::{Memo, Scratch};
use crate::method::sweep::caustics::CausticsCache;
use crate::method::view::pictures::UploadedPictures;
use crate::scene::{Material, Scene};
use bytemuck::cast_slice;
use std::sync::Arc;
use vitrum_io::Mesh;

/// The scene's values on which surface attributes depend: the materials, without their indices of refraction, and the optical depth of an opaque
/// triangle of density 1.
type LooksKey = (Vec<Material>, f32);

/// Data of rays through a mesh that the next frame of the same assets uses again.
#[derive(Default)]
pub(super) struct MeshCache {
    pub(super) uploaded: Option<UploadedMesh>,
    pub(super) caustics: CausticsCache,
    pub(super) frame: FrameCache,
}

/// Data of a frame besides the mesh.
#[derive(Default)]
pub(in crate::method) struct FrameCache {
    looks: Memo<LooksKey, Arc<Looks>>,
    looks_buffer: Memo<LooksKey, Buffer>,
    materials: Memo<Vec<f32>, Buffer>,
    pub(in crate::method) pictures: UploadedPictures,
    pub(in crate::method) scratch: Scratch,
}

fn looks_key(scene: &Scene) -> LooksKey {
    let Material { ior, abbe, cauchy_b, .. } = Material::default();
    let without_index = |material: &Material| Material { ior, abbe, cauchy_b, ..material.clone() };
    (scene.material.iter().map(without_index).collect(), scene.shadow.optical_depth)
}

impl FrameCache {
    /// The surface attributes of the bodies.
    pub(in crate::method) fn looks(&mut self, scene: &Scene, mesh: &Mesh, uploaded: &UploadedMesh) -> Arc<Looks> {
        let make = || looks(&uploaded.bodies, uploaded.first_in_tree(), mesh, scene);
        Arc::clone(self.looks.of(looks_key(scene), || Arc::new(make())))
    }

    /// The surface attributes on the backend.
    ///
    /// # Errors
    /// As [`Backend::create`].
    pub(in crate::method) fn looks_buffer(
        &mut self,
        scene: &Scene,
        looks: &Looks,
        backend: &mut dyn Backend,
    ) -> Result<Buffer, BackendError> {
        let floats = Contents::Bytes(cast_slice(&looks.floats));
        self.looks_buffer.get(looks_key(scene), || backend.create("looks", floats)).cloned()
    }

    /// The records of materials on the backend.
    ///
    /// # Errors
    /// As [`Backend::create`].
    pub(in crate::method) fn materials(
        &mut self,
        materials: Vec<f32>,
        backend: &mut dyn Backend,
    ) -> Result<Buffer, BackendError> {
        let floats = materials.clone();
        self.materials.get(materials, || backend.create("materials", Contents::Bytes(cast_slice(&floats)))).cloned()
    }
}
