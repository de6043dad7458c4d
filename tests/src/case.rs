//! A rendered case: a scene and its assets.

use std::path::Path;
use std::sync::Arc;

use vitrum::scene::{Scene, VolumeSource};
use vitrum::{Assets, OutputRequest, Subject, builtin, preset};
use vitrum_io::{Volume, Voxels};

use crate::Failure;

/// A scene and its assets.
#[derive(Debug, Clone)]
pub struct Case {
    /// The scene's name, and how it was changed.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The data that it shows.
    pub assets: Assets,
    /// Whether the volume is streamed, in as little memory as that takes.
    pub streamed: bool,
    /// Whether the light is an output, or carried as far as the picture needs it.
    pub request: OutputRequest,
}

impl Case {
    /// A built-in scene as a picture of `edge` × `edge` pixels, its volumes or its mesh with `resolution` voxels along their longest
    /// edge (their own if `None`), changed by `settings` such as `sweep.gradient=chain`.
    ///
    /// # Errors
    /// If there is no such scene, or a setting is wrong.
    pub fn builtin(name: &str, edge: u32, resolution: Option<u32>, settings: &[&str]) -> Result<Self, Failure> {
        let unknown = || Failure::Setup(format!("there is no built-in scene {name}; `vitrum scenes` lists them"));
        let mut scene = sized(builtin::scene(name).ok_or_else(unknown)?, edge);
        if !scene.mesh.is_empty() {
            scene.voxelization.resolution = resolution.unwrap_or(scene.voxelization.resolution);
        } else {
            for source in [Some(&mut scene.volume), scene.ior_volume.as_mut()].into_iter().flatten() {
                source.resolution = resolution.or(source.resolution);
            }
        }
        for setting in settings {
            scene.set(setting)?;
        }
        let assets = Assets::load(&scene, Path::new(""))?;
        let name = [&[name], settings].concat().join(" ");
        Ok(Self { name, scene, assets, streamed: false, request: OutputRequest::default() })
    }

    /// A volume file with the look of a preset, as a picture of `edge` × `edge` pixels.
    ///
    /// # Errors
    /// If the file cannot be read, or there is no such preset.
    pub fn file(path: &Path, preset: &str, edge: u32) -> Result<Self, Failure> {
        let volume = VolumeSource { file: Some(path.to_owned()), ..VolumeSource::default() };
        let mut scene = sized(Scene { volume, ..Scene::default() }, edge);
        let assets = Assets::load(&scene, Path::new(""))?;
        preset::apply(preset, shown(&assets), &mut scene)?;
        let file = path.file_name().unwrap_or(path.as_os_str());
        Ok(Self {
            name: format!("{} ({preset})", file.display()),
            scene,
            assets,
            streamed: false,
            request: OutputRequest::default(),
        })
    }

    /// Makes it a picture of `edge` × `edge` pixels.
    pub fn resize(&mut self, edge: u32) {
        (self.scene.film.width, self.scene.film.height) = (edge, edge);
    }

    /// The case with the volume streamed.
    #[must_use]
    pub fn streamed(self) -> Self {
        Self { streamed: true, ..self }
    }

    /// The case with the light carried only as far as the picture needs it.
    #[must_use]
    pub fn without_light(self) -> Self {
        Self { request: OutputRequest { light: false, ..OutputRequest::default() }, ..self }
    }

    /// The case with the voxels rounded to bytes, as many scans store them.
    ///
    /// # Errors
    /// None that built-in volumes cause.
    pub fn in_bytes(mut self) -> Result<Self, Failure> {
        let rounded = Arc::new(in_bytes(self.volume())?);
        match &mut self.assets.subject {
            Subject::Volume(shown) | Subject::Volumes { shown, .. } => *shown = rounded,
            Subject::Mesh(_) => {}
        }
        Ok(self)
    }

    /// The case with voxels of bytes that have colours and factors of extinction of their own, different ones from voxel to voxel.
    ///
    /// # Errors
    /// As [`Self::in_bytes`].
    pub fn in_colors(self) -> Result<Self, Failure> {
        let mut case = self.in_bytes()?;
        let volume = case.volume().clone();
        // Fibonacci hashing spreads the numbers of voxels.
        let colors = (0..volume.voxel_count() as u32).map(|index| index.wrapping_mul(0x9e37_79b9) | 0x8000_0000);
        let colored = Arc::new(volume.with_colors(colors.collect())?);
        if let Subject::Volume(shown) = &mut case.assets.subject {
            *shown = colored;
        }
        Ok(case)
    }

    /// The volume that the case shows.
    ///
    /// # Panics
    /// If it shows a mesh.
    #[must_use]
    pub fn volume(&self) -> &Volume {
        shown(&self.assets)
    }
}

fn shown(assets: &Assets) -> &Volume {
    assets.subject.volume().expect("the case shows a volume")
}

fn sized(mut scene: Scene, edge: u32) -> Scene {
    (scene.film.width, scene.film.height) = (edge, edge);
    scene
}

fn in_bytes(volume: &Volume) -> Result<Volume, Failure> {
    let [low, high] = volume.range;
    let scale = (high - low) / 255.0;
    let [width, height, depth] = volume.dimensions;
    // The cast saturates.
    let byte = |x, y, z| ((volume.value(x, y, z) - low) / scale).round() as u8;
    let slice = |z| (0..height).flat_map(move |y| (0..width).map(move |x| byte(x, y, z)));
    let voxels = Voxels::U8((0..depth).flat_map(slice).collect());
    let rounded = Volume::new(volume.name.clone(), volume.dimensions, volume.spacing, voxels)?;
    let rounded = rounded.with_value_mapping(scale, low)?;
    Ok(Volume { origin: volume.origin, axes: volume.axes, ..rounded })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_applied_and_named() {
        let case = Case::builtin("ball", 24, Some(16), &["sweep.gradient=chain"]).unwrap();
        assert_eq!((case.name.as_str(), case.scene.film.width), ("ball sweep.gradient=chain", 24));
        assert_eq!(case.volume().dimensions.iter().max(), Some(&16));
        assert!(Case::builtin("bal", 24, None, &[]).unwrap_err().to_string().contains("no built-in scene bal"));
    }

    #[test]
    fn bytes_keep_place_and_values() {
        let case = Case::builtin("head", 24, Some(16), &[]).unwrap();
        let before = case.volume().clone();
        let after = case.in_bytes().unwrap().volume().clone();
        assert!(matches!(after.voxels, Voxels::U8(_)));
        assert_eq!(
            (after.dimensions, after.origin, after.range[0]),
            (before.dimensions, before.origin, before.range[0])
        );
        let step = (before.range[1] - before.range[0]) / 255.0;
        assert!((after.value(8, 7, 6) - before.value(8, 7, 6)).abs() <= 0.51 * step);
    }
}
