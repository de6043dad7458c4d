//! Presets: ready-made looks that are fitted to any volume or mesh.
//!
//! A preset of a volume sets its look — `transfer`, `light`, `shading`, `environment`, `ground` and `wall` — and leaves the subject and the
//! view of it alone: `volume`, `camera`, `clip`, `sweep` (but for the grid of the light) and `film`. It is fitted to the volume's own values
//! (`subject`), so that an 8-bit CT, a signed CT and a simulation between 0 and 1 each get thresholds of their own, and it states absorption
//! for a share of the volume's size, so that 64³ and 512³ voxels look alike. A preset of a mesh (`mesh`) sets the materials of the bodies
//! and their surroundings. A preset of media (`medium`) puts meshes into fog, smoke or water.

mod adjustments;
mod amber;
mod bone;
mod choice;
mod colormap;
mod glass;
mod gradients;
mod haze;
mod histogram;
mod hounsfield;
mod labels;
mod landmarks;
mod medium;
mod mesh;
mod mip;
mod noise;
mod plain;
mod points;
mod shape;
mod subject;
mod surfaces;
#[cfg(test)]
pub(crate) mod testing;
mod xray;

pub use adjustments::{Adjustments, adjust, fit, fit_file, transfer_file};
pub use choice::{Choice, choose};
pub(crate) use choice::{are_named_labels, holds_labels};
pub use colormap::names as colormap_names;
pub use gradients::{GradientMagnitudes, gradient_percentiles};
pub use landmarks::{Landmarks, landmarks, percentiles};
pub use medium::{MediumError, medium_names, put_into_medium};
pub use mesh::{apply_to_mesh, mesh_names, surround_mesh};
pub use noise::{Noise, noise};
pub use surfaces::Surface;
pub(crate) use surfaces::show_alone;

use crate::scene::{Scene, Sweep};
use crate::suggest::nearest;
use subject::Subject;
use vitrum_io::Volume;

struct Preset {
    name: &'static str,
    description: &'static str,
    apply: fn(&Subject, &mut Scene),
    /// Where it is for Hounsfield units: its points, which are not fitted.
    table: Option<&'static hounsfield::Table>,
    /// Whether it colours the parts of a segmentation, which are no measurements to be fitted to.
    of_labels: bool,
}

impl Preset {
    /// A preset that is fitted to the volume.
    const fn fitted(name: &'static str, description: &'static str, apply: fn(&Subject, &mut Scene)) -> Self {
        Self { name, description, apply, table: None, of_labels: false }
    }

    /// A preset over Hounsfield units.
    const fn of_units(
        name: &'static str,
        description: &'static str,
        apply: fn(&Subject, &mut Scene),
        table: &'static hounsfield::Table,
    ) -> Self {
        Self { name, description, apply, table: Some(table), of_labels: false }
    }
}

const PRESETS: [Preset; 13] = {
    let [ct_bone, ct_angio, ct_soft, ct_lung, mr_angio] = hounsfield::PRESETS;
    [
        plain::PRESET,
        bone::PRESET,
        amber::PRESET,
        glass::PRESET,
        xray::PRESET,
        mip::PRESET,
        haze::PRESET,
        labels::PRESET,
        ct_bone,
        ct_angio,
        ct_soft,
        ct_lung,
        mr_angio,
    ]
};

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
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
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
    /// A preset over Hounsfield units for other values.
    #[error("`{name}` is for CT in Hounsfield units, and the values go from {} to {}", range[0], range[1])]
    NotHounsfield {
        /// The name that was asked for.
        name: &'static str,
        /// The values' range without outliers.
        range: [f32; 2],
        /// The width and the level of the window in which the preset is usually looked at.
        window: [f32; 2],
    },
    /// The preset of labels for measurements.
    #[error(
        "`{name}` is for labels of parts, and the values are none: they are not whole numbers within 256 of one another"
    )]
    NoLabels {
        /// The name that was asked for.
        name: &'static str,
    },
    /// An unknown map of colours.
    #[error("there is no map of colours `{name}`")]
    UnknownColormap {
        /// The name that was asked for.
        name: String,
    },
    /// A threshold, a window or an isosurface that is none.
    #[error("{problem}")]
    Adjustment {
        /// What is wrong with it.
        problem: String,
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
            Self::NotHounsfield { name, window: [width, level], .. } => format!(
                "take a preset that is fitted to the values, such as `bone`, or say where the window of `{name}` lies: width {width}, \
                 level {level} in Hounsfield units, level {} where 1024 was added to them",
                level + 1024.0
            ),
            Self::NoLabels { .. } => "take a preset that is fitted to measurements, such as `plain`".to_owned(),
            Self::UnknownColormap { name } => match nearest(name, colormap_names().iter().map(|&(name, _)| name)) {
                Some(near) => format!("did you mean `{near}`?"),
                None => {
                    let known: Vec<&str> = colormap_names().iter().map(|&(name, _)| name).collect();
                    format!("the maps are: {}", known.join(", "))
                }
            },
            Self::Adjustment { .. } => "give finite numbers, a width above 0, and opacities from 0 to 1".to_owned(),
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
/// Those of [`check`], and [`PresetError::NotHounsfield`]; the scene is then unchanged.
pub fn apply(name: &str, volume: &Volume, scene: &mut Scene) -> Result<(), PresetError> {
    fit(name, volume, &Adjustments::default(), scene).map(drop)
}

/// The grid of light was made to the measure of a light that is replaced.
fn forget_light_grid(scene: &mut Scene) {
    let Sweep { light_resolution, light_margin, .. } = Sweep::default();
    (scene.sweep.light_resolution, scene.sweep.light_margin) = (light_resolution, light_margin);
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
