//! Isosurfaces beside a transfer function.

use super::PresetError;
use crate::scene::piecewise::around;
use crate::scene::{ColorPoint, Isosurface, Rgb, Scene, TransferFunction, parse_color};
use std::str::FromStr;

/// An isosurface that is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Scalar value on the surface.
    pub value: f32,
    /// Reflectance, linear RGB; that which the transfer function has at the value if absent.
    pub color: Option<Rgb>,
    /// Opacity, 0 to 1.
    pub opacity: f32,
}

impl Surface {
    pub(super) fn check(&self) -> Result<(), PresetError> {
        let Self { value, opacity, .. } = *self;
        let problem = if !value.is_finite() {
            format!("the value {value} of an isosurface is not finite")
        } else if !(0.0..=1.0).contains(&opacity) {
            format!("the opacity {opacity} of an isosurface is not from 0 to 1")
        } else {
            return Ok(());
        };
        Err(PresetError::Adjustment { problem })
    }
}

impl FromStr for Surface {
    type Err = String;

    /// The surface of `VALUE[:COLOR[:OPACITY]]`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let expected = || {
            "expected VALUE[:COLOR[:OPACITY]], such as 300, 300:ivory, 300:#fc8:0.4 or 300::0.4, with an opacity from 0 to 1"
                .to_owned()
        };
        let mut parts = text.split(':').map(str::trim);
        let value = parts.next().and_then(|value| value.parse().ok()).filter(|value: &f32| value.is_finite());
        let color = match parts.next() {
            None | Some("") => None,
            Some(name) => Some(parse_color(name).ok_or_else(|| format!("`{name}` is no colour: {}", expected()))?),
        };
        let opacity = parts.next().map_or(Some(1.0), |share| share.parse().ok());
        let opacity = opacity.filter(|opacity: &f32| (0.0..=1.0).contains(opacity));
        match (value, opacity, parts.next()) {
            (Some(value), Some(opacity), None) => Ok(Self { value, color, opacity }),
            _ => Err(expected()),
        }
    }
}

/// Adds isosurfaces to those of the scene.
pub(super) fn add(surfaces: &[Surface], scene: &mut Scene) {
    let colors = scene.transfer.color.clone();
    scene.isosurface.extend(surfaces.iter().map(|&Surface { value, color, opacity }| Isosurface {
        value,
        color: color.unwrap_or_else(|| at(&colors, value)),
        opacity,
    }));
}

/// Empties the transfer function, so that isosurfaces alone are seen.
pub(crate) fn show_alone(scene: &mut Scene) {
    let TransferFunction { color, opacity, ior, filter, .. } = &mut scene.transfer;
    color.clear();
    opacity.clear();
    ior.clear();
    filter.clear();
}

/// The colour of a function at a value; white without points.
fn at(points: &[ColorPoint], value: f32) -> Rgb {
    around(points, value, |point| point.value).map_or([1.0; 3], |(before, next, share)| {
        std::array::from_fn(|channel| before.color[channel] + (next.color[channel] - before.color[channel]) * share)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_are_a_value_a_colour_and_an_opacity() {
        let surface = |value, color, opacity| Ok(Surface { value, color, opacity });
        assert_eq!("300".parse(), surface(300.0, None, 1.0));
        assert_eq!("-20.5:red".parse(), surface(-20.5, Some([1.0, 0.0, 0.0]), 1.0));
        assert_eq!("1e3:#fff:0.25".parse(), surface(1000.0, Some([1.0; 3]), 0.25));
        assert_eq!("1::0".parse(), surface(1.0, None, 0.0));
        for wrong in ["", ":red", "1:reed", "1:red:2", "1:red:-0.1", "1:red:nan", "1:red:0.5:", "nan", "inf"] {
            assert!(wrong.parse::<Surface>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn colours_are_those_of_the_function_unless_given() {
        let mut scene = Scene::default();
        scene.transfer.color =
            [(0.0, [0.0; 3]), (10.0, [1.0; 3])].map(|(value, color)| ColorPoint { value, color }).into();
        let surface = |value| Surface { value, color: None, opacity: 1.0 };
        add(
            &[surface(-1.0), surface(2.5), surface(30.0), Surface { color: Some([0.5; 3]), ..surface(5.0) }],
            &mut scene,
        );
        let found: Vec<f32> = scene.isosurface.iter().map(|surface| surface.color[1]).collect();
        assert_eq!(found, [0.0, 0.25, 1.0, 0.5]);
    }
}
