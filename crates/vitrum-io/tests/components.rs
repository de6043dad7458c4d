//! Voxels of several components: colours as they are and by their luminance, vectors by their length, or one component.

mod common;

use common::vtk::{base64, vti, word};
use common::{NiftiHeader, attached, gzip, hex, metaimage, npy_with, npz, nrrd, values};
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

/// The channels of each voxel's colour.
fn colors(volume: &Volume) -> Vec<[u8; 4]> {
    volume.colors.as_deref().expect("there are colours").iter().map(|color| color.to_le_bytes()).collect()
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
    let text = vectors().iter().map(|number| format!("{number} ")).collect::<String>();
    let mut files = vec![
        ("a.nrrd", attached(&header("raw"), &vectors())),
        ("packed.nrrd", attached(&header("gzip"), &gzip(&vectors()))),
        ("hex.nrrd", attached(&header("hex"), &hex(&vectors()))),
        ("text.nrrd", attached(&header("ascii"), text.as_bytes())),
    ];
    // Bytes of three or four are colours where the format says no kind.
    if colors {
        let placed = "ElementNumberOfChannels = 3\nElementSpacing = 2 3 4\n";
        files.push(("a.mha", attached(&metaimage("MET_UCHAR", placed, "LOCAL"), &vectors())));
        let array = "type=\"UInt8\" NumberOfComponents=\"3\" format=\"binary\"";
        files.push(("a.vti", vti("byte_order=\"LittleEndian\"", array, &inline, b"")));
        let array = "type=\"UInt8\" NumberOfComponents=\"3\" format=\"ascii\"";
        files.push(("text.vti", vti("byte_order=\"LittleEndian\"", array, &text, b"")));
        let placed = "ElementNumberOfChannels = 3\nElementSpacing = 2 3 4\nBinaryData = False\n";
        files.push(("text.mha", attached(&metaimage("MET_UCHAR", placed, "LOCAL"), text.as_bytes())));
        let scalars = "SCALARS density unsigned_char 3\nLOOKUP_TABLE default\n";
        files.push(("scalars.vtk", vtk("BINARY", scalars, &vectors())));
        files.push(("text.vtk", vtk("ASCII", scalars, text.as_bytes())));
        files.push(("colors.vtk", vtk("BINARY", "COLOR_SCALARS density 3\n", &vectors())));
        let mut header = NiftiHeader::new(128, 3, false);
        // Colours have no slope.
        header.f32(80, 2.0).f32(84, 3.0).f32(88, 4.0).f32(112, 7.0);
        files.push(("a.nii", header.with(&vectors())));
        let numbers = npy("False", "2, 2, 3, 3", &vectors());
        files.push(("a.npy", numbers.clone()));
        files.push(("a.npz", npz(&[("density.npy", zip::CompressionMethod::Deflated, &numbers)])));
    }
    files
}

/// A legacy file of 3 x 2 x 2 points with this attribute, spacings 2, 3, 4.
fn vtk(kind: &str, attribute: &str, data: &[u8]) -> Vec<u8> {
    let head = format!(
        "# vtk DataFile Version 3.0\na title\n{kind}\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nSPACING 2 3 4\n\
         POINT_DATA 12\n{attribute}"
    );
    attached(&head, data)
}

/// An array of bytes.
fn npy(fortran_order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let dictionary = format!("{{'descr': '|u1', 'fortran_order': {fortran_order}, 'shape': ({shape}), }}");
    npy_with((1, 0), &dictionary, data)
}

/// The first components, then the second, then the third.
fn in_planes(interleaved: &[u8]) -> Vec<u8> {
    (0..3).flat_map(|index| interleaved[index..].iter().step_by(3).copied()).collect()
}

#[test]
fn vectors_are_shown_by_their_length() {
    for (name, bytes) in files(false).into_iter().chain(files(true)) {
        let volume = read(name, &bytes, Some("norm")).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(volume.dimensions, [3, 2, 2], "{name}");
        assert_eq!(values(&volume)[..4], [7.0, 9.0, 3.0, 0.0], "{name}");
        if !(name.ends_with("vti") || name.contains(".np")) {
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
fn colours_are_shown_as_they_are_and_components_by_number() {
    for (name, bytes) in files(true) {
        for asked in [None, Some("rgb")] {
            // Two voxels along an axis: a small array tells its components by being asked alone.
            if asked.is_none() && name.contains(".np") {
                continue;
            }
            let volume = read(name, &bytes, asked).unwrap_or_else(|error| panic!("{name}: {error}"));
            let expected = 0.2126 * 2.0 + 0.7152 * 3.0 + 0.0722 * 6.0;
            assert!((values(&volume)[0] - expected).abs() < 1e-5, "{name}: {}", values(&volume)[0]);
            let told = volume.source.assumptions.facts().join("; ");
            assert!(told.contains("colours are shown, and opacity goes by the luminance"), "{name}: {told}");
            assert_eq!(
                colors(&volume)[..4],
                [[2, 3, 6, 255], [4, 4, 7, 255], [1, 2, 2, 255], [0, 0, 0, 255]],
                "{name}"
            );
        }
        let second = read(name, &bytes, Some("1")).or_else(|_| read(name, &bytes, Some("density:1")));
        let second = second.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(values(&second)[..3], [3.0, 4.0, 2.0], "{name}");
        assert_eq!(second.colors, None, "{name}");
    }
}

#[test]
fn colours_of_16_bits_and_of_floats_become_bytes() {
    let axes = "kinds: RGBA-color domain domain domain\n";
    let header = |kind: &str| {
        nrrd(kind, "raw", &format!("endian: little\n{axes}"))
            .replace("dimension: 3", "dimension: 4")
            .replace("sizes: 3 2 2", "sizes: 4 1 1 2")
    };
    let halves = [0_u16, 257, 65535, 514, 128, 129, 0, 65535].map(u16::to_le_bytes).concat();
    let volume = read("a.nrrd", &attached(&header("uint16"), &halves), None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(colors(&volume), [[0, 1, 255, 2], [0, 1, 0, 255]]);
    let floats = [0.0_f32, 0.5, 1.0, 0.0, 7.0, -1.0, 0.25, 0.0].map(f32::to_le_bytes).concat();
    let volume = read("a.nrrd", &attached(&header("float"), &floats), None).unwrap_or_else(|error| panic!("{error}"));
    // Nobody has filled in an opacity.
    assert_eq!(colors(&volume), [[0, 128, 255, 255], [255, 0, 64, 255]]);
    let signed = read("a.nrrd", &attached(&header("int16"), &halves), None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(signed.colors, None);
    assert!(signed.source.assumptions.facts().join("; ").contains("colours of int16 are not shown"));
    let cropped = volume.cropped(&[0..1, 0..1, 1..2]).expect("a part");
    assert_eq!(colors(&cropped), [[255, 0, 64, 255]]);
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
    assert!(error.contains("promises 12 numbers") || error.contains("promises 36 numbers"), "{error}");
    let numbers = |last: &str| attached(&text, format!("{}{last}", "1 ".repeat(35)).as_bytes());
    let error = read("a.mha", &numbers("300"), None).expect_err("no byte").to_string();
    assert!(error.contains("number 36 of the data, `300`, is not a uint8"), "{error}");
    let error = read("a.mha", &numbers("3 4"), None).expect_err("one more").to_string();
    assert!(error.contains("`4` follows the 36 numbers"), "{error}");
    for (name, scalars) in
        [("a.nii", NiftiHeader::new(2, 1, false).with(&[7; 12])), ("a.npy", npy("False", "2, 2, 3", &[7; 12]))]
    {
        let error = read(name, &scalars, Some("norm")).expect_err("scalars").to_string();
        assert!(error.contains("its voxels have one component"), "{name}: {error}");
    }
    let scalars = vtk("BINARY", "SCALARS density unsigned_char 1\nLOOKUP_TABLE default\n", &[1; 12]);
    let error = read("a.vtk", &scalars, Some("density:norm")).expect_err("scalars").to_string();
    assert!(error.contains("`density`, which has one component"), "{error}");
}

#[test]
fn colours_with_opacity_and_vectors_in_planes_are_read_of_nifti() {
    let mut rgba = Vec::new();
    vectors().chunks_exact(3).for_each(|color| rgba.extend([color[0], color[1], color[2], 99]));
    let file = NiftiHeader::new(2304, 4, true).with(&rgba);
    let volume = read("a.nii", &file, None).unwrap_or_else(|error| panic!("{error}"));
    assert!((values(&volume)[0] - (0.2126 * 2.0 + 0.7152 * 3.0 + 0.0722 * 6.0)).abs() < 1e-5, "{:?}", values(&volume));
    assert_eq!(volume.source.sample_type, "4 x uint8");
    assert_eq!(colors(&volume)[..2], [[2, 3, 6, 99], [4, 4, 7, 99]]);
    assert_eq!(values(&read("a.nii", &file, Some("3")).expect("opacity"))[..2], [99.0, 99.0]);
    // A displacement field: five dimensions, the fourth of size 1, with a slope of 2.
    let mut header = NiftiHeader::new(4, 2, false);
    header.i16(40, 5).i16(50, 3).i16(68, 1007).f32(112, 2.0);
    let planes: Vec<u8> =
        in_planes(&vectors()).into_iter().flat_map(|number| (-i16::from(number)).to_le_bytes()).collect();
    for (name, file) in [("a.nii", header.with(&planes)), ("a.nii.gz", gzip(&header.with(&planes)))] {
        let volume = read(name, &file, None).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(values(&volume)[..4], [14.0, 18.0, 6.0, 0.0], "{name}");
        assert_eq!(volume.source.sample_type, "3 x int16");
        assert_eq!(values(&read(name, &file, Some("2")).expect("a component"))[..3], [-12.0, -14.0, -4.0], "{name}");
    }
    // Two points in time: the second is of the vectors, the first of zeros.
    header.i16(48, 2);
    let timed: Vec<u8> = planes.chunks(24).flat_map(|plane| [&[0; 24][..], plane].concat()).collect();
    let options = OpenOptions { time: Some(1), ..OpenOptions::default() };
    let second = open_bytes("a.nii", &header.with(&timed), &options).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(values(&second)[..4], [14.0, 18.0, 6.0, 0.0]);
    let error = read("a.nii", &header.with(&timed[..100]), None).expect_err("cut short").to_string();
    assert!(error.contains("promises 144 bytes"), "{error}");
}

#[test]
fn a_last_axis_of_3_is_of_components_where_no_volume_is_that_thin() {
    let bytes: Vec<u8> = (0..5 * 6 * 7 * 3).map(|index| (index % 3) as u8 * 2 + 2).collect();
    let colors = read("a.npy", &npy("False", "5, 6, 7, 3", &bytes), None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(colors.dimensions, [7, 6, 5]);
    assert!(values(&colors).iter().all(|value| (value - (0.2126 * 2.0 + 0.7152 * 4.0 + 0.0722 * 6.0)).abs() < 1e-5));
    let told = colors.source.assumptions.facts().join("; ");
    assert!(told.contains("the luminance") && told.contains("last but one"), "{told}");
    // Points in time where these are asked for.
    let timed = OpenOptions { time: Some(4), ..OpenOptions::default() };
    let timed = open_bytes("a.npy", &npy("False", "5, 6, 7, 3", &bytes), &timed).expect("a time");
    assert_eq!((timed.dimensions, values(&timed)[..3].to_vec()), ([3, 7, 6], vec![2.0, 4.0, 6.0]));
    // Both: five axes.
    let both = [vec![0; 630], bytes.clone()].concat();
    let both = npy("False", "2, 5, 6, 7, 3", &both);
    let second = OpenOptions { time: Some(1), array: Some("2".to_owned()), ..OpenOptions::default() };
    assert_eq!(open_bytes("a.npy", &both, &second).expect("a time of colours").range, [6.0, 6.0]);
    assert_eq!(read("a.npy", &both, None).expect("the first time").range, [0.0, 0.0]);
    // In Fortran order, in planes.
    let planes = npy("True", "3, 2, 2, 3", &in_planes(&vectors()));
    assert_eq!(values(&read("a.npy", &planes, Some("norm")).expect("vectors"))[..4], [7.0, 9.0, 3.0, 0.0]);
    assert_eq!(values(&read("a.npy", &planes, Some("1")).expect("components"))[..3], [3.0, 4.0, 2.0]);
    // By the name of an archive's array.
    let archive = npz(&[
        ("a.npy", zip::CompressionMethod::Stored, &npy("False", "2, 2, 3", &[1; 12])),
        ("b.npy", zip::CompressionMethod::Deflated, &npy("True", "3, 2, 2, 3", &in_planes(&vectors()))),
    ]);
    for asked in ["b:norm", "norm"] {
        let volume = read("a.npz", &archive, Some(asked)).unwrap_or_else(|error| panic!("{asked}: {error}"));
        assert_eq!(values(&volume)[..4], [7.0, 9.0, 3.0, 0.0], "{asked}");
    }
}

#[test]
fn vectors_of_legacy_files_are_read_where_no_scalars_are() {
    let floats: Vec<u8> = vectors().iter().flat_map(|&number| f32::from(number).to_be_bytes()).collect();
    let vectors = attached("VECTORS v float\n", &floats);
    let file = [&vtk("BINARY", "", b"")[..], &vectors].concat();
    let volume = read("a.vtk", &file, None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(values(&volume)[..4], [7.0, 9.0, 3.0, 0.0]);
    assert_eq!(volume.source.sample_type, "3 x float32");
    // Scalars go before, wherever they stand; a part of the vectors is there for the asking.
    let scalars = attached("\nSCALARS s unsigned_char 1\nLOOKUP_TABLE default\n", &[5; 12]);
    let both = [&file[..], &scalars].concat();
    assert_eq!(read("a.vtk", &both, None).expect("scalars").range, [5.0, 5.0]);
    for (asked, first) in [("v:1", 3.0), ("norm", 7.0), ("2", 6.0), ("v", 7.0), ("s", 5.0)] {
        let volume = read("a.vtk", &both, Some(asked)).unwrap_or_else(|error| panic!("{asked}: {error}"));
        assert_eq!(values(&volume)[0].to_bits(), f32::to_bits(first), "{asked}");
    }
    // Colours of text are numbers up to 1.
    let colors = vtk("ASCII", "COLOR_SCALARS c 4\n", "0.5 0.25 1 1\n".repeat(12).as_bytes());
    let volume = read("a.vtk", &colors, None).unwrap_or_else(|error| panic!("{error}"));
    assert!((values(&volume)[11] - (0.5 * 0.2126 + 0.25 * 0.7152 + 0.0722)).abs() < 1e-6, "{:?}", values(&volume));
}
