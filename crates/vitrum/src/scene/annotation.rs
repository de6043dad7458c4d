//! Annotations: what is drawn over the finished picture.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The kind of an annotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AnnotationKind {
    /// A bar of a round length; in perspective it holds at the depth of the camera's target.
    #[default]
    ScaleBar,
    /// The colours of the transfer function over the scalar, and its opacity as a curve.
    Legend,
    /// A text.
    Caption,
    /// Directions of the patient, or of the world's axes where the volume is no patient's.
    Orientation,
    /// The edges of the box around the volume or mesh; those behind it are dashed.
    BoundingBox,
    /// The directions of the world's axes x, y and z, as arrows.
    Axes,
}

impl AnnotationKind {
    /// Name of the kind, for messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::ScaleBar => "scale bar",
            Self::Legend => "legend",
            Self::Caption => "caption",
            Self::Orientation => "mark of orientation",
            Self::BoundingBox => "bounding box",
            Self::Axes => "cross of axes",
        }
    }
}

/// The place in the picture that an annotation hangs on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Anchor {
    /// The upper left corner.
    TopLeft,
    /// The middle of the upper edge.
    Top,
    /// The upper right corner.
    TopRight,
    /// The middle of the left edge.
    Left,
    /// The middle of the picture.
    Center,
    /// The middle of the right edge.
    Right,
    /// The lower left corner.
    BottomLeft,
    /// The middle of the lower edge.
    Bottom,
    /// The lower right corner.
    BottomRight,
}

impl Anchor {
    /// The place as shares of the picture's width, from the left, and of its height, from the top: 0, ½ or 1.
    #[must_use]
    pub fn share(self) -> [f64; 2] {
        let x = match self {
            Self::TopLeft | Self::Left | Self::BottomLeft => 0.0,
            Self::Top | Self::Center | Self::Bottom => 0.5,
            Self::TopRight | Self::Right | Self::BottomRight => 1.0,
        };
        let y = match self {
            Self::TopLeft | Self::Top | Self::TopRight => 0.0,
            Self::Left | Self::Center | Self::Right => 0.5,
            Self::BottomLeft | Self::Bottom | Self::BottomRight => 1.0,
        };
        [x, y]
    }
}

/// The form of a mark of orientation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OrientationStyle {
    /// Letters at the picture's four edges.
    Letters,
    /// A cube with a letter on each face.
    Cube,
}

/// Something that is drawn over the finished picture: `kind` says what.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Annotation {
    /// Kind of the annotation.
    pub kind: AnnotationKind,
    /// Place in the picture. If absent: `bottom_right` for a scale bar, `right` for a legend, `bottom` for a caption, `bottom_left` for a cube and
    /// for axes. Letters and a bounding box have their places.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub anchor: Option<Anchor>,
    /// Shift from there to the right and downwards.
    #[schemars(inner(range(min = -200, max = 200)), extend("x-unit" = "percent of the picture's height"))]
    pub offset: [f32; 2],
    /// The words: of a caption, `\n` between lines; the heading of a legend; of a scale bar instead of its length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a text"))]
    pub text: Option<String>,
    /// Size of the letters.
    #[schemars(range(min = 0.5, max = 50), extend("x-unit" = "percent of the picture's height"))]
    pub size: f32,
    /// Width of lines, and of the edge around letters.
    #[schemars(range(min = 0.01, max = 10), extend("x-unit" = "percent of the picture's height"))]
    pub line_width: f32,
    /// Colour of letters and lines, as on the screen: a name, `#rgb` or `#rrggbb`. If absent: black where the scene's `background` is bright, else white
    /// with a dark edge.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a colour"))]
    pub color: Option<String>,
    /// Colour of a plate behind it; `#rrggbbaa` lets the picture through.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a colour"))]
    pub background: Option<String>,
    /// Length of a scale bar; the longest of 1, 2 or 5 times a power of ten that takes no more than a quarter of the picture's width if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-unit" = "world units", "exclusiveMinimum" = 0))]
    pub length: Option<f32>,
    /// Unit of length of the world, for a scale bar. If absent: mm where the volume's file gives lengths, none where it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("x-range" = "a text"))]
    pub unit: Option<String>,
    /// Height of a legend, edge of a cube, or length of axes; 40 for a legend and 9 for others if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 100), extend("x-unit" = "percent of the picture's height"))]
    pub extent: Option<f32>,
    /// Form of a mark of orientation; `letters` if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub style: Option<OrientationStyle>,
}

impl Default for Annotation {
    fn default() -> Self {
        Self {
            kind: AnnotationKind::ScaleBar,
            anchor: None,
            offset: [0.0; 2],
            text: None,
            size: 3.5,
            line_width: 0.4,
            color: None,
            background: None,
            length: None,
            unit: None,
            extent: None,
            style: None,
        }
    }
}

impl Annotation {
    /// The first key that is given and that annotations of this kind do not have.
    #[must_use]
    pub fn foreign_key(&self) -> Option<&'static str> {
        use AnnotationKind as Kind;
        let kind = self.kind;
        let is = |kinds: &[Kind]| kinds.contains(&kind);
        let letters = kind == Kind::Orientation && self.style != Some(OrientationStyle::Cube);
        let given = [
            ("anchor", self.anchor.is_some() && (letters || kind == Kind::BoundingBox)),
            ("text", self.text.is_some() && !is(&[Kind::ScaleBar, Kind::Legend, Kind::Caption])),
            ("background", self.background.is_some() && (letters || kind == Kind::BoundingBox)),
            ("length", self.length.is_some() && kind != Kind::ScaleBar),
            ("unit", self.unit.is_some() && kind != Kind::ScaleBar),
            ("extent", self.extent.is_some() && (letters || is(&[Kind::ScaleBar, Kind::Caption, Kind::BoundingBox]))),
            ("style", self.style.is_some() && kind != Kind::Orientation),
        ];
        given.into_iter().find(|(_, foreign)| *foreign).map(|(key, _)| key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_of_another_kind_are_foreign() {
        let length = |kind| Annotation { kind, length: Some(1.0), ..Annotation::default() }.foreign_key();
        assert_eq!(length(AnnotationKind::ScaleBar), None);
        assert_eq!(length(AnnotationKind::Legend), Some("length"));
        let extent = |style| {
            let kind = AnnotationKind::Orientation;
            Annotation { kind, style, extent: Some(10.0), ..Annotation::default() }.foreign_key()
        };
        assert_eq!([extent(None), extent(Some(OrientationStyle::Cube))], [Some("extent"), None]);
    }
}
