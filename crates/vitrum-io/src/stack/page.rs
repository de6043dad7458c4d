//! The pages of one TIFF file, before and while they are decoded.

use std::io::{Read, Seek, SeekFrom};
use std::path::PathBuf;

use tiff::ColorType;
use tiff::decoder::DecodingSampleType;
use tiff::tags::Tag;

use super::NATIVE;
use super::decoder::{Compression, Reader, damaged, is_thumbnail, open, order};
use super::selection::Selection;
use super::spacing::Notes;
use crate::error::{Error, Place, Report};
use crate::memory;
use crate::samples::{Endian, SampleType, VoxelBuffer};
use crate::storage::Storage;
use crate::stream;

/// Size and samples of a page, which all slices of a volume share.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Page {
    pub width: u32,
    pub height: u32,
    pub sample: SampleType,
}

impl Page {
    /// Size and type of the page, such as `384 x 384 uint16`.
    pub fn describe(&self) -> String {
        format!("{} x {} {}", self.width, self.height, self.sample.name())
    }

    pub fn voxels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }
}

/// A file of one or more pages.
#[derive(Debug)]
pub(super) struct Pages<'a> {
    storage: Storage<'a>,
    /// Path of the file, or the name under which its bytes were given.
    pub path: PathBuf,
    pub name: String,
    pub first: Page,
    /// Count of the pages that are slices.
    pub count: u64,
    /// Smaller copies of pages, which are no slices.
    pub thumbnails: u64,
    /// Coding of the first page, such as `deflate, big-endian`.
    pub encoding: String,
    /// Notes of the first page on its spacing.
    pub notes: Notes,
    /// Whether values are indices of colours.
    pub palette: bool,
    /// These colours, as far as they can be read.
    pub colors: Vec<[f64; 3]>,
    /// Whether the file says that 0 is white.
    pub white_is_zero: bool,
    /// The first byte and the order of images that lie behind one another without pages of their own.
    behind: Option<(u64, Endian)>,
}

impl<'a> Pages<'a> {
    /// Looks at all pages, and decodes none.
    pub fn scan(storage: Storage<'a>, path: PathBuf, name: String) -> Result<Self, Error> {
        let report = Report::new(&name);
        let mut decoder = open(&storage, report)?;
        let length = storage.length().map_err(|error| report.unreadable(error))?;
        let mut found: Option<(Page, String, Notes)> = None;
        let mut colors = Vec::new();
        let (mut count, mut thumbnails, mut number, mut bytes, mut most) = (0, 0, 1_u64, 0_u64, 0);
        loop {
            let at = |error| damaged(report, number, error);
            if is_thumbnail(&mut decoder).map_err(at)? {
                thumbnails += 1;
            } else {
                let compression = Compression::of(&mut decoder, report, number)?;
                let page = page(&mut decoder, report, number)?;
                count += 1;
                bytes = bytes.saturating_add(page.voxels().saturating_mul(page.sample.size() as u64));
                most = most.max(compression.ratio);
                match &found {
                    None => {
                        let encoding = format!("{}, {}", compression.name, order(&decoder));
                        found = Some((page, encoding, Notes::read(&mut decoder)));
                        colors = palette(&mut decoder);
                    }
                    Some((first, ..)) if *first != page => {
                        return Err(report.invalid(
                            Place::File,
                            format!("page {number} is {}, and the first {}", page.describe(), first.describe()),
                            "write all slices in one size and type",
                        ));
                    }
                    Some(_) => {}
                }
            }
            if !decoder.more_images() {
                break;
            }
            number += 1;
            decoder.next_image().map_err(|error| damaged(report, number, error))?;
        }
        let Some((first, encoding, notes)) = found else {
            return Err(report.invalid(Place::File, "all pages are thumbnails", "get the whole file"));
        };
        stream::check_ratio(report, bytes, length, most)?;
        let (palette, white_is_zero) = {
            let file = decoder.inner();
            (file.palette, file.white_is_zero)
        };
        let images = notes.count("images");
        let mut behind = None;
        if images > 1 && count == 1 && thumbnails == 0 {
            behind = images_behind(&storage, report, &first, images, length)?;
            count = if behind.is_some() { images } else { 1 };
        }
        Ok(Self {
            storage,
            path,
            first,
            count,
            thumbnails,
            encoding,
            notes,
            palette,
            colors,
            white_is_zero,
            behind,
            name,
        })
    }

    /// Decodes the slices that are selected.
    pub fn read(&self, selection: Selection, voxels: &mut VoxelBuffer) -> Result<(), Error> {
        let report = Report::new(&self.name);
        let mut decoder = open(&self.storage, report)?;
        let count = usize::try_from(self.first.voxels()).unwrap_or(usize::MAX);
        let size = count.saturating_mul(self.first.sample.size());
        let mut bytes = memory::reserve(report, size)?;
        bytes.resize(size, 0_u8);
        if let Some((start, endian)) = self.behind {
            return self.read_behind(report, selection, voxels, (start, endian), bytes);
        }
        let mut index = 0;
        for number in 1.. {
            let at = |error| damaged(report, number, error);
            if !is_thumbnail(&mut decoder).map_err(at)? {
                if selection.contains(index) {
                    decoder.read_image_bytes(&mut bytes).map_err(at)?;
                    stream::fill(report, voxels, &mut bytes.as_slice(), count, self.first.sample.size())?;
                }
                index += 1;
            }
            if !decoder.more_images() {
                break;
            }
            decoder.next_image().map_err(at)?;
        }
        Ok(())
    }
}

/// The colours of a page's palette: all reds, then all greens, then all blues, of 16 bits. Empty where it has none.
fn palette(decoder: &mut Reader) -> Vec<[f64; 3]> {
    // Without colours the values are what they are.
    let words = decoder.find_tag(Tag::ColorMap).ok().flatten().and_then(|value| value.into_u16_vec().ok());
    let words = words.unwrap_or_default();
    let (reds, rest) = words.split_at(words.len() / 3);
    let (greens, blues) = rest.split_at(words.len() / 3);
    let part = |word: &u16| (f64::from(*word) / 65535.0 * 1000.0).round() / 1000.0;
    reds.iter().zip(greens.iter().zip(blues)).map(|(red, (green, blue))| [red, green, blue].map(part)).collect()
}

impl Pages<'_> {
    /// Decodes the selected of the images that lie behind one another, through a buffer of one of them.
    fn read_behind(
        &self,
        report: Report,
        selection: Selection,
        voxels: &mut VoxelBuffer,
        (start, endian): (u64, Endian),
        mut bytes: Vec<u8>,
    ) -> Result<(), Error> {
        let unreadable = |error| report.unreadable(error);
        let mut file = self.storage.open().map_err(unreadable)?;
        let size = self.first.sample.size();
        for index in (0..self.count).filter(|&index| selection.contains(index)) {
            // Within the file, as was checked.
            file.seek(SeekFrom::Start(start + index * bytes.len() as u64)).map_err(unreadable)?;
            file.read_exact(&mut bytes).map_err(unreadable)?;
            if endian != NATIVE {
                bytes.chunks_exact_mut(size).for_each(<[u8]>::reverse);
            }
            stream::fill(report, voxels, &mut bytes.as_slice(), bytes.len() / size, size)?;
        }
        Ok(())
    }
}

/// The first byte of so many images behind one another, which ImageJ writes beyond 4 GiB, and their byte order; `None` where they are
/// not there, as in a page that was taken out of such a file with its description.
fn images_behind(
    storage: &Storage,
    report: Report,
    page: &Page,
    images: u64,
    length: u64,
) -> Result<Option<(u64, Endian)>, Error> {
    let mut decoder = open(storage, report)?;
    let at = |error| damaged(report, 1, error);
    let is_raw = Compression::of(&mut decoder, report, 1)?.name == "raw";
    let offsets: Option<Vec<u64>> = decoder.find_tag_unsigned_vec(Tag::StripOffsets).map_err(at)?;
    let start = offsets.and_then(|offsets| offsets.first().copied()).unwrap_or(u64::MAX);
    let bytes = page.voxels().saturating_mul(page.sample.size() as u64).saturating_mul(images);
    let big = decoder.byte_order() == tiff::tags::ByteOrder::BigEndian;
    let is_there = is_raw && bytes <= length.saturating_sub(start);
    Ok(is_there.then_some((start, if big { Endian::Big } else { Endian::Little })))
}

fn page(decoder: &mut Reader, report: Report, number: u64) -> Result<Page, Error> {
    let at = |error| damaged(report, number, error);
    let unsupported = |problem: String| {
        report.unsupported(
            Place::File,
            format!("page {number} {problem}"),
            "convert it to 8, 16 or 32 bit gray, for example by Image > Type in ImageJ",
        )
    };
    let (width, height) = decoder.dimensions().map_err(at)?;
    let samples: Option<u16> = decoder.find_tag_unsigned(Tag::SamplesPerPixel).map_err(at)?;
    let color = decoder.colortype().map_err(at)?;
    if !matches!(color, ColorType::Gray(_)) || samples.is_some_and(|samples| samples != 1) {
        return Err(unsupported(format!("has the colours {color:?}, not one gray sample")));
    }
    let layout = decoder.image_buffer_layout().map_err(at)?;
    let sample = match (layout.sample_type, color.bit_depth()) {
        (Some(DecodingSampleType::I8), 8) => SampleType::I8,
        (Some(DecodingSampleType::U8), 8) => SampleType::U8,
        (Some(DecodingSampleType::I16), 16) => SampleType::I16,
        (Some(DecodingSampleType::U16), 16) => SampleType::U16,
        (Some(DecodingSampleType::I32), 32) => SampleType::I32,
        (Some(DecodingSampleType::U32), 32) => SampleType::U32,
        (Some(DecodingSampleType::I64), 64) => SampleType::I64,
        (Some(DecodingSampleType::U64), 64) => SampleType::U64,
        (Some(DecodingSampleType::F16), 16) => SampleType::F16,
        (Some(DecodingSampleType::F32), 32) => SampleType::F32,
        (Some(DecodingSampleType::F64), 64) => SampleType::F64,
        (_, bits) => {
            return Err(unsupported(format!("has {bits} bit samples of the format {:?}", layout.sample_format)));
        }
    };
    let page = Page { width, height, sample };
    let expected = page.voxels().checked_mul(sample.size() as u64);
    let (chunk_width, chunk_height) = decoder.chunk_dimensions();
    let widest = width.next_multiple_of(16).max(1 << 14);
    if width == 0 || height == 0 || expected != u64::try_from(layout.complete_len).ok() {
        return Err(report.invalid(
            Place::File,
            format!("page {number} of {} has no voxels, or more than fit", page.describe()),
            "get the file again, or write it anew",
        ));
    }
    if chunk_width > widest || chunk_height == 0 {
        return Err(report.invalid(
            Place::File,
            format!("page {number} of {} has parts of {chunk_width} x {chunk_height}", page.describe()),
            "write it in strips, or in tiles no larger than the page",
        ));
    }
    Ok(page)
}
