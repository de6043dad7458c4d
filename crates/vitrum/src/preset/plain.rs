//! `plain`: coloured, lit surfaces, as volume rendering has always shown them.

use super::Preset;
use super::subject::{Subject, color, opacity};
use crate::scene::{Environment, Ground, Light, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset::fitted("plain", "coloured opaque surfaces with soft shadows; no refraction", apply);

fn apply(subject: &Subject, scene: &mut Scene) {
    let Subject { air, surface, soft, dense, bright, reference_length, .. } = *subject;
    scene.transfer = TransferFunction {
        reference_length: Some(reference_length),
        color: vec![
            color(surface, [0.56, 0.25, 0.14]),
            color(soft, [0.72, 0.42, 0.25]),
            color(dense, [0.85, 0.74, 0.55]),
            color(bright, [0.92, 0.90, 0.84]),
        ],
        opacity: vec![
            opacity(subject.between(air, surface, 0.5), 0.0),
            opacity(surface, 0.4),
            opacity(soft, 0.5),
            opacity(dense, 0.6),
        ],
        ior: Vec::new(),
        filter: Vec::new(),
        ..TransferFunction::default()
    };
    scene.light = vec![Light { angular_radius: 4.0, ..Light::default() }];
    // Without indices of refraction there is no Fresnel reflection to make rough.
    scene.shading = Shading { ambient: [0.08, 0.085, 0.1], ..Shading::default() };
    scene.environment = Environment::default();
    scene.ground = Some(Ground::default());
    scene.wall = None;
}
