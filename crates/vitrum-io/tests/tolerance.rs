//! The rule of all readers: what does not decide voxels, positions or connectivity is left out and told; a second source stands in for
//! a bad first one; a user's option goes before the check of what it replaces.

mod common;

use std::path::Path;

use common::dicom::{Dicom, FRAMES, POSITION, element};
use common::mesh::{cuboid, obj};
use common::tiff::{Page, Value, tiff};
use common::{Folder, attached, gzip, metaimage, nifti_u8, npy_with, nrrd, values, zlib};
use vitrum_io::{Error, Mesh, OpenOptions, Volume, open_bytes, open_mesh_bytes};

const DATA: [u8; 12] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

fn read(name: &str, bytes: &[u8], options: &OpenOptions) -> Result<Volume, Error> {
    open_bytes(name, bytes, options)
}

fn plain(name: &str, bytes: impl AsRef<[u8]>) -> Volume {
    read(name, bytes.as_ref(), &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn told(volume: &Volume, note: &str) {
    let facts = volume.source.assumptions.facts();
    assert!(facts.iter().any(|fact| fact.contains(note)), "{note}: {facts:#?}");
}

fn spaced() -> OpenOptions {
    OpenOptions { spacing: Some([2.0, 3.0, 4.0]), ..OpenOptions::default() }
}

/// Files of each format with the spacings `x y z`, whose samples are 1 to 12.
fn with_spacings(spacings: &str) -> Vec<(&'static str, Vec<u8>)> {
    let of = |index: usize| spacings.split(' ').nth(index).and_then(|word| word.parse::<f32>().ok()).unwrap_or(1.0);
    let vtk = format!(
        "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nSPACING {spacings}\n\
         POINT_DATA 12\nSCALARS s unsigned_char 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8 9 10 11 12\n"
    );
    let vti = format!(
        "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 2 0 1 0 1\" Spacing=\"{spacings}\">\
         <Piece Extent=\"0 2 0 1 0 1\"><PointData><DataArray type=\"UInt8\" Name=\"s\" format=\"ascii\">\
         1 2 3 4 5 6 7 8 9 10 11 12</DataArray></PointData></Piece></ImageData></VTKFile>"
    );
    vec![
        ("a.nrrd", attached(&nrrd("uint8", "raw", &format!("spacings: {spacings}\n")), &DATA)),
        ("a.mha", attached(&metaimage("MET_UCHAR", &format!("ElementSpacing = {spacings}\n"), "LOCAL"), &DATA)),
        ("a.nii", nifti_u8(|header| header.f32(80, of(0)).f32(84, of(1)).f32(88, of(2)))),
        ("a.vtk", vtk.into_bytes()),
        ("a.vti", vti.into_bytes()),
    ]
}

#[test]
fn a_spacing_that_is_none_is_taken_for_1_and_told() {
    for wrong in ["0", "nan", "inf"] {
        for (name, file) in with_spacings(&format!("2 3 {wrong}")) {
            let volume = plain(name, &file);
            assert_eq!((volume.dimensions, volume.spacing), ([3, 2, 2], [2.0, 3.0, 1.0]), "{name}: {wrong}");
            told(&volume, "the spacing along z is");
            // The user's goes before it.
            let volume = read(name, &file, &spaced()).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(volume.spacing, [2.0, 3.0, 4.0], "{name}: {wrong}");
            let facts = volume.source.assumptions.facts();
            assert!(!facts.iter().any(|fact| fact.contains("no distance")), "{name}: {facts:?}");
        }
    }
}

#[test]
fn an_axis_of_negative_spacing_runs_backwards() {
    for (name, file) in with_spacings("2 -3 4") {
        // A distance of NIfTI has no sign.
        if name == "a.nii" {
            continue;
        }
        let [straight, turned] = [plain(name, &with_spacings("2 3 4").remove(place(name)).1), plain(name, &file)];
        assert_eq!(turned.spacing, [2.0, 3.0, 4.0], "{name}");
        let back = straight.axes[1].map(|component| -component);
        assert!(turned.axes[1].iter().zip(back).all(|(a, b)| (a - b).abs() < 1e-6), "{name}: {:?}", turned.axes);
        told(&turned, "was taken to run backwards");
    }
}

fn place(name: &str) -> usize {
    ["a.nrrd", "a.mha", "a.nii", "a.vtk", "a.vti"].iter().position(|other| *other == name).expect("one of them")
}

#[test]
fn a_bogus_sform_gives_way_to_the_qform() {
    let volume = plain("a.nii", nifti_u8(|header| header.i16(254, 1).i16(252, 1).f32(268, 5.0)));
    assert_eq!((volume.orientation.name(), volume.origin[0]), ("patient", 5.0));
    told(&volume, "the qform stood in for it");
    let volume = plain("a.nii", nifti_u8(|header| header.i16(254, 1)));
    assert_eq!(volume.orientation.name(), "unknown");
    told(&volume, "the spacings of pixdim stood in for it");
    let volume = plain("a.nii", nifti_u8(|header| header.put(123, &[6])));
    told(&volume, "xyzt_units has 6 for space");
}

#[test]
fn an_origin_that_is_none_is_dropped() {
    let file =
        nrrd("uint8", "raw", "space: RAS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (nan,nan,nan)\n");
    let volume = plain("a.nrrd", attached(&file, &DATA));
    assert_eq!(volume.origin, [-1.0, -0.5, -0.5]);
    told(&volume, "is no position");
    // One direction is found across the others.
    let file = nrrd("uint8", "raw", "space: RAS\nspace directions: (2,0,0) (0,3,0) (0,0,0)\n");
    let volume = plain("a.nrrd", attached(&file, &DATA));
    assert_eq!((volume.spacing, volume.axes[2]), ([2.0, 3.0, 1.0], [0.0, 0.0, 1.0]));
    told(&volume, "it was taken to stand across the others");
    // Two are not, unless the user says what is up.
    let file = attached(&nrrd("uint8", "raw", "space: RAS\nspace directions: (2,0,0) (2,0,0) (0,0,4)\n"), &DATA);
    assert!(read("a.nrrd", &file, &OpenOptions::default()).is_err());
    let up = OpenOptions { up: "z".parse().ok(), ..OpenOptions::default() };
    assert_eq!(read("a.nrrd", &file, &up).expect("what is up was given").spacing, [2.0, 2.0, 4.0]);
}

#[test]
fn nan_is_nothing_and_infinities_are_the_ends() {
    let floats = |values: &[f32]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
    let row = [1.0, f32::NAN, 3.0, f32::INFINITY, -2.0, f32::NEG_INFINITY, 0.0, 0.0, 0.0, 0.0, 0.0, f32::NAN];
    let volume = plain("a.nrrd", attached(&nrrd("float", "raw", "endian: little\n"), &floats(&row)));
    assert_eq!(values(&volume), [1.0, -2.0, 3.0, 3.0, -2.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, -2.0]);
    assert_eq!(volume.range, [-2.0, 3.0]);
    told(&volume, "2 of 12 voxels are NaN, which is nothing");
    told(&volume, "2 of 12 voxels are infinite");
    let nothing = attached(&nrrd("float", "raw", "endian: little\n"), &floats(&[f32::NAN; 12]));
    let error = read("a.nrrd", &nothing, &OpenOptions::default()).expect_err("nothing is there");
    assert!(error.to_string().contains("all of the 12 voxels"), "{error}");
}

#[test]
fn marks_blank_lines_and_line_ends_of_editors_are_tolerated() {
    let marked = |text: &[u8]| [b"\xef\xbb\xbf", text].concat();
    for (name, file) in with_spacings("2 3 4") {
        if name == "a.nii" {
            continue;
        }
        assert_eq!(plain(name, marked(&file)).spacing, [2.0, 3.0, 4.0], "{name}");
    }
    let vtk = "# vtk DataFile Version 3.0\r\ntitle\r\n\r\nASCII\r\n\r\nDATASET STRUCTURED_POINTS\r\n\r\nDIMENSIONS 3 2 2\r\n\
               SPACING 2 3 4\r\n\r\nPOINT_DATA 12\r\n\r\nSCALARS s unsigned_char 1\r\nLOOKUP_TABLE default\r\n\
               1 2 3 4 5 6 7 8 9 10 11 12\r\n";
    assert_eq!(plain("a.vtk", vtk).spacing, [2.0, 3.0, 4.0]);
    let header = nrrd("uint8", "raw", "a line that some program wrote\n");
    told(&plain("a.nrrd", attached(&header, &DATA)), "left out: 1 lines of the header");
    let header = metaimage("MET_UCHAR", "a line that some program wrote\n", "LOCAL");
    told(&plain("a.mha", attached(&header, &DATA)), "left out: 1 lines of the header");
    for name in ["a.obj", "a.ply"] {
        let text = if name == "a.obj" { cube() } else { ply("") };
        assert_eq!(mesh(name, marked(text.as_bytes())).triangles.len(), 12, "{name}");
    }
}

#[test]
fn padding_behind_a_stream_is_left_unread() {
    let packed = gzip(&DATA);
    for padding in [&[0_u8; 512][..], b"\x1f and more", b"tail"] {
        let file = attached(&nrrd("uint8", "gzip", ""), &[&packed[..], padding].concat());
        assert_eq!(values(&plain("a.nrrd", file))[11], 12.0);
        let whole = gzip(&nifti_u8(|header| header));
        assert_eq!(plain("a.nii.gz", [&whole[..], padding].concat()).dimensions, [3, 2, 2]);
    }
    // Zeros inside of the stream pad it, too; anything else contradicts the sizes.
    let longer = |last: u8| attached(&nrrd("uint8", "gzip", ""), &gzip(&[&DATA[..], &[0, 0, last]].concat()));
    assert_eq!(values(&plain("a.nrrd", longer(0)))[11], 12.0);
    assert!(read("a.nrrd", &longer(1), &OpenOptions::default()).is_err());
    // The end of a packed file is as far as it goes.
    let file = attached(&nrrd("uint8", "gzip", "byte skip: -1\n"), &gzip(&[&[9; 5], &DATA[..]].concat()));
    assert_eq!(values(&plain("a.nrrd", file))[0], 1.0);
}

#[test]
fn points_in_time_are_one_thing() {
    let at = |name: &str, bytes: &[u8], time: u32| {
        let options = OpenOptions { time: Some(time), ..OpenOptions::default() };
        values(&read(name, bytes, &options).unwrap_or_else(|error| panic!("{error}")))
    };
    let twice: Vec<u8> = DATA.iter().copied().chain(DATA.iter().map(|value| value + 20)).collect();
    let mha = "ObjectType = Image\nNDims = 4\nDimSize = 3 2 2 2\nElementSpacing = 2 3 4 0.5\nTransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n\
               Offset = 0 0 0 0\nElementType = MET_UCHAR\n";
    let nrrd = "NRRD0004\ntype: uint8\ndimension: 4\nspace dimension: 4\nsizes: 3 2 2 2\nencoding: raw\n\
                space directions: (2,0,0,0) (0,3,0,0) (0,0,4,0) (0,0,0,0.5)\nspace origin: (0,0,0,0)\n\n";
    let named = "NRRD0004\ntype: uint8\ndimension: 4\nspace: right-anterior-superior-time\nsizes: 3 2 2 2\nencoding: raw\n\
                 space directions: (2,0,0,0) (0,3,0,0) (0,0,4,0) (0,0,0,0.5)\n\n";
    let files = [
        ("a.mha", attached(&format!("{mha}ElementDataFile = LOCAL\n"), &twice)),
        ("a.mha", attached(&format!("{mha}CompressedData = True\nElementDataFile = LOCAL\n"), &zlib(&twice))),
        ("a.nrrd", attached(nrrd, &twice)),
        ("a.nrrd", attached(named, &twice)),
    ];
    for (name, file) in files {
        let first = plain(name, &file);
        assert_eq!((first.dimensions, first.spacing), ([3, 2, 2], [2.0, 3.0, 4.0]));
        told(&first, "2 points in time");
        assert_eq!((at(name, &file, 0)[11], at(name, &file, 1)[0]), (12.0, 21.0), "{name}");
        let third = OpenOptions { time: Some(2), ..OpenOptions::default() };
        assert!(read(name, &file, &third).is_err());
    }
    for shape in ["(2, 2, 3, 1)", "(1, 2, 2, 3)", "(1, 2, 2, 3, 1)", "(1, 1, 2, 2, 3)"] {
        let dictionary = format!("{{'descr': '|u1', 'fortran_order': False, 'shape': {shape}, }}");
        assert_eq!(plain("a.npy", npy_with((1, 0), &dictionary, &DATA)).dimensions, [3, 2, 2], "{shape}");
    }
}

/// A cube with another line in its header and another face.
fn ply(line: &str) -> String {
    let vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
    let faces = "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n2 0 1\n";
    format!(
        "ply\nformat ascii 1.0\n{line}element vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
         element face 7\nproperty list uchar int vertex_indices\nend_header\n{vertices}{faces}"
    )
}

fn mesh(name: &str, bytes: impl AsRef<[u8]>) -> Mesh {
    open_mesh_bytes(name, bytes.as_ref(), &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn mesh_told(mesh: &Mesh, note: &str) {
    let facts = mesh.source.assumptions.facts();
    assert!(facts.iter().any(|fact| fact.contains(note)), "{note}: {facts:#?}");
}

/// A cube of 8 vertices and 12 triangles.
fn cube() -> String {
    obj(&cuboid([0.0; 3], [1.0; 3]))
}

#[test]
fn what_a_mesh_can_do_without_is_left_out_and_counted() {
    let with = |more: &str| mesh("a.obj", format!("{}{more}", cube()));
    let found = with("f 1\nf 1 2\nf\n");
    assert_eq!(found.triangles.len(), 12);
    mesh_told(&found, "left out: 3 faces of fewer than 3 corners");
    assert_eq!(with("vt 0 0\nf 1/99 2/x 3/7\n").triangles.len(), 13);
    let found = with("vn 0 0 1\nf 1//9 2//-7 3//x\n");
    assert_eq!((found.triangles.len(), found.normals.is_none()), (13, true));
    mesh_told(&found, "left out: 3 normals of corners that name none");
    let found = with("v nan nan nan\nv 1 inf 0\n");
    assert_eq!((found.triangles.len(), found.positions.len()), (12, 8));
    mesh_told(&found, "left out: 2 vertices whose position is not finite");
    let needed =
        open_mesh_bytes("a.obj", format!("{}v nan 0 0\nf 1 2 9\n", cube()).as_bytes(), &OpenOptions::default());
    assert!(needed.expect_err("a face needs it").to_string().contains("not finite"));
    let found = mesh("a.ply", ply("Created by nobody\n"));
    assert_eq!(found.triangles.len(), 12);
    mesh_told(&found, "left out: 1 faces of fewer than 3 corners");
    mesh_told(&found, "left out: 1 lines of the header without a keyword");
}

#[test]
fn names_and_libraries_of_materials_are_no_faults() {
    let folder = Folder::new();
    let open = |name: &str, text: &[u8]| {
        let path = folder.write(name, text);
        vitrum_io::open_mesh(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"))
    };
    folder.write("m.mtl", b"Kd 1 0 0\nnewmtl R\xf6t\nKd 0.5 x\nd 7\nnewmtl b\nKd 0.25 0.5 0.75\n");
    let found =
        open("a.obj", &[cube().as_bytes(), b"mtllib m.mtl\nusemtl R\xf6t\nf 1 2 3\nusemtl b\nf 2 3 4\n"].concat());
    let names: Vec<_> = found.materials.iter().map(|material| material.name.as_str()).collect();
    assert!(names.contains(&"Röt") && names.contains(&"b"), "{names:?}");
    assert!(found.materials.iter().any(|material| material.base_color == Some([0.25, 0.5, 0.75])));
    mesh_told(&found, "stands before the first `newmtl`");
    for library in ["/far/away.mtl", "../a.mtl", "missing.mtl"] {
        let text = format!("{}mtllib {library}\nusemtl a\nf 1 2 3\n", cube());
        mesh_told(&open("b.obj", text.as_bytes()), "its materials have a name alone");
    }
}

#[test]
fn tiff_says_what_its_descriptions_say() {
    let page = |value: u8| Page::bytes(&[value, value + 1, value + 2, value + 3, value + 4, value + 5]);
    let pages = |text: &'static str, count: u8| {
        let first = page(0).set(270, Value::Text(text));
        std::iter::once(first).chain((1..count).map(|index| page(10 * index))).collect::<Vec<_>>()
    };
    let ome = "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"3\" SizeY=\"2\" SizeZ=\"2\" SizeC=\"3\" \
               SizeT=\"1\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.5\" PhysicalSizeZ=\"2500\" PhysicalSizeZUnit=\"nm\">\
               <Channel Name=\"DAPI\"/><Channel Name=\"GFP\"/><Channel/></Pixels></Image></OME>";
    let file = tiff(false, &pages(ome, 6));
    let volume = plain("a.ome.tif", &file);
    assert_eq!((volume.dimensions, volume.spacing), ([3, 2, 2], [0.0005, 0.0005, 0.0025]));
    assert_eq!((volume.value(0, 0, 0), volume.value(0, 0, 1)), (0.0, 10.0));
    told(&volume, "3 channels (`DAPI`, `GFP`)");
    told(&volume, "the spacing was taken from OME-XML");
    for (asked, first) in [("GFP", 20.0), ("3", 40.0)] {
        let options = OpenOptions { array: Some(asked.to_owned()), ..OpenOptions::default() };
        assert_eq!(read("a.ome.tif", &file, &options).expect("a channel").value(0, 0, 0), first, "{asked}");
    }
    // Channels of one slice are no slices.
    let flat = "<OME><Image><Pixels DimensionOrder=\"XYCZT\" SizeC=\"3\" SizeZ=\"1\" SizeT=\"1\"/></Image></OME>";
    assert_eq!(plain("a.ome.tif", tiff(false, &pages(flat, 3))).dimensions, [3, 2, 1]);
    // ImageJ leaves out a distance of 1.
    let resolved =
        |page: Page| page.set(282, Value::Rational(2, 1)).set(283, Value::Rational(2, 1)).set(296, Value::Short(1));
    let imagej = "ImageJ=1.53t\nimages=2\nslices=2\nunit=micron\n";
    let both = [resolved(page(0).set(270, Value::Text(imagej))), resolved(page(10))];
    assert_eq!(plain("a.tif", tiff(false, &both)).spacing, [0.0005, 0.0005, 0.001]);
    // A palette and a white 0 change no value.
    for kind in [0, 3] {
        let pages = [page(0).set(262, Value::Short(kind)), page(10).set(262, Value::Short(kind))];
        let volume = plain("a.tif", tiff(false, &pages));
        assert_eq!((volume.value(2, 1, 0), volume.value(0, 0, 1)), (5.0, 10.0), "{kind}");
        told(&volume, if kind == 0 { "0 is meant to be white" } else { "indices of a palette" });
    }
    // Images behind one page, in either byte order.
    for big in [false, true] {
        let words: Vec<u8> =
            (0..18_u16).flat_map(|word| if big { word.to_be_bytes() } else { word.to_le_bytes() }).collect();
        let page = Page::new(16, 1, &words).set(279, Value::Long(12));
        let page = page.set(270, Value::Text("ImageJ=1.11a\nimages=3\nslices=3\n"));
        let volume = plain("a.tif", tiff(big, &[page]));
        assert_eq!(volume.dimensions, [3, 2, 3]);
        assert_eq!(values(&volume), (0..18_u8).map(f32::from).collect::<Vec<_>>());
    }
    // Signed samples by ImageJ's calibration.
    let calibrated = Page::new(16, 1, &[0, 0, 0, 128, 255, 255, 0, 0, 0, 0, 0, 0]);
    let text = "ImageJ=1.53t\nc0=-32768.0\nc1=1.0\nvunit=Gray Value\n";
    let volume = plain("a.tif", tiff(false, &[calibrated.set(270, Value::Text(text))]));
    assert_eq!(values(&volume)[..3], [-32768.0, 0.0, 32767.0]);
    // Tiles that strips' tags name.
    let tiled = Page::bytes(&[7; 256]).set(322, Value::Long(16)).set(323, Value::Long(16)).without(278);
    assert_eq!(values(&plain("a.tif", tiff(false, &[tiled]))), [7.0; 6]);
}

/// A folder of files.
fn folder(files: &[Vec<u8>]) -> Folder {
    let folder = Folder::new();
    for (index, file) in files.iter().enumerate() {
        folder.write(&format!("slice{index}"), file);
    }
    folder
}

fn opened(path: &Path) -> Volume {
    vitrum_io::open(path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// Three slices, changed one by one.
fn slices(change: impl Fn(usize, &mut Dicom)) -> Vec<Dicom> {
    let slice = |index: usize| {
        let start = 6 * index as u8;
        let mut slice =
            Dicom::slice(2.0 * index as f64, &[start, start + 1, start + 2, start + 3, start + 4, start + 5]);
        change(index, &mut slice);
        slice
    };
    (0..3).map(slice).collect()
}

#[test]
fn the_envelope_of_dicom_decides_nothing() {
    let files: Vec<Vec<u8>> = slices(|_, _| {}).iter().map(Dicom::bytes).collect();
    let expected: Vec<f32> = (0..18_u8).map(f32::from).collect();
    let data_set = |file: &Vec<u8>| {
        // Behind the preamble and the first group, whose length stands in its first element.
        let length = u32::from_le_bytes([file[140], file[141], file[142], file[143]]) as usize;
        file[144 + length..].to_vec()
    };
    let deflated = |file: &Vec<u8>| {
        use std::io::Write;
        let syntax = b"1.2.840.10008.1.2.1.99";
        let mut stream = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::default());
        stream.write_all(&data_set(file)).expect("memory");
        let meta = element((2, 0x10), "UI", syntax);
        let length = element((2, 0), "UL", &(meta.len() as u32).to_le_bytes());
        [vec![0; 128], b"DICM".to_vec(), length, meta, stream.finish().expect("memory")].concat()
    };
    let kinds: [(&str, Vec<Vec<u8>>); 4] = [
        ("no preamble, no first group", files.iter().map(data_set).collect()),
        (
            "no first group",
            files.iter().map(|file| [vec![0; 128], b"DICM".to_vec(), data_set(file)].concat()).collect(),
        ),
        ("no preamble", files.iter().map(|file| file[132..].to_vec()).collect()),
        ("deflated", files.iter().map(deflated).collect()),
    ];
    for (kind, files) in kinds {
        let volume = opened(&folder(&files).path("."));
        assert_eq!((volume.dimensions, values(&volume)), ([3, 2, 3], expected.clone()), "{kind}");
    }
}

#[test]
fn one_broken_file_of_a_folder_is_left_out() {
    let files: Vec<Vec<u8>> = slices(|_, _| {}).iter().map(Dicom::bytes).collect();
    let broken = [vec![0; 128], b"DICM".to_vec(), vec![0xff; 40]].concat();
    let folder = folder(&[files.clone(), vec![broken]].concat());
    for name in [".", "slice1"] {
        let volume = opened(&folder.path(name));
        assert_eq!(volume.dimensions, [3, 2, 3], "{name}");
        told(&volume, "left out: 1 files that cannot be read");
    }
    let alone = Folder::new();
    let path = alone.write("a", [vec![0; 128], b"DICM".to_vec(), vec![0xff; 40]].concat());
    assert!(vitrum_io::open(&path, &OpenOptions::default()).is_err());
    assert!(vitrum_io::open(&alone.path("."), &OpenOptions::default()).is_err());
}

#[test]
fn an_image_twice_and_a_scout_are_left_out() {
    let mut files = slices(|index, slice| {
        slice.text((0x0008, 0x0018), "UI", &format!("1.2.{index}"));
    });
    files.push(files[1].clone());
    let volume = opened(&folder(&files.iter().map(Dicom::bytes).collect::<Vec<_>>()).path("."));
    assert_eq!(volume.dimensions, [3, 2, 3]);
    told(&volume, "left out: 1 files whose image is in another one");
    files.pop();
    let mut scout = Dicom::slice(90.0, &[0; 8]);
    scout.short((0x0028, 0x0010), 2).short((0x0028, 0x0011), 4);
    files.push(scout);
    let volume = opened(&folder(&files.iter().map(Dicom::bytes).collect::<Vec<_>>()).path("."));
    assert_eq!(volume.dimensions, [3, 2, 3]);
    told(&volume, "left out: 1 files of another size or type");
}

#[test]
fn dicom_has_points_in_time() {
    for (tag, vr, name) in [
        ((0x0020, 0x0100), "IS", "temporal positions"),
        ((0x0018, 0x1060), "DS", "trigger times"),
        ((0x0020, 0x0013), "IS", "instance numbers"),
    ] {
        let at = |time: u8| {
            slices(move |index, slice| {
                let number = if vr == "IS" && tag.1 == 0x0013 {
                    u32::from(time) * 3 + index as u32
                } else {
                    u32::from(time) + 1
                };
                slice.text(tag, vr, &number.to_string()).pixels(&[10 * time + index as u8; 6]);
            })
        };
        let files: Vec<Vec<u8>> = at(0).iter().chain(&at(1)).map(Dicom::bytes).collect();
        let folder = folder(&files);
        let volume = opened(&folder.path("."));
        assert_eq!(volume.dimensions, [3, 2, 3]);
        told(&volume, name);
        told(&volume, "2 points in time");
        let second = OpenOptions { time: Some(1), ..OpenOptions::default() };
        let volume = vitrum_io::open(&folder.path("."), &second).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((volume.value(0, 0, 0), volume.value(0, 0, 2)), (10.0, 12.0), "{name}");
    }
}

#[test]
fn frames_of_nuclear_medicine_lie_to_the_side_that_their_spacing_says() {
    for (spacing, first) in [("4", 0.0), ("-4", 12.0)] {
        let mut file = Dicom::slice(0.0, &(0..18).collect::<Vec<u8>>());
        file.text(FRAMES, "IS", "3").text((0x0018, 0x0088), "DS", spacing).remove(POSITION);
        let detector =
            [element(POSITION, "DS", b"10\\20\\30"), element((0x0020, 0x0037), "DS", b"1\\0\\0\\0\\1\\0 ")].concat();
        file.sequence((0x0054, 0x0022), &[detector]);
        let volume = opened(&folder(&[file.bytes()]).path("slice0"));
        assert_eq!((volume.dimensions, volume.spacing[2], volume.orientation.name()), ([3, 2, 3], 4.0, "patient"));
        assert_eq!(volume.value(0, 0, 0), first, "{spacing}");
        assert_eq!(volume.origin[2], if first == 0.0 { 30.0 } else { 22.0 });
    }
}

/// A picture of 3 x 2 pixels in JPEG of 12 bits, all of one value: by ITU-T T.81 that is 2048 + q d / 8, of the difference d, quantized by q.
fn jpeg_of_12_bits(start_of_frame: u8, scan: [u8; 2]) -> Vec<u8> {
    let quantization = [&[255, 219, 0, 67, 0][..], &[8; 64]].concat();
    let frame = [255, start_of_frame, 0, 11, 12, 0, 2, 0, 3, 1, 1, 17, 0];
    // One code each, of one bit: a difference of 10 bits, and the end of the block.
    let table = |class: u8, symbol: u8| [&[255, 196, 0, 20, class, 1][..], &[0; 15], &[symbol]].concat();
    let parts = [&[255, 216][..], &quantization, &frame, &table(0, 10), &table(16, 0)];
    [&parts.concat()[..], &[255, 218, 0, 8, 1, 1, 0, 0, 63, 0], &scan, &[255, 217]].concat()
}

#[test]
fn pictures_of_12_bits_are_decoded() {
    // The bits 0, the difference in ten, 0, and four to fill up: 800, and -800, which is written as 223.
    for (scan, expected) in [([0b0110_0100, 0b0000_1111], 2848.0), ([0b0001_1011, 0b1110_1111], 1248.0)] {
        let mut file = Dicom::words(0.0, &[0; 6], false);
        file.bits(16, 12, 11, false).compressed("1.2.840.10008.1.2.4.51", vec![jpeg_of_12_bits(193, scan)]);
        let volume = opened(&folder(&[file.bytes()]).path("slice0"));
        assert_eq!((volume.dimensions, volume.range), ([3, 2, 1], [expected, expected]));
    }
}

#[test]
fn a_picture_in_arithmetic_code_is_not_called_damaged() {
    let mut file = Dicom::words(0.0, &[0; 6], false);
    let jpeg = jpeg_of_12_bits(201, [0; 2]);
    file.bits(16, 12, 11, false).compressed("1.2.840.10008.1.2.4.51", vec![jpeg]);
    let error = vitrum_io::open(&folder(&[file.bytes()]).path("slice0"), &OpenOptions::default()).expect_err("no code");
    let text = error.to_string();
    assert!(text.contains("arithmetic") && text.contains("gdcmconv --raw") && !text.contains("damaged"), "{text}");
}
