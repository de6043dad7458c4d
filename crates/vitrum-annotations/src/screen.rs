//! A frame as a screen shows it.

use crate::{AnnotationError, Overlay};
use vitrum::Frame;
use vitrum::io::Picture;

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
