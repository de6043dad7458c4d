//! The pictures that kernels read: the environment's, and behind it those that spots project.

use super::environment::EnvironmentMap;
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use crate::method::cache::Memo;
use crate::scene::{EnvironmentKind, Scene};
use crate::unrenderable::Unrenderable;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrum_io::Picture;

/// Pictures by the paths that the scene gives them.
type Textures = BTreeMap<PathBuf, Arc<Picture>>;

/// The place of a picture among the floats of all.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::method) struct Placed {
    /// The number of its first float.
    pub(in crate::method) first: u32,
    /// Texels across.
    pub(in crate::method) width: u32,
    /// Texels down.
    pub(in crate::method) height: u32,
}

/// The pictures of a frame, on the host and on the backend.
#[derive(Clone)]
pub(in crate::method) struct Pictures {
    pub(in crate::method) environment: Arc<EnvironmentMap>,
    textures: Arc<BTreeMap<PathBuf, Placed>>,
    /// RGB floats of all.
    pub(in crate::method) buffer: Buffer,
}

impl Pictures {
    /// The place of the picture that a light names.
    pub(in crate::method) fn texture(&self, path: &Path) -> Option<Placed> {
        self.textures.get(path).copied()
    }

    /// Uploads the picture of the environment and those that spots project.
    fn new(
        scene: &Scene,
        environment: Option<&Picture>,
        projected: &Textures,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let mut environment = EnvironmentMap::new(&scene.environment, environment);
        let own = environment.texels.len();
        let mut floats = own as u64;
        let mut textures = BTreeMap::new();
        for (path, picture) in projected {
            let (width, height) = (picture.width, picture.height);
            textures.insert(path.clone(), Placed { first: floats as u32, width, height });
            floats += 3 * u64::from(width) * u64::from(height);
            // Kernels count floats by a signed number.
            if floats > i32::MAX as u64 {
                return Err(Unrenderable::PicturesTooLarge { path: path.clone(), texels: floats / 3 }.into());
            }
        }
        // For a moment the environment's floats have the others' behind them.
        environment.texels.extend(projected.values().flat_map(|picture| picture.color()).flatten());
        let buffer = backend.create("pictures", Contents::Bytes(bytemuck::cast_slice(&environment.texels)))?;
        environment.texels.truncate(own);
        Ok(Self { environment: Arc::new(environment), textures: Arc::new(textures), buffer })
    }
}

/// The pictures of the last frame.
#[derive(Default)]
pub(in crate::method) struct UploadedPictures(Memo<bool, Pictures>);

impl UploadedPictures {
    /// The pictures of a scene; `environment` is the one of its environment, `textures` are those of its spots.
    ///
    /// # Errors
    /// As [`Backend::create`]; [`Unrenderable::PicturesTooLarge`].
    pub(in crate::method) fn get(
        &mut self,
        scene: &Scene,
        environment: Option<&Picture>,
        textures: &Textures,
        backend: &mut dyn Backend,
    ) -> Result<Pictures, Error> {
        let is_map = scene.environment.kind == EnvironmentKind::Map;
        self.0.get(is_map, || Pictures::new(scene, environment, textures, backend)).cloned()
    }
}
