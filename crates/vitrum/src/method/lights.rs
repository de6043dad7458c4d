//! Frames with several lights: light adds up, so that such a frame is the sum of frames with one light each.

use super::sources::sources;
use super::view::light::travels;
use super::{Exposure, Part, View};
use crate::scene::{Attachment, Light, Scene};

/// The exposures of a scene: the first has the first light and everything else that shines, each further one a further light alone.
pub(super) fn exposures(scene: &Scene) -> Vec<Exposure> {
    let (first, others) = match scene.light.split_first() {
        Some((first, others)) => (vec![first.clone()], others),
        None => (Vec::new(), &[][..]),
    };
    let whole = Exposure::whole(Scene { light: first, ..scene.clone() });
    let shining = others.iter().filter(|light| !is_black(light));
    let alone = |light: &Light| Exposure { part: Part::Light, ..Exposure::whole(alone(scene, light)) };
    std::iter::once(whole).chain(shining.map(alone)).collect()
}

/// The scene with crisp lights instead of soft ones: each distant light that casts soft shadows becomes `shadow.samples` lights,
/// spread over its disc, that have its strength together.
pub(super) fn crisp(scene: &Scene, view: &View) -> Scene {
    let count = scene.shadow.samples;
    let split = |light: &Light| match travels(light, view) {
        Ok(direction) if count > 1 && light.shadows && light.angular_radius > 0.0 && !is_black(light) => {
            let sample = |towards: [f32; 3]| {
                let world = view.axes * glam::Vec3::from_array(towards).as_dvec3();
                Light {
                    attachment: Some(Attachment::World),
                    direction: Some(world.as_vec3().to_array()),
                    intensity: light.intensity / count as f32,
                    ..light.clone()
                }
            };
            sources(direction, light.angular_radius, count).into_iter().map(sample).collect()
        }
        _ => vec![light.clone()],
    };
    Scene { light: scene.light.iter().flat_map(split).collect(), ..scene.clone() }
}

/// A scene in which nothing shines but one of its lights. It keeps the environment's kind, so that a map of it stays where it is.
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
            let exposures = exposures(&with(intensities));
            let found: Vec<_> =
                exposures.iter().map(|one| one.scene.light.first().map(|light| light.intensity)).collect();
            assert_eq!(found, expected);
            assert!(exposures.iter().all(|one| one.scene.light.len() < 2));
            let [first, others @ ..] = &exposures[..] else { panic!("there is always a first") };
            assert!(first.part == Part::Whole && first.scene.shading == Scene::default().shading);
            for other in others {
                assert!(other.part == Part::Light && other.scene.shading.ambient == [0.0; 3]);
                assert_eq!(other.scene.environment.intensity, 0.0);
            }
        }
    }
}
