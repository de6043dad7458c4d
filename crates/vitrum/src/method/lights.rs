//! Frames with several lights: light adds up, so that such a frame is the sum of frames with one light each.

use super::environment_lights::environment_lights;
use super::sources::{ball, sources};
use super::view::light::{axis, direction_of_light};
use super::{Bounds, Exposure, Part, View};
use crate::scene::{Attachment, Light, LightKind, Scene};
use glam::DVec3;
use vitrum_io::Picture;

/// The exposures of a scene: the first has the first light and all radiance that is not of a light, each further one has a further
/// light alone: one of the scene, or one in the place of its environment, whose map is `map`.
pub(super) fn exposures(scene: &Scene, map: Option<&Picture>) -> Vec<Exposure> {
    one_each(scene, &scene.light, &environment_lights(scene, map))
}

/// As [`exposures`], with crisp lights instead of soft points and spots. `bounds` are the subject's.
pub(super) fn sweep_exposures(scene: &Scene, map: Option<&Picture>, bounds: Bounds) -> Vec<Exposure> {
    let crisp = |light: &Light| match light.kind {
        LightKind::Distant => vec![light.clone()],
        LightKind::Point | LightKind::Spot => crisp(scene, std::slice::from_ref(light), bounds),
    };
    let own: Vec<Light> = scene.light.iter().flat_map(crisp).collect();
    one_each(scene, &own, &environment_lights(scene, map))
}

/// As [`exposures`], with crisp lights instead of soft ones. `bounds` are the subject's.
pub(super) fn crisp_exposures(scene: &Scene, map: Option<&Picture>, bounds: Bounds) -> Vec<Exposure> {
    let crisp = |lights: &[Light]| crisp(scene, lights, bounds);
    one_each(scene, &crisp(&scene.light), &crisp(&environment_lights(scene, map)))
}

/// The exposures of a scene with these lights of its own and these in the place of its environment.
fn one_each(scene: &Scene, own: &[Light], of_environment: &[Light]) -> Vec<Exposure> {
    let mut scene = scene.clone();
    scene.environment.lights = 0;
    let (first, others) = match own.split_first() {
        // Light that is none throws no shadow, and is not carried.
        Some((first, others)) => (vec![Light { shadows: first.shadows && !is_black(first), ..first.clone() }], others),
        None => (Vec::new(), own),
    };
    let whole = Exposure::whole(Scene { light: first, ..scene.clone() });
    let shining = others.iter().chain(of_environment).filter(|light| !is_black(light));
    let alone = |light: &Light| Exposure { part: Part::Light, ..Exposure::whole(alone(&scene, light)) };
    std::iter::once(whole).chain(shining.map(alone)).collect()
}

/// Crisp lights instead of soft ones: each of `lights` that casts soft shadows becomes `shadow.samples` lights that have its strength
/// together, spread over its disc if it is distant, else over its ball. `bounds` are the subject's.
pub(super) fn crisp(scene: &Scene, lights: &[Light], bounds: Bounds) -> Vec<Light> {
    let view = View::new(scene, bounds);
    let count = scene.shadow.samples;
    let split = |light: &Light| {
        if count < 2 || !light.shadows || is_black(light) {
            return vec![light.clone()];
        }
        let sample = Light { intensity: light.intensity / count as f32, ..light.clone() };
        match light.kind {
            LightKind::Distant => in_directions(&sample, count, &view),
            LightKind::Point | LightKind::Spot => at_positions(&sample, count, &view, bounds),
        }
        .unwrap_or_else(|| vec![light.clone()])
    };
    lights.iter().flat_map(split).collect()
}

/// Distant lights over the disc of a soft distant light; `None` for a crisp one.
fn in_directions(light: &Light, count: u32, view: &View) -> Option<Vec<Light>> {
    let direction = direction_of_light(light, view).ok().filter(|_| light.angular_radius > 0.0)?;
    let sample = |towards: [f32; 3]| {
        let world = view.axes * glam::Vec3::from_array(towards).as_dvec3();
        let direction = Some(world.as_vec3().to_array());
        Light { attachment: Some(Attachment::World), direction, angular_radius: 0.0, ..light.clone() }
    };
    Some(sources(direction, light.angular_radius, count).into_iter().map(sample).collect())
}

/// Points or spots over the ball of a soft point or spot; `None` for a crisp one.
fn at_positions(light: &Light, count: u32, view: &View, bounds: Bounds) -> Option<Vec<Light>> {
    let position = light.position.filter(|_| light.radius > 0.0)?;
    // All look where the one in the middle does, in the frame of its position.
    let direction = match (light.kind, light.attachment()) {
        (LightKind::Spot, Attachment::World) => Some(axis(light, view, bounds).ok()?),
        (LightKind::Spot, Attachment::Camera) => {
            let seen = view.direction(axis(light, view, bounds).ok()?);
            Some(DVec3::new(seen.x, seen.y, -seen.z))
        }
        _ => None,
    };
    let sample = |offset: DVec3| {
        let at = glam::Vec3::from_array(position).as_dvec3() + offset * f64::from(light.radius);
        Light {
            position: Some(at.as_vec3().to_array()),
            direction: direction.map(|axis| axis.as_vec3().to_array()),
            ..light.clone()
        }
    };
    Some(ball(count).into_iter().map(sample).collect())
}

/// A scene with the radiance of one light alone. It keeps the environment's kind, so that the map of the environment stays on the
/// backend.
fn alone(scene: &Scene, light: &Light) -> Scene {
    let mut scene = Scene { light: vec![light.clone()], ..scene.clone() };
    scene.shading.ambient = [0.0; 3];
    scene.environment.intensity = 0.0;
    scene
}

fn is_black(light: &Light) -> bool {
    light.intensity == 0.0 || light.color == [0.0; 3]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(intensities: &[f32]) -> Scene {
        let light = |&intensity: &f32| Light { intensity, ..Light::default() };
        Scene { light: intensities.iter().map(light).collect(), ..Scene::default() }
    }

    #[test]
    fn each_light_has_an_exposure_and_surroundings_are_in_the_first_alone() {
        for (intensities, expected) in [
            (&[][..], &[None][..]),
            (&[0.0], &[Some(0.0)]),
            (&[1.0, 2.0], &[Some(1.0), Some(2.0)]),
            (&[0.0, 0.0, 3.0], &[Some(0.0), Some(3.0)]),
        ] {
            let exposures = exposures(&with(intensities), None);
            let found: Vec<_> =
                exposures.iter().map(|one| one.scene.light.first().map(|light| light.intensity)).collect();
            assert_eq!(found, expected);
            assert!(exposures.iter().all(|one| one.scene.light.len() < 2));
            let [first, others @ ..] = &exposures[..] else { panic!("there is always a first") };
            let dark = intensities.first() == Some(&0.0);
            assert!(first.scene.light.iter().all(|light| light.shadows != dark));
            assert!(first.part == Part::Whole && first.scene.shading == Scene::default().shading);
            for other in others {
                assert!(other.part == Part::Light && other.scene.shading.ambient == [0.0; 3]);
                assert_eq!(other.scene.environment.intensity, 0.0);
            }
        }
    }
}
