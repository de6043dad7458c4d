//! MetaImage: data of every type, byte order and layout is read, and every field has its meaning.

mod common;

use common::{Folder, attached, check, gzip, metaimage, samples, values, zlib};
use vitrum_io::{Error, OpenOptions, Volume, Voxels};

const BYTES: [u8; 12] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11];

fn open_u8(more: &str) -> Volume {
    Folder::new().open("a.mha", attached(&metaimage("MET_UCHAR", more, "LOCAL"), &BYTES)).unwrap()
}

fn near(a: [f32; 3], b: [f32; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5 * (1.0 + b.abs()))
}

#[test]
fn every_type_endian_and_encoding_comes_back() {
    let folder = Folder::new();
    for sample in samples() {
        for (msb, bytes) in [("False", &sample.little), ("True", &sample.big)] {
            for field in ["BinaryDataByteOrderMSB", "ElementByteOrderMSB"] {
                let encoded = [
                    ("BinaryData = True\n", bytes.clone()),
                    ("CompressedData = False\n", bytes.clone()),
                    ("CompressedData = True\n", zlib(bytes)),
                    ("CompressedData = True\nCompressedDataSize = 3\n", zlib(bytes)),
                    ("CompressedData = True\n", gzip(bytes)),
                    ("BinaryData = False\n", sample.text.clone().into_bytes()),
                ];
                for (encoding, data) in encoded {
                    let more = format!("{field} = {msb}\n{encoding}");
                    let file = attached(&metaimage(sample.metaimage, &more, "LOCAL"), &data);
                    check(&folder.open("local.mha", file).unwrap(), &sample);
                    folder.write("data file.bin", &data);
                    let header = metaimage(sample.metaimage, &more, "./data file.bin");
                    check(&folder.open("detached.mhd", header.trim_end()).unwrap(), &sample);
                }
            }
        }
    }
}

#[test]
fn signed_integers_are_stored_shifted() {
    let volume = Folder::new().open("a.mha", attached(&metaimage("MET_CHAR", "", "LOCAL"), &BYTES)).unwrap();
    assert_eq!(volume.voxels, Voxels::from(BYTES.map(|byte| byte + 128).to_vec()));
    assert_eq!((volume.value_scale, volume.value_offset), (1.0, -128.0));
    assert_eq!(values(&volume), BYTES.map(f32::from));
}

#[test]
fn a_long_has_4_bytes() {
    let folder = Folder::new();
    for (element, name) in [("MET_LONG", "int32"), ("MET_ULONG", "uint32")] {
        let data: Vec<u8> = (0..12_u32).flat_map(u32::to_le_bytes).collect();
        let volume = folder.open("a.mha", attached(&metaimage(element, "", "LOCAL"), &data)).unwrap();
        assert_eq!(values(&volume), BYTES.map(f32::from));
        assert_eq!(volume.source.sample_type, name);
    }
}

#[test]
fn the_content_decides_and_odd_headers_are_read() {
    let header = metaimage("MET_UCHAR", "Comment = any: text = here\nComment = more\n", "Local");
    let folder = Folder::new();
    let windows = attached(&header.replace('\n', "\r\n"), &BYTES);
    let colons = attached(&header.replace(" = ", ": "), &BYTES);
    let older = attached(header.trim_start_matches("ObjectType = Image\n"), &BYTES);
    for (name, file) in [("no extension", windows), ("colons.mha", colons), ("older", older)] {
        let volume = folder.open(name, file).unwrap();
        assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()), "{name}");
        assert_eq!(volume.source.format, "MetaImage");
    }
}

#[test]
fn bytes_before_the_data_are_skipped() {
    let folder = Folder::new();
    let open = |more: &str, data: &[u8]| {
        folder.write("data", data);
        folder.open("a.mhd", metaimage("MET_UCHAR", more, "data")).unwrap()
    };
    let behind = |start: &[u8], data: &[u8]| [start, data].concat();
    let local = metaimage("MET_UCHAR", "HeaderSize = 100\n", "LOCAL");
    let padded = format!("{local:99}\n");
    let cases = [
        open("HeaderSize = 0\n", &BYTES),
        open("HeaderSize = 5\n", &behind(b"12345", &BYTES)),
        open("HeaderSize = -1\n", &behind(b"any number of bytes", &BYTES)),
        open("HeaderSize = 5\nCompressedData = True\n", &behind(b"12345", &zlib(&BYTES))),
        open("HeaderSize = 5\nBinaryData = False\n", &behind(b"12345", b"0 1 2 3 4 5 6 7 8 9 10 11")),
        folder
            .open("a.mha", attached(&metaimage("MET_UCHAR", "HeaderSize = -1\n", "LOCAL"), &behind(b"pad", &BYTES)))
            .unwrap(),
        folder.open("b.mha", attached(&padded.replace("100", &padded.len().to_string()), &BYTES)).unwrap(),
    ];
    for volume in cases {
        assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()));
    }
}

#[test]
fn many_data_files_make_one_volume() {
    let folder = Folder::new();
    let cases = [
        ("LIST\nb.raw\na.raw", vec!["b.raw", "a.raw"]),
        ("LIST 2\n\nb.raw\na.raw\n", vec!["b.raw", "a.raw"]),
        ("LIST 1\n1\n2\n3\n4", vec!["1", "2", "3", "4"]),
        ("LIST 3\nwhole", vec!["whole"]),
        ("slice.%d 4 5 1", vec!["slice.4", "slice.5"]),
        ("slice%03d.raw 10 8 -2", vec!["slice010.raw", "slice008.raw"]),
        ("s/%d.raw 7", vec!["s/7.raw", "s/8.raw"]),
        ("s/x%d.raw 0 1", vec!["s/x0.raw", "s/x1.raw"]),
        ("s/y%02d", vec!["s/y01", "s/y02"]),
        ("100% real.raw", vec!["100% real.raw"]),
    ];
    std::fs::create_dir(folder.path("s")).unwrap();
    for (field, names) in cases {
        for more in ["", "CompressedData = True\n"] {
            for (name, part) in names.iter().zip(BYTES.chunks(12 / names.len())) {
                folder.write(name, if more.is_empty() { part.to_vec() } else { zlib(part) });
            }
            let volume = folder.open("a.mhd", metaimage("MET_UCHAR", more, field)).unwrap();
            assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()), "{field}");
        }
    }
}

#[test]
fn a_file_that_says_nothing_is_centred() {
    let volume = open_u8("");
    assert_eq!(volume.spacing, [1.0; 3]);
    assert_eq!(volume.axes, [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(near(volume.origin, [1.0, 0.5, -0.5]));
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("no spacing")));
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("no TransformMatrix")));
}

#[test]
fn rows_of_the_matrix_are_axes_in_lps() {
    for matrix in ["TransformMatrix", "Orientation", "Rotation"] {
        for offset in ["Offset", "Position", "Origin"] {
            for spacing in ["ElementSpacing", "ElementSize", "ElementSize = 9 9 9\nelementspacing"] {
                let volume =
                    open_u8(&format!("{matrix} = 0 1 0 0 0 1 1 0 0\n{offset} = 10 20 30\n{spacing} = 2 3 5e-1\n"));
                assert!(near(volume.spacing, [2.0, 3.0, 0.5]), "{matrix} {offset} {spacing}");
                assert!(near(volume.axes[0], [0.0, -1.0, 0.0]));
                assert!(near(volume.axes[1], [0.0, 0.0, 1.0]));
                assert!(near(volume.axes[2], [-1.0, 0.0, 0.0]));
                assert!(near(volume.origin, [-10.0, -20.0, 30.0]));
            }
        }
    }
}

#[test]
fn without_a_matrix_the_anatomical_orientation_counts() {
    let axes = |more: &str| open_u8(more).axes;
    // Further directions that ITK writes, besides the identity.
    assert_eq!(axes("AnatomicalOrientation = RAI\n"), axes(""));
    assert_eq!(axes("AnatomicalOrientation = ???\n"), axes(""));
    // Sagittal slices from the left, whose rows run down and to the back.
    let expected = [[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]];
    assert_eq!(axes("AnatomicalOrientation = asl\n"), expected);
    assert_eq!(axes("AnatomicalOrientation = ASL\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"), axes(""));
    let notes = open_u8("AnatomicalOrientation = ASL\n").source.assumptions;
    assert!(notes.iter().any(|note| note.fact.contains("run from ASL, as ITK means")), "{notes:?}");
}

#[test]
fn lengths_turn_into_millimetres() {
    for (unit, scale) in [("mm", 1.0), ("cm", 10.0), ("um", 1e-3)] {
        let volume = open_u8(&format!("DistanceUnits = {unit}\nElementSpacing = 1 2 3\nOffset = 1 0 0\n"));
        assert!(near(volume.spacing, [scale, 2.0 * scale, 3.0 * scale]), "{unit}");
        assert!(near(volume.origin, [-scale, 0.0, 0.0]), "{unit}");
    }
}

#[test]
fn more_axes_are_fine_where_they_are_of_size_1() {
    let more = "ElementSpacing = 1 2 3 4\nOffset = 1 2 3 4\nTransformMatrix = 0 1 0 0 1 0 0 0 0 0 1 0 0 0 0 1\n";
    let header = metaimage("MET_UCHAR", more, "LOCAL").replace("NDims = 3", "NDims = 4").replace("3 2 2", "3 2 2 1");
    let volume = Folder::new().open("a.mha", attached(&header, &BYTES)).unwrap();
    assert_eq!(volume.dimensions, [3, 2, 2]);
    assert_eq!(volume.spacing, [1.0, 2.0, 3.0]);
    assert!(near(volume.axes[0], [0.0, -1.0, 0.0]));
    assert!(near(volume.origin, [-1.0, -2.0, 3.0]));
}

#[test]
fn what_was_assumed_is_told() {
    let told = |volume: Volume, expected: &str| {
        let notes = volume.source.assumptions;
        assert!(notes.iter().any(|note| note.fact.contains(expected)), "{expected} not in {notes:?}");
    };
    told(open_u8("ElementToIntensityFunctionSlope = 2\n"), "`ElementToIntensityFunctionSlope` was left out of account");
    told(open_u8("DistanceUnits = parsec\n"), "no known unit");
    told(open_u8("DistanceUnits = ?\n"), "names no unit");
    told(open_u8("TransformMatrix = 1 0 0 0.5 1 0 0 0 1\n"), "26.6° off right angles");
    let folder = Folder::new();
    let open = |element: &str, more: &str, data: &[u8]| {
        folder.open("a.mha", attached(&metaimage(element, more, "LOCAL"), data)).unwrap()
    };
    told(open("MET_UCHAR", "", &[1; 15]), "3 bytes behind");
    told(open("MET_SHORT", "", &[1; 24]), "names no byte order: little-endian");
    told(open("MET_DOUBLE", "", &[0; 96]), "rounded");
    let packed = zlib(&BYTES);
    let expected = format!("says 5 bytes of compressed data, {} are there", packed.len());
    told(open("MET_UCHAR", "CompressedData = True\nCompressedDataSize = 5\n", &packed), &expected);
}

#[test]
fn the_limit_is_on_decoded_bytes() {
    let folder = Folder::new();
    let header = metaimage("MET_DOUBLE", "CompressedData = True\n", "LOCAL");
    let path = folder.write("a.mha", attached(&header, &zlib(&[0; 96])));
    let open =
        |max_bytes| vitrum_io::open(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert_eq!(values(&open(48).unwrap()), [0.0; 12]);
    assert!(matches!(open(47), Err(Error::TooLarge { needed: 48, limit: 47, .. })));
}
