//! Small files of every kind, written by the tests themselves.

// Each test binary uses its own part.
#![allow(dead_code)]

pub mod dicom;
pub mod mesh;
pub mod tiff;
pub mod vtk;

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use tempfile::TempDir;
use vitrum_io::{Error, OpenOptions, Volume};

/// The size of every test volume: no two axes alike, so that a swap shows.
pub const DIMENSIONS: [u32; 3] = [3, 2, 2];

/// One sample type with 12 values, its ends among them.
pub struct Sample {
    pub name: &'static str,
    pub nifti_code: i16,
    pub metaimage: &'static str,
    /// NumPy's letter and size.
    pub numpy: &'static str,
    pub size: usize,
    pub values: Vec<f64>,
    pub little: Vec<u8>,
    pub big: Vec<u8>,
    pub text: String,
}

macro_rules! sample {
    ($type:ty, $name:literal, $code:literal, $metaimage:literal, $numpy:literal, $low:expr, $high:expr) => {{
        let ends: [$type; 12] = [
            $low,
            $high,
            0 as $type,
            1 as $type,
            2 as $type,
            3 as $type,
            100 as $type,
            7 as $type,
            11 as $type,
            42 as $type,
            $high,
            $low,
        ];
        Sample {
            name: $name,
            nifti_code: $code,
            metaimage: $metaimage,
            numpy: $numpy,
            size: size_of::<$type>(),
            values: ends.iter().map(|&value| value as f64).collect(),
            little: ends.iter().flat_map(|value| value.to_le_bytes()).collect(),
            big: ends.iter().flat_map(|value| value.to_be_bytes()).collect(),
            text: ends.iter().map(|value| format!("{value}\n")).collect(),
        }
    }};
}

/// Every sample type of all formats.
#[rustfmt::skip]
pub fn samples() -> Vec<Sample> {
    vec![
        sample!(i8, "int8", 256, "MET_CHAR", "i1", i8::MIN, i8::MAX),
        sample!(u8, "uint8", 2, "MET_UCHAR", "u1", u8::MIN, u8::MAX),
        sample!(i16, "int16", 4, "MET_SHORT", "i2", i16::MIN, i16::MAX),
        sample!(u16, "uint16", 512, "MET_USHORT", "u2", u16::MIN, u16::MAX),
        sample!(i32, "int32", 8, "MET_INT", "i4", i32::MIN, i32::MAX),
        sample!(u32, "uint32", 768, "MET_UINT", "u4", u32::MIN, u32::MAX),
        sample!(i64, "int64", 1024, "MET_LONG_LONG", "i8", i64::MIN, i64::MAX),
        sample!(u64, "uint64", 1280, "MET_ULONG_LONG", "u8", u64::MIN, u64::MAX),
        sample!(f32, "float", 16, "MET_FLOAT", "f4", -1.5e30, 3.25e37),
        sample!(f64, "double", 64, "MET_DOUBLE", "f8", -0.1, 1.0 / 3.0),
    ]
}

/// A folder that is gone after the test.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A file as messages about it begin.
    pub fn shown(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, content).expect("a written file");
        path
    }

    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("a readable folder");
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect()
    }

    /// Writes and opens a volume.
    pub fn open(&self, name: &str, content: impl AsRef<[u8]>) -> Result<Volume, Error> {
        vitrum_io::open(&self.write(name, content), &OpenOptions::default())
    }
}

pub fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).and_then(|()| encoder.finish()).expect("compression in memory")
}

pub fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).and_then(|()| encoder.finish()).expect("compression in memory")
}

pub fn hex(bytes: &[u8]) -> Vec<u8> {
    let digits = bytes.iter().map(|byte| format!("{byte:02x}"));
    // A line end now and then, as in real files.
    digits.collect::<Vec<_>>().chunks(5).map(|line| line.concat() + "\n").collect::<String>().into_bytes()
}

/// A NRRD header of a 3 x 2 x 2 volume, with more lines and its closing blank line.
pub fn nrrd(sample: &str, encoding: &str, more: &str) -> String {
    let [x, y, z] = DIMENSIONS;
    format!("NRRD0004\ntype: {sample}\ndimension: 3\nsizes: {x} {y} {z}\nencoding: {encoding}\n{more}\n")
}

/// A MetaImage header of a 3 x 2 x 2 volume, with more lines and its last.
pub fn metaimage(element: &str, more: &str, data_file: &str) -> String {
    let [x, y, z] = DIMENSIONS;
    format!(
        "ObjectType = Image\nNDims = 3\nDimSize = {x} {y} {z}\nElementType = {element}\n{more}\
         ElementDataFile = {data_file}\n"
    )
}

/// A .npy file of format 1.0, in C order, of the 3 x 2 x 2 volume.
pub fn npy(descr: &str, data: &[u8]) -> Vec<u8> {
    let [x, y, z] = DIMENSIONS;
    let dictionary = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({z}, {y}, {x}), }}");
    npy_with((1, 0), &dictionary, data)
}

/// A .npy file of any version and dictionary, which is padded as NumPy does.
pub fn npy_with((major, minor): (u8, u8), dictionary: &str, data: &[u8]) -> Vec<u8> {
    let mut file = b"\x93NUMPY".to_vec();
    file.extend([major, minor]);
    let before = if major == 1 { 10 } else { 12 };
    let length = (before + dictionary.len() + 1).next_multiple_of(64) - before;
    match major {
        1 => file.extend((length as u16).to_le_bytes()),
        _ => file.extend((length as u32).to_le_bytes()),
    }
    file.extend(
        format!("{dictionary:width$}\n", width = length - 1 + dictionary.chars().count() - dictionary.len()).bytes(),
    );
    file.extend(data);
    file
}

/// An archive of files, each by name, packing and content.
pub fn npz(files: &[(&str, zip::CompressionMethod, &[u8])]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, packing, content) in files {
        let options = zip::write::SimpleFileOptions::default().compression_method(*packing);
        archive.start_file(*name, options).expect("a file of an archive");
        archive.write_all(content).expect("a file of an archive");
    }
    archive.finish().expect("an archive").into_inner()
}

/// A header followed by data.
pub fn attached(header: &str, data: &[u8]) -> Vec<u8> {
    [header.as_bytes(), data].concat()
}

/// The 352 bytes before the data of a 3 x 2 x 2 NIfTI-1 volume, spacings 1, 2, 3 mm.
#[derive(Clone)]
pub struct NiftiHeader {
    pub bytes: Vec<u8>,
    big: bool,
}

impl NiftiHeader {
    pub fn new(datatype: i16, size: usize, big: bool) -> Self {
        let mut header = Self { bytes: vec![0; 352], big };
        header.put(0, &348_i32.to_le_bytes());
        for (index, value) in [3, 3, 2, 2, 1, 1, 1, 1].into_iter().enumerate() {
            header.i16(40 + 2 * index, value);
        }
        header.i16(70, datatype).i16(72, 8 * size as i16);
        header.f32(76, 1.0).f32(80, 1.0).f32(84, 2.0).f32(88, 3.0).f32(108, 352.0);
        header.bytes[123] = 2;
        header.bytes[344..348].copy_from_slice(b"n+1\0");
        header
    }

    /// The 544 bytes before the data of the same volume in NIfTI-2.
    pub fn second(datatype: i16, size: usize, big: bool) -> Self {
        let mut header = Self { bytes: vec![0; 544], big };
        header.put(0, &540_i32.to_le_bytes()).i16(12, datatype).i16(14, 8 * size as i16);
        for (index, value) in [3, 3, 2, 2, 1, 1, 1, 1].into_iter().enumerate() {
            header.i64(16 + 8 * index, value);
        }
        header.f64(104, 1.0).f64(112, 1.0).f64(120, 2.0).f64(128, 3.0).i64(168, 544).i32(500, 2);
        header.bytes[4..12].copy_from_slice(b"n+2\0\r\n\x1a\n");
        header
    }

    /// The header of a pair instead, which has its data from byte 0 on in another file.
    pub fn pair(&self) -> Self {
        let mut header = self.clone();
        let second = header.bytes.len() == 544;
        header.bytes[if second { 5 } else { 345 }] = b'i';
        header.bytes.truncate(if second { 540 } else { 348 });
        if second {
            header.i64(168, 0)
        } else {
            header.f32(108, 0.0)
        };
        header
    }

    /// Little-endian bytes, put in the header's order.
    pub fn put(&mut self, at: usize, little: &[u8]) -> &mut Self {
        let mut bytes = little.to_vec();
        if self.big {
            bytes.reverse();
        }
        self.bytes[at..at + bytes.len()].copy_from_slice(&bytes);
        self
    }

    pub fn i16(&mut self, at: usize, value: i16) -> &mut Self {
        self.put(at, &value.to_le_bytes())
    }

    pub fn f32(&mut self, at: usize, value: f32) -> &mut Self {
        self.put(at, &value.to_le_bytes())
    }

    pub fn i32(&mut self, at: usize, value: i32) -> &mut Self {
        self.put(at, &value.to_le_bytes())
    }

    pub fn i64(&mut self, at: usize, value: i64) -> &mut Self {
        self.put(at, &value.to_le_bytes())
    }

    pub fn f64(&mut self, at: usize, value: f64) -> &mut Self {
        self.put(at, &value.to_le_bytes())
    }

    pub fn with(&self, data: &[u8]) -> Vec<u8> {
        [&self.bytes, data].concat()
    }
}

/// A NIfTI-1 file of 12 bytes of uint8, after a change to its header.
pub fn nifti_u8(change: impl FnOnce(&mut NiftiHeader) -> &mut NiftiHeader) -> Vec<u8> {
    let mut header = NiftiHeader::new(2, 1, false);
    change(&mut header);
    header.with(&[7; 12])
}

/// The NIfTI-2 file of the same volume.
pub fn nifti2_u8(change: impl FnOnce(&mut NiftiHeader) -> &mut NiftiHeader) -> Vec<u8> {
    let mut header = NiftiHeader::second(2, 1, false);
    change(&mut header);
    header.with(&[7; 12])
}

/// The physical values of a volume, x fastest.
pub fn values(volume: &Volume) -> Vec<f32> {
    let [width, height, depth] = volume.dimensions;
    let mut values = Vec::new();
    for z in 0..depth {
        for y in 0..height {
            values.extend((0..width).map(|x| volume.value(x, y, z)));
        }
    }
    values
}

/// Checks the values, the stored type, the range and the count.
pub fn check(volume: &Volume, sample: &Sample) {
    let expected: Vec<f32> = sample.values.iter().map(|&value| value as f32).collect();
    assert_eq!(values(volume), expected, "{}", sample.name);
    let low = expected.iter().copied().fold(f32::INFINITY, f32::min);
    let high = expected.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    assert_eq!(volume.range, [low, high]);
    assert_eq!(volume.voxel_count(), 12);
    assert_eq!(volume.bytes(), 12 * sample.size.min(4));
    assert_eq!(volume.histogram(5).iter().sum::<u64>(), 12);
}

/// Opens broken files of a name, and checks the messages.
pub fn check_refused(name: &str, cases: Vec<(Vec<u8>, &str)>) {
    let folder = Folder::new();
    let mut others = String::new();
    for (content, expected) in cases {
        let message = match folder.open(name, content) {
            Err(error @ (Error::Invalid { .. } | Error::Unsupported { .. })) => error.to_string(),
            other => format!("{other:?}"),
        };
        if !(message.starts_with(&folder.shown(name)) && message.contains(expected)) {
            others += &format!("expected: {expected}\nfound: {message}\n");
        }
    }
    assert!(others.is_empty(), "{others}");
}
