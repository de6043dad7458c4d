//! `mip`: the largest value of each ray in shades of grey, as radiologists look at vessels.

use super::subject::{Subject, opacity};
use super::{Preset, colormap};
use crate::scene::{BlendMode, Environment, EnvironmentKind, Scene, Shading, TransferFunction};

pub(super) const PRESET: Preset =
    Preset::fitted("mip", "the largest value on each ray in shades of grey (maximum intensity projection)", apply);

fn apply(subject: &Subject, scene: &mut Scene) {
    let Subject { air, surface, bright, reference_length, .. } = *subject;
    scene.transfer = TransferFunction {
        reference_length: Some(reference_length),
        color: colormap::points("gray", [air, bright]).unwrap_or_default(),
        // Where there is nothing but air, the background is seen.
        opacity: vec![opacity(air, 0.0), opacity(subject.between(air, surface, 0.5), 1.0)],
        ior: Vec::new(),
        filter: Vec::new(),
        ..TransferFunction::default()
    };
    scene.light = Vec::new();
    scene.shading = Shading { blend_mode: BlendMode::Maximum, ..Shading::default() };
    scene.environment = Environment { kind: EnvironmentKind::Color, color: [0.0; 3], ..Environment::default() };
    scene.ground = None;
    scene.wall = None;
}
