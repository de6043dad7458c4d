//! A contact sheet: small pictures in rows, each with its name.

use crate::canvas::{Align, Canvas};
use crate::font::measure;
use crate::style::Style;
use crate::{AnnotationError, Overlay};
use vitrum::io::Picture;
use vitrum::scene::Paint;

/// A small picture of a contact sheet.
#[derive(Debug, Clone)]
pub struct Tile {
    /// The words below it.
    pub label: String,
    /// The picture; all of a sheet have one size.
    pub picture: Picture,
}

/// A sheet of pictures in rows of `columns`, each with its label below, on white, under a heading.
///
/// # Errors
/// [`AnnotationError::Drawing`] where the sheet is too large, or a picture has another size than the first.
pub fn contact_sheet(heading: &str, tiles: &[Tile], columns: usize) -> Result<Picture, AnnotationError> {
    let Some(first) = tiles.first() else { return Ok(Picture::rgb(1, 1, vec![[1.0; 3]])) };
    let [wide, high] = [first.picture.width as usize, first.picture.height as usize];
    if tiles.iter().any(|tile| [tile.picture.width as usize, tile.picture.height as usize] != [wide, high]) {
        return Err(AnnotationError::Drawing("the pictures of a sheet have one size".to_owned()));
    }
    let columns = columns.clamp(1, tiles.len());
    let rows = tiles.len().div_ceil(columns);
    let letters = (high as f64 * 0.07).max(9.0);
    let [gap, label, head] = [(0.5 * letters) as usize, (1.9 * letters) as usize, (2.0 * letters) as usize];
    let size = [columns * (wide + gap) + gap, head + rows * (high + label) + gap];
    let mut pixels = vec![[1.0; 3]; size[0] * size[1]];
    let mut canvas = Canvas::new(size.map(|edge| edge as f64));
    let ink = Paint { rgb: [0; 3], alpha: 255 };
    let style = Style {
        size: letters,
        line: 1.0,
        ink,
        edge: None,
        plate: None,
        anchor: [0.0; 2],
        offset: [0.0; 2],
        margin: 0.0,
    };
    canvas.text(
        &shortened(heading, letters, (size[0] - 2 * gap) as f64),
        [gap as f64, 1.4 * letters],
        Align::Start,
        &style,
    );
    for (index, tile) in tiles.iter().enumerate() {
        let corner = [gap + index % columns * (wide + gap), head + index / columns * (high + label)];
        for (row, line) in tile.picture.color().chunks(wide).enumerate() {
            let start = (corner[1] + row) * size[0] + corner[0];
            pixels[start..start + wide].copy_from_slice(line);
        }
        let middle = corner[0] as f64 + 0.5 * wide as f64;
        canvas.text(&tile.label, [middle, (corner[1] + high) as f64 + 1.2 * letters], Align::Middle, &style);
    }
    let [width, height] = size.map(|edge| edge as u32);
    let (svg, notes) = canvas.finish();
    let mut picture = Picture::rgb(width, height, pixels);
    Overlay { svg, notes }.draw(&mut picture)?;
    Ok(picture)
}

/// As much of the end of a text as has room.
fn shortened(text: &str, size: f64, room: f64) -> String {
    let mut letters: Vec<char> = text.chars().collect();
    while letters.len() > 1 && measure(&letters.iter().collect::<String>(), size).0 > room {
        letters.remove(0);
        letters[0] = '…';
    }
    letters.into_iter().collect()
}
