//! The scene: everything a picture depends on, and nothing else.
//!
//! A [`Scene`] is plain data. It is read from TOML ([`Scene::from_toml`]), every key has a default, unknown keys are
//! errors, and `docs/scene.md` documents each key. Lengths are world units (the volume's spacing gives them), angles are
//! degrees, colours are linear RGB.

mod annotated;
mod annotation;
mod beams;
mod camera;
mod check;
mod clip;
mod colors;
mod crop;
mod dispersion;
mod environment;
mod error;
mod files;
mod film;
mod form;
mod gradient;
mod isosurface;
mod key_frames;
mod keys;
mod light;
mod lines;
mod load;
mod mask;
mod material;
mod medium;
mod mesh;
mod method;
mod motion;
mod paint;
pub(crate) mod piecewise;
mod receiver;
mod renamed;
mod schema;
mod set;
mod settings;
mod shading;
mod shadow;
mod surroundings;
mod sweep;
mod transfer;
mod validate;
mod volume;
mod voxelization;
mod voxels;
mod write;

pub use annotation::{Anchor, Annotation, AnnotationKind, OrientationStyle};
pub use beams::{Beams, Estimator, Tracer};
pub use camera::{Camera, Framing, Projection};
pub use clip::{Clip, Removes};
pub use colors::linear as parse_color;
pub use crop::Crop;
pub use dispersion::YELLOW;
pub use environment::{Environment, EnvironmentKind};
pub use error::{Origin, Problem, SceneError};
pub use film::Film;
pub use form::{Bounds, Control, Field, field, form};
pub use gradient::{GradientFunction, GradientPoint};
pub use isosurface::Isosurface;
pub use key_frames::KeyFrames;
pub use keys::{KeyDescription, describe_keys};
pub use light::{Attachment, Light, LightKind};
pub use mask::{Hides, Mask};
pub use material::Material;
pub use medium::{Medium, Phase};
pub use mesh::MeshSource;
pub use method::{Capabilities, MethodName};
pub use motion::Motion;
pub use paint::{Background, Paint};
pub use receiver::{Ground, Wall};
pub use shading::{BlendMode, Diffuse, Shading};
pub use shadow::{Coefficient, Shadow};
pub use surroundings::Surroundings;
pub use sweep::{Gradient, Integrator, Intensity, Sweep, Transport};
pub use transfer::{ColorPoint, IorPoint, OpacityPoint, TransferFunction};
pub use volume::{Interpolation, VolumeSource};
pub use voxelization::Voxelization;
pub use voxels::{Normals, Surfaces, Voxels};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Linear RGB, each component 0 or more: a reflectance or a transmittance up to 1, a radiance up to 1e6.
pub type Rgb = [f32; 3];

/// A vector in world units.
pub type Vector = [f32; 3];

/// The description of a picture: all values that the picture depends on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Scene {
    /// Method that makes the picture.
    pub method: MethodName,
    /// Background of the picture in place of the environment, which still lights and reflects: `white`, `transparent`, another colour by its name, or
    /// `#rrggbb` as on the screen. The environment is seen, or what `environment.visible` says, if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a colour or `transparent`"))]
    pub background: Option<String>,
    /// The volume that is shown.
    pub volume: VolumeSource,
    /// The meshes that are shown, instead of a volume, or within one that the scene names, too (method `sweep`).
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 64))]
    pub mesh: Vec<MeshSource>,
    /// A second volume whose scalar gives the index of refraction instead (sweep, Figs. 11e and 12e).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ior_volume: Option<VolumeSource>,
    /// Position, direction and projection of the camera.
    pub camera: Camera,
    /// The light sources; one distant light if the key is absent, none if the list is empty.
    #[schemars(length(max = 16))]
    pub light: Vec<Light>,
    /// Colour, opacity, index of refraction and filter over the scalar.
    pub transfer: TransferFunction,
    /// Surfaces where the volume's scalar has a value, beside what `transfer` shows.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 8))]
    pub isosurface: Vec<Isosurface>,
    /// Materials of the mesh's bodies; a body without an entry keeps the mesh's own material, or is glass. Without
    /// any entry bodies within a volume are opaque.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 64))]
    pub material: Vec<Material>,
    /// Voxelization of a mesh.
    pub voxelization: Voxelization,
    /// Rays through a mesh.
    pub voxels: Voxels,
    /// Beams of light in a medium.
    pub beams: Beams,
    /// The shadow that a mesh casts.
    pub shadow: Shadow,
    /// Transport of light and viewing rays from plane to plane.
    pub sweep: Sweep,
    /// Specular reflection and ambient light.
    pub shading: Shading,
    /// Radiance behind everything, by direction.
    pub environment: Environment,
    /// The clear matter around what is shown.
    pub surroundings: Surroundings,
    /// A participating medium.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub medium: Option<Medium>,
    /// A horizontal, diffuse plane that shows shadow and caustics.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ground: Option<Ground>,
    /// A vertical, diffuse plane behind the volume that shows shadow and caustics.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall: Option<Wall>,
    /// Half-spaces in which opacity, or everything, is removed; at most four.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 4))]
    pub clip: Vec<Clip>,
    /// A box out of the volume that is left of it; the whole volume if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crop: Option<Crop>,
    /// Size and exposure of the picture.
    pub film: Film,
    /// What is drawn over the finished picture; at most 32.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 32))]
    pub annotation: Vec<Annotation>,
}

impl Scene {
    /// Whether the scene shows meshes within a volume: it names both.
    #[must_use]
    pub fn has_bodies(&self) -> bool {
        !self.mesh.is_empty() && (self.volume.file.is_some() || self.volume.builtin.is_some())
    }

    /// Whether the scene shows meshes alone, and not a volume, with or without bodies within it.
    #[must_use]
    pub fn shows_mesh(&self) -> bool {
        !self.mesh.is_empty() && !self.has_bodies()
    }
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            method: MethodName::default(),
            background: None,
            volume: VolumeSource::default(),
            mesh: Vec::new(),
            ior_volume: None,
            camera: Camera::default(),
            light: vec![Light::default()],
            transfer: TransferFunction::default(),
            isosurface: Vec::new(),
            material: Vec::new(),
            voxelization: Voxelization::default(),
            voxels: Voxels::default(),
            beams: Beams::default(),
            shadow: Shadow::default(),
            sweep: Sweep::default(),
            shading: Shading::default(),
            environment: Environment::default(),
            surroundings: Surroundings::default(),
            medium: None,
            ground: None,
            wall: None,
            clip: Vec::new(),
            crop: None,
            film: Film::default(),
            annotation: Vec::new(),
        }
    }
}
