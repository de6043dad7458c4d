//! Presets of media: the fog, smoke or water that meshes stand in.

use crate::scene::{Environment, EnvironmentKind, Light, LightKind, Medium, MethodName, Rgb, Scene, Vector};
use crate::suggest::nearest;
use glam::Vec3;

/// A medium, by optical depths over the diameter of the sphere around the meshes.
struct Look {
    name: &'static str,
    description: &'static str,
    absorption: Rgb,
    scattering: Rgb,
    /// Mean cosine of the scattering angle.
    anisotropy: f32,
}

const LOOKS: [Look; 4] = [
    Look {
        name: "fog",
        description: "a medium: thin white fog, which scatters forward",
        absorption: [0.0125; 3],
        scattering: [0.2375; 3],
        anisotropy: 0.7,
    },
    Look {
        name: "smoke",
        description: "a medium: grey smoke, which absorbs nearly as much as it scatters",
        absorption: [0.14; 3],
        scattering: [0.21; 3],
        anisotropy: 0.4,
    },
    Look {
        name: "milk",
        description: "a medium: water with a drop of milk, dense and white",
        absorption: [0.005, 0.006, 0.008],
        scattering: [0.56, 0.6, 0.64],
        anisotropy: 0.75,
    },
    Look {
        name: "sea",
        description: "a medium: clear sea water, blue-green in the distance",
        absorption: [0.24, 0.05, 0.035],
        scattering: [0.07, 0.09, 0.10],
        anisotropy: 0.8,
    },
];

const NAMES: &[(&str, &str)] = &{
    let mut names = [("", ""); LOOKS.len()];
    let mut index = 0;
    while index < names.len() {
        names[index] = (LOOKS[index].name, LOOKS[index].description);
        index += 1;
    }
    names
};

/// Place of the spot, from the middle of the meshes, in radii of the sphere around them: upwards, and aside and behind for a camera in front.
const ABOVE: f32 = 2.6;
const ASIDE: Vec3 = Vec3::new(0.8, -0.9, 0.0);
/// Radiance of a white diffuse surface that faces the spot in the middle of the meshes. A thin medium scatters a small share of it.
const BRIGHTNESS: f32 = 8.0;
/// Half-angle of the spot's cone, in degrees: the sphere and a little around it.
const CONE: f32 = 24.0;

/// Why a scene was not put into a medium.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MediumError {
    /// An unknown name.
    #[error("there is no medium `{name}`")]
    Unknown {
        /// The name that was asked for.
        name: String,
    },
    /// The scene shows no mesh.
    #[error("the medium `{name}` is shown around meshes, and the scene shows a volume")]
    NoMesh {
        /// The name that was asked for.
        name: String,
    },
}

impl MediumError {
    /// Advice: a sentence that says how to mend it.
    #[must_use]
    pub fn help(&self) -> String {
        let known: Vec<&str> = NAMES.iter().map(|&(name, _)| name).collect();
        let list = format!("the media are: {}", known.join(", "));
        match self {
            Self::Unknown { name } => match nearest(name, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`? {list}"),
                None => list,
            },
            Self::NoMesh { .. } => "name a mesh, or leave the medium out".to_owned(),
        }
    }
}

/// Name and description of every preset of media.
#[must_use]
pub fn medium_names() -> &'static [(&'static str, &'static str)] {
    NAMES
}

/// Puts the meshes of a scene into the medium `name` and shows them by the method `beams`. `bounds` are the low and the high corner of the
/// box around the meshes, in world units, by whose size the medium is as dense as it looks good. In a scene whose only light is the
/// default one a spot above the meshes takes its place, in the dark, so that beams are seen.
///
/// # Errors
///
/// [`MediumError::Unknown`], and [`MediumError::NoMesh`] where the scene names no mesh; the scene is then unchanged.
pub fn put_into_medium(name: &str, bounds: [Vector; 2], scene: &mut Scene) -> Result<(), MediumError> {
    let look = LOOKS.iter().find(|look| look.name == name);
    let look = look.ok_or_else(|| MediumError::Unknown { name: name.to_owned() })?;
    if !scene.shows_mesh() {
        return Err(MediumError::NoMesh { name: name.to_owned() });
    }
    let [low, high] = bounds.map(Vec3::from_array);
    let middle = low + (high - low) * 0.5;
    let radius = ((high - low) * 0.5).length().max(1e-6);
    let per_unit = |depths: Rgb| depths.map(|depth| rounded(depth / (2.0 * radius)));
    scene.method = MethodName::Beams;
    scene.medium = Some(Medium {
        absorption: per_unit(look.absorption),
        scattering: per_unit(look.scattering),
        anisotropy: look.anisotropy,
        ..Medium::default()
    });
    if scene.light == [Light::default()] {
        scene.light = vec![spot(middle, radius, Vec3::from_array(scene.camera.up))];
        scene.environment = Environment { kind: EnvironmentKind::Color, color: [0.0; 3], ..Environment::default() };
        scene.shading.ambient = [0.0; 3];
    }
    Ok(())
}

/// A spot that shines at the sphere around the meshes from above, in the world.
fn spot(middle: Vec3, radius: f32, up: Vec3) -> Light {
    let way = (up.normalize_or(Vec3::Z) * ABOVE + ASIDE) * radius;
    Light {
        position: Some((middle + way).to_array().map(rounded)),
        intensity: rounded(BRIGHTNESS * way.length_squared()).min(1e9),
        cone_angle: CONE,
        ..Light::of_kind(LightKind::Spot)
    }
}

/// The value to three digits: people read and edit it in scene files.
fn rounded(value: f32) -> f32 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::MeshSource;

    fn vase() -> Scene {
        let mesh = vec![MeshSource { builtin: Some("vase".to_owned()), ..MeshSource::default() }];
        Scene { method: MethodName::Voxels, mesh, ..Scene::default() }
    }

    #[test]
    fn every_medium_suits_meshes_of_any_size() {
        for (name, _) in medium_names() {
            for size in [1e-6, 1.0, 1e5] {
                let mut scene = vase();
                put_into_medium(name, [[-size; 3], [size; 3]], &mut scene).unwrap();
                scene.validate().unwrap_or_else(|error| panic!("{name}: {error}"));
                let medium = scene.medium.unwrap();
                let extinction = f64::from(medium.absorption[0] + medium.scattering[0]);
                let depth = extinction * f64::from(size) * 2.0 * libm::sqrt(3.0);
                assert!((0.2..0.7).contains(&depth), "{name}: {depth}");
            }
        }
    }

    #[test]
    fn a_light_that_the_scene_names_stays() {
        let lit = Scene { light: vec![Light { azimuth: 3.0, ..Light::default() }], ..vase() };
        let mut scene = lit.clone();
        put_into_medium("fog", [[-1.0; 3], [1.0; 3]], &mut scene).unwrap();
        assert_eq!((scene.light, scene.environment), (lit.light, lit.environment));
        let mut scene = vase();
        put_into_medium("fog", [[-1.0; 3], [1.0; 3]], &mut scene).unwrap();
        let [light] = &scene.light[..] else { panic!("{:?}", scene.light) };
        assert_eq!((light.kind, light.position), (LightKind::Spot, Some([1.39, -1.56, 4.5])));
        assert_eq!(scene.environment.color, [0.0; 3]);
    }

    #[test]
    fn unknown_names_and_volumes_are_refused() {
        let mut scene = vase();
        let error = put_into_medium("fogg", [[0.0; 3]; 2], &mut scene).unwrap_err();
        assert_eq!(error.to_string(), "there is no medium `fogg`");
        assert_eq!(error.help(), "did you mean `fog`? the media are: fog, smoke, milk, sea");
        assert_eq!(scene, vase());
        let error = put_into_medium("fog", [[0.0; 3]; 2], &mut Scene::default()).unwrap_err();
        assert!(error.to_string().contains("the scene shows a volume"), "{error}");
    }
}
