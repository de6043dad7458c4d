//! Presets of meshes: the materials of the bodies, and the surroundings.

use super::{MESHES, PresetError, VOLUMES, not_found};
use crate::scene::{Environment, EnvironmentKind, Material, Rgb, Scene};

/// A material: a clear one by its transmittance over the mesh's longest edge, or an opaque one by its reflectance.
struct Look {
    name: &'static str,
    description: &'static str,
    /// 0 for an opaque one.
    ior: f32,
    /// See [`Material::abbe`].
    abbe: Option<f32>,
    color: Rgb,
}

const LOOKS: [Look; 5] = [
    Look {
        name: "glass",
        description: "of a mesh: crown glass, index of refraction 1.52, a trace of green",
        ior: 1.52,
        abbe: None,
        color: [0.86, 0.95, 0.90],
    },
    Look { name: "water", description: "of a mesh: water, 1.333", ior: 1.333, abbe: None, color: [0.72, 0.93, 0.97] },
    Look {
        name: "diamond",
        description: "of a mesh: diamond, 2.417, which disperses (Abbe number 55.3)",
        ior: 2.417,
        abbe: Some(55.3),
        color: [0.97; 3],
    },
    Look {
        name: "jade",
        description: "of a mesh: clear jade, 1.66, deep green where it is thick",
        ior: 1.66,
        abbe: None,
        color: [0.03, 0.40, 0.12],
    },
    Look {
        name: "clay",
        description: "of a mesh: opaque pale clay on the ground",
        ior: 0.0,
        abbe: None,
        color: [0.72, 0.66, 0.58],
    },
];

pub(super) const NAMES: &[(&str, &str)] = &{
    let mut names = [("", ""); LOOKS.len()];
    let mut index = 0;
    while index < names.len() {
        names[index] = (LOOKS[index].name, LOOKS[index].description);
        index += 1;
    }
    names
};

/// Name and description of every preset of meshes.
#[must_use]
pub fn mesh_names() -> &'static [(&'static str, &'static str)] {
    NAMES
}

/// Gives a scene the default surroundings of a mesh. A clear body is visible by the surroundings that it refracts: a bright band
/// between two dark ones.
pub fn surround_mesh(scene: &mut Scene) {
    scene.environment = Environment {
        kind: EnvironmentKind::Gradient,
        color: [0.08, 0.16, 0.30],
        horizon: [0.95, 0.96, 0.97],
        nadir: [0.05, 0.045, 0.04],
        ..Environment::default()
    };
    scene.film.supersampling = 2;
}

/// Makes all bodies of a mesh of one material, and surrounds it; an opaque one stands on the ground.
///
/// # Errors
///
/// [`PresetError::Unknown`], and [`PresetError::OtherKind`] of a preset of volumes; the scene is then unchanged.
pub fn apply_to_mesh(name: &str, scene: &mut Scene) -> Result<(), PresetError> {
    let look = LOOKS.iter().find(|look| look.name == name);
    let look = look.ok_or_else(|| not_found(name, MESHES, VOLUMES))?;
    surround_mesh(scene);
    if look.ior == 0.0 {
        scene.material = vec![Material { opaque: true, color: Some(look.color), ..Material::default() }];
        scene.ground.get_or_insert_default();
    } else {
        let (ior, abbe, attenuation_color) = (look.ior, look.abbe, look.color);
        scene.material = vec![Material { ior, abbe, attenuation_color, ..Material::default() }];
    }
    Ok(())
}
