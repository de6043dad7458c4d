//! The elements of a `.vti` file: one image, its arrays, and where their data lies.

use std::io::BufRead;

use super::xml::{Document, Step, Tag, Text};
use crate::error::clip;
use crate::error::{Error, Place, Report};

/// Whether an array's values lie at the grid's points or in the cells between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Association {
    Point,
    Cell,
}

/// A `DataArray`, and the text in it, where there is any.
#[derive(Debug)]
pub(super) struct Array {
    pub tag: Tag,
    pub association: Association,
    pub text: Option<Text>,
}

impl Array {
    pub fn name(&self) -> &str {
        self.tag.get("Name").unwrap_or_default()
    }
}

/// The `AppendedData`, and where its bytes start: behind the underscore.
#[derive(Debug)]
pub(super) struct Appended {
    pub tag: Tag,
    pub start: u64,
}

/// The parts of the document that are read.
#[derive(Debug)]
pub(super) struct Layout {
    pub file: Tag,
    pub image: Tag,
    pub arrays: Vec<Array>,
    /// The array named by `Scalars` of the point data and of the cell data.
    pub active: Vec<(Association, String)>,
    pub appended: Option<Appended>,
}

impl Layout {
    pub fn read(reader: impl BufRead, report: Report) -> Result<Self, Error> {
        let mut document = Document::new(reader, report);
        let Step::Start(file) = document.next()? else {
            return Err(report.invalid(Place::Line(1), "the document has no element", "get the whole file"));
        };
        check_kind(report, &file)?;
        let mut parts = Parts::default();
        loop {
            match document.next()? {
                Step::Done => break,
                Step::Start(tag) if tag.name == "AppendedData" && document.open().len() == 2 => {
                    let start = document.find(b'_')?.ok_or_else(|| {
                        report.invalid(
                            tag.place(),
                            "`AppendedData` does not start with an underscore",
                            "get the whole file, or write it anew",
                        )
                    })?;
                    // Behind it may lie raw bytes, which are no XML.
                    parts.appended = Some(Appended { tag, start });
                    break;
                }
                Step::Start(tag) => parts.start(report, &document, tag)?,
                Step::End => {}
            }
            // Data may be long, and follow after other elements in its array.
            if document.open().last().is_some_and(|name| name.ends_with("Array")) {
                let text = document.skip_text()?;
                parts.text(&document, text);
            }
        }
        let missing = |name: &str| {
            report.invalid(
                file.place(),
                format!("there is no `{name}` in it"),
                "get the whole file, or write it by vtkXMLImageDataWriter",
            )
        };
        let image = parts.image.ok_or_else(|| missing("ImageData"))?;
        let piece = parts.piece.ok_or_else(|| missing("Piece"))?;
        check_piece(report, &image, &piece)?;
        Ok(Self { file, image, arrays: parts.arrays, active: parts.active, appended: parts.appended })
    }
}

/// Elements that were found so far.
#[derive(Default)]
struct Parts {
    image: Option<Tag>,
    piece: Option<Tag>,
    arrays: Vec<Array>,
    active: Vec<(Association, String)>,
    appended: Option<Appended>,
}

impl Parts {
    fn start<R: BufRead>(&mut self, report: Report, document: &Document<R>, tag: Tag) -> Result<(), Error> {
        let path: Vec<_> = document.open().iter().skip(1).map(String::as_str).collect();
        match path[..] {
            ["ImageData"] => keep(report, &mut self.image, tag),
            ["ImageData", "Piece"] => keep(report, &mut self.piece, tag),
            ["ImageData", "Piece", kind] => {
                if let (Some(association), Some(name)) = (association(kind), tag.get("Scalars")) {
                    self.active.push((association, name.to_owned()));
                }
                Ok(())
            }
            ["ImageData", "Piece", kind, "DataArray"] => {
                self.arrays.extend(association(kind).map(|association| Array { tag, association, text: None }));
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn text<R: BufRead>(&mut self, document: &Document<R>, text: Text) {
        // The file, the image, the piece, its data, the array; others belong to no point or cell.
        let inside = document.open().len() == 5 && association(&document.open()[3]).is_some();
        if let Some(array) = self.arrays.last_mut().filter(|array| inside && array.text.is_none() && !text.blank) {
            array.text = Some(text);
        }
    }
}

fn association(name: &str) -> Option<Association> {
    match name {
        "PointData" => Some(Association::Point),
        "CellData" => Some(Association::Cell),
        _ => None,
    }
}

fn keep(report: Report, slot: &mut Option<Tag>, tag: Tag) -> Result<(), Error> {
    if let Some(first) = slot {
        return Err(report.unsupported(
            tag.place(),
            format!("this is a second `{}` after that in line {}", tag.name, first.line),
            "merge the pieces to one image first, as vtkXMLImageDataWriter does",
        ));
    }
    *slot = Some(tag);
    Ok(())
}

fn check_kind(report: Report, file: &Tag) -> Result<(), Error> {
    if file.name != "VTKFile" {
        return Err(report.invalid(
            file.place(),
            format!("the outermost element is `{}`, not `VTKFile`", clip(&file.name)),
            "check that this is a VTK file",
        ));
    }
    match file.get("type") {
        Some("ImageData") => Ok(()),
        kind => Err(report.unsupported(
            file.place(),
            format!("the file holds `{}`, and only `ImageData` is read", clip(kind.unwrap_or_default())),
            "resample it to an image first, for example by ParaView's filter Resample To Image",
        )),
    }
}

fn check_piece(report: Report, image: &Tag, piece: &Tag) -> Result<(), Error> {
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    match (image.get("WholeExtent"), piece.get("Extent")) {
        (Some(whole), Some(part)) if words(whole) != words(part) => Err(report.unsupported(
            piece.place(),
            format!("the piece has the extent `{}` of the whole `{}`", clip(part), clip(whole)),
            "write the image as one piece",
        )),
        _ => Ok(()),
    }
}
