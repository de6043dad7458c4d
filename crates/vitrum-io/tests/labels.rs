//! Files of labels are seen for what they are.

mod common;

use common::{attached, nifti_u8, nifti2_u8, nrrd};
use vitrum_io::{OpenOptions, open_bytes};

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
    assert!(facts.contains("interpolated"), "{facts}");
    assert!(!told("a.nrrd", &attached(&nrrd("uint8", "raw", "a:=b\n"), &[3; 12])).contains("labels"));
}

#[test]
fn the_intent_of_nifti_tells_labels() {
    let first = nifti_u8(|header| header.i16(68, 1002));
    let second = nifti2_u8(|header| header.i32(504, 1002));
    for bytes in [first, second] {
        assert!(told("a.nii", &bytes).contains("the values are labels, by the header's intent; they"));
    }
    assert!(!told("a.nii", &nifti_u8(|header| header.i16(68, 3))).contains("labels"));
}
