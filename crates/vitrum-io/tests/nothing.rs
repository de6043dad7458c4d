//! NaN is nothing and infinities are the ends of the finite range, in every format that can hold them.

mod common;

use common::tiff::{Page, tiff};
use common::vtk::{base64, vti, vtk, word};
use common::{NiftiHeader, attached, metaimage, npy, npz, nrrd, values};
use vitrum_io::{OpenOptions, Volume, open_bytes};
use zip::CompressionMethod;

/// Twelve voxels: two are NaN, one is +∞ and one −∞.
const ROW: [f32; 12] = [1.0, f32::NAN, 3.0, f32::INFINITY, -2.0, f32::NEG_INFINITY, 0.5, 0.0, 0.25, 2.0, 0.0, f32::NAN];

fn little(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn big(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_be_bytes()).collect()
}

fn wide(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|&value| f64::from(value).to_le_bytes()).collect()
}

fn read(name: &str, bytes: &[u8], raw: Option<&str>) -> Volume {
    let raw = raw.map(|raw| raw.parse().expect("a layout"));
    let options = OpenOptions { raw, ..OpenOptions::default() };
    open_bytes(name, bytes, &options).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn every_reader_takes_nan_for_nothing_and_tells_how_often() {
    let text: String = ROW.iter().map(|value| format!("{value} ")).collect();
    let archive = npz(&[("a.npy", CompressionMethod::Deflated, &npy("<f4", &little(&ROW)))]);
    let inline = base64(&[word(48, 4, false), little(&ROW)].concat());
    let files: Vec<(&str, Vec<u8>, Option<&str>)> = vec![
        ("a.nrrd", attached(&nrrd("float", "raw", "endian: big\n"), &big(&ROW)), None),
        ("text.nrrd", attached(&nrrd("float", "text", ""), text.as_bytes()), None),
        ("wide.nrrd", attached(&nrrd("double", "raw", "endian: little\n"), &wide(&ROW)), None),
        ("a.nii", NiftiHeader::new(16, 4, false).with(&little(&ROW)), None),
        ("a.mha", attached(&metaimage("MET_FLOAT", "", "LOCAL"), &little(&ROW)), None),
        ("a.npy", npy("<f4", &little(&ROW)), None),
        ("wide.npy", npy("<f8", &wide(&ROW)), None),
        ("a.npz", archive, None),
        ("a.vti", vti("byte_order=\"LittleEndian\"", "type=\"Float32\" format=\"binary\"", &inline, b""), None),
        ("a.vtk", vtk("BINARY", "float", &big(&ROW)), None),
        ("text.vtk", vtk("ASCII", "float", text.as_bytes()), None),
        ("a.tif", tiff(false, &[Page::new(32, 3, &little(&ROW[..6])), Page::new(32, 3, &little(&ROW[6..]))]), None),
        ("a.raw", little(&ROW), Some("3x2x2:f32:le")),
    ];
    for (name, bytes, raw) in files {
        let volume = read(name, &bytes, raw);
        let expected = [1.0, -2.0, 3.0, 3.0, -2.0, -2.0, 0.5, 0.0, 0.25, 2.0, 0.0, -2.0];
        assert_eq!(values(&volume), expected, "{name}");
        assert_eq!(volume.range, [-2.0, 3.0], "{name}");
        let facts = volume.source.assumptions.facts().join("; ");
        assert!(facts.contains("2 of 12 voxels are NaN, which is nothing"), "{name}: {facts}");
        assert!(facts.contains("2 of 12 voxels are infinite"), "{name}: {facts}");
    }
}

#[test]
fn what_is_beyond_float32_is_the_end_of_the_finite_range() {
    let mut row = ROW.map(f64::from);
    (row[0], row[1]) = (1e300, -1e300);
    let bytes: Vec<u8> = row.iter().flat_map(|value| value.to_le_bytes()).collect();
    let volume = read("a.npy", &npy("<f8", &bytes), None);
    assert_eq!(values(&volume)[..2], [3.0, -2.0]);
    let facts = volume.source.assumptions.facts().join("; ");
    assert!(facts.contains("1 of 12 voxels are NaN") && facts.contains("4 of 12 voxels are infinite"), "{facts}");
}

#[test]
fn nothing_is_the_least_physical_value_under_a_falling_scale() {
    // NIfTI: the slope at byte 112.
    let mut bytes = NiftiHeader::new(16, 4, false).with(&little(&ROW));
    bytes[112..116].copy_from_slice(&(-2.0_f32).to_le_bytes());
    let volume = read("a.nii", &bytes, None);
    assert_eq!(volume.range, [-6.0, 4.0]);
    assert_eq!([volume.value(1, 0, 0), volume.value(2, 1, 1)], [-6.0, -6.0]);
    // +∞ times −2 is −∞.
    assert_eq!([volume.value(0, 1, 0), volume.value(2, 1, 0)], [-6.0, 4.0]);
}
