//! DICOM: slices come in the order of their places, with their values, wherever they lie.

mod common;

use std::path::Path;

use common::dicom::{
    Dicom, FRAMES, INTERCEPT, JPEG, JPEG_2000, JPEG_2000_SIGNED, JPEG_2000_WORDS, JPEG_LS, JPEG_LS_WORDS, LOSSLESS,
    ORIENTATION, POSITION, RLE, SERIES, SLOPE, element, nested, rle,
};
use common::{Folder, values};
use vitrum_io::{Error, OpenOptions, Volume, Voxels, open};

fn opened(path: &Path) -> Volume {
    open(path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Six pixels that start at a number.
fn pixels(start: u8) -> Vec<u8> {
    (start..start + 6).collect()
}

/// A folder of slices.
fn folder(slices: &[Dicom]) -> Folder {
    let folder = Folder::new();
    for (index, slice) in slices.iter().enumerate() {
        folder.write(&format!("slice{index}"), slice.bytes());
    }
    folder
}

fn told(volume: &Volume, note: &str) -> bool {
    volume.source.assumptions.iter().any(|assumption| assumption.fact.contains(note))
}

#[test]
fn slices_are_sorted_by_their_place_and_not_by_their_name() {
    let folder =
        folder(&[Dicom::slice(6.0, &pixels(12)), Dicom::slice(0.0, &pixels(0)), Dicom::slice(3.0, &pixels(6))]);
    folder.write("readme.txt", "no slice");
    let volume = opened(&folder.path("."));
    assert_eq!((volume.dimensions, volume.spacing), ([3, 2, 3], [1.0, 2.0, 3.0]));
    assert_eq!(values(&volume), (0..18).map(|value| value as f32).collect::<Vec<_>>());
    // From the patient's left and posterior to right and anterior.
    assert_eq!(volume.origin, [-10.0, -20.0, 0.0]);
    assert_eq!(volume.axes, [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(volume.source.format, "DICOM");
    assert!(told(&volume, "1 files of the folder are no DICOM images"), "{:?}", volume.source.assumptions);
    // One file stands for its series.
    let same = opened(&folder.path("slice1"));
    assert_eq!((same.voxels, same.origin), (volume.voxels, volume.origin));
}

#[test]
fn the_normal_of_a_turned_slice_gives_the_order() {
    // Rows to posterior, columns to inferior: the normal points to the patient's left... and right is our x.
    let slice = |x: f64, start: u8| {
        let mut slice = Dicom::slice(0.0, &pixels(start));
        slice.text(POSITION, "DS", &format!("{x}\\0\\0")).text(ORIENTATION, "DS", "0\\1\\0\\0\\0\\-1");
        slice
    };
    let folder = folder(&[slice(-5.0, 6), slice(5.0, 0)]);
    let volume = opened(&folder.path("."));
    // The normal is (0, 1, 0) x (0, 0, -1) = (-1, 0, 0): the slice at x = 5 comes first.
    assert_eq!(values(&volume), (0..12).map(|value| value as f32).collect::<Vec<_>>());
    assert_eq!(volume.axes, [[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]].map(|axis| axis.map(|x| x + 0.0)));
    assert_eq!((volume.spacing, volume.origin), ([1.0, 2.0, 10.0], [-5.0, 0.0, 0.0]));
}

#[test]
fn a_tilted_gantry_makes_oblique_axes() {
    let slice = |index: f64| {
        let mut slice = Dicom::slice(0.0, &[0; 6]);
        slice.text(POSITION, "DS", &format!("0\\{}\\{}", 3.0 * index, 4.0 * index));
        slice
    };
    let folder = folder(&[slice(0.0), slice(1.0), slice(2.0)]);
    let volume = opened(&folder.path("."));
    assert_eq!((volume.spacing[2], volume.axes[2]), (5.0, [0.0, -0.6, 0.8]));
    assert!(told(&volume, "off right angles"));
}

#[test]
fn samples_of_every_kind_keep_their_values() {
    let one = |slice: &Dicom| opened(&folder(std::slice::from_ref(slice)).path("."));
    // 12 bits from bit 2 on, signed, with something else in the bits around them.
    let mut slice = Dicom::words(0.0, &[0xc001, 0x1ffe, 0x2000, 0x7ffc, 0xbfff, 0x0004], true);
    slice.bits(16, 12, 13, true);
    assert_eq!(values(&one(&slice)), [0.0, 2047.0, -2048.0, -1.0, -1.0, 1.0]);
    let slice = Dicom::words(0.0, &[0, 1, 2, 3, 40000, 65535], false);
    assert_eq!(values(&one(&slice)), [0.0, 1.0, 2.0, 3.0, 40000.0, 65535.0]);
    let mut slice = Dicom::words(0.0, &[0, 1, 0x8000, 0xffff, 2000, 7], true);
    slice.text(SLOPE, "DS", "2").text(INTERCEPT, "DS", "-1024");
    let volume = one(&slice);
    assert_eq!(values(&volume), [-1024.0, -1022.0, -66560.0, -1026.0, 2976.0, -1010.0]);
    assert!(matches!(volume.voxels, Voxels::U16(_)));
    let mut slice = Dicom::slice(0.0, &[0x80, 0xff, 0, 1, 2, 0x7f]);
    slice.bits(8, 8, 7, true);
    assert_eq!(values(&one(&slice)), [-128.0, -1.0, 0.0, 1.0, 2.0, 127.0]);
}

#[test]
fn slopes_of_their_own_become_float32() {
    let slice = |z: f64, slope: &str| {
        let mut slice = Dicom::slice(z, &pixels(0));
        slice.text(SLOPE, "DS", slope);
        slice
    };
    let volume = opened(&folder(&[slice(0.0, "1"), slice(1.0, "0.5")]).path("."));
    assert!(matches!(volume.voxels, Voxels::F32(_)));
    let expected: Vec<f32> = (0..6).map(|value| value as f32).chain((0..6).map(|value| 0.5 * value as f32)).collect();
    assert_eq!(values(&volume), expected);
}

#[test]
fn moderately_uneven_slices_are_interpolated() {
    // Heights 0, 4, 10: evenly at 0, 5, 10.
    let slice = |z: f64, value: u8| Dicom::slice(z, &[value; 6]);
    let volume = opened(&folder(&[slice(0.0, 0), slice(4.0, 40), slice(10.0, 100)]).path("."));
    assert_eq!(volume.spacing[2], 5.0);
    let along: Vec<f32> = (0..3).map(|z| volume.value(0, 0, z)).collect();
    assert_eq!(along, [0.0, 50.0, 100.0], "a linear field stays linear");
    assert!(told(&volume, "4.000 to 6.000 mm apart: they were interpolated linearly to 5.000 mm"));
    // Rounded positions are no uneven ones.
    let volume = opened(&folder(&[slice(0.0, 0), slice(4.98, 40), slice(10.0, 100)]).path("."));
    assert_eq!(volume.value(0, 0, 1), 40.0);
}

#[test]
fn frames_of_one_file_are_slices() {
    let groups = |z: f64| {
        let place = element(POSITION, "DS", format!("0\\0\\{z:<4}").as_bytes());
        nested((0x0020, 0x9113), &[place])
    };
    let mut file = Dicom::slice(0.0, &[pixels(6), pixels(0)].concat());
    file.text(FRAMES, "IS", "2").remove(POSITION).remove(ORIENTATION).remove((0x0028, 0x0030));
    let shared = [
        nested((0x0020, 0x9116), &[element(ORIENTATION, "DS", b"1\\0\\0\\0\\1\\0 ")]),
        nested((0x0028, 0x9110), &[element((0x0028, 0x0030), "DS", b"3\\4 ")]),
    ];
    file.sequence((0x5200, 0x9229), &[shared.concat()]).sequence((0x5200, 0x9230), &[groups(2.5), groups(0.0)]);
    let folder = Folder::new();
    let volume = folder.open("multi.dcm", file.bytes()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((volume.dimensions, volume.spacing), ([3, 2, 2], [4.0, 3.0, 2.5]));
    assert_eq!(values(&volume), (0..12).map(|value| value as f32).collect::<Vec<_>>());
    // Frames without places stay in their order.
    let mut file = Dicom::slice(0.0, &[pixels(0), pixels(6)].concat());
    file.text(FRAMES, "IS", "2").remove(POSITION).text((0x0018, 0x0088), "DS", "7");
    let volume = folder.open("plain.dcm", file.bytes()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((volume.spacing, values(&volume)), ([1.0, 2.0, 7.0], (0..12).map(|value| value as f32).collect()));
    assert!(told(&volume, "the frames say no place") && told(&volume, "no orientation"));
}

#[test]
fn run_lengths_are_decoded() {
    let mut slice = Dicom::words(0.0, &[], false);
    let words: Vec<u16> = vec![1, 258, 513, 40000, 0, 65535];
    let plane = |shift: u32| words.iter().map(|word| (word >> shift) as u8).collect::<Vec<u8>>();
    slice.compressed(RLE, vec![rle(&[plane(8), plane(0)])]);
    let volume = opened(&folder(&[slice]).path("."));
    assert_eq!(values(&volume), words.iter().map(|&word| f32::from(word)).collect::<Vec<_>>());
    assert_eq!(volume.source.encoding, "RLE");
}

#[test]
fn lossless_jpeg_is_decoded() {
    let mut slice = Dicom::words(0.0, &[], false);
    slice.compressed(LOSSLESS, vec![JPEG.to_vec()]);
    let volume = opened(&folder(&[slice]).path("."));
    assert_eq!(values(&volume), [1.0, 258.0, 513.0, 40000.0, 0.0, 65535.0]);
    assert_eq!(volume.source.encoding, "JPEG, lossless");
}

#[test]
fn jpeg_ls_and_jpeg_2000_are_decoded() {
    for (syntax, picture, signed, encoding) in [
        (JPEG_LS, &JPEG_LS_WORDS[..], false, "JPEG-LS, lossless"),
        (JPEG_2000, &JPEG_2000_WORDS, false, "JPEG 2000, lossless"),
        (JPEG_2000, &JPEG_2000_SIGNED, true, "JPEG 2000, lossless"),
    ] {
        let mut slice = Dicom::words(0.0, &[], signed);
        slice.compressed(syntax, vec![picture.to_vec()]);
        let volume = opened(&folder(&[slice]).path("."));
        let expected = match signed {
            false => [1.0, 258.0, 513.0, 40000.0, 0.0, 65535.0],
            true => [-32768.0, -1.0, 0.0, 1.0, 258.0, 32767.0],
        };
        assert_eq!(values(&volume), expected, "{encoding}");
        assert_eq!(volume.source.encoding, encoding);
    }
}

#[test]
fn the_largest_series_is_taken_and_the_others_are_named() {
    let of = |series: &str, z: f64| {
        let mut slice = Dicom::slice(z, &pixels(0));
        slice.text(SERIES, "UI", series).text((0x0008, 0x103e), "LO", if series == "9" { "scout" } else { "T1" });
        slice
    };
    let mixed = folder(&[of("9", 0.0), of("7", 0.0), of("7", 1.0)]);
    let volume = opened(&mixed.path("."));
    assert_eq!(volume.dimensions, [3, 2, 2]);
    assert!(told(&volume, "`MR, scout`, 1 slices, slice0 among its files"), "{:?}", volume.source.assumptions);
    assert_eq!(opened(&mixed.path("slice0")).dimensions, [3, 2, 1], "a file names its series");
    let alike = folder(&[of("9", 0.0), of("7", 0.0)]);
    match open(&alike.path("."), &OpenOptions::default()) {
        Err(Error::Unsupported { problem, advice, .. }) => {
            assert!(problem.contains("2 series, the largest alike") && advice.contains("name a file"), "{problem}");
        }
        other => panic!("{other:?}"),
    }
}

/// Slices below a folder, by their paths.
fn export(slices: &[(&str, Dicom)]) -> Folder {
    let folder = Folder::new();
    for (path, slice) in slices {
        std::fs::create_dir_all(folder.path(path).parent().expect("a folder")).expect("it is writable");
        folder.write(path, slice.bytes());
    }
    folder
}

/// A slice of a series with a description.
fn of(series: &str, z: f64) -> Dicom {
    let mut slice = Dicom::slice(z, &pixels(z as u8));
    slice.text(SERIES, "UI", series).text((0x0008, 0x103e), "LO", &format!("series {series}"));
    slice
}

/// A file that says something and holds no image, such as DICOMDIR.
fn index() -> Dicom {
    let mut index = of("1", 0.0);
    index.remove((0x0028, 0x0010)).remove((0x0028, 0x0011));
    index
}

/// An image in colours, such as a picture of the screen.
fn screen(series: &str) -> Dicom {
    let mut screen = of(series, 0.0);
    screen.short((0x0028, 0x0002), 3).text((0x0028, 0x0004), "CS", "RGB");
    screen
}

#[test]
fn the_one_series_of_an_export_is_found_below_the_folder() {
    let export = export(&[
        ("DICOMDIR", index()),
        ("PAT/ST1/SE1/IM2", of("1.7", 1.0)),
        ("PAT/ST1/SE1/IM1", of("1.7", 0.0)),
        ("PAT/ST1/SE2/IM1", screen("1.8")),
        ("PAT/ST1/SE3/SR1", index()),
    ]);
    export.write("PAT/readme.txt", "no slice");
    for folder in [".", "PAT", "PAT/ST1", "PAT/ST1/SE1"] {
        let volume = opened(&export.path(folder));
        assert_eq!((volume.dimensions, volume.source.format), ([3, 2, 2], "DICOM"), "{folder}");
        let notes = &volume.source.assumptions;
        let below = folder != "PAT/ST1/SE1";
        assert_eq!(
            told(&volume, "the one series below the folder was taken (`MR, series 1.7`, 2 slices"),
            below,
            "{notes:?}"
        );
        assert_eq!(told(&volume, "1 files of other series were left out, such as"), below, "{notes:?}");
    }
    // Files in a folder come before files in the folders below it.
    export.write("PAT/IM9", of("1.9", 0.0).bytes());
    assert_eq!(opened(&export.path("PAT")).dimensions, [3, 2, 1]);
    // A screen alone is refused for what it is.
    let message = open(&export.path("PAT/ST1/SE2"), &OpenOptions::default()).unwrap_err().to_string();
    assert!(message.contains("in colours (RGB"), "{message}");
    // A slice of the series that is not read would be missing.
    export.write("PAT/ST1/SE1/IM3", screen("1.7").bytes());
    let message = open(&export.path("PAT/ST1/SE1"), &OpenOptions::default()).unwrap_err().to_string();
    assert!(message.contains("IM3") && message.contains("in colours (RGB"), "{message}");
}

#[test]
fn several_series_below_a_folder_are_named() {
    let export =
        export(&[("ST1/SE1/IM1", of("1.7", 0.0)), ("ST1/SE1/IM2", of("1.7", 1.0)), ("ST1/SE2/IM1", of("1.8", 0.0))]);
    let message = open(&export.path("."), &OpenOptions::default()).unwrap_err().to_string();
    let first = "there are 2 series below the folder: `MR, series 1.7`, 2 slices, series 1.7, such as ST1/SE1/IM1; ";
    let second =
        "`MR, series 1.8`, 1 slices, series 1.8, such as ST1/SE2/IM1; give the folder of the one that is wanted";
    assert!(message.contains(first) && message.contains(second), "{message}");
    assert_eq!(opened(&export.path("ST1/SE1")).dimensions, [3, 2, 2]);
    // Not deeper than any export goes.
    let deep = self::export(&[("1/2/3/4/5/6/7/8/IM1", of("1", 0.0))]);
    assert!(open(&deep.path("."), &OpenOptions::default()).is_ok());
    let deep = self::export(&[("1/2/3/4/5/6/7/8/9/IM1", of("1", 0.0))]);
    let message = open(&deep.path("."), &OpenOptions::default()).unwrap_err().to_string();
    assert!(message.contains("without DICOM or TIFF files, and without DICOM files below it"), "{message}");
}

#[cfg(unix)]
#[test]
fn links_that_lead_back_end_no_search() {
    let export = export(&[("a/b/IM1", of("1", 0.0))]);
    std::os::unix::fs::symlink(export.path("a"), export.path("a/b/back")).expect("a link");
    assert_eq!(opened(&export.path(".")).dimensions, [3, 2, 1]);
}

const PADDING: (u16, u16) = (0x0028, 0x0120);
const PADDING_LIMIT: (u16, u16) = (0x0028, 0x0121);

#[test]
fn padding_widens_no_range() {
    let ct = |z: f64, words: [i16; 6]| {
        let mut slice = Dicom::words(z, &words.map(|word| word as u16), true);
        slice.text(SLOPE, "DS", "1").text(INTERCEPT, "DS", "-24").short(PADDING, -2000_i16 as u16);
        slice
    };
    // The least measured value lies in the other slice.
    let volume =
        opened(&folder(&[ct(0.0, [-2000, -2000, 5, 40, 3000, 7]), ct(1.0, [-1000, 0, 1, 2, 3, -2000])]).path("."));
    assert_eq!(volume.range, [-1024.0, 2976.0]);
    let expected = [-1024.0, -1024.0, -19.0, 16.0, 2976.0, -17.0, -1024.0, -24.0, -23.0, -22.0, -21.0, -1024.0];
    assert_eq!(values(&volume), expected);
    assert!(told(&volume, "3 voxels are padding, by their Pixel Padding Value"), "{:?}", volume.source.assumptions);
    assert!(told(&volume, "they were given -1024"), "{:?}", volume.source.assumptions);

    let one = |slice: &Dicom| opened(&folder(std::slice::from_ref(slice)).path("."));
    // A range, given from above to below; what lies above all values becomes the largest.
    let mut slice = Dicom::words(0.0, &[65535, 65000, 64999, 3, 9, 64000], false);
    slice.short(PADDING, 65535).short(PADDING_LIMIT, 64000);
    let volume = one(&slice);
    assert_eq!((values(&volume), volume.range), (vec![9.0, 9.0, 9.0, 3.0, 9.0, 9.0], [3.0, 9.0]));
    // Among measured values it becomes the least.
    let mut slice = Dicom::slice(0.0, &[7, 50, 9, 50, 80, 8]);
    slice.short(PADDING, 50);
    assert_eq!(values(&one(&slice)), [7.0, 7.0, 9.0, 7.0, 80.0, 8.0]);
    // The next number widens nothing.
    let mut slice = Dicom::slice(0.0, &[0, 0, 1, 9, 7, 0]);
    slice.short(PADDING, 0);
    let volume = one(&slice);
    assert_eq!(values(&volume), [0.0, 0.0, 1.0, 9.0, 7.0, 0.0]);
    assert!(!told(&volume, "padding"));
    // Nothing but padding, and none.
    let mut slice = Dicom::slice(0.0, &[7; 6]);
    slice.short(PADDING, 7);
    assert!(told(&one(&slice), "all 6 voxels are padding"));
    slice.short(PADDING, 8);
    assert!(!told(&one(&slice), "padding"));
    // With slopes of their own, voxels are physical values.
    let scaled = |z: f64, slope: &str| {
        let mut slice = ct(z, [-2000, 1, 2, 3, 4, 5]);
        slice.text(SLOPE, "DS", slope).text(INTERCEPT, "DS", "0");
        slice
    };
    let volume = opened(&folder(&[scaled(0.0, "0.1"), scaled(1.0, "0.5")]).path("."));
    assert_eq!(volume.range, [0.1, 2.5]);
    assert_eq!([volume.value(0, 0, 0), volume.value(0, 0, 1)], [0.1, 0.1]);
}

#[test]
fn the_limit_holds_before_pixels_are_read() {
    let folder = folder(&[Dicom::slice(0.0, &pixels(0)), Dicom::slice(1.0, &pixels(0))]);
    let open =
        |max_bytes| open(&folder.path("."), &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert!(matches!(open(20), Err(Error::TooLarge { limit: 20, .. })));
    assert!(open(1 << 20).is_ok());
}
