//! Options of a caller for reading: layout, spacing, time, up, the memory limit; and compression around whole files.

mod common;

use std::path::Path;

use common::tiff::{Page, tiff};
use common::vtk::{vti_text, vtk};
use common::{Folder, NiftiHeader, attached, gzip, metaimage, npy, npy_with, nrrd, values};
use ruzstd::encoding::{CompressionLevel, compress_to_vec};
use vitrum_io::{Error, OpenOptions, Setting, Volume, open};

/// The numbers 1 to 12.
const DATA: [u8; 12] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

fn zstd(bytes: &[u8]) -> Vec<u8> {
    compress_to_vec(bytes, CompressionLevel::Fastest)
}

fn read(path: &Path, change: impl FnOnce(&mut OpenOptions)) -> Result<Volume, Error> {
    let mut options = OpenOptions::default();
    change(&mut options);
    open(path, &options)
}

fn refused(path: &Path, change: impl FnOnce(&mut OpenOptions)) -> String {
    read(path, change).expect_err("a wrong option").to_string()
}

#[test]
fn every_format_is_read_through_gzip_and_zstd() {
    let folder = Folder::new();
    let pages = [Page::bytes(&DATA[..6]), Page::bytes(&DATA[6..])];
    let files: [(&str, Vec<u8>); 7] = [
        ("a.nrrd", attached(&nrrd("uint8", "raw", ""), &DATA)),
        ("a.nii", NiftiHeader::new(2, 1, false).with(&DATA)),
        ("a.mha", attached(&metaimage("MET_UCHAR", "", "LOCAL"), &DATA)),
        ("a.npy", npy("|u1", &DATA)),
        ("a.vti", vti_text().into_bytes()),
        ("a.vtk", vtk("BINARY", "unsigned_char", &DATA)),
        ("a.tif", tiff(false, &pages)),
    ];
    let expected: Vec<f32> = DATA.iter().map(|&value| value.into()).collect();
    for (name, content) in files {
        let parts = content.len() / 2;
        let frames = [zstd(&content[..parts]), b"\x50\x2a\x4d\x18\x03\0\0\0abc".to_vec(), zstd(&content[parts..])];
        for (name, packed) in [
            (format!("{name}.gz"), gzip(&content)),
            (format!("{name}.zst"), zstd(&content)),
            // The content tells; and there may be several frames, and some to skip.
            (name.to_owned(), frames.concat()),
        ] {
            let volume = folder.open(&name, packed).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(values(&volume), expected, "{name}");
        }
    }
    let raw = folder.open("a_3x2x2_uint8.raw.zst", zstd(&DATA)).unwrap();
    assert_eq!((values(&raw), raw.source.encoding.as_str()), (expected, "zstd"));
}

#[test]
fn a_packed_header_names_files_beside_it() {
    let folder = Folder::new();
    folder.write("a.raw", DATA);
    let volume = folder.open("a.nhdr.zst", zstd(nrrd("uint8", "raw", "data file: a.raw\n").as_bytes())).unwrap();
    assert_eq!(values(&volume)[11], 12.0);
}

#[test]
fn files_that_unpack_to_more_than_the_limit_are_refused() {
    let folder = Folder::new();
    let bomb = attached(&nrrd("uint8", "raw", ""), &vec![0; 8 << 20]);
    for (name, packed) in [("a.nrrd.gz", gzip(&bomb)), ("a.nrrd.zst", zstd(&bomb))] {
        assert!(packed.len() < 100_000);
        let path = folder.write(name, packed);
        match read(&path, |options| options.max_bytes = Some(1 << 20)) {
            Err(Error::TooLarge { needed, limit, .. }) => {
                // It stops soon behind the limit.
                assert!(limit == 1 << 20 && needed <= (1 << 20) + (64 << 10), "{needed}");
            }
            other => panic!("{other:?}"),
        }
        assert!(read(&path, |options| options.max_bytes = Some(16 << 20)).is_ok(), "the limit can be raised");
    }
    // A header that promises more than a zstd stream of this size can hold.
    let path = folder.write("a_3000x3000x3000_uint8.raw.zst", zstd(&DATA));
    assert!(refused(&path, |_| {}).contains("can hold"));
}

#[test]
fn damaged_packing_is_told_so() {
    let folder = Folder::new();
    let content = attached(&nrrd("uint8", "raw", ""), &DATA);
    for packed in [gzip(&content), zstd(&content)] {
        let cut = packed[..packed.len() - 6].to_vec();
        let mut damaged = packed.clone();
        let end = packed.len() - 2;
        damaged[end] ^= 0x55;
        for content in [cut, damaged] {
            let error = folder.open("a.nrrd", content).expect_err("a damaged file").to_string();
            assert!(error.starts_with(&folder.shown("a.nrrd: the data is damaged after")), "{error}");
        }
    }
}

#[test]
fn a_layout_reads_any_file() {
    let folder = Folder::new();
    let words: Vec<u8> = (1..=12_i16).flat_map(|value| (-value).to_be_bytes()).collect();
    let path = folder.write("voxels.dat", [b"header", &words[..]].concat());
    let layout = |text: &str| Some(text.parse().unwrap());
    let volume = read(&path, |options| options.raw = layout("3x2x2:i16:be:skip=6")).unwrap();
    assert_eq!(values(&volume), (1..=12).map(|value| -value as f32).collect::<Vec<_>>());
    assert_eq!((volume.spacing, volume.source.encoding.as_str()), ([1.0; 3], "raw, big-endian"));
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("no spacing")));
    let spaced = |options: &mut OpenOptions| {
        (options.raw, options.spacing) = (layout("3x2x2:i16:be:skip=6"), Some([0.5, 1.0, 2.0]));
    };
    let volume = read(&path, spaced).unwrap();
    assert_eq!((volume.spacing, volume.origin), ([0.5, 1.0, 2.0], [-0.5, -0.5, -1.0]));
    assert!(!volume.source.assumptions.iter().any(|note| note.fact.contains("no spacing")));
    assert!(refused(&path, |options| options.raw = layout("3x2x2:i16")).contains("take 24 bytes, and 30 are there"));
    assert!(refused(&path, |options| options.raw = layout("3x2x2:i16:skip=7")).contains("behind the 7 skipped"));
    // Voxels that begin as a gzip file does are voxels where their size fits.
    let path = folder.write("odd.dat", [0x1f, 0x8b, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]);
    assert_eq!(values(&read(&path, |options| options.raw = layout("3x2x2:u8")).unwrap())[0], 31.0);
    let path = folder.write("packed.dat", gzip(&DATA));
    assert_eq!(values(&read(&path, |options| options.raw = layout("3x2x2:u8")).unwrap())[11], 12.0);
}

/// Three points in time: 1 to 12, 101 to 112, 201 to 212.
fn three() -> Vec<u8> {
    [0, 100, 200].iter().flat_map(|start| DATA.map(|value| value + start)).collect()
}

#[test]
fn points_in_time_are_picked() {
    let folder = Folder::new();
    let mut nifti = NiftiHeader::new(2, 1, false);
    nifti.i16(40, 4).i16(48, 3);
    let four = |encoding: &str, more: &str| {
        nrrd("uint8", encoding, more).replace("dimension: 3", "dimension: 4").replace("2 2\n", "2 2 3\n")
    };
    let text: String = three().iter().map(|value| format!("{value} ")).collect();
    let hex = common::hex(&three());
    let directions = "space: RAS\nspace directions: (1,0,0) (0,2,0) (0,0,3) none\nkinds: domain domain domain time\n";
    let c_order = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 2, 2, 3)}";
    let fortran = "{'descr': '|u1', 'fortran_order': True, 'shape': (3, 2, 2, 3)}";
    folder.write("t0", &three()[..12]);
    folder.write("t1", &three()[12..24]);
    folder.write("t2", &three()[24..]);
    let files: [(&str, Vec<u8>); 10] = [
        ("a.nii", nifti.with(&three())),
        ("a.nii.gz", gzip(&nifti.with(&three()))),
        ("a.nii.zst", zstd(&nifti.with(&three()))),
        ("raw.nrrd", attached(&four("raw", directions), &three())),
        ("gzip.nrrd", attached(&four("gzip", "spacings: 1 2 3 nan\n"), &gzip(&three()))),
        ("text.nrrd", attached(&four("text", ""), text.as_bytes())),
        ("hex.nrrd", attached(&four("hex", ""), &hex)),
        ("files.nhdr", four("raw", "data file: t%d 0 2 1\n").into_bytes()),
        ("c.npy", npy_with((1, 0), c_order, &three())),
        ("fortran.npy", npy_with((1, 0), fortran, &three())),
    ];
    for (name, content) in files {
        let path = folder.write(name, content);
        for time in 0..3_u32 {
            let volume = read(&path, |options| options.time = Some(time)).unwrap_or_else(|error| panic!("{error}"));
            let expected: Vec<f32> = (1..=12).map(|value| (100 * time + value) as f32).collect();
            assert_eq!(values(&volume), expected, "{name} at {time}");
            assert!(!volume.source.assumptions.iter().any(|note| note.fact.contains("in time")), "{name}");
        }
        let volume = read(&path, |_| {}).unwrap();
        assert_eq!(values(&volume)[0], 1.0);
        let taken = volume.source.assumptions.iter().find(|note| note.setting == Some(Setting::Time)).unwrap();
        assert_eq!(
            taken.to_string(),
            "the file has 3 points in time: the first was taken; others are: 0 to 2",
            "{name}"
        );
        let error = read(&path, |options| options.time = Some(3)).unwrap_err();
        assert_eq!(error.setting(), Some(Setting::Time));
        let error = refused(&path, |options| options.time = Some(3));
        assert!(error.contains("the point in time 3 is asked for, and the file has 3"), "{error}");
    }
    let short = folder.write("short.nii", nifti.with(&three()[..35]));
    assert!(refused(&short, |options| options.time = Some(0)).contains("promises 36 bytes"));
    let list = folder.write("list.nhdr", four("raw", "data file: LIST\nt0\nt1\n"));
    assert!(refused(&list, |_| {}).contains("2 data files for 3 points in time"));
}

#[test]
fn what_a_format_does_not_have_cannot_be_picked() {
    let folder = Folder::new();
    let path = folder.write("a.mha", attached(&metaimage("MET_UCHAR", "", "LOCAL"), &DATA));
    assert!(refused(&path, |options| options.array = Some("a".to_owned())).contains("has no arrays with names"));
    assert!(refused(&path, |options| options.time = Some(1)).contains("the file has 1"));
    assert!(read(&path, |options| options.time = Some(0)).is_ok());
}

#[test]
fn up_turns_what_is_placed() {
    let folder = Folder::new();
    let more = "space: RAS\nspace directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (1,2,3)\n";
    let path = folder.write("a.nrrd", attached(&nrrd("uint8", "raw", more), &DATA));
    let volume = read(&path, |options| options.up = Some(vitrum_io::Up::Inferior)).unwrap();
    assert_eq!(volume.axes, [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]);
    assert_eq!((volume.origin, volume.spacing), ([-1.0, 2.0, -3.0], [1.0, 2.0, 3.0]));
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("turned so that -z points up")));
    let volume = read(&path, |options| options.up = Some(vitrum_io::Up::Superior)).unwrap();
    assert_eq!(volume, read(&path, |_| {}).unwrap());
}
