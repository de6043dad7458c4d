//! Colours as people write them: a name, or sRGB in hexadecimal digits.

use super::Rgb;
use vitrum_io::srgb_to_linear;

/// Names of colours, with red, green and blue in sRGB.
const NAMES: [(&str, [u8; 3]); 17] = [
    ("black", [0, 0, 0]),
    ("white", [255, 255, 255]),
    ("gray", [128, 128, 128]),
    ("grey", [128, 128, 128]),
    ("silver", [192, 192, 192]),
    ("red", [255, 0, 0]),
    ("green", [0, 128, 0]),
    ("lime", [0, 255, 0]),
    ("blue", [0, 0, 255]),
    ("navy", [0, 0, 128]),
    ("yellow", [255, 255, 0]),
    ("orange", [255, 165, 0]),
    ("cyan", [0, 255, 255]),
    ("teal", [0, 128, 128]),
    ("magenta", [255, 0, 255]),
    ("purple", [128, 0, 128]),
    ("brown", [165, 42, 42]),
];

/// What a colour can be, for messages.
pub(super) const EXPECTED: &str =
    "a colour: `#rgb`, `#rrggbb`, or a name such as black, white, gray, red, orange, yellow, green, blue, navy";

/// A colour of the screen, in sRGB, with its opacity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Paint {
    /// Red, green and blue in sRGB.
    pub rgb: [u8; 3],
    /// Opacity: 255 is opaque.
    pub alpha: u8,
}

impl Paint {
    /// The colour of a text: a name, `#rgb`, `#rrggbb` or `#rrggbbaa`.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        if let Some((_, rgb)) = NAMES.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)) {
            return Some(Self { rgb: *rgb, alpha: 255 });
        }
        let digits = text.strip_prefix('#')?;
        let digits = digits.chars().map(|digit| digit.to_digit(16).map(|digit| digit as u8));
        match digits.collect::<Option<Vec<_>>>()?.as_slice() {
            [r, g, b] => Some(Self { rgb: [r * 17, g * 17, b * 17], alpha: 255 }),
            [a, b, c, d, e, f] => Some(Self { rgb: [a * 16 + b, c * 16 + d, e * 16 + f], alpha: 255 }),
            [a, b, c, d, e, f, g, h] => Some(Self { rgb: [a * 16 + b, c * 16 + d, e * 16 + f], alpha: g * 16 + h }),
            _ => None,
        }
    }

    /// Linear red, green and blue.
    #[must_use]
    pub fn linear(self) -> Rgb {
        self.rgb.map(|code| srgb_to_linear(f32::from(code) / 255.0))
    }

    /// Relative luminance, 0 to 1.
    #[must_use]
    pub fn luminance(self) -> f32 {
        let [r, g, b] = self.linear();
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }
}

/// What stands behind the picture in place of the environment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Background {
    /// Nothing: the picture has an alpha.
    Transparent,
    /// A colour.
    Color(Paint),
}

impl Background {
    /// The background of a text: `transparent`, or an opaque colour.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        if text.trim().eq_ignore_ascii_case("transparent") {
            return Some(Self::Transparent);
        }
        Paint::parse(text).filter(|paint| paint.alpha == 255).map(Self::Color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_names_or_digits() {
        let rgb = |text| Paint::parse(text).map(|paint| paint.rgb);
        assert_eq!([rgb("white"), rgb("#fff"), rgb("#FFFFFF")], [Some([255; 3]); 3]);
        assert_eq!(rgb("#1f77b4"), Some([0x1f, 0x77, 0xb4]));
        assert_eq!(Paint::parse("#00000080").map(|paint| paint.alpha), Some(0x80));
        for wrong in ["", "#", "#12", "#12345", "whit", "1f77b4", "#gggggg", "#ééé"] {
            assert_eq!(rgb(wrong), None, "{wrong}");
        }
        assert!((Paint::parse("white").map_or(0.0, Paint::luminance) - 1.0).abs() < 1e-5);
        assert_eq!(Background::parse("transparent"), Some(Background::Transparent));
        assert_eq!(Background::parse("#00000080"), None, "a background is opaque, or not there");
    }
}
