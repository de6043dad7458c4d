//! The document: what is open in the window.

use crate::scene_history::SceneHistory;
use crate::transfer_editor::TransferEditor;
use crate::trouble::Trouble;
use crate::worker::Data;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use vitrum::composition::{Composed, Composition, CompositionError};
use vitrum::method::Bounds;
use vitrum::preset::Adjustments;
use vitrum::scene::{Environment, Framing, Light, Medium, Scene, VolumeSource};
use vitrum::{Assets, framed_all_round, preset};

/// What is open: a scene, its data, and what was done to it.
#[derive(Debug, Clone)]
pub struct Document {
    /// The input, as a person names it.
    pub input: String,
    /// The composition that the scene began with: the input, and the preset that it took since.
    pub composition: Composition,
    /// The scene as it is now. Its files are named independently of any folder.
    pub scene: Scene,
    /// The data.
    pub data: Data,
    /// The scene as it was opened.
    pub home: Scene,
    /// What can be undone.
    pub history: SceneHistory,
    /// The editor of its transfer functions, until the window takes it: it takes a while to count voxels.
    pub editor: TransferEditor,
    /// What was taken for granted, for people to read.
    pub notes: Vec<String>,
}

impl Document {
    /// Opens an input, with a picture of `size` pixels.
    ///
    /// # Errors
    /// Where the input cannot be read, or makes no picture.
    pub fn open(input: &str, size: Option<[u32; 2]>) -> Result<Self, Trouble> {
        let composition = Composition { input: from_anywhere(input), size, ..Composition::default() };
        let composed = composition.compose()?;
        Self::new(input, composition, composed)
    }

    /// The document of a scene that was saved by itself, with the name of its input.
    ///
    /// # Errors
    /// Where the scene is not valid, or its files cannot be read.
    pub fn restore(input: &str, text: &str) -> Result<Self, Trouble> {
        let scene = Scene::from_toml(text, "the saved session")?;
        let assets = Assets::load(&scene, Path::new(""))?;
        let composition = Composition { input: from_anywhere(input), ..Composition::default() };
        Self::new(input, composition, Composed { scene, base: PathBuf::new(), assets, notes: Vec::new() })
    }

    fn new(input: &str, composition: Composition, composed: Composed) -> Result<Self, Trouble> {
        let Composed { mut scene, base, assets, notes } = composed;
        scene.free_of(&base);
        vitrum::check(&scene, &assets)?;
        keep_distance(&mut scene, &assets)?;
        let data = Data { assets, number: next_number() };
        let editor = TransferEditor::new(&scene, &data.assets.subject);
        let input = input.to_owned();
        Ok(Self {
            editor,
            input,
            composition,
            home: scene.clone(),
            history: SceneHistory::new(&scene),
            scene,
            data,
            notes,
        })
    }

    /// The box around what is shown.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds::from(&self.data.assets.subject)
    }

    /// Gives the scene the look of a preset; the camera and the picture's size stay.
    ///
    /// # Errors
    /// Where the preset does not suit the data.
    pub fn take_preset(&mut self, name: &str) -> Result<Vec<String>, Trouble> {
        let (scene, notes) = with_preset(name, &self.scene, &self.data.assets)?;
        self.scene = scene;
        self.composition.preset = Some(name.to_owned());
        Ok(notes)
    }

    /// Fits the camera to what is visible now, from all sides.
    ///
    /// # Errors
    /// Where the memory for a volume that is smoothed first does not suffice.
    pub fn fit(&mut self) -> Result<(), Trouble> {
        let camera = &mut self.scene.camera;
        (camera.framing, camera.distance, camera.target, camera.zoom) = (Framing::Visible, None, None, 1.0);
        camera.position = None;
        keep_distance(&mut self.scene, &self.data.assets)
    }
}

/// The scene in the look of a preset, with the same camera and film, and what the preset took for granted.
///
/// # Errors
/// Where the preset does not suit the data.
pub fn with_preset(name: &str, scene: &Scene, assets: &Assets) -> Result<(Scene, Vec<String>), Trouble> {
    let mut changed = scene.clone();
    let notes = match assets.subject.volume() {
        Some(volume) => preset::fit(name, volume, &Adjustments::default(), &mut changed),
        None => preset::apply_to_mesh(name, &mut changed).map(|()| Vec::new()),
    };
    let notes = notes.map_err(CompositionError::from)?;
    let changed = Scene { camera: scene.camera.clone(), film: scene.film.clone(), ..changed };
    vitrum::check(&changed, assets)?;
    Ok((changed, notes))
}

/// Fixes a camera that is fitted to what is visible from its side at the distance that suits all sides: while it goes round, nothing should grow and shrink.
fn keep_distance(scene: &mut Scene, assets: &Assets) -> Result<(), Trouble> {
    let fits =
        scene.camera.framing == Framing::Visible && scene.camera.position.is_none() && scene.camera.distance.is_none();
    if fits {
        *scene = framed_all_round(scene, assets)?;
        scene.camera.framing = Framing::Whole;
    }
    Ok(())
}

/// An input that means the same in any folder.
fn from_anywhere(input: &str) -> String {
    let path = Path::new(input);
    let found = path.exists().then(|| std::path::absolute(path).ok()).flatten();
    found.map_or_else(|| input.to_owned(), |path| path.display().to_string())
}

/// A number that no data has had yet.
pub fn next_number() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// A scene of nothing but the data that `scene` names: where it changes, data is to be read anew.
#[must_use]
pub fn sources(scene: &Scene) -> Scene {
    let volume = |source: &VolumeSource| {
        let mut source = source.clone();
        source.interpolation = VolumeSource::default().interpolation;
        if let Some(mask) = &mut source.mask {
            mask.labels.clear();
            mask.hides = vitrum::scene::Hides::default();
        }
        source
    };
    let Environment { kind, file, .. } = &scene.environment;
    let density = scene.medium.as_ref().and_then(|medium| medium.density.as_ref()).map(volume);
    let texture =
        |light: &Light| light.texture.clone().map(|texture| Light { texture: Some(texture), ..Light::default() });
    Scene {
        volume: volume(&scene.volume),
        mesh: scene.mesh.clone(),
        ior_volume: scene.ior_volume.as_ref().map(volume),
        environment: Environment { kind: *kind, file: file.clone(), ..Environment::default() },
        light: scene.light.iter().filter_map(texture).collect(),
        medium: density.map(|density| Medium { density: Some(density), ..Medium::default() }),
        ..Scene::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_change_no_data_and_sources_do() {
        let mut scene = Scene::default();
        scene.volume.builtin = Some("ball".to_owned());
        let before = sources(&scene);
        scene.camera.azimuth = 99.0;
        scene.light.push(Light::default());
        scene.environment.intensity = 3.0;
        assert_eq!(sources(&scene), before);
        scene.volume.resolution = Some(32);
        assert_ne!(sources(&scene), before);
    }
}
