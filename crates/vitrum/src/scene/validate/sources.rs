//! Checks of the keys that name files and built-in data.

use super::super::error::Fault;
use super::super::{Environment, EnvironmentKind, MeshSource, Scene, VolumeSource};
use super::refuse;
use crate::assets::made;
use vitrum_io::{RawLayout, Up};

pub(super) fn check(scene: &Scene) -> Result<(), Fault> {
    check_shown(scene)?;
    scene.ior_volume.as_ref().map_or(Ok(()), |source| check_source("ior_volume", source))?;
    let density = scene.medium.as_ref().and_then(|medium| medium.density.as_ref());
    density.map_or(Ok(()), |source| check_source("medium.density", source))?;
    check_environment(&scene.environment)
}

/// The scene names a volume or meshes, whichever the method shows.
fn check_shown(scene: &Scene) -> Result<(), Fault> {
    let (name, shows) = (scene.method.as_str(), scene.method.capabilities());
    if scene.mesh.is_empty() && shows.volumes {
        return check_source("volume", &scene.volume);
    }
    if scene.has_bodies() && shows.volumes {
        check_source("volume", &scene.volume)?;
        let problem = "meshes within a volume take its place";
        refuse(&[("ior_volume", scene.ior_volume.is_some())], problem, "or leave `mesh` out")?;
        return scene
            .mesh
            .iter()
            .enumerate()
            .try_for_each(|(index, mesh)| check_mesh(scene, &format!("mesh.{index}"), mesh));
    }
    if scene.mesh.is_empty() {
        return Err(Fault::contradiction(
            "method",
            format!("`{name}` shows a mesh, and none is given"),
            "name one in `mesh.0.file` or `mesh.0.builtin`, or take the method `sweep`",
        ));
    }
    if !shows.meshes {
        return Err(Fault::contradiction(
            "method",
            format!("`{name}` shows a volume, and `mesh` is given"),
            "leave `mesh` out, or take the method `voxels`",
        ));
    }
    for (index, mesh) in scene.mesh.iter().enumerate() {
        check_mesh(scene, &format!("mesh.{index}"), mesh)?;
    }
    let given = [("volume", scene.volume != VolumeSource::default()), ("ior_volume", scene.ior_volume.is_some())];
    refuse(
        &given,
        "a volume and a mesh are given",
        "or leave `mesh` out, or take the method `sweep`, which shows meshes within a volume",
    )
}

fn check_mesh(scene: &Scene, key: &str, mesh: &MeshSource) -> Result<(), Fault> {
    check_one_source(key, mesh.file.is_some(), mesh.builtin.is_some(), "a mesh", "vase")?;
    check_up(key, mesh.up.as_deref())?;
    if mesh.twist != 0.0 && scene.mesh.len() > 1 {
        return Err(Fault::contradiction(
            &format!("{key}.twist"),
            format!("only a mesh that is alone can be twisted, and there are {}", scene.mesh.len()),
            "leave it out, or leave the other meshes out",
        ));
    }
    if mesh.time.is_some() && !mesh.builtin.as_deref().is_some_and(made::may_move) {
        let moving = made::moving_meshes().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        return Err(Fault::contradiction(
            &format!("{key}.time"),
            match &mesh.builtin {
                Some(name) => format!("the mesh `{name}` does not move"),
                None => "a mesh from a file does not move".to_owned(),
            },
            format!("leave it out, or show a built-in mesh that moves: {moving}"),
        ));
    }
    let named = |name: &String| scene.material.iter().any(|material| material.name.as_ref() == Some(name));
    match mesh.material.as_ref().filter(|name| !named(name)) {
        Some(name) => Err(Fault::contradiction(
            &format!("{key}.material"),
            format!("no entry of `material` has the name \"{name}\""),
            format!("add one with `name = \"{name}\"`, or leave `{key}.material` out"),
        )),
        None => Ok(()),
    }
}

/// Exactly one of `file` and `builtin`.
fn check_one_source(key: &str, file: bool, builtin: bool, what: &str, example: &str) -> Result<(), Fault> {
    match (file, builtin) {
        (true, true) => Err(Fault::contradiction(key, "both `file` and `builtin` are given", "leave one of them out")),
        (false, false) => Err(Fault::contradiction(
            key,
            "neither `file` nor `builtin` is given",
            format!("name {what}, such as `{key}.builtin = \"{example}\"`"),
        )),
        _ => Ok(()),
    }
}

fn check_source(key: &str, source: &VolumeSource) -> Result<(), Fault> {
    check_one_source(key, source.file.is_some(), source.builtin.is_some(), "a volume", "ball")?;
    if source.builtin.is_some() {
        check_builtin(key, source)?;
    } else {
        let layout = source.raw.as_deref().map_or(Ok(()), |text| text.parse::<RawLayout>().map(drop));
        layout.map_err(|problem| unreadable(&format!("{key}.raw"), &problem))?;
        if source.time.is_some() && source.seconds.is_some() {
            let problem = "both `time` and `seconds` say a point in time";
            return Err(Fault::contradiction(&format!("{key}.seconds"), problem, "leave one of them out"));
        }
    }
    if let Some(mask) = &source.mask {
        let of_shown = key == "volume";
        refuse(
            &[(&format!("{key}.mask"), !of_shown)],
            "a mask is of the volume that is shown",
            "and set `volume.mask`",
        )?;
        refuse(
            &[("volume.mask.labels", !mask.labels.iter().all(|label| label.is_finite()))],
            "a label is not finite",
            "or correct it",
        )?;
    }
    check_up(key, source.up.as_deref())
}

/// A procedural volume has nothing that would have to be picked out of a file.
fn check_builtin(key: &str, source: &VolumeSource) -> Result<(), Fault> {
    let given = [
        ("raw", source.raw.is_some()),
        ("array", source.array.is_some()),
        ("time", source.time.is_some()),
        ("seconds", source.seconds.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((name, _)) => Err(Fault::contradiction(
            &format!("{key}.{name}"),
            "it says how to read a file, and the volume is a built-in one",
            "leave it out",
        )),
    }
}

fn check_up(key: &str, up: Option<&str>) -> Result<(), Fault> {
    let up = up.map_or(Ok(()), |text| text.parse::<Up>().map(drop));
    up.map_err(|problem| unreadable(&format!("{key}.up"), &problem))
}

/// Problems of small languages end in what was expected, behind a semicolon.
fn unreadable(key: &str, problem: &str) -> Fault {
    let (problem, advice) = problem.split_once("; ").unwrap_or((problem, "correct it"));
    Fault::contradiction(key, problem, advice)
}

fn check_environment(environment: &Environment) -> Result<(), Fault> {
    if environment.kind != EnvironmentKind::Map && environment.file.is_some() {
        return Err(Fault::contradiction(
            "environment.file",
            "the picture does not show, as `environment.kind` is not `map`",
            "set `environment.kind = \"map\"`, or leave the file out",
        ));
    }
    if environment.ambient > 0.0 && environment.lights > 0 {
        return Err(Fault::contradiction(
            "environment.ambient",
            "the environment would light twice: as ambient light, and by `environment.lights`",
            "set one of the two to 0",
        ));
    }
    if environment.kind == EnvironmentKind::Map && environment.file.is_none() {
        return Err(Fault::contradiction(
            "environment.kind",
            "`map` needs a picture, and `environment.file` is not given",
            "name an equirectangular picture in `environment.file`, or take another kind",
        ));
    }
    Ok(())
}
