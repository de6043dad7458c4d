//! Voxels of several components: colours by their luminance, vectors by their length, or one component.

mod common;

use common::vtk::{base64, vti, word};
use common::{attached, gzip, metaimage, nrrd, values};
use vitrum_io::{OpenOptions, Volume, open_bytes};

/// Twelve vectors: the first is (2, 3, 6), the second (4, 4, 7), the third (1, 2, 2), the others are 0.
fn vectors() -> Vec<u8> {
    let mut bytes = vec![2, 3, 6, 4, 4, 7, 1, 2, 2];
    bytes.resize(36, 0);
    bytes
}

fn read(name: &str, bytes: &[u8], array: Option<&str>) -> Result<Volume, vitrum_io::Error> {
    open_bytes(name, bytes, &OpenOptions { array: array.map(str::to_owned), ..OpenOptions::default() })
}

/// The same vectors in every format, as unsigned bytes, and a word of each format's name for one component.
fn files(colors: bool) -> Vec<(&'static str, Vec<u8>)> {
    let kind = if colors { "RGB-color" } else { "3-vector" };
    let axes =
        format!("kinds: {kind} domain domain domain\nspace: RAS\nspace directions: none (2,0,0) (0,3,0) (0,0,4)\n");
    let header = |encoding: &str| {
        nrrd("uint8", encoding, &axes).replace("dimension: 3", "dimension: 4").replace("sizes: 3 2 2", "sizes: 3 3 2 2")
    };
    let inline = base64(&[word(36, 4, false), vectors()].concat());
    let mut files = vec![
        ("a.nrrd", attached(&header("raw"), &vectors())),
        ("packed.nrrd", attached(&header("gzip"), &gzip(&vectors()))),
    ];
    // Bytes of three or four are colours where the format says no kind.
    if colors {
        let placed = "ElementNumberOfChannels = 3\nElementSpacing = 2 3 4\n";
        files.push(("a.mha", attached(&metaimage("MET_UCHAR", placed, "LOCAL"), &vectors())));
        let array = "type=\"UInt8\" NumberOfComponents=\"3\" format=\"binary\"";
        files.push(("a.vti", vti("byte_order=\"LittleEndian\"", array, &inline, b"")));
    }
    files
}

#[test]
fn vectors_are_shown_by_their_length() {
    for (name, bytes) in files(false).into_iter().chain(files(true)) {
        let volume = read(name, &bytes, Some("norm")).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(volume.dimensions, [3, 2, 2], "{name}");
        assert_eq!(values(&volume)[..4], [7.0, 9.0, 3.0, 0.0], "{name}");
        if !name.ends_with("vti") {
            assert_eq!(volume.spacing, [2.0, 3.0, 4.0], "{name}");
        }
        assert_eq!(volume.source.sample_type, "3 x uint8", "{name}");
        let told = volume.source.assumptions.facts().join("; ");
        assert!(told.contains("3 components: the length of the vector was taken"), "{name}: {told}");
    }
    // Without being asked for.
    let (_, bytes) = &files(false)[0];
    assert_eq!(values(&read("a.nrrd", bytes, None).expect("vectors"))[0], 7.0);
}

#[test]
fn colours_are_shown_by_their_luminance_and_components_by_number() {
    for (name, bytes) in files(true) {
        for asked in [None, Some("rgb")] {
            let volume = read(name, &bytes, asked).unwrap_or_else(|error| panic!("{name}: {error}"));
            let expected = 0.2126 * 2.0 + 0.7152 * 3.0 + 0.0722 * 6.0;
            assert!((values(&volume)[0] - expected).abs() < 1e-5, "{name}: {}", values(&volume)[0]);
            let told = volume.source.assumptions.facts().join("; ");
            assert!(told.contains("the luminance was taken"), "{name}: {told}");
        }
        let second = read(name, &bytes, Some("1")).or_else(|_| read(name, &bytes, Some("density:1")));
        let second = second.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(values(&second)[..3], [3.0, 4.0, 2.0], "{name}");
    }
}

#[test]
fn wrong_components_are_refused() {
    let (_, bytes) = &files(true)[0];
    let error = read("a.nrrd", bytes, Some("3")).expect_err("there are three").to_string();
    assert!(error.contains("`3` is asked for of voxels with 3 components") && error.contains("0 to 2"), "{error}");
    let scalars = attached(&metaimage("MET_UCHAR", "", "LOCAL"), &[1; 12]);
    let error = read("a.mha", &scalars, Some("norm")).expect_err("scalars").to_string();
    assert!(error.contains("no arrays with names"), "{error}");
    let short = attached(&metaimage("MET_UCHAR", "ElementNumberOfChannels = 3\n", "LOCAL"), &[1; 35]);
    assert!(read("a.mha", &short, None).is_err());
    let text = metaimage("MET_UCHAR", "ElementNumberOfChannels = 3\nBinaryData = False\n", "LOCAL");
    let error = read("a.mha", &attached(&text, b"1 2 3"), None).expect_err("text").to_string();
    assert!(error.contains("binary form"), "{error}");
}
