//! Projections: one scalar of each viewing ray, in place of light.

use crate::scene::{BlendMode, Intensity, Scene, Transport};
use std::borrow::Cow;
use vitrum_kernels::abi::sweep::blend;

/// The [`blend`] of a scene that is a projection.
pub(super) fn blend(scene: &Scene) -> Option<u32> {
    match scene.shading.blend_mode {
        BlendMode::Composite => None,
        BlendMode::Maximum => Some(blend::MAXIMUM),
        BlendMode::Minimum => Some(blend::MINIMUM),
        BlendMode::Mean => Some(blend::MEAN),
    }
}

/// The scene as the sweep shows it: a projection without light, receivers, filter, isosurfaces and refraction.
pub(super) fn as_shown(scene: &Scene) -> Cow<'_, Scene> {
    if blend(scene).is_none() {
        return Cow::Borrowed(scene);
    }
    let mut scene = scene.clone();
    scene.light.clear();
    scene.environment.lights = 0;
    (scene.ground, scene.wall) = (None, None);
    (scene.sweep.light, scene.sweep.intensity, scene.sweep.refraction) =
        (Transport::Forward, Intensity::Jacobian, false);
    scene.transfer.filter.clear();
    scene.isosurface.clear();
    Cow::Owned(scene)
}
