//! A scene composed of an input, the look of a preset and single keys, and the data that it shows.

mod command;
mod error;
mod input;
mod projection;
mod quality;
mod sides;

pub use command::shell_command;
pub use error::CompositionError;
pub use input::{Opened, is_scene_file, open, read_text};
pub use quality::Quality;
pub use sides::Side;

use crate::error::Error;
use crate::preset::Adjustments;
use crate::scene::{Framing, Problem, Scene, SceneError, Vector, VolumeSource};
use crate::{Assets, Subject, preset, shown};
use std::path::{Path, PathBuf};
use vitrum_io::transfer::read_transfer;
use vitrum_io::{Mesh, Volume};

/// Reads the data that a scene names; relative paths start at the folder.
type Load<'a> = dyn Fn(&Scene, &Path) -> Result<Assets, Error> + 'a;

/// Bounds of meshes whose size is not known yet.
const UNIT: [Vector; 2] = [[-1.0; 3], [1.0; 3]];

/// An input, and the changes to its scene. They are applied in the order of the fields.
#[derive(Debug, Clone, Default)]
pub struct Composition {
    /// A scene file (`.toml`), the file of a volume or of a mesh, a folder of DICOM files, `-` for a volume from standard input, or
    /// `builtin:NAME`.
    pub input: String,
    /// The name of a preset. If absent, a volume's file is shown by that which suits its contents ([`preset::choose`]), a mesh's file by its own materials, or as
    /// glass.
    pub preset: Option<String>,
    /// The name of a medium that meshes are put into, one of [`preset::medium_names`]. If absent the scene keeps its own, if any.
    pub medium: Option<String>,
    /// The quality of the picture. If absent, a scene's file has the rays that it says, and everything else is [`Quality::Good`].
    pub quality: Option<Quality>,
    /// A file of transfer functions of another program, which takes the place of the scene's; see [`crate::io::transfer`].
    pub transfer: Option<PathBuf>,
    /// Changes of the transfer function: window, threshold, map of colours, isosurfaces. Where these alone are asked for, and no preset, a volume's file shows
    /// nothing else.
    pub adjustments: Adjustments,
    /// Width and height of the film, in pixels.
    pub size: Option<[u32; 2]>,
    /// Options for reading the volume's file: `raw`, `spacing`, `array`, `time`, `up` and `mask` replace the scene's where they are set, `up`
    /// of meshes as well. The other fields are not used.
    pub source: VolumeSource,
    /// The side of the patient from which the camera looks, where the volume's file says how the patient lies.
    pub side: Option<Side>,
    /// Keys with values, such as `camera.azimuth=60`, as [`Scene::set`] takes them.
    pub settings: Vec<String>,
    /// The most bytes that a file may take in memory; without it the limit of [`crate::io::OpenOptions`].
    pub max_bytes: Option<u64>,
}

/// A scene that has passed [`Scene::validate`], and its data.
#[derive(Debug)]
pub struct Composed {
    /// The scene, with everything that the preset and the settings say.
    pub scene: Scene,
    /// The folder that relative paths in the scene start at.
    pub base: PathBuf,
    /// The data that the scene names.
    pub assets: Assets,
    /// Statements about what a preset or a file of transfer functions took for granted, for people to read.
    pub notes: Vec<String>,
}

impl Composition {
    /// Reads the scene and its files, and applies the changes.
    ///
    /// # Errors
    /// [`CompositionError`] where the input cannot be read, there is no such preset or medium, or the scene is not valid with a change. Names and
    /// values are checked before the volume is read.
    pub fn compose(&self) -> Result<Composed, CompositionError> {
        self.compose_with(&|scene, base| Assets::load_within(scene, base, self.max_bytes))
    }

    /// As [`Self::compose`], of a volume or a mesh in memory, shown as one of a file is. The input is a name for it, which the scene has for its file.
    ///
    /// # Errors
    /// As [`Self::compose`].
    pub fn compose_of(&self, subject: &Subject) -> Result<Composed, CompositionError> {
        let opened = Opened::of_memory(&self.input, subject);
        let load = |scene: &Scene, base: &Path| Assets::of_memory(subject, scene, base, self.max_bytes);
        self.compose_opened(opened, &load)
    }

    /// As [`Self::compose`], of data that has been read before: those of an earlier [`Composed`] of the same input.
    ///
    /// # Errors
    /// As [`Self::compose`].
    pub fn compose_again(&self, assets: &Assets) -> Result<Composed, CompositionError> {
        self.compose_with(&|_, _| Ok(assets.clone()))
    }

    fn compose_with(&self, load: &Load<'_>) -> Result<Composed, CompositionError> {
        self.compose_opened(open(&self.input)?, load)
    }

    fn compose_opened(&self, opened: Opened, load: &Load<'_>) -> Result<Composed, CompositionError> {
        let composed = self.compose_any_side(opened, load)?;
        self.side.map_or(Ok(()), |side| side.check(&composed.assets.subject))?;
        Ok(composed)
    }

    fn compose_any_side(&self, opened: Opened, load: &Load<'_>) -> Result<Composed, CompositionError> {
        let Opened { mut scene, base, bare } = opened;
        if bare && self.source.raw.is_some() {
            scene = input::without_mesh(scene);
        }
        if bare {
            scene.camera.framing = Framing::Visible;
        }
        if scene.shows_mesh() {
            if self.transfer.is_some() || !self.adjustments.is_empty() {
                return Err(CompositionError::NoTransferFunction { input: self.input.clone() });
            }
            return self.compose_mesh(scene, base, bare, load);
        }
        if let Some(name) = &self.medium {
            // It fails: without a mesh there is nothing to put into a medium.
            preset::put_into_medium(name, UNIT, &mut scene)?;
        }
        // Names first: a slip should not cost the time to read a volume.
        self.preset.as_deref().map_or(Ok(()), preset::check)?;
        self.adjustments.check()?;
        let file = self.transfer.as_deref().map(read_transfer).transpose().map_err(Error::from)?;
        let is_chosen = bare && file.is_none() && self.preset.is_none();
        let mut before = scene.clone();
        let adds = !self.adjustments.isosurfaces.is_empty();
        self.change(&mut before, is_chosen || self.preset.is_some() || file.is_some() || adds)?;
        let assets = load(&before, &base)?;
        let mut notes = Vec::new();
        let surfaces_alone = is_chosen && self.adjustments.are_isosurfaces();
        let choose = |volume: &Volume| {
            if surfaces_alone { preset::Choice::for_surfaces() } else { preset::choose(volume) }
        };
        let choice = assets.subject.volume().filter(|_| is_chosen).map(choose);
        let preset = self.preset.as_deref().or(choice.as_ref().map(|choice| choice.name));
        if let Some(volume) = assets.subject.volume() {
            let adjustments = &self.adjustments;
            match (&file, preset) {
                (Some(file), preset) => {
                    preset.map_or(Ok(Vec::new()), |name| {
                        preset::fit(name, volume, &Adjustments::default(), &mut scene)
                    })?;
                    let in_surroundings = bare && preset.is_none();
                    notes = preset::fit_file(file, volume, adjustments, in_surroundings, &mut scene)?;
                }
                (None, Some(name)) => notes = preset::fit(name, volume, adjustments, &mut scene)?,
                (None, None) => preset::adjust(volume, adjustments, &mut scene)?,
            }
            if surfaces_alone {
                preset::show_alone(&mut scene);
            }
            if let Some(preset::Choice { name, reason }) = choice {
                notes.push(format!("the preset `{name}` was chosen: {reason}; --preset takes another"));
            }
        }
        let of_file = (preset.is_none() && is_scene_file(Path::new(&self.input))).then(|| scene.clone());
        self.change(&mut scene, false)?;
        notes.extend(projection::left_out(&scene, of_file.as_ref(), &self.settings));
        notes.extend(shown::told_of_mask(&scene, &assets));
        Ok(Composed { scene, base, assets, notes })
    }

    /// The look of a mesh does not depend on the contents of its file.
    fn compose_mesh(
        &self,
        mut scene: Scene,
        base: PathBuf,
        bare: bool,
        load: &Load<'_>,
    ) -> Result<Composed, CompositionError> {
        match &self.preset {
            Some(name) => preset::apply_to_mesh(name, &mut scene)?,
            None if bare => preset::surround_mesh(&mut scene),
            None => {}
        }
        let Some(medium) = &self.medium else {
            self.change(&mut scene, false)?;
            let assets = load(&scene, &base)?;
            return Ok(Composed { scene, base, assets, notes: Vec::new() });
        };
        // The density of a medium depends on the size of the meshes, and their size on the settings.
        let mut before = scene.clone();
        preset::put_into_medium(medium, UNIT, &mut before)?;
        self.change(&mut before, false)?;
        let assets = load(&before, &base)?;
        preset::put_into_medium(medium, assets.subject.mesh().map_or(UNIT, Mesh::bounds), &mut scene)?;
        self.change(&mut scene, false)?;
        Ok(Composed { scene, base, assets, notes: Vec::new() })
    }

    /// Applies size, source and settings. If a preset is still to come, it may fill in a key that is missing now, such as the points of
    /// a transfer function.
    fn change(&self, scene: &mut Scene, preset_to_come: bool) -> Result<(), Error> {
        if let Some([width, height]) = self.size {
            scene.film.width = width;
            scene.film.height = height;
        }
        let quality = self.quality.or((!is_scene_file(Path::new(&self.input))).then_some(Quality::Good));
        if let Some(quality) = quality {
            quality.apply(&mut scene.film, scene.method);
        }
        self.change_source(scene);
        if let Some(side) = self.side {
            side.look(scene);
        }
        for assignment in &self.settings {
            match scene.set(assignment) {
                Err(error) if preset_to_come && is_missing(&error) => {}
                outcome => outcome?,
            }
        }
        Ok(scene.validate()?)
    }

    /// Applies the changes but the preset once more, to a scene that has got another look since.
    ///
    /// # Errors
    /// Where the scene is not valid with them.
    pub fn change_again(&self, scene: &mut Scene) -> Result<(), CompositionError> {
        Ok(self.change(scene, false)?)
    }

    fn change_source(&self, scene: &mut Scene) {
        let mut keys = self.source.clone();
        if scene.shows_mesh()
            && let Some(up) = keys.up.take()
        {
            scene.mesh.iter_mut().for_each(|mesh| mesh.up = Some(up.clone()));
        }
        scene.volume.read_as(keys);
    }
}

fn is_missing(error: &SceneError) -> bool {
    matches!(*error.problem, Problem::MissingKey { .. } | Problem::Contradiction { .. })
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::*;

    fn composed(preset: Option<&str>, settings: &[&str]) -> Result<Composed, CompositionError> {
        let composition = Composition {
            input: "builtin:ball".to_owned(),
            preset: preset.map(str::to_owned),
            size: Some([32, 24]),
            settings: settings.iter().map(|&setting| setting.to_owned()).collect(),
            ..Composition::default()
        };
        composition.compose()
    }

    #[test]
    fn settings_come_after_size_and_preset() -> Result<(), CompositionError> {
        let Composed { scene, .. } = composed(Some("haze"), &["volume.resolution=16", "film.width=48"])?;
        assert_eq!([scene.film.width, scene.film.height], [48, 24]);
        let Composed { scene: plain, .. } = composed(None, &["volume.resolution=16"])?;
        assert_eq!([plain.film.width, plain.film.height], [32, 24]);
        assert_ne!(scene.transfer, plain.transfer, "the preset has a look of its own");
        Ok(())
    }

    #[test]
    fn a_projection_tells_of_lights_that_were_asked_for() -> Result<(), CompositionError> {
        let notes = |preset, settings: &[&str]| composed(preset, settings).map(|composed| composed.notes);
        assert_eq!(notes(Some("mip"), &[])?, [""; 0]);
        assert_eq!(notes(Some("bone"), &["shading.blend_mode=mean"])?, [""; 0]);
        let told = notes(Some("mip"), &["light.0.azimuth=3", "ground.height=1", "camera.azimuth=3"])?;
        assert!(told.len() == 1 && told[0].ends_with("`light.0.azimuth`, `ground.height` are left out"), "{told:?}");
        assert_eq!(notes(None, &["light.0.azimuth=3"])?, [""; 0]);
        Ok(())
    }

    #[test]
    fn a_medium_is_fitted_to_meshes_and_settings_come_after_it() -> Result<(), CompositionError> {
        let composed = |input: &str, settings: &[&str]| {
            let composition = Composition {
                input: input.to_owned(),
                medium: Some("fog".to_owned()),
                settings: settings.iter().map(|&setting| setting.to_owned()).collect(),
                ..Composition::default()
            };
            composition.compose()
        };
        let scattering = |scene: &Scene| scene.medium.as_ref().map_or(0.0, |medium| medium.scattering[0]);
        let Composed { scene, .. } = composed("builtin:vase", &[])?;
        let Composed { scene: large, .. } = composed("builtin:vase", &["mesh.0.scale=10", "medium.anisotropy=0"])?;
        assert_eq!(
            (scene.method.as_str(), large.medium.as_ref().map(|medium| medium.anisotropy)),
            ("beams", Some(0.0))
        );
        assert!((scattering(&scene) / scattering(&large) - 10.0).abs() < 0.1, "{scene:?}");
        assert!(matches!(composed("builtin:ball", &[]), Err(CompositionError::Medium(_))));
        Ok(())
    }

    #[test]
    fn unknown_names_are_told_with_what_was_meant() {
        let error = open("builtin:bal").expect_err("there is no such scene");
        assert_eq!(error.advice().as_deref(), Some("did you mean `builtin:ball`?"));
        assert!(matches!(composed(Some("bune"), &[]), Err(CompositionError::Preset(_))));
        assert!(matches!(composed(None, &["camera.azimut=3"]), Err(CompositionError::Scene(Error::SceneFile(_)))));
    }
}
