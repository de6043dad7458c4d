//! Checks of the keys that a picture depends on, wherever its data comes from.

use super::super::error::Fault;
use super::super::{
    Beams, BlendMode, Camera, Capabilities, Crop, Film, GradientFunction, Intensity, Interpolation, Light, LightKind,
    Material, MethodName, Scene, Sweep, Tracer, TransferFunction, Transport, Vector,
};
use super::{figure, medium, refuse};

pub(super) fn check(scene: &Scene) -> Result<(), Fault> {
    check_method(scene)?;
    check_camera(&scene.camera)?;
    for (index, light) in scene.light.iter().enumerate() {
        check_light(&format!("light.{index}"), light)?;
    }
    check_lights_of_method(scene)?;
    for (index, clip) in scene.clip.iter().enumerate() {
        check_direction(&format!("clip.{index}.normal"), clip.normal)?;
    }
    scene.crop.as_ref().map_or(Ok(()), check_crop)?;
    check_transfer(&scene.transfer)?;
    let of_labels = scene.volume.interpolation == Interpolation::Nearest && !scene.isosurface.is_empty();
    refuse(
        &[("isosurface", of_labels)],
        "`volume.interpolation` is `nearest`, and between voxels there is no value that a surface could have",
        "or set `volume.interpolation = \"linear\"`",
    )?;
    for (index, material) in scene.material.iter().enumerate() {
        check_dispersion(&format!("material.{index}"), material.abbe, material.cauchy_b)?;
    }
    check_sweep(&scene.sweep)?;
    check_beams(&scene.beams)?;
    figure::check(scene)?;
    check_film(scene)
}

/// Refuses settings of beams that exclude each other.
fn check_beams(beams: &Beams) -> Result<(), Fault> {
    let problem = "`beams.tracer` is `depth-map`, whose maps have one texel for each ray of light, and `beams.adaptive` splits texels";
    let splits = beams.tracer == Tracer::DepthMap && beams.adaptive;
    refuse(&[("beams.adaptive", splits)], problem, "or set `beams.tracer = \"tree\"`")
}

/// Refuses a scene that its method cannot render.
fn check_method(scene: &Scene) -> Result<(), Fault> {
    if let Some(medium) = &scene.medium {
        medium::check(scene.method, medium)?;
    }
    // A method that shows volumes shows one where no mesh is named.
    match (scene.method.capabilities().volumes, scene.mesh.is_empty(), scene.has_bodies()) {
        (true, true, _) => Ok(()),
        (true, _, true) => check_bodies(scene),
        _ => check_mesh(scene),
    }
}

/// Refuses the keys that a picture of bodies within a volume cannot have.
fn check_bodies(scene: &Scene) -> Result<(), Fault> {
    let blends = [("shading.blend_mode", scene.shading.blend_mode != BlendMode::Composite)];
    refuse(&blends, "it shows values of the volume alone, and `mesh` is given", "or leave `mesh` out")?;
    check_no_mirror(scene)?;
    check_materials(scene)?;
    for (index, material) in scene.material.iter().enumerate() {
        let given = [
            ("abbe", material.abbe.is_some()),
            ("cauchy_b", material.cauchy_b.is_some()),
            ("attenuation_color", material.attenuation_color != Material::default().attenuation_color),
        ];
        if let Some((name, _)) = given.into_iter().find(|(_, given)| *given) {
            return Err(Fault::contradiction(
                &format!("material.{index}.{name}"),
                "clear bodies within a volume bend all colours alike and absorb none",
                "leave it out, or show the mesh without a volume",
            ));
        }
    }
    Ok(())
}

/// Keys that the scene's method ignores, or cannot render, in a picture of a mesh are refused.
pub(super) fn check_mesh(scene: &Scene) -> Result<(), Fault> {
    let Capabilities { volumes, opaque_bodies, mirrors, clipping, .. } = scene.method.capabilities();
    if !clipping {
        let problem = format!("the method `{}` does not clip a mesh, and `mesh` is given", scene.method.as_str());
        let clips = MethodName::that_renders(|shows| shows.clipping);
        let advice =
            clips.map_or("or show a volume".to_owned(), |name| format!("or take the method `{}`", name.as_str()));
        refuse(&[("clip", !scene.clip.is_empty())], &problem, &advice)?;
    }
    let of_volumes = [
        ("crop", scene.crop.is_some()),
        ("shading.blend_mode", scene.shading.blend_mode != BlendMode::Composite),
        ("isosurface", !scene.isosurface.is_empty()),
    ];
    refuse(&of_volumes, "it is of volumes, and the picture shows a mesh", "or show a volume")?;
    if !mirrors {
        check_no_mirror(scene)?;
    }
    if opaque_bodies {
        check_materials(scene)?;
    } else {
        check_clear(scene)?;
    }
    check_dispersing(scene)?;
    if volumes {
        let given = [("transfer", scene.transfer != TransferFunction::default())];
        refuse(&given, "a mesh has no scalar, and `mesh` is given", "and say in `material` what bodies are made of")?;
    }
    Ok(())
}

/// Refuses mirrors.
fn check_no_mirror(scene: &Scene) -> Result<(), Fault> {
    match scene.material.iter().position(|material| material.mirror) {
        None => Ok(()),
        Some(index) => Err(Fault::contradiction(
            &format!("material.{index}.mirror"),
            format!("the method `{}` renders no mirrors", scene.method.as_str()),
            advised(|shows| shows.mirrors, "make the material clear"),
        )),
    }
}

/// The advice to take a method that renders what `part` picks, or else to do without.
fn advised(part: impl Fn(Capabilities) -> bool, otherwise: &str) -> String {
    match MethodName::that_renders(part) {
        Some(method) => format!("set `method = \"{}\"`, or {otherwise}", method.as_str()),
        None => otherwise.to_owned(),
    }
}

/// Refuses opaque bodies.
fn check_clear(scene: &Scene) -> Result<(), Fault> {
    match scene.material.iter().position(|material| material.opaque) {
        None => Ok(()),
        Some(index) => Err(Fault::contradiction(
            &format!("material.{index}.opaque"),
            format!("the method `{}` shows clear bodies of a mesh, and this one is opaque", scene.method.as_str()),
            advised(|shows| shows.opaque_bodies, "make the material clear"),
        )),
    }
}

/// A body is either diffuse or a mirror, and only one of these has a colour.
fn check_materials(scene: &Scene) -> Result<(), Fault> {
    if let Some(index) = scene.material.iter().position(|material| material.mirror && material.opaque) {
        return Err(Fault::contradiction(
            &format!("material.{index}.mirror"),
            "the material is given as diffuse by `opaque` and as a mirror",
            "leave one of them out; a mirror is opaque without saying so",
        ));
    }
    let clear = |material: &Material| !material.opaque && !material.mirror;
    match scene.material.iter().position(|material| material.color.is_some() && clear(material)) {
        None => Ok(()),
        Some(index) => Err(Fault::contradiction(
            &format!("material.{index}.color"),
            "it is the colour of an opaque body, and the material is clear",
            format!("set `material.{index}.opaque = true`, or give a clear material an `attenuation_color`"),
        )),
    }
}

/// Only clear bodies disperse.
fn check_dispersing(scene: &Scene) -> Result<(), Fault> {
    for (index, material) in scene.material.iter().enumerate() {
        let kind = match (material.opaque, material.mirror) {
            (false, false) => continue,
            (_, true) => "a mirror",
            (true, false) => "opaque",
        };
        for (name, given) in [("abbe", material.abbe), ("cauchy_b", material.cauchy_b)] {
            if given.is_some() {
                return Err(Fault::contradiction(
                    &format!("material.{index}.{name}"),
                    format!("it is the dispersion of a clear body, and the material is {kind}"),
                    "leave it out, or make the material clear",
                ));
            }
        }
    }
    Ok(())
}

/// An index of refraction has one measure of dispersion; `key` is the table of both.
fn check_dispersion(key: &str, abbe: Option<f32>, cauchy_b: Option<f32>) -> Result<(), Fault> {
    if abbe.is_none() || cauchy_b.is_none() {
        return Ok(());
    }
    Err(Fault::contradiction(&format!("{key}.abbe"), "both `abbe` and `cauchy_b` are given", "leave one of them out"))
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

/// A crop box has an inside.
fn check_crop(crop: &Crop) -> Result<(), Fault> {
    let Crop { min, max } = *crop;
    match (0..3).find(|&axis| min[axis] >= max[axis]) {
        None => Ok(()),
        Some(axis) => Err(Fault::contradiction(
            &format!("crop.max.{axis}"),
            format!("{} is not above `crop.min.{axis}`, which is {}, so that nothing is left", max[axis], min[axis]),
            "make it larger",
        )),
    }
}

/// A direction may have any length that survives being squared in f32.
fn check_direction(key: &str, direction: Vector) -> Result<(), Fault> {
    let length = direction.iter().fold(0.0, |length, &component| libm::hypot(length, f64::from(component)));
    if (1e-15..=1e15).contains(&length) {
        return Ok(());
    }
    Err(Fault::contradiction(
        key,
        format!("{direction:?} is {length} long and gives no direction"),
        "give a vector whose length is from 1e-15 to 1e15, such as one of length 1",
    ))
}

fn check_light(key: &str, light: &Light) -> Result<(), Fault> {
    let kind = light.kind.name();
    light.direction.map_or(Ok(()), |direction| check_direction(&format!("{key}.direction"), direction))?;
    if let Some(foreign) = light.foreign_key() {
        return Err(Fault::contradiction(
            &format!("{key}.{foreign}"),
            format!("a {kind} light has no `{foreign}`"),
            format!("leave it out, or set another `{key}.kind`"),
        ));
    }
    if light.kind != LightKind::Distant && light.position.is_none() {
        return Err(Fault::contradiction(
            key,
            format!("a {kind} light needs a `position`, and none is given"),
            format!("give it one, such as `{key}.position = [0, 0, 100]`"),
        ));
    }
    Ok(())
}

/// The lights that the scene's method has.
fn check_lights_of_method(scene: &Scene) -> Result<(), Fault> {
    if scene.method != MethodName::Sweep {
        return Ok(());
    }
    let on_texels = scene.sweep.light == Transport::Texels;
    for (index, light) in scene.light.iter().enumerate() {
        let kind = light.kind.name();
        if on_texels && light.kind != LightKind::Distant {
            return Err(Fault::contradiction(
                &format!("light.{index}.kind"),
                format!("a sweep carries distant lights alone on texels, and this is a {kind} light"),
                format!("set `sweep.light = \"forward\"`, or `light.{index}.kind = \"distant\"`"),
            ));
        }
        if light.texture.is_some() {
            return Err(Fault::contradiction(
                &format!("light.{index}.texture"),
                "spots project no pictures in a sweep".to_owned(),
                "leave it out, or show a mesh by the method `voxels`".to_owned(),
            ));
        }
    }
    Ok(())
}

fn check_sweep(sweep: &Sweep) -> Result<(), Fault> {
    if sweep.light == Transport::Forward && sweep.intensity != Intensity::Jacobian {
        return Err(Fault::contradiction(
            "sweep.intensity",
            "there is nothing to correct where `sweep.light` is `forward`: it conserves flux by itself",
            "leave `sweep.intensity` out, or set `sweep.light = \"texels\"`",
        ));
    }
    Ok(())
}

fn check_transfer(transfer: &TransferFunction) -> Result<(), Fault> {
    for (index, point) in transfer.ior.iter().enumerate() {
        check_dispersion(&format!("transfer.ior.{index}"), point.abbe, point.cauchy_b)?;
    }
    check_sorted("transfer.color", "value", transfer.color.iter().map(|point| point.value))?;
    check_sorted("transfer.opacity", "value", transfer.opacity.iter().map(|point| point.value))?;
    check_sorted("transfer.ior", "value", transfer.ior.iter().map(|point| point.value))?;
    check_sorted("transfer.filter", "value", transfer.filter.iter().map(|point| point.value))?;
    transfer.gradient.iter().enumerate().try_for_each(|(index, function)| check_gradient(index, function))
}

/// Refuses a function of the gradient whose numbers are in no order.
fn check_gradient(index: usize, function: &GradientFunction) -> Result<(), Fault> {
    let key = format!("transfer.gradient.{index}");
    if let Some([low, high]) = function.values
        && low > high
    {
        let problem = format!("the values from {low} to {high} are none");
        return Err(Fault::contradiction(&format!("{key}.values"), problem, "give the smaller one first"));
    }
    let magnitudes = function.opacity.iter().map(|point| point.magnitude);
    check_sorted(&format!("{key}.opacity"), "magnitude", magnitudes)
}

fn check_sorted(key: &str, name: &str, values: impl Iterator<Item = f32>) -> Result<(), Fault> {
    let mut previous = f32::NEG_INFINITY;
    for (index, value) in values.enumerate() {
        if value < previous {
            return Err(Fault::contradiction(
                &format!("{key}.{index}.{name}"),
                format!("{value} comes after {previous}"),
                format!("sort the points by `{name}`; two points at the same place make a step"),
            ));
        }
        previous = value;
    }
    Ok(())
}

fn check_film(scene: &Scene) -> Result<(), Fault> {
    let Film { width, height, supersampling, .. } = scene.film;
    // Those pictures come in parts.
    if scene.method == MethodName::Sweep && scene.sweep.light == Transport::Forward {
        return Ok(());
    }
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
