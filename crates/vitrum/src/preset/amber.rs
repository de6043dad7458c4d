//! `amber`: opaque dense matter, embedded in a clear, yellow, refracting body (sweep, Figs. 1 and 9).

use super::Preset;
use super::subject::{Subject, color, ior, opacity, tint};
use crate::scene::{Environment, EnvironmentKind, Ground, Light, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset::fitted("amber", "opaque dense matter inside a yellow, clear, refracting body", apply);

fn apply(subject: &Subject, scene: &mut Scene) {
    let Subject { air, surface, soft, dense, bright, reference_length, .. } = *subject;
    // White light that has crossed half of the volume, 128 layers, is this yellow.
    let body = tint([0.92, 0.56, 0.09], 128.0);
    scene.transfer = TransferFunction {
        reference_length: Some(reference_length),
        color: vec![
            color(soft, [0.70, 0.42, 0.22]),
            color(dense, [0.86, 0.74, 0.54]),
            color(bright, [0.94, 0.90, 0.80]),
        ],
        opacity: vec![
            opacity(subject.between(soft, dense, 0.6), 0.0),
            opacity(dense, 0.3),
            opacity(subject.between(dense, bright, 0.5), 0.8),
        ],
        // Flat where the tissue lies, so that its noise does not scatter rays.
        ior: vec![
            ior(air, 1.0),
            ior(subject.between(surface, soft, 0.5), subject.index(0.14)),
            ior(subject.between(soft, dense, 0.5), subject.index(0.15)),
            ior(bright, subject.index(0.25)),
        ],
        filter: vec![color(air, [1.0; 3]), color(surface, body)],
        ..TransferFunction::default()
    };
    scene.light = vec![Light { angular_radius: 1.5, intensity: 1.1, ..Light::default() }];
    scene.shading = Shading { roughness: 0.15, ambient: [0.18, 0.17, 0.16], ..Shading::default() };
    // Bright behind and above: a clear body shows by what passes through it.
    scene.environment = Environment {
        kind: EnvironmentKind::Gradient,
        color: [0.55, 0.66, 0.80],
        horizon: [0.92, 0.93, 0.94],
        nadir: [0.50, 0.47, 0.44],
        ..Environment::default()
    };
    scene.ground = Some(Ground { height: None, color: [0.75, 0.75, 0.75], ..Ground::default() });
    scene.wall = None;
}
