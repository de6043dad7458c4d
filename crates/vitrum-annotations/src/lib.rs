//! Annotations over a finished picture: scale bar, legend, caption, mark of orientation, bounding box and axes.
//!
//! [`Overlay::new`] makes one SVG document of the scene's annotations, its camera and the picture's size. The document is what
//! `vitrum render --annotations` writes; [`Overlay::draw`] draws the same one over a picture, with a font that the program brings along.

mod axes;
mod bounding_box;
mod canvas;
mod caption;
mod draw;
mod font;
mod legend;
mod orientation;
mod scale_bar;
mod screen;
mod sheet;
mod style;
mod unit;

pub use scale_bar::round_length;
pub use screen::{file_picture, is_of_screens, is_opaque, layers_of, screen_picture};
pub use sheet::{Tile, contact_sheet};

use canvas::Canvas;
use style::Style;
use vitrum::method::{Bounds, View};
use vitrum::scene::{Annotation, AnnotationKind, OrientationStyle, Scene};
use vitrum::{Assets, Subject, framed};

/// Why annotations cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AnnotationError {
    /// A legend for a mesh, or for a volume without colours.
    #[error("annotation.{index}: {problem}")]
    NotPossible {
        /// Index of the annotation in the scene.
        index: usize,
        /// The problem.
        problem: String,
        /// Advice: a sentence that says how to mend it.
        advice: String,
    },
    /// The document was not understood by the program's own drawing.
    #[error("the annotations cannot be drawn: {0}")]
    Drawing(String),
}

impl AnnotationError {
    /// Advice: a sentence that says how to mend it.
    #[must_use]
    pub fn advice(&self) -> String {
        match self {
            Self::NotPossible { advice, .. } => advice.clone(),
            Self::Drawing(_) => "leave `annotation` out".to_owned(),
        }
    }
}

/// A picture's annotations.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    svg: String,
    notes: Vec<String>,
}

/// What annotations are made of.
struct Job<'a> {
    scene: &'a Scene,
    subject: &'a Subject,
    view: View,
    bounds: Bounds,
    /// Pixels across and down.
    size: [f64; 2],
}

impl Overlay {
    /// The annotations of a scene; `None` if it has none.
    ///
    /// # Errors
    /// [`AnnotationError::NotPossible`] for a legend of what has no transfer function.
    pub fn new(scene: &Scene, subject: &Subject) -> Result<Option<Self>, AnnotationError> {
        if scene.annotation.is_empty() {
            return Ok(None);
        }
        let bounds = Bounds::from(subject);
        let size = [scene.film.width, scene.film.height].map(f64::from);
        let job = Job { scene, subject, view: View::new(scene, bounds), bounds, size };
        let mut canvas = Canvas::new(size);
        for (index, annotation) in scene.annotation.iter().enumerate() {
            let refuse = |(problem, advice): (String, String)| AnnotationError::NotPossible { index, problem, advice };
            add(&job, annotation, &mut canvas).map_err(refuse)?;
        }
        let (svg, notes) = canvas.finish();
        Ok(Some(Self { svg, notes }))
    }

    /// The annotations of a scene where the camera of its picture sees their places; `None` if it has none, and then the data is not looked at.
    ///
    /// # Errors
    /// As [`Self::new`] and [`vitrum::framed`].
    pub fn framed<E: From<vitrum::Error> + From<AnnotationError>>(
        scene: &Scene,
        assets: &Assets,
    ) -> Result<Option<Self>, E> {
        if scene.annotation.is_empty() {
            return Ok(None);
        }
        Ok(Self::new(&framed(scene, assets)?, &assets.subject)?)
    }

    /// The SVG document, of the picture's size in pixels.
    #[must_use]
    pub fn svg(&self) -> &str {
        &self.svg
    }

    /// What a reader of the picture should know, such as where a scale bar holds; sentences.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }
}

/// A problem, and advice.
type Refusal = (String, String);

fn add(job: &Job<'_>, annotation: &Annotation, canvas: &mut Canvas) -> Result<(), Refusal> {
    let style = Style::new(job, annotation);
    match annotation.kind {
        AnnotationKind::ScaleBar => scale_bar::add(job, annotation, &style, canvas),
        AnnotationKind::Legend => legend::add(job, annotation, &style, canvas)?,
        AnnotationKind::Caption => caption::add(annotation, &style, canvas),
        AnnotationKind::Orientation => match annotation.style {
            Some(OrientationStyle::Cube) => orientation::add_cube(job, annotation, &style, canvas),
            Some(OrientationStyle::Letters) | None => orientation::add_letters(job, annotation, &style, canvas),
        },
        AnnotationKind::BoundingBox => bounding_box::add(job, &style, canvas),
        AnnotationKind::Axes => axes::add(job, annotation, &style, canvas),
    }
    Ok(())
}
