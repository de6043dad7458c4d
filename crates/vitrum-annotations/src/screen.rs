//! A frame as a screen shows it.

use crate::{AnnotationError, Overlay};
use std::path::Path;
use vitrum::io::Picture;
use vitrum::{Frame, Layers};

/// Formats of the screen, whose pictures are annotated.
const OF_SCREENS: [&str; 6] = ["png", "apng", "jpg", "jpeg", "gif", "mp4"];

/// Formats of the screen without an alpha.
const OPAQUE: [&str; 3] = ["jpg", "jpeg", "mp4"];

fn is_one_of(file: &Path, extensions: &[&str]) -> bool {
    file.extension().is_some_and(|own| extensions.iter().any(|extension| own.eq_ignore_ascii_case(extension)))
}

/// Whether a file's format is one of the screen, in 8 bits or 16 by the curve of sRGB; the others are linear.
#[must_use]
pub fn is_of_screens(file: &Path) -> bool {
    is_one_of(file, &OF_SCREENS)
}

/// Whether a file's format is one of the screen without an alpha.
#[must_use]
pub fn is_opaque(file: &Path) -> bool {
    is_one_of(file, &OPAQUE)
}

/// The outputs that the picture in a file has, by the file's format.
#[must_use]
pub fn layers_of(file: &Path) -> Layers {
    if is_one_of(file, &["exr"]) { Layers::ALL } else { Layers::color() }
}

/// The frame's picture as a file gets it: formats of the screen with straight alpha and annotations, others linear and complete.
///
/// # Errors
/// Those of [`Overlay::draw`].
pub fn file_picture(frame: Frame, overlay: Option<&Overlay>, file: &Path) -> Result<Picture, AnnotationError> {
    if is_of_screens(file) {
        screen_picture(frame, overlay, is_opaque(file))
    } else if is_one_of(file, &["tif", "tiff"]) {
        Ok(frame.into_straight_picture())
    } else {
        Ok(frame.into_picture())
    }
}

/// The frame's colour with a straight alpha and the annotations over it; `opaque` for a format without alpha, in which what is clear is black.
///
/// # Errors
/// Those of [`Overlay::draw`].
pub fn screen_picture(frame: Frame, overlay: Option<&Overlay>, opaque: bool) -> Result<Picture, AnnotationError> {
    let mut picture = if opaque { frame.into_picture() } else { frame.into_straight_picture() };
    picture.layers.truncate(1);
    if opaque && let Some(layer) = picture.layers.first_mut() {
        layer.channels.retain(|channel| channel.name != "A");
    }
    overlay.map_or(Ok(()), |overlay| overlay.draw(&mut picture))?;
    Ok(picture)
}
