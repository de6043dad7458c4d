//! Compressed pictures of gray pixels: JPEG, JPEG-LS and JPEG 2000. Each is held against the file's header before it is decoded: a
//! picture could be made to need any amount of memory.

use std::panic::{AssertUnwindSafe, catch_unwind};

use hayro_jpeg2000::{DecodeSettings, DecoderContext, Image};
use jpeg_decoder::Decoder;

/// Why a picture is not decoded.
#[derive(Debug)]
pub(super) enum Problem {
    /// It is damaged, or contradicts the file's header.
    Damaged(String),
    /// It may well be whole, but is of a kind that no decoder here reads.
    Unknown(String),
}

impl From<String> for Problem {
    fn from(problem: String) -> Self {
        Self::Damaged(problem)
    }
}

/// Rows and columns, as the file's header says.
pub(super) type Size = [u32; 2];

/// The pixels of a JPEG picture, with or without loss, each in `bytes` bytes, little-endian; else the problem.
pub(super) fn jpeg(packed: &[u8], size: Size, bytes: usize) -> Result<Vec<u8>, Problem> {
    check_frame(packed, size, bytes)?;
    if bytes == 2 && !is_lossless(packed) {
        return jpeg_of_12_bits(packed);
    }
    // The decoder is not ours: should it panic on a damaged picture, the picture is at fault and not the program.
    let decode = || {
        Decoder::new(packed).decode().map_err(|error| match error {
            jpeg_decoder::Error::Unsupported(_) => Problem::Unknown(error.to_string()),
            error => Problem::Damaged(error.to_string()),
        })
    };
    let mut pixels = catch_unwind(decode).map_err(|_| "it cannot be decoded".to_owned())??;
    if bytes == 2 && cfg!(target_endian = "big") {
        // It gives words in the machine's order.
        pixels.chunks_exact_mut(2).for_each(<[u8]>::reverse);
    }
    Ok(pixels)
}

/// As [`jpeg`], of a picture with loss whose samples have more than 8 bits.
fn jpeg_of_12_bits(packed: &[u8]) -> Result<Vec<u8>, Problem> {
    use oxiarc_jpeg::{DecodeOptions, Decoder, JpegError};
    let decode = || {
        Decoder::with_options(packed, DecodeOptions::raw()).decode_u16().map_err(|error| match error {
            JpegError::Unsupported(_) => Problem::Unknown(error.to_string()),
            error => Problem::Damaged(error.to_string()),
        })
    };
    // As above.
    let pixels = catch_unwind(decode).map_err(|_| "it cannot be decoded".to_owned())??;
    Ok(pixels.into_iter().flat_map(u16::to_le_bytes).collect())
}

/// Fails where a JPEG or JPEG-LS picture is not one of gray pixels in `bytes` bytes each, or of another size.
fn check_frame(packed: &[u8], [rows, columns]: Size, bytes: usize) -> Result<(), String> {
    let Some([precision, height, width, components]) = frame(packed) else {
        return Err("it has no frame header".to_owned());
    };
    if [height, width] != [rows, columns] {
        return Err(format!("it is {width} x {height}, and the header says {columns} x {rows}"));
    }
    if components != 1 {
        return Err(format!("it has {components} components, not one of gray"));
    }
    if precision.div_ceil(8) != bytes as u32 {
        return Err(format!("its samples have {precision} bits, and the header says {bytes} bytes"));
    }
    Ok(())
}

/// Whether a JPEG picture was written without loss.
fn is_lossless(packed: &[u8]) -> bool {
    start_of_frame(packed).is_some_and(|(marker, _)| matches!(marker, 0xc3 | 0xc7 | 0xcb | 0xcf))
}

/// Bits of a sample, rows, columns and components, where these bytes start a JPEG or JPEG-LS picture.
fn frame(bytes: &[u8]) -> Option<[u32; 4]> {
    start_of_frame(bytes).map(|(_, frame)| frame)
}

/// The marker of the start of frame, and what it says.
fn start_of_frame(bytes: &[u8]) -> Option<(u8, [u32; 4])> {
    let mut rest = bytes.strip_prefix(&[0xff, 0xd8])?;
    loop {
        let [0xff, marker, high, low, after @ ..] = rest else { return None };
        let byte = |at: usize| after.get(at).map(|&byte| u32::from(byte));
        match marker {
            // A byte that fills up.
            0xff => rest = &rest[1..],
            // A start of frame; the others of its row are tables.
            0xc0..=0xcf | 0xf7 if !matches!(marker, 0xc4 | 0xc8 | 0xcc) => {
                let word = |at: usize| Some(byte(at)? << 8 | byte(at + 1)?);
                return Some((*marker, [byte(0)?, word(1)?, word(3)?, byte(5)?]));
            }
            _ => rest = after.get(usize::from(u16::from_be_bytes([*high, *low])).checked_sub(2)?..)?,
        }
    }
}

/// The pixels of a JPEG-LS picture, each in `bytes` bytes, little-endian; else the problem.
pub(super) fn jpeg_ls(packed: &[u8], size: Size, bytes: usize) -> Result<Vec<u8>, Problem> {
    check_frame(packed, size, bytes)?;
    let [rows, columns] = size;
    // The decoder is not ours: should it panic on a damaged picture, the picture is at fault and not the program.
    let decoded =
        catch_unwind(|| jpegls::decode(packed, columns, rows)).map_err(|_| "it cannot be decoded".to_owned())?;
    let (pixels, ..) = decoded.map_err(|error| error.to_string())?;
    Ok(pixels.into_iter().flat_map(|pixel| u32::from(pixel).to_le_bytes().into_iter().take(bytes)).collect())
}

/// The pixels of a JPEG 2000 picture, which may have signs, each in `bytes` bytes, little-endian; else the problem.
pub(super) fn jpeg_2000(packed: &[u8], size: Size, bytes: usize) -> Result<Vec<u8>, Problem> {
    let Codestream { precision, signed } = Codestream::check(packed, size)?;
    // A damaged codestream is an error; its pixels are not guessed.
    let settings = DecodeSettings { resolve_palette_indices: false, strict: true, target_resolution: None };
    let decode = || {
        let image = Image::new(packed, &settings).map_err(|error| error.to_string())?;
        let mut context = DecoderContext::default();
        let decoded = image.decode(&mut context).map_err(|error| error.to_string())?;
        Ok::<_, String>(decoded.components().first().map(|component| component.samples().to_vec()).unwrap_or_default())
    };
    let samples = catch_unwind(AssertUnwindSafe(decode)).map_err(|_| "it cannot be decoded".to_owned())??;
    let most = (1_u64 << precision) - 1;
    // Samples come moved up so that none is below 0.
    let zero = if signed { 1_i64 << (precision - 1) } else { 0 };
    let number = |sample: f32| i64::from(sample.round().clamp(0.0, most as f32) as u32) - zero;
    Ok(samples.into_iter().flat_map(|sample| number(sample).to_le_bytes().into_iter().take(bytes)).collect())
}

/// First segment of a JPEG 2000 codestream.
struct Codestream {
    /// Bits of a sample.
    precision: u32,
    signed: bool,
}

impl Codestream {
    /// Reads a codestream's header, and fails where it contradicts the header of the file.
    fn check(packed: &[u8], [rows, columns]: Size) -> Result<Self, String> {
        const START: &[u8] = &[0xff, 0x4f, 0xff, 0x51];
        // Some writers put a file of the format there, with boxes before the codestream.
        let start = packed.windows(START.len()).position(|window| window == START);
        let header = start.and_then(|start| packed.get(start..start + 43)).ok_or("it has no codestream")?;
        let word = |at: usize| u32::from_be_bytes([header[at], header[at + 1], header[at + 2], header[at + 3]]);
        let found = [word(12).saturating_sub(word(20)), word(8).saturating_sub(word(16))];
        if found != [rows, columns] {
            return Err(format!("it is {} x {}, and the header says {columns} x {rows}", found[1], found[0]));
        }
        let components = u16::from_be_bytes([header[40], header[41]]);
        if components != 1 {
            return Err(format!("it has {components} components, not one of gray"));
        }
        let precision = u32::from(header[42] & 0x7f) + 1;
        if precision > 16 {
            return Err(format!("its samples have {precision} bits, more than 16"));
        }
        Ok(Self { precision, signed: header[42] & 0x80 != 0 })
    }
}
