//! What a scene names, read.

use crate::builtin;
use crate::render::Error;
use crate::scene::{EnvironmentKind, Scene, VolumeSource};
use std::path::Path;
use vitrum_io::{OpenOptions, Picture, Volume};

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
            volume: load_volume(&scene.volume, base, "volume")?,
            ior_volume: scene.ior_volume.as_ref().map(|source| load_volume(source, base, "ior_volume")).transpose()?,
            environment,
        })
    }
}

fn load_volume(source: &VolumeSource, base: &Path, key: &str) -> Result<Volume, Error> {
    let mut volume = match (&source.file, &source.builtin) {
        (Some(file), None) => vitrum_io::open(&base.join(file), &OpenOptions::default())?,
        (None, Some(name)) => builtin::volume(name, source.resolution).ok_or_else(|| {
            Error::Scene(format!("{key}.builtin = \"{name}\" is not a built-in volume; `vitrum scenes` lists them"))
        })??,
        (Some(_), Some(_)) => {
            return Err(Error::Scene(format!("{key}.file and {key}.builtin are both given: keep one")));
        }
        (None, None) => {
            return Err(Error::Scene(format!("{key} names neither a file nor a builtin: give one of them")));
        }
    };
    if let Some(spacing) = source.spacing {
        volume.spacing = spacing;
    }
    Ok(volume)
}
