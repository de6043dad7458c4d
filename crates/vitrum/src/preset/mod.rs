//! Presets: ready-made looks that are fitted to any volume or mesh.
//!
//! A preset of a volume sets its look — `transfer`, `light`, `shading`, `environment`, `ground` and `wall` — and leaves the subject and the
//! view of it alone: `volume`, `camera`, `clip`, `sweep` (but for the grid of the light) and `film`. It is fitted to the volume's own values
//! (`subject`), so that an 8-bit CT, a signed CT and a simulation between 0 and 1 each get thresholds of their own, and it states absorption
//! for a share of the volume's size, so that 64³ and 512³ voxels look alike. A preset of a mesh (`mesh`) sets the materials of the bodies
//! and their surroundings. A preset of media (`medium`) puts meshes into fog, smoke or water.

mod amber;
mod bone;
mod glass;
mod haze;
mod histogram;
mod medium;
mod mesh;
mod plain;
mod shape;
mod subject;
mod xray;

pub use medium::{MediumError, medium_names, put_into_medium};
pub use mesh::{apply_to_mesh, mesh_names, surround_mesh};

use crate::scene::{Scene, Sweep};
use crate::suggest::nearest;
use subject::Subject;
use vitrum_io::Volume;

/// The preset of a volume for which no preset is named. Of all presets, `amber` shows most of the contents of an unknown volume at
/// first sight: the outer shape by refraction and colour, dense parts inside by opacity, and their places by shadow. The other presets
/// show one of these alone.
pub const DEFAULT: &str = "amber";

struct Preset {
    name: &'static str,
    description: &'static str,
    apply: fn(&Subject, &mut Scene),
}

const PRESETS: [Preset; 6] = [plain::PRESET, bone::PRESET, amber::PRESET, glass::PRESET, xray::PRESET, haze::PRESET];

const NAMES: [(&str, &str); PRESETS.len()] = {
    let mut names = [("", ""); PRESETS.len()];
    let mut index = 0;
    while index < names.len() {
        names[index] = (PRESETS[index].name, PRESETS[index].description);
        index += 1;
    }
    names
};

/// Why a preset was not applied.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PresetError {
    /// An unknown name.
    #[error("there is no preset `{name}`")]
    Unknown {
        /// The name that was asked for.
        name: String,
        /// The name that was most likely meant.
        nearest: Option<&'static str>,
        /// The names of all presets.
        known: Vec<&'static str>,
    },
    /// The preset of a volume for a mesh, or the preset of a mesh for a volume.
    #[error("`{name}` is a preset of {kind}, and none of {shown}")]
    OtherKind {
        /// The name that was asked for.
        name: String,
        /// The kind of data that the preset is for: `meshes` or `volumes`.
        kind: &'static str,
        /// The kind of data that the scene shows.
        shown: &'static str,
        /// The names of all presets for that kind.
        known: Vec<&'static str>,
    },
}

impl PresetError {
    /// Advice: a sentence that says how to mend it.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::Unknown { nearest: Some(nearest), .. } => format!("did you mean `{nearest}`?"),
            Self::Unknown { nearest: None, known, .. } => format!("the presets are: {}", known.join(", ")),
            Self::OtherKind { shown, known, .. } => format!("the presets of {shown} are: {}", known.join(", ")),
        }
    }
}

/// Name and description of every preset.
#[must_use]
pub fn names() -> &'static [(&'static str, &'static str)] {
    &NAMES
}

/// Whether there is a preset of this name; worth asking before reading a volume.
///
/// # Errors
///
/// [`PresetError::Unknown`], and [`PresetError::OtherKind`] of a preset of meshes.
pub fn check(name: &str) -> Result<(), PresetError> {
    find(name).map(drop)
}

/// Gives `scene` the look of the preset `name`, fitted to the values of `volume`.
///
/// # Errors
///
/// Those of [`check`]; the scene is then unchanged.
pub fn apply(name: &str, volume: &Volume, scene: &mut Scene) -> Result<(), PresetError> {
    (find(name)?.apply)(&Subject::of(volume), scene);
    // The grid of light was made to the measure of the light that is replaced.
    let Sweep { light_resolution, light_margin, .. } = Sweep::default();
    (scene.sweep.light_resolution, scene.sweep.light_margin) = (light_resolution, light_margin);
    Ok(())
}

fn find(name: &str) -> Result<&'static Preset, PresetError> {
    PRESETS.iter().find(|preset| preset.name == name).ok_or_else(|| not_found(name, VOLUMES, MESHES))
}

/// A kind of data, and the presets for it by name and description.
type Kind = (&'static str, &'static [(&'static str, &'static str)]);

const VOLUMES: Kind = ("volumes", &NAMES);
const MESHES: Kind = ("meshes", mesh::NAMES);

/// The error that names why the data that is `shown` has no preset `name`.
fn not_found(name: &str, (shown, names): Kind, (kind, others): Kind) -> PresetError {
    let (name, known) = (name.to_owned(), names.iter().map(|&(name, _)| name).collect());
    if others.iter().any(|(other, _)| *other == name) {
        return PresetError::OtherKind { name, kind, shown, known };
    }
    PresetError::Unknown { nearest: nearest(&name, names.iter().map(|&(name, _)| name)), name, known }
}
