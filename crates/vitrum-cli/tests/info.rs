//! `vitrum info` in the words of those who look at patients.

mod common;

use common::{Folder, nrrd};
use serde_json::Value;

const VOXELS: [u8; 24] = [7; 24];

#[test]
fn sides_and_millimetres_are_told_of_a_patient() {
    let folder = Folder::new();
    let fields = "space: left-posterior-superior\nspace directions: (0.5,-0,-6.24e-29) (0,1.2,-0.5) (0,1,2.4)\nspace origin: (-0,3,4)\n";
    folder.write("a.nrrd", nrrd("2 3 4", fields, &VOXELS));
    let text = folder.succeed(&["info", "a.nrrd"]);
    for words in [
        "spacing     0.5 x 1.3 x 2.6 mm  (from `space directions`)",
        "extent      1 x 3.9 x 10.4 mm",
        "origin      (0, -3, 4) mm",
        "orientation patient  (from `space` and `space directions`)",
        // atan(5 / 12) = 22.62 degrees.
        "axes        x R→L; y A→P, 22.6° oblique; z I→S, 22.6° oblique",
        "range       7 to 7",
    ] {
        assert!(text.contains(words), "there is no `{words}`:\n{text}");
    }
    assert!(!text.contains("-0,") && !text.contains("-0)") && !text.contains("e-29"), "{text}");
    let json: Value = serde_json::from_str(&folder.succeed(&["info", "a.nrrd", "--json"])).expect("JSON");
    assert_eq!((&json["unit"], &json["letters"][0]), (&"mm".into(), &"R→L".into()));
    assert_eq!(json["facts"][0]["name"], "spacing");
    assert!(!json.to_string().contains("-0.0") && !json.to_string().contains("e-29"), "{json}");
}

#[test]
fn nothing_is_made_up_where_the_file_does_not_say_it() {
    let folder = Folder::new();
    folder.write("a.nrrd", nrrd("2 3 4", "spacings: 1 1 1\n", &VOXELS));
    let text = folder.succeed(&["info", "a.nrrd"]);
    assert!(text.contains("spacing     1 x 1 x 1  (from `spacings`)\n"), "{text}");
    assert!(!text.contains('→') && !text.contains(" mm") && text.contains("axes        x (1, 0, 0), y"), "{text}");
}
