//! TIFF stacks: every type, byte order and compression comes back, from pages and from numbered files.

mod common;

use std::io::Cursor;

use common::tiff::{Page, Value, stack_u8, tiff};
use common::vtk::zlib;
use common::{Folder, check, samples, values};
use tiff::encoder::{Compression, TiffEncoder, colortype};
use vitrum_io::{OpenOptions, Volume};

fn open(content: Vec<u8>) -> Volume {
    Folder::new().open("a.tif", content).unwrap_or_else(|error| panic!("{error}"))
}

fn notes(volume: &Volume) -> String {
    volume.source.assumptions.facts().join("; ")
}

#[test]
fn every_type_and_endian_comes_back() {
    for sample in samples() {
        let format = match sample.name {
            "float" | "double" => 3,
            name if name.starts_with('u') => 1,
            _ => 2,
        };
        for (big, data) in [(false, &sample.little), (true, &sample.big)] {
            let bits = 8 * sample.size as u16;
            let pages: Vec<_> = data.chunks(6 * sample.size).map(|data| Page::new(bits, format, data)).collect();
            check(&open(tiff(big, &pages)), &sample);
            let packed =
                data.chunks(6 * sample.size).map(|data| Page::new(bits, format, &zlib(data)).set(259, Value::Short(8)));
            let volume = open(tiff(big, &packed.collect::<Vec<_>>()));
            check(&volume, &sample);
            assert_eq!(volume.source.encoding, if big { "deflate, big-endian" } else { "deflate, little-endian" });
        }
    }
}

#[test]
fn every_compression_comes_back() {
    for compression in [Compression::Uncompressed, Compression::Lzw, Compression::Packbits] {
        let mut file = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap().with_compression(compression);
        for slice in 0..3_u16 {
            let row: Vec<u16> = (0..400 * 300).map(|index| slice * 1000 + index as u16 % 7).collect();
            encoder.write_image::<colortype::Gray16>(400, 300, &row).unwrap();
        }
        let volume = open(file.into_inner());
        assert_eq!(volume.dimensions, [400, 300, 3]);
        assert_eq!(volume.value(399, 299, 2), 2000.0 + ((400 * 300 - 1) % 65536 % 7) as f32);
        assert_eq!(volume.range, [0.0, 2006.0]);
    }
}

#[test]
fn spacing_comes_from_description_and_resolution() {
    let resolution = |page: Page, x: u32, unit: u16| {
        page.set(282, Value::Rational(x, 1)).set(283, Value::Rational(4, 1)).set(296, Value::Short(unit))
    };
    let spacing = |page: Page| open(tiff(false, &[page.clone(), page])).spacing;
    let plain = Page::bytes(&[0; 6]);
    let imagej = |text| resolution(plain.clone(), 2, 1).set(270, Value::Text(text));
    assert_eq!(spacing(plain.clone()), [1.0; 3]);
    assert_eq!(spacing(imagej("ImageJ=1.51n\nimages=2\nslices=2\nunit=mm\nspacing=8.8\n")), [0.5, 0.25, 8.8]);
    assert_eq!(spacing(imagej("ImageJ=1.51n\nunit=cm\nspacing=-2\n")), [5.0, 2.5, 20.0]);
    assert_eq!(spacing(imagej("ImageJ=1.51n\nunit=\\u00B5m\nspacing=none\n")), [0.0005, 0.00025, 0.001]);
    assert_eq!(spacing(plain.clone().set(270, Value::Text("ImageJ=1\nspacing=3"))), [1.0, 1.0, 3.0]);
    // Between slices as between pixels, where nothing says it.
    assert_eq!(spacing(resolution(plain.clone(), 2, 3)), [5.0, 2.5, 5.0]);
    // For printers: only that pixels are twice as long along y.
    assert_eq!(spacing(resolution(plain.clone(), 8, 2)), [1.0, 2.0, 1.0]);
    assert_eq!(spacing(resolution(plain.clone(), 4, 1)), [1.0; 3]);
    assert_eq!(spacing(resolution(plain, 0, 3)), [1.0; 3]);
}

#[test]
fn white_as_zero_and_thumbnails() {
    let pages = [Page::bytes(&[0, 1, 2, 3, 4, 255]).set(262, Value::Short(0))];
    let volume = open(tiff(true, &pages));
    // A table of colours changes no value.
    assert_eq!(values(&volume), [0.0, 1.0, 2.0, 3.0, 4.0, 255.0]);
    assert!(notes(&volume).contains("0 is meant to be white"));
    let small = Page::bytes(&[9]).set(256, Value::Long(1)).set(257, Value::Long(1)).set(254, Value::Long(1));
    let volume = open(tiff(true, &[Page::bytes(&[1; 6]), small, Page::bytes(&[2; 6])]));
    assert_eq!(volume.dimensions, [3, 2, 2]);
    assert!(notes(&volume).contains("1 smaller copies of pages"));
    let frames = stack_u8(|page| page);
    assert_eq!(values(&open(frames))[11], 12.0);
    let text = "ImageJ=1\nimages=2\nframes=2\n";
    let page = Page::bytes(&[1; 6]).set(270, Value::Text(text));
    assert!(notes(&open(tiff(false, &[page.clone(), page]))).contains("points in time"));
}

#[test]
fn numbered_files_are_slices() {
    let folder = Folder::new();
    let slice = |value| tiff(value % 2 == 0, &[Page::bytes(&[value; 6])]);
    for (name, value) in [("a08.tif", 8), ("a09.tif", 9), ("a10.tif", 10), ("a12.tif", 12), ("b11.tif", 77)] {
        folder.write(name, slice(value));
    }
    for name in ["a08.tif", "a09.tif", "a10.tif"] {
        let volume = vitrum_io::open(&folder.path(name), &OpenOptions::default()).unwrap();
        assert_eq!(volume.dimensions, [3, 2, 3]);
        assert_eq!([0, 1, 2].map(|z| volume.value(2, 1, z)), [8.0, 9.0, 10.0]);
        assert_eq!(volume.name, folder.path(name).display().to_string());
        assert!(notes(&volume).contains("from 3 files, a08.tif to a10.tif"));
    }
    for name in ["a12.tif", "b11.tif"] {
        assert_eq!(vitrum_io::open(&folder.path(name), &OpenOptions::default()).unwrap().dimensions, [3, 2, 1]);
    }
    for number in 8..12_u8 {
        folder.write(&format!("plain{number}.tiff"), slice(number));
    }
    let volume = vitrum_io::open(&folder.path("plain11.tiff"), &OpenOptions::default()).unwrap();
    assert_eq!([0, 1, 2, 3].map(|z| volume.value(0, 0, z)), [8.0, 9.0, 10.0, 11.0]);
    // The pages of one file are a volume whatever lies beside it.
    folder.write("plain12.tiff", stack_u8(|page| page));
    let stack = vitrum_io::open(&folder.path("plain12.tiff"), &OpenOptions::default()).unwrap();
    assert_eq!(values(&stack)[11], 12.0);
}

#[test]
fn the_limit_counts_all_slices() {
    let folder = Folder::new();
    let path = folder.write("a.tif", stack_u8(|page| page));
    let open =
        |max_bytes| vitrum_io::open(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert!(open(12).is_ok());
    assert!(open(11).unwrap_err().to_string().contains("needs 12 bytes once decoded, and the limit is 11 bytes"));
}

/// A page of 3 x 2 bytes, all alike, with what ImageJ says of the file.
fn page(value: u8, says: &'static str) -> Page {
    Page::bytes(&[value; 6]).set(270, Value::Text(says))
}

#[test]
fn a_hyperstack_is_read_channel_by_channel_and_time_by_time() {
    let folder = Folder::new();
    // 2 channels of 3 slices at 4 points in time; each page has its number.
    let says = "ImageJ=1.54f\nimages=24\nchannels=2\nslices=3\nframes=4\nhyperstack=true\n";
    let pages: Vec<_> = (0..24).map(|value| page(value, says)).collect();
    let path = folder.write("a.tif", tiff(false, &pages));
    let open = |time: Option<u32>, array: Option<&str>| {
        let array = array.map(str::to_owned);
        vitrum_io::open(&path, &OpenOptions { time, array, ..OpenOptions::default() })
    };
    let first = |volume: Volume| [0, 1, 2].map(|z| volume.value(0, 0, z));
    assert_eq!(first(open(None, None).unwrap()), [0.0, 2.0, 4.0]);
    assert_eq!(first(open(Some(0), Some("2")).unwrap()), [1.0, 3.0, 5.0]);
    assert_eq!(first(open(Some(3), Some("1")).unwrap()), [18.0, 20.0, 22.0]);
    let told = notes(&open(None, None).unwrap());
    assert!(told.contains("2 channels: the first was taken") && told.contains("4 points in time"), "{told}");
    for (time, array, words) in [
        (Some(4), None, "the point in time 4 is asked for, and the file has 4"),
        (None, Some("3"), "the array `3` is asked for, and the file has 2 channels"),
        (None, Some("red"), "give a number from 1 to 2"),
    ] {
        let message = open(time, array).unwrap_err().to_string();
        assert!(message.contains(words), "{message}");
    }
}

#[test]
fn channels_at_points_in_time_have_those_for_slices() {
    let says = "ImageJ=1.54f\nimages=4\nchannels=2\nframes=2\nhyperstack=true\n";
    let volume = open(tiff(true, &[0, 1, 2, 3].map(|value| page(value, says))));
    assert_eq!([0, 1].map(|z| volume.value(0, 0, z)), [0.0, 2.0]);
}

#[test]
fn halves_of_floats_are_widened() {
    let words: [u16; 6] = [0x3c00, 0xc000, 0x7bff, 0x0001, 0x3555, 0];
    let expected = [1.0, -2.0, 65504.0, 1.0 / 16_777_216.0, 1365.0 / 4096.0, 0.0];
    for (big, bytes) in [(false, words.map(u16::to_le_bytes)), (true, words.map(u16::to_be_bytes))] {
        let volume = open(tiff(big, &[Page::new(16, 3, bytes.as_flattened())]));
        assert_eq!(values(&volume), expected);
    }
}

#[test]
fn a_folder_is_a_volume_of_its_files() {
    let folder = Folder::new();
    let slice = |value: u8| tiff(false, &[Page::bytes(&[value; 6])]);
    let open = || vitrum_io::open(&folder.path("."), &OpenOptions::default());
    // By number and not by letter, with another number that stays, and steps of 10.
    for number in [90, 100, 110] {
        folder.write(&format!("scan7_z{number}.TIF"), slice(number));
    }
    folder.write("notes.txt", "no slice");
    let volume = open().unwrap();
    assert_eq!([0, 1, 2].map(|z| volume.value(0, 0, z)), [90.0, 100.0, 110.0]);
    folder.write("other1.tif", slice(1));
    let told = notes(&open().unwrap());
    assert!(told.contains("the largest series was taken, scan#_z#.TIF (3 files); others are: other#.tif"), "{told}");
}

#[test]
fn a_folder_of_one_file_is_that_file() {
    let folder = Folder::new();
    folder.write("only.tiff", tiff(false, &[5, 6].map(|value| Page::bytes(&[value; 6]))));
    let volume = vitrum_io::open(&folder.path("."), &OpenOptions::default()).unwrap();
    assert_eq!((volume.dimensions, volume.value(0, 0, 1)), ([3, 2, 2], 6.0));
}
