//! The data that a scene names, read from files or made.

use crate::error::Error;
use crate::meshes::{arrange, load_meshes};
use crate::scene::{EnvironmentKind, Mask, MeshSource, Scene, VolumeSource};
use crate::subject::Subject;
use crate::unrenderable::Unrenderable;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrum_io::{Mesh, OpenOptions, Picture, STANDARD_INPUT, Volume};

/// The data that a picture is made of. It is shared, not copied: a clone is the same data.
#[derive(Debug, Clone)]
pub struct Assets {
    /// The data that the picture shows.
    pub subject: Subject,
    /// The equirectangular picture of the environment, if the scene's environment is a map.
    pub environment: Option<Arc<Picture>>,
    /// The pictures that spots project, by the paths that the scene gives them (`light.N.texture`).
    pub textures: BTreeMap<PathBuf, Arc<Picture>>,
    /// The volume of the medium's density, if the scene has one (`medium.density`).
    pub density: Option<Arc<Volume>>,
    /// The segmentation by which parts of the volume are hidden, if the scene has one (`volume.mask`).
    pub mask: Option<Arc<Volume>>,
    /// The mesh of the bodies within the volume, if the scene has a volume and meshes ([`Scene::has_bodies`]).
    pub bodies: Option<Arc<Mesh>>,
}

impl<S: Into<Subject>> From<S> for Assets {
    fn from(subject: S) -> Self {
        Self {
            subject: subject.into(),
            environment: None,
            textures: BTreeMap::new(),
            density: None,
            mask: None,
            bodies: None,
        }
    }
}

impl Assets {
    /// Reads the files that `scene` names; relative paths start at `base`.
    ///
    /// # Errors
    /// [`Error::Io`] where a file cannot be read, [`Error::Unrenderable`] where the scene names no data, or built-in data that does not exist.
    pub fn load(scene: &Scene, base: &Path) -> Result<Self, Error> {
        Self::load_within(scene, base, None)
    }

    /// As [`Self::load`], with at most `max_bytes` for each volume ([`OpenOptions::max_bytes`]).
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_within(scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<Self, Error> {
        let others = Self::beside(scene, base, max_bytes)?;
        if scene.shows_mesh() {
            return Ok(others(load_meshes(&scene.mesh, base, max_bytes)?.into()));
        }
        let bodies = load_bodies(scene, base, max_bytes)?;
        let shown = Arc::new(load_volume(&scene.volume, base, max_bytes)?);
        let ior = load_ior(scene, base, max_bytes)?;
        let mask = scene.volume.mask.as_ref().map(|mask| load_mask(mask, &scene.volume, base, max_bytes));
        let mask = mask.transpose()?.map(Arc::new);
        Ok(Self { mask, bodies, ..others(volumes(shown, ior)) })
    }

    /// Puts `mesh` in the place of the mesh: of the bodies within the volume, if there are any, else of the subject.
    pub fn set_mesh(&mut self, mesh: Arc<Mesh>) {
        if self.bodies.is_some() {
            self.bodies = Some(mesh);
        } else {
            self.subject = Subject::Mesh(mesh);
        }
    }

    /// A volume or a mesh from memory, which takes the place of the one that `scene` names first, and the other files that the scene names. The keys of
    /// `volume` and `mesh.0` that turn, scale or place are applied to it.
    ///
    /// # Errors
    /// As [`Self::load`]; [`Error::Unrenderable`] where the scene shows a mesh and the data is a volume or the other way round, shows more than one mesh, or
    /// picks a part of a file.
    pub fn of_memory(subject: &Subject, scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<Self, Error> {
        let VolumeSource { raw, array, time, seconds, .. } = &scene.volume;
        if raw.is_some() || array.is_some() || time.is_some() || seconds.is_some() {
            let keys = "`volume.raw`, `volume.array`, `volume.time` and `volume.seconds`";
            return Err(syntax(format!("{keys} pick a part of a file, and the volume is in memory")));
        }
        let others = Self::beside(scene, base, max_bytes)?;
        match (subject, scene.mesh.as_slice()) {
            (Subject::Mesh(mesh), [source]) => {
                let as_it_is = MeshSource { file: source.file.clone(), builtin: None, ..MeshSource::default() };
                let stays = *source == as_it_is;
                let mesh = if stays { Arc::clone(mesh) } else { Arc::new(arrange(Mesh::clone(mesh), source)?) };
                Ok(others(Subject::Mesh(mesh)))
            }
            (Subject::Mesh(_), []) => Err(Unrenderable::NeedsVolume.into()),
            (Subject::Mesh(_), [_, ..]) => Err(syntax("one mesh is in memory, and the scene shows several".to_owned())),
            (Subject::Volume(_) | Subject::Volumes { .. }, [_, ..]) if !scene.has_bodies() => {
                Err(Unrenderable::NeedsMesh { method: scene.method.as_str() }.into())
            }
            (Subject::Volume(shown) | Subject::Volumes { shown, .. }, _) => {
                let bodies = load_bodies(scene, base, max_bytes)?;
                let options = options(&scene.volume, max_bytes)?;
                let stays = options.spacing.is_none() && options.up.is_none();
                let place = || Ok::<_, Error>(Arc::new(options.place(Volume::clone(shown))?));
                let shown = if stays { Arc::clone(shown) } else { place()? };
                let ior = match subject {
                    Subject::Volumes { ior, .. } => Some(Arc::clone(ior)),
                    _ => load_ior(scene, base, max_bytes)?,
                };
                let mask = scene.volume.mask.as_ref().map(|mask| load_mask(mask, &scene.volume, base, max_bytes));
                let mask = mask.transpose()?.map(Arc::new);
                Ok(Self { mask, bodies, ..others(volumes(shown, ior)) })
            }
        }
    }

    /// The pictures and the density that a scene names, still without a subject.
    fn beside(scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<impl FnOnce(Subject) -> Self, Error> {
        let environment = match (scene.environment.kind, &scene.environment.file) {
            (EnvironmentKind::Map, Some(file)) => Some(Arc::new(vitrum_io::read_picture(&base.join(file))?)),
            (EnvironmentKind::Map, None) => {
                return Err(Unrenderable::NoEnvironmentMap.into());
            }
            _ => None,
        };
        let read = |path: &PathBuf| Ok((path.clone(), Arc::new(vitrum_io::read_picture(&base.join(path))?)));
        let named = scene.light.iter().filter_map(|light| light.texture.as_ref()).collect::<BTreeSet<_>>();
        let textures = named.into_iter().map(read).collect::<Result<_, Error>>()?;
        let density = scene.medium.as_ref().and_then(|medium| medium.density.as_ref());
        let density = density.map(|source| {
            let density = load_volume(source, base, max_bytes)?;
            density.require_whole("a medium's density")?;
            Ok::<_, Error>(Arc::new(density))
        });
        let density = density.transpose()?;
        Ok(move |subject| Self { subject, environment, textures, density, mask: None, bodies: None })
    }
}

/// One volume, or two.
fn volumes(shown: Arc<Volume>, ior: Option<Arc<Volume>>) -> Subject {
    match ior {
        None => Subject::Volume(shown),
        Some(ior) => Subject::Volumes { shown, ior },
    }
}

/// Reads the meshes of the bodies within a scene's volume, where it has any.
fn load_bodies(scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<Option<Arc<Mesh>>, Error> {
    scene.has_bodies().then(|| load_meshes(&scene.mesh, base, max_bytes).map(Arc::new)).transpose()
}

/// Reads the volume whose scalar gives the index of refraction, where a scene names one.
fn load_ior(scene: &Scene, base: &Path, max_bytes: Option<u64>) -> Result<Option<Arc<Volume>>, Error> {
    let ior = scene.ior_volume.as_ref().map(|source| load_volume(source, base, max_bytes)).transpose()?;
    Ok(ior.map(Arc::new))
}

/// Built-in data.
#[cfg(feature = "builtin")]
pub(crate) mod made {
    use crate::builtin;
    use crate::error::Error;
    use crate::scene::Scene;
    use crate::unrenderable::Unrenderable;
    use vitrum_io::{Mesh, Volume};

    pub(crate) fn scene(name: &str) -> Option<Scene> {
        builtin::scene(name)
    }

    pub(crate) fn scene_names() -> impl Iterator<Item = &'static str> {
        builtin::names().iter().map(|&(name, _)| name)
    }

    fn mesh(name: &str) -> Result<Mesh, Error> {
        let known = || builtin::mesh_names().collect();
        let unknown = || Unrenderable::UnknownBuiltin { kind: "mesh", name: name.to_owned(), known: known() };
        Ok(builtin::mesh(name).ok_or_else(unknown)?)
    }

    /// As [`mesh`], at a moment of `seconds`, where the mesh's unit is `metres` long; one that does not move is as always.
    pub(crate) fn mesh_at(name: &str, seconds: f64, metres: f64) -> Result<Mesh, Error> {
        builtin::moving_mesh(name, seconds, metres).map_or_else(|| mesh(name), Ok)
    }

    pub(crate) fn moving_meshes() -> impl Iterator<Item = &'static str> {
        builtin::moving_mesh_names()
    }

    /// Whether a mesh moves, as far as is known: what there is no mesh of that name is for its loader to say.
    pub(crate) fn may_move(name: &str) -> bool {
        moving_meshes().any(|moving| moving == name) || builtin::mesh_names().all(|known| known != name)
    }

    pub(super) fn volume(name: &str, resolution: Option<u32>) -> Result<Volume, Error> {
        let known = || builtin::volume_names().collect();
        let unknown = || Unrenderable::UnknownBuiltin { kind: "volume", name: name.to_owned(), known: known() };
        Ok(builtin::volume(name, resolution).ok_or_else(unknown)??)
    }
}

/// The place of built-in data in a build without it.
#[cfg(not(feature = "builtin"))]
pub(crate) mod made {
    use crate::error::Error;
    use crate::scene::Scene;
    use crate::unrenderable::Unrenderable;
    use vitrum_io::{Mesh, Volume};

    pub(crate) fn scene(_name: &str) -> Option<Scene> {
        None
    }

    pub(crate) fn scene_names() -> impl Iterator<Item = &'static str> {
        std::iter::empty()
    }

    pub(crate) fn mesh_at(name: &str, _seconds: f64, _metres: f64) -> Result<Mesh, Error> {
        Err(left_out("mesh", name))
    }

    pub(crate) fn moving_meshes() -> impl Iterator<Item = &'static str> {
        std::iter::empty()
    }

    pub(crate) fn may_move(_name: &str) -> bool {
        true
    }

    pub(super) fn volume(name: &str, _resolution: Option<u32>) -> Result<Volume, Error> {
        Err(left_out("volume", name))
    }

    fn left_out(kind: &'static str, name: &str) -> Error {
        Unrenderable::BuiltinLeftOut { kind, name: name.to_owned() }.into()
    }
}

pub(crate) fn syntax(problem: String) -> Error {
    Unrenderable::Syntax { problem }.into()
}

/// Reads the volume that `source` names; a relative path starts at `base`.
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
        (Some(_), Some(_)) => Err(Unrenderable::TwoSources { kind: "volume" }.into()),
        (None, None) => Err(Unrenderable::NoSource { kind: "volume" }.into()),
    }
}

/// Reads the mask of the volume that `source` names, turned and scaled as that is.
fn load_mask(mask: &Mask, source: &VolumeSource, base: &Path, max_bytes: Option<u64>) -> Result<Volume, Error> {
    let VolumeSource { spacing, up, .. } = source.clone();
    let of_mask = VolumeSource { file: Some(mask.file.clone()), spacing, up, ..VolumeSource::default() };
    let mask = load_volume(&of_mask, base, max_bytes)?;
    mask.require_whole("a mask")?;
    Ok(mask)
}

fn options(source: &VolumeSource, max_bytes: Option<u64>) -> Result<OpenOptions, Error> {
    Ok(OpenOptions {
        max_bytes,
        paged: false,
        raw: source.raw.as_deref().map(str::parse).transpose().map_err(syntax)?,
        spacing: source.spacing,
        array: source.array.clone(),
        time: source.time,
        seconds: source.seconds,
        up: source.up.as_deref().map(str::parse).transpose().map_err(syntax)?,
    })
}
