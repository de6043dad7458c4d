//! A conformance run as one self-contained HTML page: the numbers, and pictures to flip through.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use vitrum_compare::difference_picture;
use vitrum_io::{Picture, PictureFormat, WriteOptions, encode_picture};

use crate::raster::{Pixels, Raster};
use crate::run::Run;
use crate::table::Row;

/// A comparison's pictures, as PNG files.
#[derive(Debug, Clone)]
pub struct Pictures {
    /// The comparison, by its number in the run.
    pub row: usize,
    /// The reference, what it was compared with, and their difference.
    pub files: [Vec<u8>; 3],
    /// By how much the difference is brightened.
    pub gain: f64,
}

impl Pictures {
    /// The pictures of two rasters, if they are colours.
    ///
    /// # Errors
    /// If a picture cannot be encoded.
    pub fn new(row: usize, reference: &Raster, other: &Raster) -> io::Result<Option<Self>> {
        let (Pixels::Colors(first), Pixels::Colors(second)) = (&reference.pixels, &other.pixels) else {
            return Ok(None);
        };
        let difference = difference_picture(first, second).map_err(io::Error::other)?;
        let encode = |pixels: &[[f32; 3]]| encode(&Picture::rgb(reference.width, reference.height, pixels.to_vec()));
        let files = [encode(first)?, encode(second)?, encode(&difference.pixels)?];
        Ok(Some(Self { row, files, gain: difference.gain }))
    }
}

/// A picture as a PNG file.
fn encode(picture: &Picture) -> io::Result<Vec<u8>> {
    encode_picture(picture, PictureFormat::Png, &[], &WriteOptions::default()).map_err(io::Error::other)
}

const STYLE: &str = "body{font:14px/1.4 system-ui,sans-serif;margin:2em;color:#222}table{border-collapse:collapse}\
td,th{padding:.2em .7em;border-bottom:1px solid #ddd;text-align:left}td.n{text-align:right;font-variant-numeric:tabular-nums}\
tr.bad{background:#fdd}figure{display:inline-block;margin:0 1em 1em 0;cursor:pointer}img{width:288px;image-rendering:pixelated;\
display:block;background:#888}figcaption{max-width:288px}";

/// A click shows the next of a figure's pictures.
const SCRIPT: &str = "document.querySelectorAll('figure').forEach(f=>f.onclick=()=>{const p=[...f.querySelectorAll('img')];\
const i=p.findIndex(x=>!x.hidden);p[i].hidden=true;const n=p[(i+1)%p.length];n.hidden=false;\
f.querySelector('b').textContent=n.alt})";

/// Writes the page.
///
/// # Errors
/// If the file cannot be written.
pub fn write(path: &Path, backends: &str, run: &Run) -> io::Result<()> {
    fs::write(path, page(backends, run))
}

/// The page's text.
#[must_use]
pub fn page(backends: &str, run: &Run) -> String {
    let mut text = format!(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Vitrum conformance</title><style>{STYLE}</style>\
         <h1>Vitrum conformance</h1><p>{}</p><p>{}</p>\n",
        escape(backends),
        escape(run.summary().lines().next().unwrap_or_default()),
    );
    if !run.pictures().is_empty() {
        text.push_str("<h2>Pictures</h2><p>A click flips through reference, other and difference.</p>\n");
    }
    for pictures in run.pictures() {
        figure(&mut text, pictures, &run.rows()[pictures.row]);
    }
    text.push_str("<h2>Numbers</h2><table>\n<tr>");
    for name in Row::HEADER {
        let _ = write!(text, "<th>{}</th>", escape(name));
    }
    text.push_str("</tr>\n");
    let rows = run.groups().flat_map(|group| group.iter().enumerate());
    for (index, row) in rows {
        if index == 0 && !row.against.is_empty() {
            let _ = writeln!(text, "<tr><th colspan=\"{}\">{}</th></tr>", Row::HEADER.len(), escape(&row.against));
        }
        let class = if row.verdict().passed() { "" } else { " class=\"bad\"" };
        let _ = write!(text, "<tr{class}>");
        for cell in row.cells() {
            let _ = write!(text, "<td>{}</td>", escape(&cell));
        }
        text.push_str("</tr>\n");
    }
    let _ = writeln!(text, "</table><script>{SCRIPT}</script></html>");
    text
}

fn figure(text: &mut String, pictures: &Pictures, row: &Row) {
    let names = ["reference", "other", "difference"];
    text.push_str("<figure>");
    for (index, (name, file)) in names.iter().zip(&pictures.files).enumerate() {
        let hidden = if index == 0 { "" } else { " hidden" };
        let data = STANDARD.encode(file);
        let _ = write!(text, "<img alt=\"{name}\"{hidden} src=\"data:image/png;base64,{data}\">");
    }
    let _ = writeln!(
        text,
        "<figcaption><b>{}</b> · {} {} {} · {} · difference × {:.3e}</figcaption></figure>",
        names[0],
        row.tier,
        escape(&row.scene),
        escape(&row.item),
        escape(&row.verdict().to_string()),
        pictures.gain,
    );
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::About;
    use std::path::PathBuf;
    use vitrum_compare::Bound;

    fn colors(value: f32) -> Raster {
        Raster { width: 2, height: 2, pixels: Pixels::Colors(vec![[value; 3]; 4]) }
    }

    #[test]
    fn a_page_has_numbers_and_pictures_of_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let mut run = Run::new(folder.path().to_owned());
        run.keep_pictures();
        let about = About { tier: "T2", scene: "a<b", item: "color", components: &[] };
        run.hold(about, Bound::BitEqual, &colors(0.5), &colors(0.5)).unwrap();
        run.hold(about, Bound::BitEqual, &colors(0.5), &colors(0.25)).unwrap();
        let page = page("CPU against \"x\"", &run);
        assert_eq!(page.matches("data:image/png;base64,").count(), 6);
        assert_eq!(page.matches("<tr class=\"bad\">").count(), 1);
        assert!(page.contains("a&lt;b") && !page.contains("a<b") && page.contains("&quot;x&quot;"));
        assert!(!page.contains("http"), "a page needs nothing else");
    }

    #[test]
    fn numbers_have_no_picture() {
        let mut run = Run::new(PathBuf::new());
        run.keep_pictures();
        let numbers = Raster::stacked(1, [[1.0].as_slice()]);
        run.hold(About { tier: "T1", scene: "s", item: "i", components: &[] }, Bound::BitEqual, &numbers, &numbers)
            .unwrap();
        assert!(run.pictures().is_empty());
    }
}
