//! The font: DejaVu Sans, in the binary.

use resvg::usvg::fontdb::{Database, Source};
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};
use std::sync::{Arc, LazyLock};

/// The font's family, with what other programs may take in its place.
pub const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// The family's name in the font.
pub const NAME: &str = "DejaVu Sans";

/// Height of capitals and digits, over the size.
pub const CAPITAL: f64 = 0.729;

/// Height from the lowest to the highest letter, over the size.
pub const LINE: f64 = 1.164;

/// The font alone: none of the system's.
pub static DATABASE: LazyLock<Arc<Database>> = LazyLock::new(|| {
    let mut database = Database::new();
    let font: &'static [u8] = dejavu::sans::regular();
    database.load_font_source(Source::Binary(Arc::new(font)));
    Arc::new(database)
});

/// The width of a line of text in letters of `size`, and the first character that the font does not have.
pub fn measure(text: &str, size: f64) -> (f64, Option<char>) {
    let Ok(font) = FontRef::new(dejavu::sans::regular()) else { return (0.6 * size * text.len() as f64, None) };
    let metrics = font.glyph_metrics(Size::new(size as f32), LocationRef::default());
    let letters = font.charmap();
    let glyphs = text.chars().map(|letter| (letter, letters.map(letter)));
    let width = glyphs.clone().filter_map(|(_, glyph)| metrics.advance_width(glyph?)).map(f64::from).sum();
    (width, glyphs.into_iter().find(|(_, glyph)| glyph.is_none()).map(|(letter, _)| letter))
}

#[cfg(test)]
mod tests {
    use super::{DATABASE, NAME, measure};

    #[test]
    fn the_font_is_there_and_alone() {
        let names: Vec<_> =
            DATABASE.faces().flat_map(|face| face.families.iter().map(|family| family.0.clone())).collect();
        assert_eq!(names, [NAME]);
        let (narrow, _) = measure("iii", 10.0);
        let (wide, missing) = measure("WWW", 10.0);
        assert!(narrow > 5.0 && wide > 2.0 * narrow && missing.is_none(), "{narrow}, {wide}");
        assert_eq!(measure("50 µm", 10.0).1, None);
        assert_eq!(measure("a漢字", 10.0).1, Some('漢'));
    }
}
