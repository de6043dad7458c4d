//! Small DICOM files: explicit VR, little-endian.

use std::collections::BTreeMap;

pub const POSITION: (u16, u16) = (0x0020, 0x0032);
pub const ORIENTATION: (u16, u16) = (0x0020, 0x0037);
pub const SERIES: (u16, u16) = (0x0020, 0x000e);
pub const SLOPE: (u16, u16) = (0x0028, 0x1053);
pub const INTERCEPT: (u16, u16) = (0x0028, 0x1052);
pub const FRAMES: (u16, u16) = (0x0028, 0x0008);
pub const RAW: &str = "1.2.840.10008.1.2.1";
pub const RLE: &str = "1.2.840.10008.1.2.5";

/// One file: elements by tag, and its pixels.
#[derive(Clone)]
pub struct Dicom {
    elements: BTreeMap<(u16, u16), (&'static str, Vec<u8>)>,
    syntax: &'static str,
    /// The pixels, or fragments where they are compressed.
    fragments: Vec<Vec<u8>>,
}

impl Dicom {
    /// A slice of 3 x 2 pixels at a height, spacings 1 along x and 2 along y, of uint8.
    pub fn slice(z: f64, pixels: &[u8]) -> Self {
        let mut file = Self { elements: BTreeMap::new(), syntax: RAW, fragments: vec![pixels.to_vec()] };
        file.text((0x0008, 0x0060), "CS", "MR").text(SERIES, "UI", "1.2.3");
        file.text(POSITION, "DS", &format!("10\\20\\{z}")).text(ORIENTATION, "DS", "1\\0\\0\\0\\1\\0");
        file.short((0x0028, 0x0002), 1).text((0x0028, 0x0004), "CS", "MONOCHROME2");
        file.short((0x0028, 0x0010), 2).short((0x0028, 0x0011), 3).text((0x0028, 0x0030), "DS", "2\\1");
        file.bits(8, 8, 7, false);
        file
    }

    /// A slice of 16-bit pixels.
    pub fn words(z: f64, pixels: &[u16], signed: bool) -> Self {
        let bytes: Vec<u8> = pixels.iter().flat_map(|pixel| pixel.to_le_bytes()).collect();
        let mut file = Self::slice(z, &bytes);
        file.bits(16, 16, 15, signed);
        file
    }

    pub fn bits(&mut self, allocated: u16, stored: u16, high: u16, signed: bool) -> &mut Self {
        self.short((0x0028, 0x0100), allocated).short((0x0028, 0x0101), stored);
        self.short((0x0028, 0x0102), high).short((0x0028, 0x0103), signed.into())
    }

    pub fn text(&mut self, tag: (u16, u16), vr: &'static str, text: &str) -> &mut Self {
        let mut bytes = text.as_bytes().to_vec();
        if bytes.len() % 2 == 1 {
            bytes.push(if vr == "UI" { 0 } else { b' ' });
        }
        self.elements.insert(tag, (vr, bytes));
        self
    }

    pub fn short(&mut self, tag: (u16, u16), value: u16) -> &mut Self {
        self.elements.insert(tag, ("US", value.to_le_bytes().to_vec()));
        self
    }

    pub fn remove(&mut self, tag: (u16, u16)) -> &mut Self {
        self.elements.remove(&tag);
        self
    }

    pub fn pixels(&mut self, pixels: &[u8]) -> &mut Self {
        self.fragments = vec![pixels.to_vec()];
        self
    }

    pub fn compressed(&mut self, syntax: &'static str, fragments: Vec<Vec<u8>>) -> &mut Self {
        (self.syntax, self.fragments) = (syntax, fragments);
        self
    }

    /// A sequence of items, each of elements with numbers as text, or of such sequences.
    pub fn sequence(&mut self, tag: (u16, u16), items: &[Vec<u8>]) -> &mut Self {
        self.elements.insert(tag, ("SQ", items.iter().flat_map(|content| item(content)).collect()));
        self
    }

    pub fn bytes(&self) -> Vec<u8> {
        let meta = element((0x0002, 0x0010), "UI", &padded(self.syntax));
        let mut file = vec![0; 128];
        file.extend(b"DICM");
        file.extend(element((0x0002, 0x0000), "UL", &(meta.len() as u32).to_le_bytes()));
        file.extend(meta);
        for (&tag, (vr, bytes)) in &self.elements {
            file.extend(element(tag, vr, bytes));
        }
        if self.syntax == RAW {
            let mut pixels = self.fragments.concat();
            if pixels.len() % 2 == 1 {
                pixels.push(0);
            }
            file.extend(element((0x7fe0, 0x0010), "OW", &pixels));
        } else {
            file.extend([0xe0, 0x7f, 0x10, 0x00, b'O', b'B', 0, 0, 0xff, 0xff, 0xff, 0xff]);
            file.extend(item(&[]));
            self.fragments.iter().for_each(|fragment| file.extend(item(fragment)));
            file.extend([0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0]);
        }
        file
    }
}

fn padded(text: &str) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    bytes.resize(bytes.len().next_multiple_of(2), 0);
    bytes
}

/// An element in explicit VR.
pub fn element((group, number): (u16, u16), vr: &str, bytes: &[u8]) -> Vec<u8> {
    let mut element = [group.to_le_bytes(), number.to_le_bytes()].concat();
    element.extend(vr.as_bytes());
    if matches!(vr, "OB" | "OW" | "SQ") {
        element.extend([0, 0]);
        element.extend((bytes.len() as u32).to_le_bytes());
    } else {
        element.extend((bytes.len() as u16).to_le_bytes());
    }
    element.extend(bytes);
    element
}

/// A sequence as an element, to be put into an item.
pub fn nested(tag: (u16, u16), items: &[Vec<u8>]) -> Vec<u8> {
    element(tag, "SQ", &items.iter().flat_map(|content| item(content)).collect::<Vec<_>>())
}

fn item(content: &[u8]) -> Vec<u8> {
    let mut content = content.to_vec();
    content.resize(content.len().next_multiple_of(2), 0);
    [&[0xfe, 0xff, 0x00, 0xe0][..], &(content.len() as u32).to_le_bytes(), &content].concat()
}

/// A frame of bytes in DICOM's RLE: one segment a byte of the pixel, most significant first.
pub fn rle(segments: &[Vec<u8>]) -> Vec<u8> {
    // A literal run of at most 128 bytes each.
    let packed: Vec<Vec<u8>> = segments
        .iter()
        .map(|bytes| {
            let mut packed: Vec<u8> =
                bytes.chunks(128).flat_map(|run| [vec![run.len() as u8 - 1], run.to_vec()].concat()).collect();
            packed.resize(packed.len().next_multiple_of(2), 0x80);
            packed
        })
        .collect();
    let mut header = vec![segments.len() as u32];
    let mut offset = 64;
    for segment in &packed {
        header.push(offset);
        offset += segment.len() as u32;
    }
    header.resize(16, 0);
    [header.into_iter().flat_map(u32::to_le_bytes).collect(), packed.concat()].concat()
}

pub const LOSSLESS: &str = "1.2.840.10008.1.2.4.57";

/// Lossless JPEG of the words 1, 258, 513, 40000, 0, 65535, written by imagecodecs.
pub const JPEG: [u8; 62] = [
    255, 216, 255, 196, 0, 22, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 15, 8, 9, 255, 195, 0, 11, 16, 0, 2,
    0, 3, 1, 0, 17, 0, 255, 218, 0, 8, 1, 0, 0, 6, 0, 0, 0, 0, 208, 27, 252, 112, 248, 195, 123, 31, 128, 255, 217,
];

pub const JPEG_LS: &str = "1.2.840.10008.1.2.4.80";

/// The words as lossless JPEG-LS, written by CharLS.
pub const JPEG_LS_WORDS: [u8; 108] = [
    255, 216, 255, 232, 0, 32, 83, 80, 73, 70, 70, 0, 2, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 10, 16, 6, 1, 0, 0, 1, 44, 0,
    0, 1, 44, 255, 232, 0, 8, 0, 0, 0, 1, 255, 216, 255, 247, 0, 11, 16, 0, 2, 0, 3, 1, 1, 17, 0, 255, 248, 0, 13, 1,
    255, 255, 0, 18, 0, 67, 1, 20, 0, 64, 255, 218, 0, 8, 1, 1, 0, 0, 0, 0, 64, 28, 3, 127, 64, 0, 0, 0, 0, 0, 113,
    224, 0, 0, 0, 0, 0, 0, 113, 223, 239, 248, 255, 217,
];

pub const JPEG_2000: &str = "1.2.840.10008.1.2.4.90";

/// The words as lossless JPEG 2000, written by OpenJPEG.
pub const JPEG_2000_WORDS: [u8; 138] = [
    255, 79, 255, 81, 0, 41, 0, 0, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 1, 15, 1, 1, 255, 82, 0, 12, 0, 0, 0, 1, 0, 0, 4, 4, 0, 1, 255, 92, 0, 4, 64, 128, 255, 100, 0, 37,
    0, 1, 67, 114, 101, 97, 116, 101, 100, 32, 98, 121, 32, 79, 112, 101, 110, 74, 80, 69, 71, 32, 118, 101, 114, 115,
    105, 111, 110, 32, 50, 46, 53, 46, 52, 255, 144, 0, 10, 0, 0, 0, 0, 0, 32, 0, 1, 255, 147, 223, 248, 144, 112, 16,
    101, 57, 80, 37, 251, 64, 119, 92, 133, 167, 239, 189, 127, 255, 217,
];

/// The words -32768, -1, 0, 1, 258, 32767, written so.
pub const JPEG_2000_SIGNED: [u8; 134] = [
    255, 79, 255, 81, 0, 41, 0, 0, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 1, 143, 1, 1, 255, 82, 0, 12, 0, 0, 0, 1, 0, 0, 4, 4, 0, 1, 255, 92, 0, 4, 64, 128, 255, 100, 0, 37,
    0, 1, 67, 114, 101, 97, 116, 101, 100, 32, 98, 121, 32, 79, 112, 101, 110, 74, 80, 69, 71, 32, 118, 101, 114, 115,
    105, 111, 110, 32, 50, 46, 53, 46, 52, 255, 144, 0, 10, 0, 0, 0, 0, 0, 28, 0, 1, 255, 147, 223, 248, 144, 80, 7,
    249, 110, 58, 8, 176, 10, 44, 90, 47, 255, 217,
];
