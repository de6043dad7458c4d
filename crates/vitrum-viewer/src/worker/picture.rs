//! A frame as the window shows it.

use crate::trouble::Trouble;
use vitrum::scene::Scene;
use vitrum::{Assets, Frame};
use vitrum_annotations::{Overlay, screen_picture};

/// A picture for the window: what an 8-bit PNG of `vitrum render` holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shown {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Red, green and blue in sRGB, and a straight alpha; row by row from the top.
    pub pixels: Vec<[u8; 4]>,
}

/// The frame's picture with the scene's annotations over it.
///
/// # Errors
/// Where the annotations cannot be drawn.
pub fn shown(frame: Frame, scene: &Scene, assets: &Assets) -> Result<Shown, Trouble> {
    let size = [frame.width, frame.height];
    let overlay = Overlay::framed::<Trouble>(scene, assets)?;
    let picture = screen_picture(frame, overlay.as_ref(), false)?;
    Ok(Shown { size, pixels: picture.to_srgb8() })
}
