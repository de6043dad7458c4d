//! Sizes and colours of an annotation, in pixels and as SVG has them.

use crate::Job;
use vitrum::scene::{Anchor, Annotation, AnnotationKind, Background, Paint};

/// Distance of annotations from the picture's edges, over its height.
const MARGIN: f64 = 0.03;

/// Sizes and colours of an annotation.
pub struct Style {
    /// Size of letters, in pixels.
    pub size: f64,
    /// Width of lines, in pixels.
    pub line: f64,
    /// Colour of letters and lines.
    pub ink: Paint,
    /// Colour of the edge around letters and lines; none where the ink stands out by itself.
    pub edge: Option<Paint>,
    /// Colour of the plate behind.
    pub plate: Option<Paint>,
    /// The place to hang on, in shares of the picture's size.
    pub anchor: [f64; 2],
    /// Shift from there, in pixels.
    pub offset: [f64; 2],
    /// Distance from the picture's edges, in pixels.
    pub margin: f64,
}

const BLACK: Paint = Paint { rgb: [0; 3], alpha: 255 };
const WHITE: Paint = Paint { rgb: [255; 3], alpha: 255 };

/// A colour at most so bright takes white letters: where the contrast of both is the same.
const BRIGHT: f32 = 0.18;

impl Style {
    pub fn new(job: &Job<'_>, annotation: &Annotation) -> Self {
        let height = job.size[1];
        let percent = |value: f32| f64::from(value) * 0.01 * height;
        let paint = |text: &Option<String>| text.as_deref().and_then(Paint::parse);
        let plate = paint(&annotation.background);
        let behind = plate.filter(|plate| plate.alpha >= 128).or(
            match job.scene.background.as_deref().and_then(Background::parse) {
                Some(Background::Color(paint)) => Some(paint),
                // Pages are white.
                Some(Background::Transparent) => Some(WHITE),
                None => None,
            },
        );
        let chosen = paint(&annotation.color);
        let ink = chosen.unwrap_or(match behind {
            Some(behind) if behind.luminance() > BRIGHT => BLACK,
            _ => WHITE,
        });
        let contrast = Paint { alpha: 160, ..if ink.luminance() > BRIGHT { BLACK } else { WHITE } };
        let edge = (behind.is_none() && chosen.is_none()).then_some(contrast);
        Self {
            size: percent(annotation.size),
            line: percent(annotation.line_width),
            ink,
            edge,
            plate,
            anchor: annotation.anchor.unwrap_or(usual_anchor(annotation.kind)).share(),
            offset: annotation.offset.map(percent),
            margin: MARGIN * height,
        }
    }
}

fn usual_anchor(kind: AnnotationKind) -> Anchor {
    match kind {
        AnnotationKind::ScaleBar => Anchor::BottomRight,
        AnnotationKind::Legend => Anchor::Right,
        AnnotationKind::Caption => Anchor::Bottom,
        AnnotationKind::Orientation | AnnotationKind::Axes => Anchor::BottomLeft,
        AnnotationKind::BoundingBox => Anchor::Center,
    }
}

/// A colour as SVG has it, without its opacity.
pub fn hex(paint: Paint) -> String {
    let [r, g, b] = paint.rgb;
    format!("#{r:02x}{g:02x}{b:02x}")
}
