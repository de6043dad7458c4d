//! `glass`: everything clear; shape shows by refraction and reflection alone.

use super::Preset;
use super::subject::{Subject, color, ior, opacity, tint};
use crate::scene::{Environment, EnvironmentKind, Light, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset { name: "glass", description: "everything clear and refracting, before a checkerboard", apply };

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
            ior(subject.between(surface, soft, 0.5), subject.index(0.25)),
            ior(subject.between(soft, dense, 0.5), subject.index(0.25)),
            ior(bright, subject.index(0.4)),
        ],
        medium: vec![color(air, [1.0; 3]), color(surface, body)],
    };
    scene.light = Light { softness: 0.5, intensity: 1.2, ..Light::default() };
    scene.shading = Shading { roughness: 0.06, ..Shading::default() };
    // Squares show the bending of rays; their contrast is low enough to leave the body in front.
    scene.environment = Environment {
        kind: EnvironmentKind::Checkerboard,
        color: [0.34, 0.40, 0.48],
        horizon: [0.86, 0.88, 0.90],
        square: 4.0,
        ..Environment::default()
    };
    // A ground would hide the squares up to the horizon.
    scene.ground = None;
    scene.wall = None;
}
