//! `glass`: everything clear; shape shows by refraction and reflection alone.

use super::Preset;
use super::subject::{Subject, color, ior, opacity, tint};
use crate::scene::{Environment, EnvironmentKind, Light, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset::fitted("glass", "everything clear and refracting, before a bright horizon", apply);

fn apply(subject: &Subject, scene: &mut Scene) {
    let Subject { air, surface, soft, dense, bright, reference_length, .. } = *subject;
    // White light that has crossed half of the volume, 128 layers, is this green.
    let body = tint([0.80, 0.93, 0.87], 128.0);
    scene.transfer = TransferFunction {
        reference_length: Some(reference_length),
        color: Vec::new(),
        // An empty list would be a ramp of opacity.
        opacity: vec![opacity(surface, 0.0)],
        ior: vec![
            ior(air, 1.0),
            ior(subject.between(surface, soft, 0.5), subject.index(0.14)),
            ior(subject.between(soft, dense, 0.5), subject.index(0.14)),
            ior(bright, subject.index(0.2)),
        ],
        filter: vec![color(air, [1.0; 3]), color(surface, body)],
        ..TransferFunction::default()
    };
    scene.light = vec![Light { angular_radius: 0.5, intensity: 1.2, ..Light::default() }];
    scene.shading = Shading { roughness: 0.06, ..Shading::default() };
    // A clear body shows by what it mirrors and bends into view: a bright band between two dark ones.
    scene.environment = Environment {
        kind: EnvironmentKind::Gradient,
        color: [0.08, 0.16, 0.30],
        horizon: [0.95, 0.96, 0.97],
        nadir: [0.05, 0.045, 0.04],
        ..Environment::default()
    };
    // A ground would hide the dark below the horizon.
    scene.ground = None;
    scene.wall = None;
}
