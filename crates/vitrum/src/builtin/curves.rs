//! Shorthand for transfer functions and scenes.

use crate::scene::{ColorPoint, IorPoint, OpacityPoint, Rgb, VolumeSource};

/// Colours (of particles or of the medium) at scalar values.
pub(super) fn colors<const N: usize>(points: [(f32, Rgb); N]) -> Vec<ColorPoint> {
    points.map(|(value, color)| ColorPoint { value, color }).to_vec()
}

/// Opacities at scalar values.
pub(super) fn opacities<const N: usize>(points: [(f32, f32); N]) -> Vec<OpacityPoint> {
    points.map(|(value, opacity)| OpacityPoint { value, opacity }).to_vec()
}

/// Indices of refraction at scalar values.
pub(super) fn iors<const N: usize>(points: [(f32, f32); N]) -> Vec<IorPoint> {
    points.map(|(value, ior)| IorPoint::new(value, ior)).to_vec()
}

/// The procedural volume of that name, at its default resolution.
pub(super) fn procedural(name: &str) -> VolumeSource {
    VolumeSource { builtin: Some(name.to_owned()), ..VolumeSource::default() }
}
