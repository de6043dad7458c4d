//! Properties: whatever the bytes are, opening them ends, in a volume, a picture or an error.

mod common;

use std::sync::LazyLock;

use common::dicom::{Dicom, FRAMES, JPEG, LOSSLESS, POSITION, RLE, rle};
use common::tiff::{Page, Value, stack_u8, tiff};
use common::vtk::{LITTLE, appended, base64, vti, vti_text, vtk, word, zlib_blocks};
use common::{Folder, NiftiHeader, attached, gzip, metaimage, npy, npy_with, nrrd, zlib};
use proptest::collection::vec;
use proptest::prelude::*;
use ruzstd::encoding::{CompressionLevel, compress_to_vec};
use vitrum_io::{OpenOptions, Picture, read_picture, write_picture};

/// Bytes to overwrite, as positions and values, and how much to cut off the end.
type Damage = (Vec<(usize, u8)>, usize);

fn damage() -> impl Strategy<Value = Damage> {
    (vec((any::<usize>(), any::<u8>()), 1..12), prop_oneof![4 => Just(0_usize), 1 => any::<usize>()])
}

fn damaged(file: &[u8], (changes, cut): &Damage) -> Vec<u8> {
    let mut file = file.to_vec();
    for (position, value) in changes {
        let position = position % file.len();
        file[position] = *value;
    }
    file.truncate(file.len() - cut % file.len());
    file
}

fn volumes() -> Vec<Vec<u8>> {
    let more = "endian: big\nspace: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3)\n";
    let nifti = NiftiHeader::new(4, 2, false).with(&[1; 24]);
    let placed = "BinaryDataByteOrderMSB = True\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\n\
                  ElementSpacing = 1 2 3\nHeaderSize = 0\n";
    vec![
        attached(&nrrd("int16", "raw", more), &[1; 24]),
        attached(&nrrd("float", "gzip", more), &gzip(&[1; 48])),
        attached(&nrrd("uint8", "text", "spacings: 1 2 3\n"), b"1 2 3 4 5 6 7 8 9 10 11 12"),
        attached(&nrrd("uint8", "hex", "byte skip: 0\nline skip: 0\n"), b"0102030405060708090a0b0c"),
        nrrd("uint8", "raw", "data file: slice%d 1 2 1 2\n").into_bytes(),
        nrrd("uint8", "raw", "data file: LIST\nslice1\nslice2\n").into_bytes(),
        NiftiHeader::new(2, 1, false).i16(40, 4).i16(48, 2).with(&[1; 24]),
        npy_with((1, 0), "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2, 2, 3)}", &[1; 24]),
        gzip(&nifti),
        nifti,
        NiftiHeader::second(4, 2, true).with(&[1; 24]),
        attached(&metaimage("MET_SHORT", placed, "LOCAL"), &[1; 24]),
        attached(&metaimage("MET_FLOAT", "CompressedData = True\nCompressedDataSize = 9\n", "LOCAL"), &zlib(&[1; 48])),
        attached(&metaimage("MET_UCHAR", "BinaryData = False\n", "LOCAL"), b"1 2 3 4 5 6 7 8 9 10 11 12"),
        metaimage("MET_UCHAR", "HeaderSize = -1\n", "slice%d 1 2 1").into_bytes(),
        metaimage("MET_UCHAR", "", "LIST 2\nslice1\nslice2").into_bytes(),
        npy(">i2", &[1; 24]),
        npy_with((2, 0), "{'descr': '<f4', 'fortran_order': True, 'shape': (3, 2, 2)}", &[1; 48]),
    ]
}

/// DICOM files of every way to write pixels.
fn dicom_files() -> Vec<Vec<u8>> {
    let mut run_lengths = Dicom::words(0.0, &[], true);
    run_lengths.compressed(RLE, vec![rle(&[vec![1; 6], vec![2; 6]])]);
    let mut picture = Dicom::words(0.0, &[], false);
    picture.compressed(LOSSLESS, vec![JPEG.to_vec()]);
    let mut frames = Dicom::slice(0.0, &[1; 12]);
    frames.text(FRAMES, "IS", "2").remove(POSITION);
    vec![Dicom::slice(0.0, &[1; 6]).bytes(), run_lengths.bytes(), picture.bytes(), frames.bytes()]
}

fn vtk_files() -> Vec<Vec<u8>> {
    let (header, data) = zlib_blocks(&[1; 24], 10, 8, false);
    let file = format!("{LITTLE} header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"");
    let plain = base64(&[word(24, 4, true), vec![1; 24]].concat());
    vec![
        vti_text().into_bytes(),
        vtk("ASCII", "short", b"1 2 3 4 5 6 7 8 9 10 11 12"),
        vtk("BINARY", "float", &[1; 48]),
        vti("byte_order=\"BigEndian\"", "type=\"Int16\" format=\"binary\"", &plain, b""),
        vti(&file, "type=\"Int16\" format=\"binary\"", &(base64(&header) + &base64(&data)), b""),
        vti(&file, "type=\"UInt16\" format=\"appended\" offset=\"0\"", "", &appended("raw", &[header, data].concat())),
    ]
}

fn stacks() -> Vec<Vec<u8>> {
    let packed = Page::new(16, 2, &zlib(&[1; 12])).set(259, Value::Short(8));
    let noted = Page::new(32, 3, &[1; 24]).set(270, Value::Text("ImageJ=1.51n\nimages=2\nunit=mm\nspacing=8.8\n"));
    let noted = noted.set(282, Value::Rational(2, 1)).set(283, Value::Rational(2, 1)).set(296, Value::Short(3));
    let tiles = Page::bytes(&[1; 256]).without(273).without(278).without(279);
    let tiles = tiles.set(322, Value::Long(16)).set(323, Value::Long(16));
    let tiles = tiles.set(324, Value::Long(8)).set(325, Value::Long(256));
    vec![stack_u8(|page| page), tiff(true, &[packed.clone(), packed]), tiff(true, &[noted]), tiff(false, &[tiles])]
}

/// One file of each picture format, written once.
static PICTURES: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| {
    let folder = Folder::new();
    let pixels = (0..16).map(|index| [index as f32 / 16.0, 0.5, 2.0]).collect();
    let picture = Picture::rgb(4, 4, pixels);
    ["png", "exr", "hdr", "jpg", "tif"]
        .map(|extension| {
            let path = folder.path(&format!("a.{extension}"));
            write_picture(&path, &picture, &[]).unwrap();
            std::fs::read(path).unwrap()
        })
        .to_vec()
});

fn open(folder: &Folder, name: &str, content: &[u8]) {
    let path = folder.write(name, content);
    let options = OpenOptions { max_bytes: Some(1 << 20), ..OpenOptions::default() };
    if let Ok(volume) = vitrum_io::open(&path, &options) {
        assert!(volume.bytes() <= 1 << 20);
        assert!(volume.range[0] <= volume.range[1] && volume.range.iter().all(|end| end.is_finite()));
        assert!(volume.spacing.iter().all(|spacing| *spacing > 0.0 && spacing.is_finite()));
        assert!(volume.origin.iter().chain(volume.axes.as_flattened()).all(|value| value.is_finite()));
        assert_eq!(volume.histogram(7).iter().sum::<u64>(), volume.voxel_count() as u64);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_volumes(damage in damage()) {
        let folder = Folder::new();
        folder.write("slice1", [1; 6]);
        folder.write("slice2", [2; 6]);
        for file in volumes() {
            open(&folder, "a", &damaged(&file, &damage));
        }
    }

    #[test]
    fn damaged_pairs(damage in damage(), image in damage()) {
        let folder = Folder::new();
        for header in [NiftiHeader::new(2, 1, false), NiftiHeader::second(2, 1, true)] {
            folder.write("a.img", damaged(&gzip(&[1; 12]), &image));
            open(&folder, "a.hdr", &damaged(&header.pair().bytes, &damage));
        }
    }

    #[test]
    fn damaged_vtk_files(damage in damage()) {
        let folder = Folder::new();
        for file in vtk_files() {
            open(&folder, "a", &damaged(&file, &damage));
        }
    }

    #[test]
    fn random_metaimage_lines(lines in vec("(ElementSpacing|ElementSize|Offset|TransformMatrix|HeaderSize|CompressedData|BinaryData|ElementByteOrderMSB|ElementNumberOfChannels|DistanceUnits|ElementDataFile)[:= ]{1,3}[-0-9a-zLIST%., ]{0,24}", 0..6)) {
        let header = metaimage("MET_UCHAR", &format!("{}\n", lines.join("\n")), "LOCAL");
        open(&Folder::new(), "a.mha", &attached(&header, &[1; 12]));
    }

    #[test]
    fn random_numpy_dictionaries(text in "[{}()'\"<>|, :a-zA-Z0-9\\[\\]µ]{0,60}", version in 1_u8..4) {
        let folder = Folder::new();
        open(&folder, "a.npy", &npy_with((version, 0), &text, &[1; 12]));
        let entries = format!("{{'descr': '|u1', 'fortran_order': False, 'shape': {text}}}");
        open(&folder, "a.npy", &npy_with((version, 0), &entries, &[1; 12]));
    }

    #[test]
    fn damaged_dicom_files(damage in damage()) {
        let folder = Folder::new();
        for file in dicom_files() {
            open(&folder, "a.dcm", &damaged(&file, &damage));
        }
    }

    #[test]
    fn damaged_packed_files(damage in damage()) {
        let folder = Folder::new();
        let file = attached(&nrrd("uint8", "raw", ""), &[1; 12]);
        for packed in [gzip(&file), compress_to_vec(&file[..], CompressionLevel::Fastest)] {
            open(&folder, "a", &damaged(&packed, &damage));
        }
        let nifti = NiftiHeader::new(2, 1, false).with(&[1; 12]);
        open(&folder, "a", &damaged(&compress_to_vec(&nifti[..], CompressionLevel::Fastest), &damage));
    }

    #[test]
    fn any_layout(text in "[0-9]{1,3}x[0-9]x[0-9]:[uif](8|16|32|64)(:[lb]e)?(:skip=[0-9]{1,20})?|[0-9x:a-z=-]{0,20}", bytes in vec(any::<u8>(), 0..99)) {
        if let Ok(raw) = text.parse() {
            let path = Folder::new();
            let file = path.write("a", &bytes);
            let _ = vitrum_io::open(&file, &OpenOptions { raw: Some(raw), max_bytes: Some(1 << 20), ..OpenOptions::default() });
        }
    }

    #[test]
    fn random_vtk_lines(lines in vec("(SCALARS|VECTORS|FIELD|LOOKUP_TABLE|COLOR_SCALARS|TEXTURE_COORDINATES|METADATA|CELL_DATA|POINT_DATA|a)( [a-z0-9_]{1,5}){0,3}", 0..8)) {
        for kind in ["ASCII", "BINARY"] {
            let file = vtk(kind, "unsigned_char", format!("{}\n", "1 ".repeat(12)).as_bytes());
            open(&Folder::new(), "a.vtk", &[&file[..], lines.join("\n").as_bytes()].concat());
        }
    }

    #[test]
    fn damaged_stacks(damage in damage()) {
        let folder = Folder::new();
        for file in stacks() {
            open(&folder, "a", &damaged(&file, &damage));
        }
    }

    #[test]
    fn any_bytes_under_a_raw_name(bytes in vec(any::<u8>(), 0..99), name in "[a-z_]{0,3}[0-9]{0,2}x[0-9]x[0-9](_[uif](8|16|32))?(_[lb]e)?\\.(raw|bin)(\\.gz)?") {
        let folder = Folder::new();
        open(&folder, &name, &bytes);
        open(&folder, &name, &gzip(&bytes));
    }

    #[test]
    fn random_header_lines(lines in vec("(type|sizes|space|spacings|encoding|endian|data ?file|byte skip|line skip|space directions|space origin|units|kinds|LIST)[:= ]{1,3}[-0-9a-z%., ()\"]{0,24}", 0..6)) {
        let header = nrrd("uint8", "raw", "");
        let header: String = header.lines().filter(|line| {
            let name = line.split(':').next().unwrap_or_default();
            name.is_empty() || !lines.iter().any(|other| other.starts_with(name))
        }).map(|line| format!("{line}\n")).collect();
        let header = format!("{}{}\n\n", header.trim_end_matches('\n').to_owned() + "\n", lines.join("\n"));
        open(&Folder::new(), "a.nrrd", &attached(&header, &[1; 12]));
    }

    #[test]
    fn random_bytes(bytes in vec(any::<u8>(), 0..700), extension in "nrrd|nhdr|nii|nii\\.gz|hdr|img|mha|mhd|npy|vti|vtk|tif|raw|png|x") {
        let folder = Folder::new();
        open(&folder, &format!("a.{extension}"), &bytes);
        let _ = read_picture(&folder.path(&format!("a.{extension}")));
    }

    #[test]
    fn damaged_pictures(damage in damage()) {
        let folder = Folder::new();
        for file in PICTURES.iter() {
            let path = folder.write("a", damaged(file, &damage));
            if let Ok(picture) = read_picture(&path) {
                assert_eq!(picture.color().len() as u64, u64::from(picture.width) * u64::from(picture.height));
            }
        }
    }
}
