//! The files that a scene names.

use super::Scene;
use std::path::{Path, PathBuf};

impl Scene {
    /// The paths of all files that the scene names: volumes, meshes, a mask, pictures.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let density = self.medium.as_mut().and_then(|medium| medium.density.as_mut());
        let volumes = [Some(&mut self.volume), self.ior_volume.as_mut(), density].into_iter().flatten();
        let volumes =
            volumes.flat_map(|volume| volume.file.iter_mut().chain(volume.mask.as_mut().map(|mask| &mut mask.file)));
        let meshes = self.mesh.iter_mut().filter_map(|mesh| mesh.file.as_mut());
        let textures = self.light.iter_mut().filter_map(|light| light.texture.as_mut());
        volumes.chain(meshes).chain(textures).chain(&mut self.environment.file)
    }

    /// Makes the paths of all files independent of the folder `base` that relative ones start at, so that the scene can be saved anywhere.
    pub fn free_of(&mut self, base: &Path) {
        for file in self.files_mut().filter(|file| file.as_path() != Path::new(vitrum_io::STANDARD_INPUT)) {
            let path = base.join(&*file);
            // A path stays as it is where the system does not say where it runs.
            *file = std::path::absolute(&path).unwrap_or(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Hides, Light, Mask, Medium, MeshSource, VolumeSource, describe_keys};

    #[test]
    fn every_key_of_a_path_is_a_file() {
        let source = |name: &str| VolumeSource {
            file: Some(name.into()),
            mask: Some(Mask { file: format!("mask of {name}").into(), labels: Vec::new(), hides: Hides::default() }),
            ..VolumeSource::default()
        };
        let mut scene = Scene {
            volume: source("shown"),
            ior_volume: Some(source("index")),
            medium: Some(Medium { density: Some(source("density")), ..Medium::default() }),
            mesh: vec![MeshSource { file: Some("mesh".into()), ..MeshSource::default() }],
            light: vec![Light { texture: Some("slide".into()), ..Light::default() }],
            ..Scene::default()
        };
        scene.environment.file = Some("sky".into());
        let keys = describe_keys().into_iter().filter(|key| key.range == "a path" || key.path.ends_with("mask.file"));
        assert_eq!(scene.files_mut().count(), keys.count());
        scene.free_of(Path::new("/base"));
        assert!(scene.files_mut().all(|file| file.starts_with("/base")), "{scene:?}");
    }
}
