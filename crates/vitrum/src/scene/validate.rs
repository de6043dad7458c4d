//! The rules that tie several keys of a scene together.

use super::check::check_table;
use super::error::{Fault, Origin, SceneError};
use super::schema::Shape;
use super::{
    Camera, Environment, EnvironmentKind, Film, Intensity, MeshSource, MethodName, Scene, Sweep, TransferFunction,
    Transport, Vector, VolumeSource,
};
use vitrum_io::{RawLayout, Up};

impl Scene {
    /// Checks every value's range, and that the values do not contradict each other.
    ///
    /// Scenes read by [`Scene::from_toml`] have passed; one that was changed since may have lost it.
    ///
    /// # Errors
    ///
    /// Where a value is out of its documented range or not finite; where a volume has not exactly one of `file` and
    /// `builtin`; where the method and what is shown do not belong together; where a direction has no length, the eye stands on its target, the points of a transfer function are
    /// not sorted, an environment map has no file, or the film is beyond 2^28 rays.
    pub fn validate(&self) -> Result<(), SceneError> {
        self.check_settings()?;
        self.check_sources().map_err(|fault| fault.from(Origin::Memory))
    }

    /// As [`Scene::validate`], but for the files and built-in data that the scene names: a picture of data in memory needs none.
    ///
    /// # Errors
    ///
    /// As [`Scene::validate`].
    pub fn check_settings(&self) -> Result<(), SceneError> {
        let check = || {
            check_table(Shape::scene(), &self.to_table()?, &mut Vec::new())?;
            self.check_together()
        };
        check().map_err(|fault: Fault| fault.from(Origin::Memory))
    }

    /// The part of [`Scene::validate`] that looks at several keys at once.
    pub(super) fn check_consistency(&self) -> Result<(), Fault> {
        self.check_sources()?;
        self.check_together()
    }

    /// Whether the scene names data, and data that its method shows.
    fn check_sources(&self) -> Result<(), Fault> {
        check_shown(self)?;
        self.ior_volume.as_ref().map_or(Ok(()), |source| check_source("ior_volume", source))
    }

    /// Whether the values go together with a mesh that is swept.
    ///
    /// # Errors
    ///
    /// Where they do not.
    pub(crate) fn check_for_swept_mesh(&self) -> Result<(), SceneError> {
        check_swept_mesh(self).map_err(|fault| fault.from(Origin::Memory))
    }

    /// Whether the values go together with rays through a mesh.
    ///
    /// # Errors
    ///
    /// Where they do not.
    pub(crate) fn check_for_mesh(&self) -> Result<(), SceneError> {
        check_mesh(self).map_err(|fault| fault.from(Origin::Memory))
    }

    /// The values that stand in several keys and have to go together, whatever is shown.
    fn check_together(&self) -> Result<(), Fault> {
        check_camera(&self.camera)?;
        self.light.direction.map_or(Ok(()), |direction| check_direction("light.direction", direction))?;
        for (index, clip) in self.clip.iter().enumerate() {
            check_direction(&format!("clip.{index}.normal"), clip.normal)?;
        }
        check_transfer(&self.transfer)?;
        check_sweep(&self.sweep)?;
        check_environment(&self.environment)?;
        check_film(&self.film)
    }
}

/// A sweep shows a volume or a mesh, voxels a mesh.
fn check_shown(scene: &Scene) -> Result<(), Fault> {
    match (scene.method, &scene.mesh) {
        (MethodName::Sweep, None) => check_source("volume", &scene.volume),
        (MethodName::Sweep, Some(mesh)) => {
            check_mesh_source(scene, mesh)?;
            check_swept_mesh(scene)
        }
        (MethodName::Voxels, None) => Err(Fault::contradiction(
            "method",
            "`voxels` shows a mesh, and none is given",
            "name one in `mesh.file` or `mesh.builtin`, or take the method `sweep`",
        )),
        (MethodName::Voxels, Some(mesh)) => {
            check_mesh_source(scene, mesh)?;
            check_mesh(scene)
        }
    }
}

fn check_mesh(scene: &Scene) -> Result<(), Fault> {
    let given = [("clip", !scene.clip.is_empty())];
    refuse(&given, "rays through a mesh know nothing of it, and `mesh` is given", "or take the method `sweep`")?;
    check_materials(scene)
}

/// The materials say what a mesh's volume looks like.
fn check_swept_mesh(scene: &Scene) -> Result<(), Fault> {
    if let Some(index) = scene.material.iter().position(|material| material.opaque) {
        return Err(Fault::contradiction(
            &format!("material.{index}.opaque"),
            "a plane sweep shows clear bodies of a mesh, and this one is opaque",
            "set `method = \"voxels\"`, or make the material clear",
        ));
    }
    let given = [("transfer", scene.transfer != TransferFunction::default())];
    refuse(&given, "a mesh has no scalar, and `mesh` is given", "and say in `material` what bodies are made of")
}

fn check_mesh_source(scene: &Scene, mesh: &MeshSource) -> Result<(), Fault> {
    match (&mesh.file, &mesh.builtin) {
        (Some(_), Some(_)) => {
            Err(Fault::contradiction("mesh", "both `file` and `builtin` are given", "leave one of them out"))
        }
        (None, None) => Err(Fault::contradiction(
            "mesh",
            "neither `file` nor `builtin` is given",
            "name a mesh, such as `mesh.builtin = \"vase\"`",
        )),
        _ => Ok(()),
    }?;
    let up = mesh.up.as_deref().map_or(Ok(()), |text| text.parse::<Up>().map(drop));
    up.map_err(|problem| unreadable("mesh.up", &problem))?;
    let given = [("volume", scene.volume != VolumeSource::default()), ("ior_volume", scene.ior_volume.is_some())];
    refuse(&given, "a volume and a mesh are given", "or leave `mesh` out")
}

/// Fails at the first key that is given and must not be.
fn refuse(given: &[(&str, bool)], problem: &str, advice: &str) -> Result<(), Fault> {
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((name, _)) => Err(Fault::contradiction(name, problem, format!("leave `{name}` out, {advice}"))),
    }
}

/// Only an opaque body has a colour.
fn check_materials(scene: &Scene) -> Result<(), Fault> {
    match scene.material.iter().position(|material| material.color.is_some() && !material.opaque) {
        None => Ok(()),
        Some(index) => Err(Fault::contradiction(
            &format!("material.{index}.color"),
            "it is the colour of an opaque body, and the material is clear",
            format!("set `material.{index}.opaque = true`, or give a clear material an `attenuation_color`"),
        )),
    }
}

fn check_source(key: &str, source: &VolumeSource) -> Result<(), Fault> {
    match (&source.file, &source.builtin) {
        (Some(_), Some(_)) => {
            Err(Fault::contradiction(key, "both `file` and `builtin` are given", "leave one of them out"))
        }
        (None, None) => Err(Fault::contradiction(
            key,
            "neither `file` nor `builtin` is given",
            format!("name a volume, such as `{key}.builtin = \"ball\"`"),
        )),
        (None, Some(_)) => check_builtin(key, source),
        (Some(_), None) => {
            let layout = source.raw.as_deref().map_or(Ok(()), |text| text.parse::<RawLayout>().map(drop));
            layout.map_err(|problem| unreadable(&format!("{key}.raw"), &problem))
        }
    }?;
    let up = source.up.as_deref().map_or(Ok(()), |text| text.parse::<Up>().map(drop));
    up.map_err(|problem| unreadable(&format!("{key}.up"), &problem))
}

/// A procedural volume has nothing that would have to be picked out of a file.
fn check_builtin(key: &str, source: &VolumeSource) -> Result<(), Fault> {
    let given = [("raw", source.raw.is_some()), ("array", source.array.is_some()), ("time", source.time.is_some())];
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((name, _)) => Err(Fault::contradiction(
            &format!("{key}.{name}"),
            "it says how to read a file, and the volume is a built-in one",
            "leave it out",
        )),
    }
}

/// Problems of small languages end in what was expected, behind a semicolon.
fn unreadable(key: &str, problem: &str) -> Fault {
    let (problem, advice) = problem.split_once("; ").unwrap_or((problem, "correct it"));
    Fault::contradiction(key, problem, advice)
}

fn check_camera(camera: &Camera) -> Result<(), Fault> {
    check_direction("camera.up", camera.up)?;
    if camera.position.is_some() && camera.position == camera.target {
        return Err(Fault::contradiction(
            "camera.position",
            "the eye stands on its target, so there is no viewing direction",
            "move `camera.position` or `camera.target`",
        ));
    }
    Ok(())
}

/// A direction may have any length that survives being squared in f32.
fn check_direction(key: &str, direction: Vector) -> Result<(), Fault> {
    let length = direction.iter().fold(0.0, |length: f64, &component| length.hypot(f64::from(component)));
    if (1e-15..=1e15).contains(&length) {
        return Ok(());
    }
    Err(Fault::contradiction(
        key,
        format!("{direction:?} is {length} long and gives no direction"),
        "give a vector whose length is from 1e-15 to 1e15, such as one of length 1",
    ))
}

fn check_sweep(sweep: &Sweep) -> Result<(), Fault> {
    if sweep.light == Transport::Sheets && sweep.intensity != Intensity::Jacobian {
        return Err(Fault::contradiction(
            "sweep.intensity",
            "there is nothing to correct where `sweep.light` is `sheets`: they conserve flux by themselves",
            "leave `sweep.intensity` out, or set `sweep.light = \"texels\"`",
        ));
    }
    Ok(())
}

fn check_transfer(transfer: &TransferFunction) -> Result<(), Fault> {
    if let Some(index) = transfer.ior.iter().position(|point| point.abbe.is_some() && point.cauchy_b.is_some()) {
        return Err(Fault::contradiction(
            &format!("transfer.ior.{index}.abbe"),
            "both `abbe` and `cauchy_b` are given",
            "leave one of them out",
        ));
    }
    check_sorted("transfer.color", transfer.color.iter().map(|point| point.value))?;
    check_sorted("transfer.opacity", transfer.opacity.iter().map(|point| point.value))?;
    check_sorted("transfer.ior", transfer.ior.iter().map(|point| point.value))?;
    check_sorted("transfer.medium", transfer.medium.iter().map(|point| point.value))
}

fn check_sorted(key: &str, values: impl Iterator<Item = f32>) -> Result<(), Fault> {
    let mut previous = f32::NEG_INFINITY;
    for (index, value) in values.enumerate() {
        if value < previous {
            return Err(Fault::contradiction(
                &format!("{key}.{index}.value"),
                format!("{value} comes after {previous}"),
                "sort the points by `value`; two points at the same value make a step",
            ));
        }
        previous = value;
    }
    Ok(())
}

fn check_environment(environment: &Environment) -> Result<(), Fault> {
    if environment.kind == EnvironmentKind::Map && environment.file.is_none() {
        return Err(Fault::contradiction(
            "environment.kind",
            "`map` needs a picture, and `environment.file` is not given",
            "name an equirectangular picture in `environment.file`, or take another kind",
        ));
    }
    Ok(())
}

fn check_film(film: &Film) -> Result<(), Fault> {
    let Film { width, height, supersampling, .. } = *film;
    // Each factor has passed its range, so that the product fits easily.
    let rays = u64::from(width) * u64::from(height) * u64::from(supersampling).pow(2);
    if rays > Film::MOST_RAYS {
        return Err(Fault::contradiction(
            "film",
            format!(
                "{width} x {height} pixels with supersampling {supersampling} are {rays} viewing rays, and the limit is {}",
                Film::MOST_RAYS
            ),
            "make the picture smaller, or lower `film.supersampling`",
        ));
    }
    Ok(())
}
