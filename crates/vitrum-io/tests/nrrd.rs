//! NRRD: data of every type, byte order and encoding is read, and every field has its meaning.

mod common;

use common::{Folder, attached, check, gzip, hex, nrrd, samples, values};
use vitrum_io::{Error, OpenOptions, Setting, Volume, Voxels};

const BYTES: [u8; 12] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11];

/// A header whose data is elsewhere: without the closing blank line.
fn detached(sample: &str, encoding: &str, more: &str) -> String {
    let mut header = nrrd(sample, encoding, more);
    header.pop();
    header
}

fn open_u8(more: &str) -> Volume {
    Folder::new().open("a.nrrd", attached(&nrrd("uint8", "raw", more), &BYTES)).unwrap()
}

fn near(a: [f32; 3], b: [f32; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5 * (1.0 + b.abs()))
}

#[test]
fn every_type_endian_and_encoding_comes_back() {
    let folder = Folder::new();
    for sample in samples() {
        for (endian, bytes) in [("little", &sample.little), ("big", &sample.big)] {
            let encoded = [
                ("raw", bytes.clone()),
                ("gzip", gzip(bytes)),
                ("gz", gzip(bytes)),
                ("hex", hex(bytes)),
                ("ascii", sample.text.clone().into_bytes()),
                ("text", sample.text.replace('\n', ", ").into_bytes()),
                ("txt", sample.text.replace('\n', "\r\n").into_bytes()),
            ];
            for (encoding, data) in encoded {
                let more = format!("endian: {endian}\n");
                let file = attached(&nrrd(sample.name, encoding, &more), &data);
                check(&folder.open("attached.nrrd", file).unwrap(), &sample);
                folder.write("data file.bin", &data);
                let more = format!("endian: {endian}\ndata file: ./data file.bin\n");
                let header = detached(sample.name, encoding, &more);
                check(&folder.open("detached.nhdr", header).unwrap(), &sample);
            }
        }
    }
}

#[test]
fn signed_integers_are_stored_shifted() {
    let volume = Folder::new().open("a.nrrd", attached(&nrrd("int8", "raw", ""), &BYTES)).unwrap();
    assert_eq!(volume.voxels, Voxels::from(BYTES.map(|byte| byte + 128).to_vec()));
    assert_eq!((volume.value_scale, volume.value_offset), (1.0, -128.0));
}

#[test]
fn every_spelling_of_a_type() {
    let spellings = [
        ("int8", "signed char|int8|int8_t"),
        ("uint8", "uchar|unsigned char|uint8|uint8_t|Unsigned  Char"),
        ("int16", "short|short int|signed short|signed short int|int16|int16_t"),
        ("uint16", "ushort|unsigned short|unsigned short int|uint16|uint16_t"),
        ("int32", "int|signed int|int32|int32_t"),
        ("uint32", "uint|unsigned int|uint32|uint32_t"),
        ("int64", "longlong|long long|long long int|signed long long|signed long long int|int64|int64_t"),
        ("uint64", "ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t"),
        ("float32", "float"),
        ("float64", "double"),
    ];
    let folder = Folder::new();
    for (name, all) in spellings {
        for spelling in all.split('|') {
            let text = "1 2 3 4 5 6 7 8 9 10 11 12";
            let volume = folder.open("a.nrrd", attached(&nrrd(spelling, "text", ""), text.as_bytes()));
            assert_eq!(volume.unwrap().source.sample_type, name, "{spelling}");
        }
    }
}

#[test]
fn comments_pairs_and_windows_line_ends_are_read_over() {
    let header = nrrd("uint8", "raw", "# a comment: with colon\nkey:=value: 1\nContent: ball\n");
    let file = attached(&header.replace('\n', "\r\n"), &BYTES);
    let folder = Folder::new();
    let volume = folder.open("no extension at all", file).unwrap();
    assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()));
    assert_eq!(volume.name, folder.shown("no extension at all"));
}

#[test]
fn lines_and_bytes_are_skipped() {
    let folder = Folder::new();
    let open = |encoding: &str, more: &str, data: &[u8]| {
        folder.write("data", data);
        let header = detached("uint8", encoding, &format!("{more}datafile: data\n"));
        folder.open("a.nhdr", header).unwrap()
    };
    let behind = |start: &[u8], data: &[u8]| [start, data].concat();
    let cases = [
        open("raw", "line skip: 2\n", &behind(b"one\r\ntwo\n", &BYTES)),
        open("raw", "byte skip: 5\n", &behind(b"12345", &BYTES)),
        open("raw", "lineskip: 1\nbyteskip: 2\n", &behind(b"one\nab", &BYTES)),
        open("raw", "byte skip: -1\n", &behind(b"any number of bytes", &BYTES)),
        open("gzip", "line skip: 1\nbyte skip: 2\n", &behind(b"one\n", &gzip(&behind(b"ab", &BYTES)))),
        open("hex", "byte skip: 3\n", &behind(b"xyz", &hex(&BYTES))),
        open("text", "line skip: 1\n", b"numbers:\n0 1 2 3 4 5 6 7 8 9 10 11"),
    ];
    for volume in cases {
        assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()));
    }
}

#[test]
fn many_data_files_make_one_volume() {
    let folder = Folder::new();
    let cases = [
        ("slice.%d 4 5 1", vec!["slice.4", "slice.5"]),
        ("slice%03d.raw 10 8 -2", vec!["slice010.raw", "slice008.raw"]),
        ("s/%d.raw 0 3 1 1", vec!["s/0.raw", "s/1.raw", "s/2.raw", "s/3.raw"]),
        ("slab%d.raw 1 1 1 3", vec!["slab1.raw"]),
        ("LIST\nb.raw\na.raw", vec!["b.raw", "a.raw"]),
        ("LIST 1\n1\n2\n3\n4", vec!["1", "2", "3", "4"]),
        ("LIST 3\nwhole", vec!["whole"]),
    ];
    std::fs::create_dir(folder.path("s")).unwrap();
    for (field, names) in cases {
        for (name, part) in names.iter().zip(BYTES.chunks(12 / names.len())) {
            folder.write(name, part);
        }
        let header = detached("uint8", "raw", &format!("data file: {field}\n"));
        let volume = folder.open("a.nhdr", header).unwrap();
        assert_eq!(volume.voxels, Voxels::from(BYTES.to_vec()), "{field}");
    }
}

#[test]
fn a_file_that_says_nothing_is_centred() {
    let volume = open_u8("");
    assert_eq!(volume.spacing, [1.0; 3]);
    assert_eq!(volume.origin, [-1.0, -0.5, -0.5]);
    assert_eq!(volume.axes, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(volume.extent(), [3.0, 2.0, 2.0]);
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("no spacing")));
}

#[test]
fn directions_turn_into_spacing_and_axes_in_ras() {
    let directions = "space directions: (0,2,0) (3,0,0) (0, 0, -0.5)\nspace origin: (1,2,3)\n";
    let cases = [
        ("right-anterior-superior", [1.0, 1.0, 1.0]),
        ("LAS", [-1.0, 1.0, 1.0]),
        ("left-posterior-superior", [-1.0, -1.0, 1.0]),
        ("scanner-xyz", [1.0, 1.0, 1.0]),
        ("3D-left-handed", [1.0, -1.0, 1.0]),
    ];
    for (space, [x, y, z]) in cases {
        let volume = open_u8(&format!("space: {space}\n{directions}"));
        assert_eq!(volume.spacing, [2.0, 3.0, 0.5]);
        assert!(near(volume.axes[0], [0.0, y, 0.0]), "{space}");
        assert!(near(volume.axes[1], [x, 0.0, 0.0]), "{space}");
        assert!(near(volume.axes[2], [0.0, 0.0, -z]), "{space}");
        assert!(near(volume.origin, [x, 2.0 * y, 3.0 * z]), "{space}");
    }
}

#[test]
fn a_space_without_directions_is_that_of_the_axes() {
    let cases = [("RAS", [1.0, 1.0, 1.0]), ("LPS", [-1.0, -1.0, 1.0]), ("3D-left-handed", [1.0, -1.0, 1.0])];
    for (space, [x, y, z]) in cases {
        let volume = open_u8(&format!("space: {space}\nspacings: 2 3 4\nspace origin: (1,2,3)\n"));
        assert_eq!(volume.spacing, [2.0, 3.0, 4.0], "{space}");
        assert_eq!(volume.axes, [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], "{space}");
        assert!(near(volume.origin, [x, 2.0 * y, 3.0 * z]), "{space}");
    }
}

#[test]
fn without_an_origin_a_turned_grid_is_centred() {
    let volume = open_u8("space: RAS\nspace directions: (0,2,0) (3,0,0) (0,0,4)\n");
    // Half of the way: 1 step of 2 along y, half a step of 3 along x, half a step of 4 along z.
    assert!(near(volume.origin, [-1.5, -2.0, -2.0]));
}

#[test]
fn lengths_turn_into_millimetres() {
    let volume = open_u8("spacings: 1 2 3\nunits: \"cm\" \"cm\" \"cm\"\n");
    assert!(near(volume.spacing, [10.0, 20.0, 30.0]));
    let volume = open_u8(
        "space: RAS\nspace units: \"um\" \"um\" \"um\"\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1000,0,0)\n",
    );
    assert!(near(volume.spacing, [1e-3; 3]));
    assert!(near(volume.origin, [1.0, 0.0, 0.0]));
}

#[test]
fn what_was_assumed_is_told() {
    let told = |more: &str, expected: &str| {
        let notes = open_u8(more).source.assumptions;
        assert!(notes.iter().any(|note| note.fact.contains(expected)), "{expected} not in {notes:?}");
    };
    told("", "no orientation");
    let turned = |more: &str| open_u8(more).source.assumptions.iter().any(|note| note.setting == Some(Setting::Up));
    assert!(turned("") && !turned("space: LPS\n"));
    assert!(turned("space: 3D-left-handed\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"));
    assert!(turned("space: scanner-xyz\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"));
    told("space: LPS\n", "run along the space's");
    told("space: 3D-left-handed\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n", "left-handed");
    told("space: RAS\nspace directions: (1,0,0) (0.5,1,0) (0,0,1)\n", "26.6° off right angles");
    told("units: \"parsec\" \"parsec\" \"parsec\"\n", "no known unit");
    told("old min: 0\n", "`oldmin` was left out of account");
    let file = attached(&nrrd("uint8", "raw", ""), &[1; 15]);
    let volume = Folder::new().open("a.nrrd", file).unwrap();
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("3 bytes behind")));
}

#[test]
fn the_limit_is_on_decoded_bytes() {
    let folder = Folder::new();
    let path = folder.write("a.nrrd", attached(&nrrd("double", "gzip", "endian: big\n"), &gzip(&[0; 96])));
    let open =
        |max_bytes| vitrum_io::open(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert_eq!(values(&open(48).unwrap()), [0.0; 12]);
    assert!(matches!(open(47), Err(Error::TooLarge { needed: 48, limit: 47, .. })));
}

#[test]
fn a_lie_about_the_size_costs_neither_time_nor_memory() {
    let folder = Folder::new();
    let start = std::time::Instant::now();
    for encoding in ["raw", "gzip", "hex", "text"] {
        let header = nrrd("uint8", encoding, "").replace("3 2 2", "10000 10000 10000");
        let error = folder.open("a.nrrd", attached(&header, &[0; 1000])).unwrap_err().to_string();
        assert!(error.contains("the header promises"), "{error}");
        assert!(error.contains("000000000000") && error.contains("1000 "), "{error}");
    }
    assert!(start.elapsed().as_secs() < 5);
}
