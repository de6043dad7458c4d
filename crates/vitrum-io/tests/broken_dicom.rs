//! DICOM series with one thing wrong each, and the part of the message that says so.

mod common;

use common::Folder;
use common::dicom::{
    Dicom, FRAMES, JPEG_2000, JPEG_2000_WORDS, JPEG_LS, JPEG_LS_WORDS, ORIENTATION, POSITION, RLE, SERIES, rle,
};
use vitrum_io::{Error, OpenOptions, open};

fn at(z: f64) -> Dicom {
    Dicom::slice(z, &[1; 6])
}

fn changed(z: f64, change: impl FnOnce(&mut Dicom) -> &mut Dicom) -> Dicom {
    let mut slice = at(z);
    change(&mut slice);
    slice
}

/// A JPEG picture's start: its size, and nothing behind it.
fn jpeg(rows: u16, columns: u16) -> Vec<u8> {
    let [rows, columns] = [rows, columns].map(u16::to_be_bytes);
    [&[0xff, 0xd8, 0xff, 0xc3, 0, 11, 8][..], &rows, &columns, &[1, 1, 0x11, 0]].concat()
}

/// A slice of words, compressed.
fn packed(syntax: &'static str, picture: &[u8]) -> Dicom {
    let mut slice = Dicom::words(0.0, &[], false);
    slice.compressed(syntax, vec![picture.to_vec()]);
    slice
}

/// A picture with 255 in one of its bytes.
fn wide(picture: &[u8], at: usize) -> Vec<u8> {
    let mut picture = picture.to_vec();
    picture[at] = 255;
    picture
}

#[test]
fn broken_series() {
    let cases: Vec<(Vec<Dicom>, &str)> = vec![
        (vec![at(0.0), at(1.0), at(1.0)], "lie at the same place; keep one of them"),
        (vec![at(0.0), at(1.0), at(3.0), at(4.0)], "1 slice(s) seem to be missing: 2.000 mm between slice1 and slice2"),
        (vec![at(0.0), at(1.0), at(2.7)], "too unevenly: from 1.000 mm to 1.700 mm between slice1 and slice2"),
        (vec![at(0.0), changed(1.0, |s| s.short((0x0028, 0x0010), 1))], "slice1: this slice is 3 x 1 uint8 of 8 bits"),
        (vec![at(0.0), changed(1.0, |s| s.bits(8, 7, 6, false))], "of 7 bits"),
        (vec![at(0.0), changed(1.0, |s| s.text((0x0028, 0x0030), "DS", "3\\1"))], "at other distances"),
        (vec![at(0.0), changed(1.0, |s| s.text(ORIENTATION, "DS", "0\\1\\0\\0\\0\\1"))], "is turned against slice0"),
        (vec![at(0.0), changed(1.0, |s| s.text(ORIENTATION, "DS", "1\\0\\0\\1\\0\\0"))], "is turned against"),
        (vec![changed(1.0, |s| s.text(ORIENTATION, "DS", "1\\0\\0\\1\\0\\0"))], "is not two directions of length 1"),
        (vec![at(0.0), changed(1.0, |s| s.remove(POSITION))], "slice1: the slice says no Image Position"),
        (vec![at(0.0), changed(1.0, |s| s.text(POSITION, "DS", "10\\25\\1")), at(2.0)], "beside the line"),
        (
            vec![changed(0.0, |s| s.short((0x0028, 0x0002), 3).text((0x0028, 0x0004), "CS", "RGB"))],
            "in colours (RGB, 3",
        ),
        (vec![changed(0.0, |s| s.bits(12, 12, 11, false))], "have 12 bits"),
        (vec![changed(0.0, |s| s.bits(16, 12, 16, false))], "12 bits up to bit 16 do not fit into 16"),
        (vec![changed(0.0, |s| s.bits(16, 12, 3, false))], "12 bits up to bit 3"),
        (vec![changed(0.0, |s| s.short((0x0028, 0x0010), 0))], "no rows"),
        (
            vec![changed(0.0, |s| s.short((0x0028, 0x0010), 60000).short((0x0028, 0x0011), 60000))],
            "take 3600000000 bytes",
        ),
        (vec![changed(0.0, |s| s.text(FRAMES, "IS", "2000000000"))], "2000000000 frames do not fit"),
        (vec![changed(0.0, |s| s.text(FRAMES, "IS", "40").remove(POSITION))], "frame 2 takes 6 bytes"),
        (vec![changed(0.0, |s| s.remove((0x0028, 0x0011)))], "hold no images"),
        (vec![changed(0.0, |s| s.compressed("1.2.840.10008.1.2.4.110", vec![vec![0; 8]]))], "JPEG XL (1.2.840"),
        (vec![packed(JPEG_2000, &[0; 8])], "the JPEG 2000, lossless of frame 1 is damaged: it has no codestream"),
        (vec![packed(JPEG_2000, &JPEG_2000_WORDS[..60])], "the JPEG 2000, lossless of frame 1 is damaged"),
        (vec![packed(JPEG_2000, &wide(&JPEG_2000_WORDS, 11))], "it is 255 x 2, and the header says 3 x 2"),
        (vec![packed(JPEG_2000, &wide(&JPEG_2000_WORDS, 41))], "it has 255 components, not one of gray"),
        (vec![packed(JPEG_LS, &[0; 8])], "the JPEG-LS, lossless of frame 1 is damaged"),
        (vec![packed(JPEG_LS, &JPEG_LS_WORDS[..90])], "the JPEG-LS, lossless of frame 1 is damaged"),
        (vec![packed(JPEG_LS, &wide(&JPEG_LS_WORDS, 54))], "it is 255 x 2, and the header says 3 x 2"),
        (vec![changed(0.0, |s| s.compressed("1.2.3", vec![vec![0; 8]]))], "Unrecognized transfer syntax `1.2.3`"),
        (vec![changed(0.0, |s| s.compressed(RLE, vec![vec![0; 8]]))], "the RLE of frame 1 is damaged"),
        (vec![changed(0.0, |s| s.compressed(RLE, vec![rle(&[vec![1; 3]])]))], "3 of 6 bytes"),
        (
            vec![changed(0.0, |s| s.compressed("1.2.840.10008.1.2.4.70", vec![jpeg(60000, 60000)]))],
            "the JPEG, lossless of frame 1 is damaged: it is 60000 x 60000, and the header says 3 x 2",
        ),
        (vec![changed(0.0, |s| s.compressed("1.2.840.10008.1.2.4.70", vec![jpeg(2, 3)]))], "damaged"),
        (
            vec![changed(0.0, |s| s.compressed("1.2.840.10008.1.2.4.70", vec![wide(&jpeg(2, 3), 6)]))],
            "its samples have 255 bits, and the header says",
        ),
        (vec![changed(0.0, |s| s.text((0x0028, 0x1053), "DS", "0"))], "value scale 0"),
    ];
    let mut others = String::new();
    for (slices, expected) in cases {
        let folder = Folder::new();
        for (index, slice) in slices.iter().enumerate() {
            folder.write(&format!("slice{index}"), slice.bytes());
        }
        let message = match open(&folder.path("."), &OpenOptions::default()) {
            Err(error @ (Error::Invalid { .. } | Error::Unsupported { .. })) => error.to_string(),
            other => format!("{other:?}"),
        };
        if !message.contains(expected) {
            others += &format!("expected: {expected}\nfound: {message}\n");
        }
    }
    assert!(others.is_empty(), "{others}");
}

#[test]
fn lengths_that_lie_take_no_memory() {
    let folder = Folder::new();
    let whole = at(0.0).bytes();
    // Of the pixels, the last element: 6 bytes behind a length of 4.
    for (from_end, length) in [(10, 0xffff_fff0_u32), (10, 7)] {
        let mut file = whole.clone();
        let place = file.len() - from_end;
        file[place..place + 4].copy_from_slice(&length.to_le_bytes());
        let error = folder.open("a.dcm", file).expect_err("a lie").to_string();
        assert!(error.contains(&format!("says to have {length} bytes, and 6 are there")), "{error}");
    }
}

/// Elements of an unknown value representation have lengths of 32 bits, as elements of unknown values have.
#[test]
fn an_unknown_kind_of_value_has_a_long_length() {
    let folder = Folder::new();
    let mut file = at(0.0).bytes();
    let orientation = file.windows(6).position(|window| window == [0x20, 0, 0x37, 0, b'D', b'S']).expect("an element");
    file[orientation + 4..orientation + 6].copy_from_slice(b"SD");
    let error = folder.open("a.dcm", file).expect_err("a lie").to_string();
    assert!(error.contains("says to have 1546673201 bytes"), "{error}");
}

#[test]
fn the_length_of_the_first_group_decides_nothing() {
    let folder = Folder::new();
    for change in [1, 0xff] {
        let mut file = at(0.0).bytes();
        // Behind `DICM`, a tag, a kind and a length.
        assert_eq!(&file[132..140], [2, 0, 0, 0, b'U', b'L', 4, 0]);
        file[140] = file[140].wrapping_add(change);
        assert_eq!(folder.open("a.dcm", file).expect("its elements say where it ends").dimensions, [3, 2, 1]);
    }
}

/// An item of four bytes has no room for an element: the library that reads elements would take the next bytes for the rest of one.
#[test]
fn items_and_sequences_end_where_they_should() {
    let folder = Folder::new();
    let item = |length: u32, content: &[u8]| [&[0xfe, 0xff, 0, 0xe0][..], &length.to_le_bytes(), content].concat();
    let end = |tag: u8| [0xfe, 0xff, tag, 0xe0, 0, 0, 0, 0];
    for (content, expected) in [
        ([item(4, &[0xfe, 0xff, 0, 0]), end(0xdd).to_vec()].concat(), "an item does not end"),
        (item(u32::MAX, &[]), "an item does not end"),
        (item(0, &[]), "a sequence does not end"),
    ] {
        let mut file = at(0.0).bytes();
        let place = file.windows(4).position(|window| window == [0x20, 0, 0x37, 0]).expect("an element");
        file.truncate(place);
        file.extend([&[0x20, 0, 0x36, 0][..], b"SQ", &[0, 0, 0xff, 0xff, 0xff, 0xff], &content].concat());
        let error = folder.open("a.dcm", file).expect_err("no end").to_string();
        assert!(error.contains(expected), "{expected}: {error}");
    }
}

/// A number of four bytes cannot have two: the library that reads elements would take none, and begin the next element with these.
#[test]
fn numbers_are_whole() {
    let folder = Folder::new();
    let mut file = at(0.0).bytes();
    let rows = file.windows(6).position(|window| window == [0x28, 0, 0x10, 0, b'U', b'S']).expect("an element");
    file[rows + 4..rows + 6].copy_from_slice(b"SL");
    let error = folder.open("a.dcm", file).expect_err("half a number").to_string();
    assert!(error.contains("the `SL` here has 2 bytes, which are no numbers of 4"), "{error}");
}

/// The library that reads elements goes on behind a delimiter; so must the check of their lengths, or it would let through any.
#[test]
fn a_stray_delimiter_does_not_end_the_check() {
    let folder = Folder::new();
    for (tag, shown) in [([0xfe, 0xff, 0xdd, 0xe0], "(fffe,e0dd)"), ([0xfe, 0xff, 0x0d, 0xe0], "(fffe,e00d)")] {
        let mut file = at(0.0).bytes();
        let place = file.windows(4).position(|window| window == [0x20, 0, 0x37, 0]).expect("an element");
        file.splice(place..place, [&tag[..], &[0; 4]].concat());
        let error = folder.open("a.dcm", file).expect_err("nothing to end").to_string();
        assert!(error.contains(&format!("{shown} ends what has not begun")), "{error}");
    }
}

#[test]
fn cut_files_are_told_so() {
    let folder = Folder::new();
    let whole = changed(0.0, |slice| slice.text(SERIES, "UI", "1")).bytes();
    for length in [140, whole.len() / 2, whole.len() - 4] {
        let error = folder.open("cut.dcm", &whole[..length]).expect_err("a cut file").to_string();
        assert!(error.starts_with(&folder.shown("cut.dcm")), "{error}");
    }
    assert!(
        folder.open("empty.dcm", [0; 300]).expect_err("no DICOM").to_string().starts_with(&folder.shown("empty.dcm"))
    );
}
