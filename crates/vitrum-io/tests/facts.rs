//! Facts that files state, with the part of the file that states them.

mod common;

use common::dicom::{Dicom, INTERCEPT};
use common::{Folder, attached, nifti_u8};
use vitrum_io::{OpenOptions, Volume, open, open_bytes};

const DATA: [u8; 12] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

/// The value and the origin of a fact.
fn fact<'a>(volume: &'a Volume, name: &str) -> (&'a str, &'a str) {
    let facts = volume.source.assumptions.stated();
    let fact = facts.iter().find(|fact| fact.name == name).unwrap_or_else(|| panic!("no {name}: {facts:?}"));
    (&fact.value, &fact.from)
}

fn nrrd(options: &OpenOptions) -> Volume {
    let header = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: raw\nspace: left-posterior-superior\n\
                  space directions: (1,0,0) (0,2,0) (0,0,3)\n\n";
    open_bytes("a.nrrd", &attached(header, &DATA), options).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn spacing_and_orientation_say_where_they_come_from() {
    let volume = nrrd(&OpenOptions::default());
    assert_eq!(fact(&volume, "spacing").1, "`space directions`");
    assert_eq!(fact(&volume, "orientation").1, "`space` and `space directions`");
    let spaced = OpenOptions { spacing: Some([2.0; 3]), ..OpenOptions::default() };
    assert_eq!(fact(&nrrd(&spaced), "spacing").1, "what was asked for");
    let sform = nifti_u8(|header| {
        // sform_code, and the rows of the matrix.
        header.i16(254, 1).f32(280, 1.0).f32(296 + 4, 2.0).f32(312 + 8, 3.0)
    });
    let volume = open_bytes("a.nii", &sform, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((fact(&volume, "spacing").1, fact(&volume, "orientation").1), ("the sform", "the sform"));
}

#[test]
fn a_series_says_what_a_radiologist_asks_first() {
    let folder = Folder::new();
    for index in 0..3_u8 {
        let mut slice = Dicom::slice(f64::from(index), &[index; 6]);
        slice.text((0x0008, 0x0060), "CS", "CT").text((0x0020, 0x0011), "IS", "4");
        slice.text((0x0008, 0x103e), "LO", "Head").text((0x0018, 0x0060), "DS", "120");
        slice.text((0x0018, 0x0050), "DS", "0.75").text(INTERCEPT, "DS", "-1024");
        folder.write(&format!("slice{index}"), slice.bytes());
    }
    let volume = open(&folder.path("."), &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    for (name, value, from) in [
        ("series", "4: Head", "Series Number"),
        ("modality", "CT", "Modality"),
        ("kVp", "120", "KVP"),
        ("thickness", "0.75 mm a slice", "Slice Thickness"),
        ("values", "Hounsfield units (HU)", "Rescale Intercept"),
        ("spacing", "", "Pixel Spacing, Image Position (Patient)"),
        ("orientation", "", "Image Orientation (Patient)"),
    ] {
        let (found, place) = fact(&volume, name);
        assert!(found == value && place.contains(from), "{name}: {found} from {place}");
    }
    // MR is in no unit, and that is told as well.
    let other = Folder::new();
    other.write("slice0", Dicom::slice(0.0, &[1; 6]).bytes());
    let volume = open(&other.path("slice0"), &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert!(fact(&volume, "values").0.contains("not Hounsfield units"));
}
