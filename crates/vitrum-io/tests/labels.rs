//! Files of labels are seen for what they are.

mod common;

use common::tiff::{Page, Value, tiff};
use common::{NiftiHeader, attached, nifti_u8, nifti2_u8, nrrd};
use vitrum_io::{Labels, OpenOptions, Volume, open_bytes};

fn read(name: &str, bytes: &[u8]) -> Volume {
    open_bytes(name, bytes, &OpenOptions::default()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn labels(name: &str, bytes: &[u8]) -> Option<Labels> {
    read(name, bytes).source.labels().cloned()
}

/// 16 x 16 x 16 voxels by their place.
fn cube(value: impl Fn([usize; 3]) -> u8) -> Vec<u8> {
    (0..4096).map(|index| value([index % 16, index / 16 % 16, index / 256])).collect()
}

/// Two blocks side by side and one apart, whose labels are no neighbours of each other.
fn blocks() -> Vec<u8> {
    cube(|[x, y, z]| match (x, y, z) {
        (2..8, 2..8, 2..8) => 2,
        (8..14, 2..8, 2..8) => 17,
        (2..8, 10..14, 2..14) => 5,
        _ => 0,
    })
}

fn nifti(data: &[u8], change: impl FnOnce(&mut NiftiHeader) -> &mut NiftiHeader) -> Vec<u8> {
    let mut header = NiftiHeader::new(2, 1, false);
    header.i16(42, 16).i16(44, 16).i16(46, 16);
    change(&mut header);
    header.with(data)
}

fn told(name: &str, bytes: &[u8]) -> String {
    let volume = open_bytes(name, bytes, &OpenOptions::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
    volume.source.assumptions.facts().join("; ")
}

#[test]
fn segmentations_are_told_with_names_and_colours() {
    let segments = "Segment0_ID:=a\nSegment0_Name:=liver\nSegment0_Color:=0.87 0.72 0.43\nSegment0_LabelValue:=3\n\
                    Segment1_Name:=left kidney\nSegment1_LabelValue:=7\nSegmentation_MasterRepresentation:=Binary labelmap\n";
    let facts = told("a.seg.nrrd", &attached(&nrrd("uint8", "raw", segments), &[3; 12]));
    assert!(
        facts.contains(
            "the values are labels, by the segments of the header: 3 `liver` (0.87 0.72 0.43), 7 `left kidney`"
        ),
        "{facts}"
    );
    assert!(facts.contains("--preset labels"), "{facts}");
    assert!(!told("a.nrrd", &attached(&nrrd("uint8", "raw", "a:=b\n"), &[3; 12])).contains("labels"));
}

#[test]
fn the_intent_of_nifti_tells_labels() {
    let first = nifti_u8(|header| header.i16(68, 1002));
    let second = nifti2_u8(|header| header.i32(504, 1002));
    for bytes in [first, second] {
        assert!(told("a.nii", &bytes).contains("the values are labels, by the header's intent: 7; `--preset labels`"));
    }
    assert!(!told("a.nii", &nifti_u8(|header| header.i16(68, 3))).contains("labels"));
    // The values that are there are listed.
    let facts = told("a.nii", &nifti(&blocks(), |header| header.i16(68, 1002)));
    assert!(facts.contains("by the header's intent: 2, 5, 17; `--preset labels`"), "{facts}");
}

#[test]
fn few_whole_numbers_that_lie_apart_are_labels() {
    let values = |labels: Option<Labels>| -> Vec<f32> {
        labels.into_iter().flat_map(|labels| labels.list).map(|label| label.value).collect()
    };
    let header = nrrd("uint8", "raw", "").replace("sizes: 3 2 2", "sizes: 16 16 16");
    for (name, file) in [("a.nii", nifti(&blocks(), |header| header)), ("a.nrrd", attached(&header, &blocks()))] {
        let found = labels(name, &file);
        assert!(found.as_ref().is_some_and(|labels| labels.by.contains("few whole numbers")), "{name}: {found:?}");
        assert_eq!(values(found), [2.0, 5.0, 17.0], "{name}");
    }
    // Measurements are none: coarse steps of a smooth field, scattered values, floats, and few voxels.
    let smooth = cube(|[x, y, z]| (x.abs_diff(8) + y.abs_diff(8) + z.abs_diff(8)).min(15) as u8);
    let scattered = cube(|[x, y, z]| [0, 2, 5, 17][(x * 7 + y * 3 + z * 5 + x * y) % 4]);
    for (name, data) in [("smooth", smooth), ("scattered", scattered)] {
        assert_eq!(labels("a.nii", &nifti(&data, |header| header)), None, "{name}");
    }
    assert_eq!(labels("a.nii", &nifti(&blocks(), |header| header.f32(112, 0.5))), None, "scaled values");
    assert_eq!(labels("a.nii", &nifti_u8(|header| header)), None, "few voxels");
}

#[test]
fn masks_and_palettes_of_imagej_are_labels() {
    let pages = |data: &[u8], change: &dyn Fn(Page) -> Page| -> Vec<u8> {
        let pages: Vec<Page> = data
            .chunks(256)
            .map(|page| {
                let page = Page::bytes(page).set(256, Value::Long(16)).set(257, Value::Long(16));
                change(page.set(278, Value::Long(16)))
            })
            .collect();
        tiff(false, &pages)
    };
    let mask = cube(|[x, y, z]| if [x, y, z].iter().all(|place| (4..12).contains(place)) { 255 } else { 0 });
    let found = labels("a.tif", &pages(&mask, &|page| page)).expect("a mask");
    assert!(found.by.contains("two values, as those of a mask"), "{found:?}");
    assert_eq!(found.list.iter().map(|label| label.value).collect::<Vec<_>>(), [255.0]);
    // Voxels that a body fills are not told from a mask in a format of volumes.
    let header = nrrd("uint8", "raw", "").replace("sizes: 3 2 2", "sizes: 16 16 16");
    assert_eq!(labels("a.nrrd", &attached(&header, &mask)), None);
    // A palette whose colours jump is of labels, one that runs is of measurements.
    let jumping = |index: u16| [(index % 2) * 65535, (index / 2 % 2) * 65535, (index / 4 % 2) * 65535];
    let running = |index: u16| [index * 257; 3];
    let palette = |color: &dyn Fn(u16) -> [u16; 3]| -> Vec<u8> {
        let map: Vec<u16> = (0..3)
            .flat_map(|part| (0..256).map(move |index| (part, index)))
            .map(|(part, index)| color(index)[part])
            .collect();
        pages(&blocks(), &move |page| page.set(262, Value::Short(3)).set(320, Value::Shorts(map.clone())))
    };
    let found = labels("a.tif", &palette(&jumping)).expect("labels");
    assert_eq!(found.by, "colours of the palette");
    let colors: Vec<_> = found.list.iter().map(|label| (label.value, label.color)).collect();
    let expected = [(2.0, [0.0, 1.0, 0.0]), (5.0, [1.0, 0.0, 1.0]), (17.0, [1.0, 0.0, 0.0])];
    assert_eq!(colors, expected.map(|(value, color)| (value, Some(color))));
    assert!(told("a.tif", &palette(&jumping)).contains("colours of the palette: 2 (0 1 0), 5 (1 0 1), 17 (1 0 0)"));
    let found = labels("a.tif", &palette(&running)).expect("labels by their values");
    assert!(
        found.by.contains("few whole numbers") && found.list.iter().all(|label| label.color.is_none()),
        "{found:?}"
    );
}
