//! `xray`: absorption alone, before a light box.

use super::Preset;
use super::subject::{Subject, color, opacity};
use crate::scene::{ColorPoint, Environment, EnvironmentKind, Light, Rgb, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset::fitted("xray", "absorption alone, as on a light box; the exposure fits the volume's thickness", apply);

/// Optical depth of the thick rays, per colour: blue passes furthest.
const DEPTH: Rgb = [2.7, 2.4, 2.0];

fn apply(subject: &Subject, scene: &mut Scene) {
    scene.transfer = TransferFunction {
        reference_length: Some(subject.reference_length),
        color: Vec::new(),
        // An empty list would be a ramp of opacity.
        opacity: vec![opacity(subject.surface, 0.0)],
        ior: Vec::new(),
        filter: filter(subject),
        ..TransferFunction::default()
    };
    scene.light = vec![Light::default()];
    scene.shading = Shading { specular: 0.0, ..Shading::default() };
    scene.environment =
        Environment { kind: EnvironmentKind::Color, color: [0.88, 0.93, 1.0], ..Environment::default() };
    scene.ground = None;
    scene.wall = None;
}

/// Absorption proportional to density: exponential in the value, in pieces short enough to look smooth.
fn filter(subject: &Subject) -> Vec<ColorPoint> {
    const PIECES: u8 = 8;
    let pieces = 0..=PIECES;
    pieces
        .map(|piece| {
            let density = f32::from(piece) / f32::from(PIECES);
            let value = subject.between(subject.air, subject.bright, density);
            color(value, DEPTH.map(|depth| libm::expf(-density * subject.absorption(depth))))
        })
        .collect()
}
