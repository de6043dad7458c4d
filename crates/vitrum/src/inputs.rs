//! What a scene names, read.

use crate::builtin;
use crate::error::Error;
use crate::meshes::load_meshes;
use crate::scene::{EnvironmentKind, Scene, VolumeSource};
use std::path::Path;
use vitrum_io::{Mesh, OpenOptions, Picture, STANDARD_INPUT, Volume, Voxels};

/// The volumes and pictures a scene names.
#[derive(Debug, Clone)]
pub struct Inputs {
    /// The volume that is shown; of a mesh its bounds, as a single voxel.
    pub volume: Volume,
    /// The mesh that is shown instead.
    pub mesh: Option<Mesh>,
    /// The volume that gives η, if it is another one.
    pub ior_volume: Option<Volume>,
    /// The environment map.
    pub environment: Option<Picture>,
}

impl Inputs {
    /// Reads what `scene` names; relative paths start at `base`.
    ///
    /// # Errors
    /// [`Error::Io`] where a file cannot be read, [`Error::Scene`] where the scene names nothing, or something built in that is not there.
    pub fn load(scene: &Scene, base: &Path) -> Result<Self, Error> {
        Self::load_within(scene, base, None)
    }

    /// As [`Self::load`], with at most `max_bytes` for each volume ([`OpenOptions::max_bytes`]).
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_within(scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<Self, Error> {
        let environment = match (scene.environment.kind, &scene.environment.file) {
            (EnvironmentKind::Map, Some(file)) => Some(vitrum_io::read_picture(&base.join(file))?),
            (EnvironmentKind::Map, None) => {
                return Err(Error::Scene(
                    "environment.kind is \"map\" but environment.file is not given: name an equirectangular picture"
                        .to_owned(),
                ));
            }
            _ => None,
        };
        if !scene.mesh.is_empty() {
            return Ok(Self { environment, ..Self::of_mesh(load_meshes(&scene.mesh, base, max_bytes)?)? });
        }
        Ok(Self {
            mesh: None,
            volume: load_volume(&scene.volume, base, max_bytes)?,
            ior_volume: scene.ior_volume.as_ref().map(|source| load_volume(source, base, max_bytes)).transpose()?,
            environment,
        })
    }
}

impl Inputs {
    /// A mesh alone.
    ///
    /// # Errors
    /// None that meshes cause which can be read.
    pub fn of_mesh(mesh: Mesh) -> Result<Self, Error> {
        let [low, high] = mesh.bounds();
        let extent: [f32; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
        let longest = extent.into_iter().fold(f32::MIN_POSITIVE, f32::max);
        // What is flat has a side all the same.
        let edges = extent.map(|extent| extent.max(longest * 1e-6));
        let mut volume = Volume::new(mesh.name.clone(), [1; 3], edges, Voxels::U8(vec![0].into()))?;
        volume.origin = std::array::from_fn(|axis| 0.5 * (low[axis] + high[axis]));
        Ok(Self { volume, mesh: Some(mesh), ior_volume: None, environment: None })
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
        (None, Some(name)) => {
            let volume = builtin::volume(name, source.resolution).ok_or_else(|| {
                Error::Scene(format!("there is no built-in volume `{name}`; `vitrum scenes` lists the built-in scenes"))
            })??;
            Ok(options.place(volume)?)
        }
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
