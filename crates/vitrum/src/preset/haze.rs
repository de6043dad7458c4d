//! `haze`: glowing fog, for fields without surfaces.

use super::Preset;
use super::subject::{Subject, color, opacity};
use crate::scene::{Environment, EnvironmentKind, Light, OpacityPoint, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset::fitted("haze", "soft translucent fog, coloured by value; for fields without surfaces", apply);

/// Optical depth of the thick rays.
const DEPTH: f32 = 3.0;

fn apply(subject: &Subject, scene: &mut Scene) {
    let Subject { air, surface, soft, dense, bright, reference_length, .. } = *subject;
    scene.transfer = TransferFunction {
        reference_length: Some(reference_length),
        color: vec![
            color(air, [0.10, 0.26, 0.60]),
            color(surface, [0.22, 0.50, 0.80]),
            color(soft, [0.72, 0.78, 0.80]),
            color(dense, [0.98, 0.70, 0.34]),
            color(bright, [0.96, 0.34, 0.14]),
        ],
        opacity: fog(subject),
        ior: Vec::new(),
        filter: Vec::new(),
        ..TransferFunction::default()
    };
    scene.light = vec![Light { angular_radius: 20.0, intensity: 1.3, ..Light::default() }];
    scene.shading = Shading { specular: 0.0, ambient: [0.22, 0.23, 0.25], ..Shading::default() };
    scene.environment = Environment {
        kind: EnvironmentKind::Gradient,
        color: [0.01, 0.012, 0.02],
        horizon: [0.05, 0.06, 0.08],
        nadir: [0.01, 0.01, 0.012],
        ..Environment::default()
    };
    scene.ground = None;
    scene.wall = None;
}

/// Absorption proportional to density: exponential in the value, in pieces short enough to look smooth.
fn fog(subject: &Subject) -> Vec<OpacityPoint> {
    const PIECES: u8 = 8;
    let absorption = subject.absorption(DEPTH);
    let pieces = 0..=PIECES;
    pieces
        .map(|piece| {
            let density = f32::from(piece) / f32::from(PIECES);
            opacity(subject.between(subject.air, subject.bright, density), 1.0 - libm::expf(-density * absorption))
        })
        .collect()
}
