//! `bone`: opaque dense tissue in a faint veil of the tissue around it.

use super::Preset;
use super::subject::{Subject, color, opacity};
use crate::scene::{Environment, EnvironmentKind, Light, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset = Preset::fitted("bone", "dense matter opaque and ivory, the rest a faint veil", apply);

fn apply(subject: &Subject, scene: &mut Scene) {
    let Subject { air, surface, soft, dense, bright, reference_length, .. } = *subject;
    scene.transfer = TransferFunction {
        reference_length: Some(reference_length),
        color: vec![
            color(surface, [0.60, 0.20, 0.13]),
            color(soft, [0.66, 0.26, 0.17]),
            color(dense, [0.82, 0.70, 0.48]),
            color(bright, [0.94, 0.90, 0.80]),
        ],
        opacity: vec![
            opacity(subject.between(air, surface, 0.5), 0.0),
            opacity(surface, 0.003),
            opacity(subject.between(soft, dense, 0.6), 0.004),
            opacity(dense, 0.35),
            opacity(subject.between(dense, bright, 0.5), 0.8),
        ],
        ior: Vec::new(),
        filter: Vec::new(),
        ..TransferFunction::default()
    };
    scene.light = vec![Light { angular_radius: 3.0, ..Light::default() }];
    scene.shading = Shading { ambient: [0.12, 0.12, 0.14], ..Shading::default() };
    // Ivory stands out from dark slate.
    scene.environment = Environment {
        kind: EnvironmentKind::Gradient,
        color: [0.02, 0.025, 0.035],
        horizon: [0.10, 0.12, 0.15],
        nadir: [0.02, 0.02, 0.025],
        ..Environment::default()
    };
    scene.ground = None;
    scene.wall = None;
}
