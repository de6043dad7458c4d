//! Written volumes are read again: values, and in NRRD the place.

mod common;

use common::{Folder, NiftiHeader, samples, values};
use vitrum_io::{Error, OpenOptions, Orientation, Up, open, write_volume};

#[test]
fn every_type_comes_back_from_what_was_written() {
    let folder = Folder::new();
    for sample in samples() {
        let mut header = NiftiHeader::new(sample.nifti_code, sample.size, false);
        // A turned sform: x to anterior, y to the left, z up.
        header.i16(254, 1).f32(284, -2.0).f32(292, 5.0).f32(296, 1.0).f32(308, 6.0).f32(320, 3.0).f32(324, 7.0);
        let volume = folder.open("a.nii", header.with(&sample.little)).unwrap_or_else(|error| panic!("{error}"));
        for name in ["b.nrrd", "b.npy"] {
            let path = folder.path(name);
            write_volume(&path, &volume).unwrap_or_else(|error| panic!("{error}"));
            let again = open(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(values(&again), values(&volume), "{name} of {}", sample.name);
            if name == "b.nrrd" {
                assert_eq!((again.spacing, again.axes, again.origin), (volume.spacing, volume.axes, volume.origin));
            }
            let small = sample.size <= 2;
            let kept = again.source.sample_type == volume.source.sample_type;
            assert_eq!(kept, small || sample.name == "float", "{}", sample.name);
        }
    }
}

#[test]
fn what_a_file_does_not_say_about_its_place_stays_unsaid() {
    let folder = Folder::new();
    let voxels = [7; 12];
    let plain = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: raw\n";
    let nrrd = |more: &str| [format!("{plain}{more}\n").as_bytes(), &voxels].concat();
    let directions = "space directions: (0,2,0) (-1,0,0) (0,0,3)\nspace origin: (1,2,3)\n";
    let mut sform = NiftiHeader::new(2, 1, false);
    sform.i16(254, 1).f32(280, 1.0).f32(300, 1.0).f32(320, 1.0);
    let meta = |more: &str| {
        let header = format!("NDims = 3\nDimSize = 3 2 2\n{more}ElementType = MET_UCHAR\nElementDataFile = LOCAL\n");
        [header.as_bytes(), &voxels].concat()
    };
    let matrix = "TransformMatrix = 1 0 0 0 1 0 0 0 1\n";
    let (patient, world, unknown) = (Orientation::Patient, Orientation::World, Orientation::Unknown);
    for (name, content, orientation) in [
        ("a.nrrd", nrrd(""), unknown),
        ("a.nrrd", nrrd(&format!("space dimension: 3\n{directions}")), unknown),
        ("a.nrrd", nrrd(&format!("space: 3D-right-handed\n{directions}")), world),
        ("a.nrrd", nrrd(&format!("space: 3D-left-handed\n{directions}")), world),
        ("a.nrrd", nrrd(&format!("space: LPS\n{directions}")), patient),
        ("a.nii", NiftiHeader::new(2, 1, false).with(&voxels), unknown),
        ("a.nii", sform.with(&voxels), patient),
        ("a.mha", meta(""), unknown),
        ("a.mha", meta("AnatomicalOrientation = RAI\n"), patient),
        ("a.mha", meta(matrix), patient),
    ] {
        let volume = folder.open(name, content).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(volume.orientation, orientation, "{name}");
        for up in [Up::Superior, Up::Inferior] {
            let volume = volume.clone().turned(up);
            let path = folder.path("b.nrrd");
            write_volume(&path, &volume).unwrap();
            let again = open(&path, &OpenOptions::default()).unwrap();
            assert_eq!((again.axes, again.origin), (volume.axes, volume.origin), "{name}");
            // A patient that stands on its head does not lie along the patient's axes.
            let kept = if up == Up::Inferior && orientation == patient { world } else { orientation };
            assert_eq!((volume.orientation, again.orientation), (kept, kept), "{name}");
            let told = again.source.assumptions.iter().any(|note| note.fact.contains("the file says no orientation"));
            assert_eq!(told, kept == unknown, "{name}: {:?}", again.source.assumptions);
        }
    }
}

#[test]
fn scaled_values_are_written_as_they_are() {
    let folder = Folder::new();
    let mut header = NiftiHeader::new(2, 1, false);
    header.f32(112, 0.5).f32(116, -1.0);
    let volume = folder.open("a.nii", header.with(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 255])).unwrap();
    write_volume(&folder.path("b.npy"), &volume).unwrap();
    assert_eq!(values(&open(&folder.path("b.npy"), &OpenOptions::default()).unwrap()), values(&volume));
}

#[test]
fn what_cannot_be_written_leaves_nothing() {
    let folder = Folder::new();
    let volume = folder.open("a.nii", NiftiHeader::new(2, 1, false).with(&[7; 12])).unwrap();
    assert!(matches!(write_volume(&folder.path("b.nii"), &volume), Err(Error::Unsupported { .. })));
    assert!(matches!(write_volume(&folder.path("none/b.npy"), &volume), Err(Error::Write { .. })));
    assert_eq!(folder.names(), ["a.nii"]);
}
