//! Colours by name or in hexadecimal, such as `white` and `#fff`, wherever a key holds a colour.
//!
//! They are colours of CSS, which are sRGB; the scene holds the linear RGB that they stand for.

use super::schema::{Kind, Shape};
use crate::io::srgb_to_linear;
use toml::{Table, Value};

/// The units of keys that hold colours, where they are lists of three numbers.
pub(super) const UNITS: [&str; 4] = ["radiance", "reflectance", "transmittance", "a share"];

/// Turns the colours that a table holds as texts into linear RGB. A text that is no colour stays, for the check to refuse.
pub(super) fn resolve_table(shape: Shape<'_>, table: &mut Table) {
    for (key, value) in table {
        if let Some(child) = shape.child(key) {
            resolve(child, value);
        }
    }
}

/// As [`resolve_table`], of the value of one key.
pub(super) fn resolve(shape: Shape<'_>, value: &mut Value) {
    match (shape.kind(), &mut *value) {
        (Kind::Table, Value::Table(table)) => resolve_table(shape, table),
        (Kind::List { .. }, Value::String(text)) if shape.is_color() => {
            if let Some(rgb) = linear(text) {
                *value = rgb.map(f64::from).to_vec().into();
            }
        }
        (Kind::List { .. }, Value::Array(items)) => items.iter_mut().for_each(|item| resolve(shape.item(), item)),
        _ => {}
    }
}

/// The linear RGB of a colour of CSS, such as `white` and `#fff`; `None` where the text is none, or one that is not opaque.
#[must_use]
pub fn linear(text: &str) -> Option<[f32; 3]> {
    let color = csscolorparser::parse(text).ok().filter(|color| color.a >= 1.0)?;
    Some([color.r, color.g, color.b].map(|channel| srgb_to_linear(channel.clamp(0.0, 1.0))))
}

#[cfg(test)]
mod tests {
    use super::super::{KeyFrames, Scene};
    use super::linear;

    #[test]
    fn colors_are_those_of_css_in_linear_light() {
        assert_eq!(linear("white"), Some([1.0; 3]));
        assert_eq!(linear("#f00"), Some([1.0, 0.0, 0.0]));
        // IEC 61966-2-1: ((0.5 + 0.055) / 1.055)^2.4 of code 0.5; 128 / 255 is a little above it.
        let grey = linear("#808080").expect("a colour");
        assert!(grey.iter().all(|channel| (channel - 0.215_86).abs() < 1e-5), "{grey:?}");
        for none in ["whitish", "#ff", "rgba(255, 0, 0, 0.5)", "transparent", ""] {
            assert_eq!(linear(none), None, "{none}");
        }
    }

    #[test]
    fn every_way_to_write_a_key_takes_colors() {
        let text = "[volume]\nbuiltin = \"ball\"\n[ground]\ncolor = \"red\"\n[transfer]\ncolor = [{ value = 1, color = \"#00f\" }]\n";
        let mut scene = Scene::from_toml(text, "colors.toml").expect("valid");
        assert_eq!(scene.ground.as_ref().map(|ground| ground.color), Some([1.0, 0.0, 0.0]));
        assert_eq!(scene.transfer.color[0].color, [0.0, 0.0, 1.0]);
        scene.set("light.0.color=white").expect("a name without quotes");
        scene.set("environment.horizon=#000").expect("hexadecimal without quotes");
        assert_eq!((scene.light[0].color, scene.environment.horizon), ([1.0; 3], [0.0; 3]));
        let keys = "[[key]]\nframe = 0\nground.color = \"black\"\n[[key]]\nframe = 2\nground.color = \"white\"\n";
        let keys = KeyFrames::from_toml(keys, "keys.toml", 1.0).expect("valid");
        let grey = keys.at(&scene, 1).expect("valid").ground.expect("a ground").color;
        assert_eq!(grey, [0.5; 3], "half way in linear light");
    }

    #[test]
    fn what_is_no_color_is_refused_with_what_would_be_one() {
        let mut scene = Scene::default();
        let error = scene.set("light.0.color=whitish").expect_err("no colour");
        assert!(error.to_string().contains("or a colour such as \"white\" or \"#fff\""), "{error}");
        scene.set("medium.scattering=white").expect_err("coefficients are no colours");
    }
}
