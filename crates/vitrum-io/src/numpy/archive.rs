//! NumPy's `.npz`: a ZIP archive of arrays, each a `.npy` file.

use zip::result::ZipError;
use zip::{CompressionMethod, ZipArchive};

use super::array;
use super::header::Header;
use crate::arrays;
use crate::components::Components;
use crate::error::{Error, Place, Report, clip};
use crate::formats::{self, Format};
use crate::input::Input;
use crate::options::{OpenOptions, Part};
use crate::reader::VolumeReader;
use crate::storage::ByteReader;
use crate::stream;
use crate::volume::Volume;

/// The reader of `.npz` files.
pub(crate) struct Npz;

/// The extension that the arrays have inside.
const EXTENSION: &str = ".npy";

type Archive<'a> = ZipArchive<ByteReader<'a>>;

impl VolumeReader for Npz {
    fn format(&self) -> &'static Format {
        &formats::NPZ
    }

    fn recognises(&self, input: &Input) -> bool {
        // The name of the first file is as long as two bytes say, behind 30 bytes in all.
        let length = |low: u8, high: u8| usize::from(u16::from_le_bytes([low, high]));
        let head = &input.head;
        head.starts_with(b"PK\x03\x04")
            && head
                .get(26..28)
                .and_then(|bytes| head.get(30..30 + length(bytes[0], bytes[1])))
                .is_some_and(|name| name.ends_with(EXTENSION.as_bytes()))
    }

    fn parts(&self) -> &'static [Part] {
        &[Part::Array, Part::Time]
    }

    fn read(&self, input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
        let report = Report::new(&input.name);
        let mut archive = ZipArchive::new(input.open()?).map_err(|error| damaged(report, error))?;
        let arrays = names(&archive, report)?;
        let (index, name, part) = choose(report, &arrays, &mut archive, input.length, options)?;
        let inside = format!("{}, array {}", input.name, clip(name));
        let report = Report::new(&inside);
        let packing = packing(&mut archive, index, input.length, report)?;
        let mut entry = archive.by_index(index).map_err(|error| damaged(report, error))?;
        let length = entry.size();
        let (mut volume, left) = array::read(&mut entry, length, packing, part, report, options, None)?;
        if left == 0 {
            // The sum of all bytes is checked where they end.
            stream::refuse_surplus(report, &mut entry, length)?;
        }
        volume.name.clone_from(&input.name);
        volume.source.format = self.format().name;
        if options.array.is_none() {
            let others = arrays.iter().filter(|(other, _)| *other != index).map(|(_, name)| name.as_str());
            volume.source.assumptions.extend(arrays::others_note(name, others));
        }
        Ok(volume)
    }
}

/// Indices and names of the arrays, at least one.
fn names(archive: &Archive, report: Report) -> Result<Vec<(usize, String)>, Error> {
    let mut arrays = Vec::new();
    for index in 0..archive.len() {
        let Some(name) = archive.name_for_index(index) else { continue };
        let name = name.map_err(|error| damaged(report, error))?;
        arrays.extend(name.strip_suffix(EXTENSION).map(|name| (index, name.to_owned())));
    }
    if arrays.is_empty() {
        return Err(report.unsupported(
            Place::File,
            "the archive holds no arrays, which are files ending in `.npy`",
            "write one by numpy.savez or numpy.savez_compressed",
        ));
    }
    Ok(arrays)
}

/// The array of a name, behind which a part of its components may stand after a colon; else the first that can be a volume.
fn choose<'a, 'b>(
    report: Report,
    arrays: &'a [(usize, String)],
    archive: &mut Archive,
    most: u64,
    options: &'b OpenOptions,
) -> Result<(usize, &'a str, Option<&'b str>), Error> {
    let known = arrays.iter().map(|(_, name)| name.as_str());
    let named = |asked: &str| {
        let found = arrays.iter().find(|(_, name)| name == asked || name.as_str() == asked.trim_end_matches(EXTENSION));
        found.map(|(index, name)| (*index, name.as_str()))
    };
    let asked = options.array.as_deref();
    if let Some(asked) = asked {
        if let Some((index, name)) = named(asked) {
            return Ok((index, name, None));
        }
        if let Some((name, part)) = asked.rsplit_once(':')
            && let Some((index, name)) = named(name)
        {
            return Ok((index, name, Some(part)));
        }
        if !Components::is_part(asked) {
            return Err(arrays::unknown(report, asked, known));
        }
    }
    let mut first = None;
    for (index, name) in arrays {
        let inside = format!("{}, array {}", report.file, clip(name));
        let report = Report::new(&inside);
        let header = packing(archive, *index, most, report).and_then(|_| {
            let mut entry = archive.by_index(*index).map_err(|error| damaged(report, error))?;
            let length = entry.size();
            Header::read(&mut entry, length, array::wanted(asked, options), report)
        });
        match header {
            Ok(header) if asked.is_some() && header.components == 1 => {}
            Ok(_) => return Ok((*index, name, asked)),
            Err(error) => first = first.or(Some(error)),
        }
    }
    // The archive has at least one array.
    Err(first.unwrap_or_else(|| arrays::unknown(report, asked.unwrap_or_default(), known)))
}

/// Compression of an array; an error where it is unknown, or where the compressed bytes are too few for the promised size.
fn packing(archive: &mut Archive, index: usize, most: u64, report: Report) -> Result<&'static str, Error> {
    let entry = archive.by_index_raw(index).map_err(|error| damaged(report, error))?;
    let (name, ratio) = match entry.compression() {
        CompressionMethod::Stored => ("raw", 1),
        CompressionMethod::Deflated => ("deflate", stream::DEFLATE_RATIO),
        other => {
            let problem = format!("the array is compressed by {other}, not by deflate");
            return Err(report.unsupported(Place::File, problem, "write it by numpy.savez_compressed"));
        }
    };
    stream::check_length(report, entry.compressed_size(), 0, most)?;
    stream::check_ratio(report, entry.size(), entry.compressed_size(), ratio)?;
    Ok(name)
}

/// The library's error, sorted into unsupported archives, damaged ones and failures of the operating system.
fn damaged(report: Report, error: ZipError) -> Error {
    match error {
        ZipError::Io(error) => stream::broken(report, 0, error),
        ZipError::UnsupportedArchive(problem) => report.unsupported(
            Place::File,
            format!("the archive cannot be read: {problem}"),
            "write it by numpy.savez or numpy.savez_compressed",
        ),
        error => report.invalid(
            Place::File,
            format!("the archive is damaged: {error}"),
            "get the whole file, or write it anew by numpy.savez",
        ),
    }
}
