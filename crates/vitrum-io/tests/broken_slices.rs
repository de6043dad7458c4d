//! TIFF stacks and headerless voxels with one thing wrong each, and the part of the message that says so.

mod common;

use common::tiff::{Page, Value, stack_u8, tiff};
use common::vtk::zlib;
use common::{Folder, check_refused, gzip};
use vitrum_io::OpenOptions;

#[test]
fn broken_stacks() {
    let whole = stack_u8(|page| page);
    let changed = |tag: u16, value: Value| stack_u8(|page| page.set(tag, value));
    let both =
        |change: &dyn Fn(Page) -> Page| tiff(true, &[change(Page::bytes(&[1; 6])), change(Page::bytes(&[2; 6]))]);
    let text = |text: &'static str| both(&|page| page.set(270, Value::Text(text)));
    let packed = |data: &[u8]| {
        let page = Page::bytes(data).set(259, Value::Short(8));
        tiff(false, &[page.clone(), page])
    };
    let mut cycle = tiff(false, &[Page::bytes(&[1; 6])]);
    let end = cycle.len() - 4;
    cycle.copy_within(4..8, end);
    check_refused(
        "broken.tif",
        vec![
            (b"II*".to_vec(), "page 1 is damaged"),
            (b"II*\0\0\0\0\0".to_vec(), "page 1 is damaged"),
            (whole[..whole.len() - 30].to_vec(), "page 2 is damaged"),
            (cycle, "page 1 is damaged: format error: file contained a cycle in the list of IFDs"),
            (stack_u8(|page| page.without(256)), "page 2 is damaged"),
            (stack_u8(|page| page.without(279)), "page 2 is damaged"),
            (changed(256, Value::Long(0)), "page 2 is damaged"),
            (changed(257, Value::Long(1)), "page 2 is 3 x 1 uint8, and the first 3 x 2 uint8"),
            (changed(339, Value::Short(2)), "page 2 is 3 x 2 int8, and the first 3 x 2 uint8"),
            (changed(273, Value::Long(5000)), "page 2 is damaged"),
            (changed(262, Value::Short(2)), "page 2"),
            (both(&|page| page.set(258, Value::Short(4))), "page 1 has 4 bit samples of the format Uint"),
            (both(&|page| page.set(258, Value::Short(12))), "page 1"),
            (both(&|page| page.set(259, Value::Short(7))), "page 1 is compressed by ModernJPEG, none of LZW, deflate"),
            (both(&|page| page.set(259, Value::Short(999))), "page 1 is compressed by Unknown(999)"),
            (both(&|page| page.set(277, Value::Short(3))), "page 1"),
            (
                both(&|page| page.set(257, Value::Long(50)).set(278, Value::Long(50))),
                "promises 300 bytes of data, and the",
            ),
            (both(&|page| page.set(256, Value::Long(1 << 30))), "bytes of data, and the"),
            (both(&|page| page.set(254, Value::Long(1))), "all pages are thumbnails"),
            (packed(&zlib(&[1; 5])), "page 1 is damaged"),
            (packed(&[0xff; 30]), "page 1 is damaged"),
            (tiff(false, &vec![Page::new(32, 3, &f32::NAN.to_le_bytes().repeat(6)); 2]), "all of the 12 voxels"),
            (
                text("ImageJ=1\nchannels=3\n"),
                "the pages are 3 channels of 1 slices at 1 points in time, as ImageJ says, and 2 are",
            ),
            (text("ImageJ=1\nslices=2\nframes=3\n"), "1 channels of 2 slices at 3 points in time"),
            (text("ImageJ=1\nunit=mm\nspacing=1e30\n"), "the volume is 2e30 long"),
        ],
    );
}

#[test]
fn neighbours_that_are_no_slices() {
    let folder = Folder::new();
    let slice = tiff(false, &[Page::bytes(&[1; 6])]);
    folder.write("a1.tif", &slice);
    let open = || vitrum_io::open(&folder.path("a1.tif"), &OpenOptions::default()).unwrap_err().to_string();
    folder.write("a2.tif", stack_u8(|page| page));
    assert!(open().contains("a2.tif: 2 page(s) of 3 x 2 uint8, and its numbered neighbour a1.tif has one of 3 x 2"));
    folder.write("a2.tif", tiff(false, &[Page::new(16, 1, &[1; 12])]));
    assert!(open().contains("a2.tif: 1 page(s) of 3 x 2 uint16, and its numbered neighbour a1.tif"));
    folder.write("a2.tif", "nothing");
    assert!(open().contains("a2.tif: page 1 is damaged"));
    folder.write("a2.tif", &slice[..20]);
    assert!(open().contains("a2.tif: page 1 is damaged"));
}

#[test]
fn broken_raw_files() {
    let folder = Folder::new();
    let mut damaged = gzip(&[1; 12]);
    let end = damaged.len() - 6;
    damaged[end] ^= 0xff;
    let plain = || vec![1; 12];
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("a.raw", plain(), "the file has no header, and its name says no dimensions; expected a layout such as"),
        ("a_3x2.raw", plain(), "its name says no dimensions"),
        ("a_3x2x0.raw", plain(), "its name says no dimensions"),
        ("a_3x2x2x2.raw", plain(), "its name says no dimensions"),
        ("a_99999999999x1x1.raw", plain(), "its name says no dimensions"),
        ("a_3x2x1.raw", plain(), "its name says no sample type"),
        ("a_3x2x2.raw.gz", gzip(&[1; 12]), "its name says no sample type"),
        ("a_3x2x3_uint8.raw", plain(), "3 x 2 x 3 voxels of uint8, as the name says, take 18 bytes, and 12 are there"),
        ("a_3x2x2_uint16.bin", plain(), "3 x 2 x 2 voxels of uint16, as the name says, take 24 bytes, and 12"),
        ("a_3x2x1_u8.raw", plain(), "take 6 bytes, and 12 are there"),
        ("a_3x2x2_u8.raw", vec![], "take 12 bytes, and 0 are there"),
        ("a_4294967295x4294967295x4294967295_u8.raw", plain(), "more than any file holds"),
        ("a_3x2x2_f32.raw", vec![0xff; 48], "all of the 12 voxels are NaN"),
        ("a_3x2x3_u8.raw.gz", gzip(&[1; 12]), "the header promises 18 bytes of data, 12 were found"),
        ("a_3x2x1_u8.raw.gz", gzip(&[1; 12]), "the header promises 6 bytes of data, 12 were found"),
        ("a_999x999x999_u8.raw.gz", gzip(&[1; 12]), "compressed bytes can hold"),
        ("a_3x2x2_u8.raw.gz", damaged, "the data is damaged after 12 of 12 bytes"),
    ];
    for (name, content, expected) in cases {
        let message = folder.open(name, content).expect_err(expected).to_string();
        assert!(message.starts_with(&folder.shown(name)), "{message}");
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}

#[test]
fn folders_that_are_no_volume() {
    let cases: [(&[&str], &str); 5] = [
        (&["a1.tif", "a2.tif", "a4.tif"], "between a2.tif and a4.tif slices are missing"),
        (&["a1.tif", "a01.tif"], "two slices have the number 1: a01.tif and a1.tif"),
        (&["a1_1.tif", "a1_2.tif", "a2_1.tif"], "differ in several numbers"),
        (&["a1.tif", "b1.tif"], "several series alike: a#.tif (1 files), b#.tif (1 files)"),
        (&["a.png"], "this is a folder without DICOM or TIFF files"),
    ];
    for (names, expected) in cases {
        let folder = Folder::new();
        for name in names {
            folder.write(name, tiff(false, &[Page::bytes(&[1; 6])]));
        }
        let message = vitrum_io::open(&folder.path("."), &OpenOptions::default()).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    }
}
