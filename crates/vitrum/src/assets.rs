//! The data that a scene names, read from files or made.

use crate::error::Error;
use crate::meshes::load_meshes;
use crate::scene::{EnvironmentKind, Scene, VolumeSource};
use crate::subject::Subject;
use std::path::Path;
use std::sync::Arc;
use vitrum_io::{OpenOptions, Picture, STANDARD_INPUT, Volume};

/// The data that a picture is made of. It is shared, not copied: a clone is the same data.
#[derive(Debug, Clone)]
pub struct Assets {
    /// The data that the picture shows.
    pub subject: Subject,
    /// The equirectangular picture of the environment, if the scene's environment is a map.
    pub environment: Option<Arc<Picture>>,
}

impl<S: Into<Subject>> From<S> for Assets {
    fn from(subject: S) -> Self {
        Self { subject: subject.into(), environment: None }
    }
}

impl Assets {
    /// Reads the files that `scene` names; relative paths start at `base`.
    ///
    /// # Errors
    /// [`Error::Io`] where a file cannot be read, [`Error::Scene`] where the scene names no data, or built-in data that does not exist.
    pub fn load(scene: &Scene, base: &Path) -> Result<Self, Error> {
        Self::load_within(scene, base, None)
    }

    /// As [`Self::load`], with at most `max_bytes` for each volume ([`OpenOptions::max_bytes`]).
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_within(scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<Self, Error> {
        let environment = match (scene.environment.kind, &scene.environment.file) {
            (EnvironmentKind::Map, Some(file)) => Some(Arc::new(vitrum_io::read_picture(&base.join(file))?)),
            (EnvironmentKind::Map, None) => {
                return Err(Error::Scene(
                    "environment.kind is \"map\" but environment.file is not given: name an equirectangular picture"
                        .to_owned(),
                ));
            }
            _ => None,
        };
        if !scene.mesh.is_empty() {
            return Ok(Self { subject: load_meshes(&scene.mesh, base, max_bytes)?.into(), environment });
        }
        let shown = Arc::new(load_volume(&scene.volume, base, max_bytes)?);
        let ior = scene.ior_volume.as_ref().map(|source| load_volume(source, base, max_bytes)).transpose()?;
        let subject = match ior {
            None => Subject::Volume(shown),
            Some(ior) => Subject::Volumes { shown, ior: Arc::new(ior) },
        };
        Ok(Self { subject, environment })
    }
}

/// Built-in data.
#[cfg(feature = "builtin")]
pub(crate) mod made {
    use crate::builtin;
    use crate::error::Error;
    use vitrum_io::{Mesh, Volume};

    pub(crate) fn mesh(name: &str) -> Result<Mesh, Error> {
        builtin::mesh(name).ok_or_else(|| {
            let names = builtin::mesh_names().collect::<Vec<_>>().join(", ");
            Error::Scene(format!("there is no built-in mesh `{name}`; they are {names}"))
        })
    }

    pub(super) fn volume(name: &str, resolution: Option<u32>) -> Result<Volume, Error> {
        let unknown =
            || Error::Scene(format!("there is no built-in volume `{name}`; `vitrum scenes` lists the built-in scenes"));
        Ok(builtin::volume(name, resolution).ok_or_else(unknown)??)
    }
}

/// The place of built-in data in a build without it.
#[cfg(not(feature = "builtin"))]
pub(crate) mod made {
    use crate::error::Error;
    use vitrum_io::{Mesh, Volume};

    pub(crate) fn mesh(name: &str) -> Result<Mesh, Error> {
        Err(left_out("mesh", name))
    }

    pub(super) fn volume(name: &str, _resolution: Option<u32>) -> Result<Volume, Error> {
        Err(left_out("volume", name))
    }

    fn left_out(kind: &str, name: &str) -> Error {
        Error::Scene(format!("the built-in {kind} `{name}` is not in this build (feature `builtin`); name a file"))
    }
}

/// Reads the one volume that `source` names; a relative path starts at `base`.
///
/// # Errors
///
/// Those of [`vitrum_io::open`]; where `source` would not pass [`Scene::validate`], or its built-in volume does not exist.
pub fn load_volume(source: &VolumeSource, base: &Path, max_bytes: Option<u64>) -> Result<Volume, Error> {
    let options = options(source, max_bytes)?;
    match (&source.file, &source.builtin) {
        (Some(file), None) if file == Path::new(STANDARD_INPUT) => Ok(vitrum_io::open(file, &options)?),
        (Some(file), None) => Ok(vitrum_io::open(&base.join(file), &options)?),
        (None, Some(name)) => Ok(options.place(made::volume(name, source.resolution)?)?),
        (Some(_), Some(_)) => Err(Error::Scene("a volume has both a file and a builtin; keep one".to_owned())),
        (None, None) => Err(Error::Scene("a volume has neither a file nor a builtin; give one of them".to_owned())),
    }
}

fn options(source: &VolumeSource, max_bytes: Option<u64>) -> Result<OpenOptions, Error> {
    Ok(OpenOptions {
        max_bytes,
        raw: source.raw.as_deref().map(str::parse).transpose().map_err(Error::Scene)?,
        spacing: source.spacing,
        array: source.array.clone(),
        time: source.time,
        up: source.up.as_deref().map(str::parse).transpose().map_err(Error::Scene)?,
    })
}
