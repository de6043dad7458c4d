//! What a scene names, read.

use crate::builtin;
use crate::render::Error;
use crate::scene::{EnvironmentKind, Scene, VolumeSource};
use std::path::Path;
use vitrum_io::{OpenOptions, Picture, STANDARD_INPUT, Volume};

/// The volumes and pictures a scene names.
#[derive(Debug, Clone)]
pub struct Inputs {
    /// The volume that is shown.
    pub volume: Volume,
    /// The volume that gives η, if it is another one.
    pub ior_volume: Option<Volume>,
    /// The environment map.
    pub environment: Option<Picture>,
}

impl Inputs {
    /// Reads what `scene` names; relative paths start at `base`.
    pub fn load(scene: &Scene, base: &Path) -> Result<Self, Error> {
        Self::load_within(scene, base, None)
    }

    /// As [`Self::load`], with at most `max_bytes` for each volume ([`OpenOptions::max_bytes`]).
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
        Ok(Self {
            volume: load_volume(&scene.volume, base, max_bytes)?,
            ior_volume: scene.ior_volume.as_ref().map(|source| load_volume(source, base, max_bytes)).transpose()?,
            environment,
        })
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
