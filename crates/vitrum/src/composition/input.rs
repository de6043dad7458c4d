//! The scene that an input stands for, before a preset and settings change it.

use super::CompositionError;
use crate::Subject;
use crate::assets::made;
use crate::io::{STANDARD_INPUT, is_mesh};
use crate::scene::{MeshSource, MethodName, Scene, VolumeSource};
use std::fs;
use std::path::{Path, PathBuf};

/// The scene of an input.
#[derive(Debug)]
pub struct Opened {
    /// The scene.
    pub scene: Scene,
    /// The folder that relative paths in the scene start at.
    pub base: PathBuf,
    /// Whether the input is the file of a volume or of a mesh, which says nothing about its look.
    pub bare: bool,
}

impl Opened {
    /// The scene of a volume or a mesh in memory: the scene of a file of that name.
    pub(super) fn of_memory(name: &str, subject: &Subject) -> Self {
        let scene = if subject.mesh().is_some() { of_mesh(name.into()) } else { of_volume(name.into()) };
        Self { scene, base: PathBuf::new(), bare: true }
    }

    /// The scene of a mesh's file as one of a volume's file; other scenes are not changed.
    #[must_use]
    pub fn as_volume(self) -> Self {
        Self { scene: without_mesh(self.scene), ..self }
    }
}

/// Whether a file is read as a scene, by its name.
#[must_use]
pub fn is_scene_file(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// Finds out which kind of input `input` is (see [`super::Composition::input`]). A scene file is read, a volume or a mesh is not yet.
///
/// # Errors
/// [`CompositionError`] for an unknown built-in scene, and for a scene file that cannot be read or is not valid.
pub fn open(input: &str) -> Result<Opened, CompositionError> {
    if let Some(name) = input.strip_prefix("builtin:") {
        let unknown = || CompositionError::UnknownBuiltin { name: name.to_owned() };
        let scene = made::scene(name).ok_or_else(unknown)?;
        return Ok(Opened { scene, base: PathBuf::new(), bare: false });
    }
    let path = Path::new(input);
    if is_scene_file(path) {
        let base = path.parent().unwrap_or(Path::new("")).to_owned();
        let scene = Scene::from_toml(&read_text(path, "scene")?, &path.display().to_string())?;
        return Ok(Opened { scene, base, bare: false });
    }
    // The reader of volumes has the message for a file that cannot be looked at.
    if path != Path::new(STANDARD_INPUT) && is_mesh(path).unwrap_or(false) {
        return Ok(Opened { scene: of_mesh(path.to_owned()), base: PathBuf::new(), bare: true });
    }
    Ok(Opened { scene: of_volume(path.to_owned()), base: PathBuf::new(), bare: true })
}

/// The scene of a mesh's file as a volume.
pub(super) fn without_mesh(scene: Scene) -> Scene {
    match scene.mesh.as_slice() {
        [MeshSource { file: Some(file), .. }] => of_volume(file.clone()),
        _ => scene,
    }
}

fn of_mesh(file: PathBuf) -> Scene {
    let mesh = vec![MeshSource { file: Some(file), ..MeshSource::default() }];
    Scene { method: MethodName::Voxels, mesh, ..Scene::default() }
}

fn of_volume(file: PathBuf) -> Scene {
    let volume = VolumeSource { file: Some(file), ..VolumeSource::default() };
    Scene { volume, ..Scene::default() }
}

/// Reads a text file of at most 16 MiB that should hold a `kind`, such as a scene.
///
/// # Errors
/// [`CompositionError::Text`] where the file cannot be read, is larger, or is not in UTF-8.
pub fn read_text(path: &Path, kind: &str) -> Result<String, CompositionError> {
    // Scenes are small; a large file by that name should not fill the memory.
    const MOST_BYTES: u64 = 16 << 20;
    let unreadable = |reason, advice| CompositionError::Text { file: path.to_owned(), reason, advice };
    let metadata =
        fs::metadata(path).map_err(|error| unreadable(format!("cannot be read: {error}"), "check the path"))?;
    let length = metadata.len();
    if length > MOST_BYTES {
        let reason = format!("{length} bytes are no {kind}, the limit is {MOST_BYTES}");
        return Err(unreadable(reason, "give a text file; volumes have other extensions"));
    }
    fs::read_to_string(path)
        .map_err(|error| unreadable(format!("cannot be read: {error}"), "give a text file in UTF-8"))
}
