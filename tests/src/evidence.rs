//! Evidence of a breach: both pictures, their difference, and the numbers.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use vitrum_compare::difference_picture;
use vitrum_io::{Picture, write_picture};

use crate::table::Row;

/// The default folder of evidence: `target/conformance`, which version control ignores.
#[must_use]
pub fn folder() -> PathBuf {
    crate::root().join("target/conformance")
}

/// Writes `reference.exr`, `other.exr`, `difference.png` and `numbers.json` to a folder of the row's own, below the folder of its
/// counterpart. The result is that folder.
///
/// # Errors
/// If a file cannot be written.
pub fn write(folder: &Path, row: &Row, reference: &[[f32; 3]], other: &[[f32; 3]]) -> io::Result<PathBuf> {
    let folder = folder.join(file_name(&row.against));
    let folder = folder.join(file_name(&format!("{}-{}-{}-{}", row.tier, row.scene, row.method, row.item)));
    fs::create_dir_all(&folder)?;
    let difference = difference_picture(reference, other).map_err(io::Error::other)?;
    let (width, height) = (row.comparison.width, row.comparison.height);
    let picture = |name: &str, pixels: Vec<[f32; 3]>| {
        let picture = Picture::rgb(width, height, pixels);
        write_picture(&folder.join(name), &picture, &[]).map_err(io::Error::other)
    };
    picture("reference.exr", reference.to_vec())?;
    picture("other.exr", other.to_vec())?;
    picture("difference.png", difference.pixels)?;
    let mut numbers = row.json();
    numbers["difference_gain"] = difference.gain.into();
    fs::write(folder.join("numbers.json"), format!("{numbers:#}\n"))?;
    Ok(folder)
}

fn file_name(text: &str) -> String {
    text.replace(|character: char| !character.is_ascii_alphanumeric() && character != '-', "_")
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrum_compare::{Bound, compare};

    #[test]
    fn a_breach_leaves_pictures_and_numbers() {
        let (reference, other) = ([[0.5; 3]; 4], [[0.5, 0.75, 0.5]; 4]);
        let row = Row {
            tier: "T2",
            scene: "glass/wine".to_owned(),
            method: "sweep".to_owned(),
            item: "color".to_owned(),
            component: None,
            comparison: compare(&reference, &other, 2, 2).unwrap(),
            bound: Bound::BitEqual,
            against: String::new(),
        };
        let folder = tempfile::tempdir().unwrap();
        let folder = write(folder.path(), &row, &reference, &other).unwrap();
        assert!(folder.ends_with("T2-glass_wine-sweep-color"));
        for name in ["reference.exr", "other.exr", "difference.png"] {
            assert!(fs::metadata(folder.join(name)).unwrap().len() > 0, "{name}");
        }
        let numbers = fs::read_to_string(folder.join("numbers.json")).unwrap();
        assert!(numbers.contains("\"difference_gain\": 4.0"), "{numbers}");
    }
}
