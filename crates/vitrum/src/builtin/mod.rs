//! Procedural volumes and meshes, and the scenes that show them: nothing to download.
//!
//! All volumes are centred on the world's origin, stand upright along +z and are 2 world units along their longest edge (the
//! ball and the Luneburg lens have a radius of exactly 1, and a margin). They are computed with additions, multiplications and
//! square roots only, so that every machine makes the same voxels.

mod ball;
mod combustion;
mod curves;
mod glass;
mod grid;
mod head;
mod luneburg;
mod mesh;
mod noise;
mod phantom;
mod prism;
mod shapes;
mod smoke;
mod supernova;

use crate::scene::Scene;
use std::sync::LazyLock;
use vitrum_io::{Error, Mesh, Volume};

/// Name, one-line description and maker of a scene.
type SceneEntry = (&'static str, &'static str, fn() -> Scene);

/// Name, default resolution and maker of a volume.
type VolumeEntry = (&'static str, u32, fn(&str, u32) -> Result<Volume, Error>);

const SCENES: &[&[SceneEntry]] = &[
    glass::SCENES,
    supernova::SCENES,
    head::SCENES,
    combustion::SCENES,
    ball::SCENES,
    luneburg::SCENES,
    prism::SCENES,
    phantom::SCENES,
];

const VOLUMES: &[VolumeEntry] = &[
    ("glass", 256, glass::volume),
    ("supernova", 256, supernova::volume),
    ("head", 256, head::volume),
    ("combustion", 256, combustion::volume),
    ("combustion-mixture", 256, combustion::mixture_volume),
    ("ball", 192, ball::volume),
    ("luneburg", 160, luneburg::volume),
    ("prism", 160, prism::volume),
    ("phantom", 256, phantom::volume),
    ("smoke", 96, smoke::volume),
];

/// The built-in scenes and what each shows; a variant is named `SCENE/VARIANT`.
#[must_use]
pub fn names() -> &'static [(&'static str, &'static str)] {
    static NAMES: LazyLock<Vec<(&str, &str)>> =
        LazyLock::new(|| entries().map(|&(name, description, _)| (name, description)).collect());
    &NAMES
}

/// The built-in scene of that name: volume, camera, light, materials and receivers.
#[must_use]
pub fn scene(name: &str) -> Option<Scene> {
    entries().find(|entry| entry.0 == name).map(|entry| entry.2())
}

/// Computes the procedural volume of that name ([`crate::scene::VolumeSource::builtin`]), with `resolution` voxels along its
/// longest edge (16 to 2048), or as many as suit a first picture.
#[must_use]
pub fn volume(name: &str, resolution: Option<u32>) -> Option<Result<Volume, Error>> {
    let &(name, default, make) = VOLUMES.iter().find(|entry| entry.0 == name)?;
    Some(make(name, resolution.unwrap_or(default)))
}

/// Computes the procedural mesh of that name ([`crate::scene::MeshSource::builtin`]).
#[must_use]
pub fn mesh(name: &str) -> Option<Mesh> {
    mesh::MESHES.iter().find(|entry| entry.0 == name).map(|entry| entry.1(name))
}

/// As [`mesh`], of one that moves, at a moment of `seconds` ([`crate::scene::MeshSource::time`]), where its unit is `metres` long; `None` for one that
/// does not move, too.
#[must_use]
pub fn moving_mesh(name: &str, seconds: f64, metres: f64) -> Option<Mesh> {
    mesh::MOVING.iter().find(|entry| entry.0 == name).map(|entry| entry.1(name, seconds, metres))
}

/// The names of the procedural meshes that move.
pub fn moving_mesh_names() -> impl Iterator<Item = &'static str> {
    mesh::MOVING.iter().map(|entry| entry.0)
}

/// The names of the procedural meshes.
pub fn mesh_names() -> impl Iterator<Item = &'static str> {
    mesh::MESHES.iter().map(|entry| entry.0)
}

/// The built-in volumes.
pub fn volume_names() -> impl Iterator<Item = &'static str> {
    VOLUMES.iter().map(|entry| entry.0)
}

fn entries() -> impl Iterator<Item = &'static SceneEntry> {
    SCENES.iter().chain(mesh::SCENES).copied().flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Attachment, Light, LightKind, MeshSource, MethodName};
    use vitrum_io::Voxels;

    #[test]
    fn names_resolve_and_are_different() {
        for (index, (name, description)) in names().iter().enumerate() {
            assert!(scene(name).is_some(), "{name}");
            assert!(!description.is_empty() && names()[..index].iter().all(|other| other.0 != *name), "{name}");
        }
        assert!(scene("glas").is_none() && scene("glass/").is_none() && volume("glass/beer", None).is_none());
    }

    #[test]
    fn scenes_are_valid_and_differ_from_their_siblings() {
        for (name, scene) in entries().map(|entry| (entry.0, entry.2())) {
            scene.validate().unwrap_or_else(|error| panic!("{name}: {error}"));
            let base = name.split('/').next().unwrap();
            let same = entries().filter(|entry| entry.0.starts_with(base) && entry.2() == scene).count();
            assert!(same <= if names().iter().any(|other| other.0 == base) { 2 } else { 1 }, "{name}");
            if !scene.mesh.is_empty() {
                let known = |source: &MeshSource| mesh_names().any(|known| Some(known) == source.builtin.as_deref());
                assert!(scene.mesh.iter().all(known), "{name}");
                let density = scene.medium.as_ref().and_then(|medium| medium.density.as_ref()?.builtin.as_deref());
                assert!(density.is_none_or(|density| volume_names().any(|known| known == density)), "{name}");
                continue;
            }
            for source in [Some(&scene.volume), scene.ior_volume.as_ref()].into_iter().flatten() {
                let volume = source.builtin.as_deref().unwrap();
                assert!(VOLUMES.iter().any(|entry| entry.0 == volume), "{name}: {volume}");
            }
            assert!(scene.transfer.reference_length.is_some(), "{name}: the look depends on the resolution");
        }
    }

    #[test]
    fn volumes_have_the_resolution_asked_for() {
        for (name, ..) in VOLUMES {
            let volume_of = |resolution| volume(name, Some(resolution)).unwrap();
            assert_eq!(volume_of(16).unwrap().dimensions.iter().max(), Some(&16), "{name}");
            assert!(volume_of(15).is_err() && volume_of(2049).is_err(), "{name}");
        }
    }

    #[test]
    fn light_shines_away_from_the_camera() {
        // Beams may go any way.
        let scenes = entries().map(|entry| (entry.0, entry.2())).filter(|(_, scene)| scene.method != MethodName::Beams);
        for (name, scene) in scenes {
            for light in scene.light.into_iter().filter(|light| light.kind == LightKind::Distant) {
                let Light { azimuth, elevation, direction, .. } = light;
                assert_eq!((light.attachment(), direction), (Attachment::Camera, None), "{name}");
                let cosine = libm::cosf(azimuth.to_radians()) * libm::cosf(elevation.to_radians());
                assert!(cosine > libm::cosf(85_f32.to_radians()), "{name}");
            }
        }
    }

    #[test]
    fn air_is_empty_in_every_scene() {
        for (name, scene) in SCENES.iter().copied().flatten().map(|entry| (entry.0, entry.2())) {
            let volume = volume(scene.volume.builtin.as_deref().unwrap(), Some(32)).unwrap().unwrap();
            let transfer = scene.transfer;
            assert!(transfer.opacity[0].opacity == 0.0 && transfer.opacity[0].value >= volume.range[0], "{name}");
            assert!(transfer.ior.first().is_none_or(|point| point.ior == 1.0), "{name}");
            assert!(transfer.filter.first().is_none_or(|point| point.color == [1.0; 3]), "{name}");
            let air = volume.histogram(50)[0] as f32 / volume.voxel_count() as f32;
            assert!((0.3..0.9).contains(&air), "{name}: {air} is air");
        }
    }

    /// FNV-1a of the stored voxels: they are the same on every machine.
    fn fingerprint(volume: &Volume) -> u64 {
        let bytes: Vec<u8> = match &volume.voxels {
            Voxels::U8(voxels) => voxels.to_vec(),
            Voxels::U16(voxels) => voxels.iter().flat_map(|voxel| voxel.to_le_bytes()).collect(),
            Voxels::F32(voxels) => voxels.iter().flat_map(|voxel| voxel.to_le_bytes()).collect(),
        };
        bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }

    #[test]
    fn voxels_are_the_same_everywhere() {
        let found: Vec<(&str, u64)> =
            VOLUMES.iter().map(|&(name, ..)| (name, fingerprint(&volume(name, Some(48)).unwrap().unwrap()))).collect();
        assert_eq!(found, FINGERPRINTS);
    }

    const FINGERPRINTS: [(&str, u64); 10] = [
        ("glass", 0x2170_4c9c_b50d_546f),
        ("supernova", 0x1f29_ef4f_7f37_1fdf),
        ("head", 0x5842_7ca0_ae6e_edb2),
        ("combustion", 0xe355_4488_e558_1441),
        ("combustion-mixture", 0x341e_ea67_6881_cbb2),
        ("ball", 0xe5f1_d667_7fec_fb75),
        ("luneburg", 0xdeed_63e6_1164_11d5),
        ("prism", 0x5e6e_1461_ee60_44ad),
        ("phantom", 0x6d39_e3a0_86f9_3ec5),
        ("smoke", 0xe5a4_11af_93c4_10e0),
    ];
}
