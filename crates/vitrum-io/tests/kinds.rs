//! Faults that decide neither voxels nor positions nor connectivity, of every format: a file each, the option of its user, and what is told.

mod common;

use common::dicom::{Dicom, element};
use common::mesh::{cuboid, files, obj, stl_ascii, stl_binary};
use common::tiff::{Page, Value, tiff};
use common::{Folder, attached, gzip, metaimage, nifti_u8, npy_with, nrrd, values};
use vitrum_io::{OpenOptions, open_bytes, open_mesh_bytes};

const DATA: [u8; 12] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];

/// A fault: what it is, the file's name and bytes, an option, and a part of what is told; empty where nothing has to be.
struct Fault(&'static str, &'static str, Vec<u8>, Asked, &'static str);

#[derive(Clone, Copy)]
enum Asked {
    Nothing,
    Spacing,
    Up,
}

use Asked::{Nothing, Spacing, Up};

impl Asked {
    fn options(self) -> OpenOptions {
        match self {
            Nothing => OpenOptions::default(),
            Spacing => OpenOptions { spacing: Some([2.0, 3.0, 4.0]), ..OpenOptions::default() },
            Up => OpenOptions { up: "z".parse().ok(), ..OpenOptions::default() },
        }
    }
}

fn with_nrrd(lines: &str) -> Vec<u8> {
    attached(&nrrd("uint8", "raw", lines), &DATA)
}

fn with_mha(lines: &str) -> Vec<u8> {
    attached(&metaimage("MET_UCHAR", lines, "LOCAL"), &DATA)
}

/// A header whose letters beyond ASCII are Latin-1.
fn latin(text: &str, data: &[u8]) -> Vec<u8> {
    [&text.chars().map(|letter| letter as u8).collect::<Vec<_>>()[..], data].concat()
}

const NUMBERS: &str = "1 2 3 4 5 6 7 8 9 10 11 12";

fn with_vtk(grid: &str, behind: &str) -> String {
    format!(
        "# vtk DataFile Version 3.0\nmade at K\u{f6}ln\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\n{grid}POINT_DATA 12\n\
         SCALARS s unsigned_char\nLOOKUP_TABLE default\n{NUMBERS}\n{behind}"
    )
}

fn with_vti(image: &str, array: &str, more: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!-- K\u{f6}ln -->\n<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\">\n\
         <ImageData WholeExtent=\"0 2 0 1 0 1\" {image}>\n<Piece Extent=\"0 2 0 1 0 1\">\n<PointData Scalars=\"s\">\n\
         <DataArray type=\"UInt8\" Name=\"s\" format=\"ascii\" {array}>{NUMBERS}</DataArray>\n{more}</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n"
    )
}

fn with_npy(dictionary: &str) -> Vec<u8> {
    npy_with((1, 0), dictionary, &DATA)
}

/// Two pages, the first with another tag.
fn with_tiff(tag: u16, value: Value, behind: &[u8]) -> Vec<u8> {
    let pages = [Page::bytes(&DATA[..6]).set(tag, value), Page::bytes(&DATA[6..])];
    [&tiff(false, &pages)[..], behind].concat()
}

fn carriage_returns(text: &str) -> String {
    text.replace('\n', "\r\n")
}

#[test]
fn volumes_are_read_whatever_is_wrong_beside_their_voxels() {
    let vtk_end = "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\nFIELD f 1\nbroken 1 12 unsigned_char\n1 2\n";
    #[rustfmt::skip]
    let faults = vec![
        Fault("a name in Latin-1", "a.nrrd", latin(&nrrd("uint8", "raw", "content: K\u{f6}ln\nby:=J\u{fc}rgen\n"), &DATA), Nothing, ""),
        Fault("CR LF throughout", "a.nrrd", attached(&carriage_returns(&nrrd("uint8", "raw", "spacings: 1 2 3\n")), &DATA), Nothing, ""),
        Fault("blanks behind words", "a.nrrd", attached("NRRD0004 \ntype: uint8 \ndimension: 3 \nsizes: 3  2 2\t\nencoding:  raw \n\n", &DATA), Nothing, ""),
        Fault("capitals", "a.nrrd", attached("NRRD0004\nType: UINT8\nDimension: 3\nSizes: 3 2 2\nEncoding: RAW\n\n", &DATA), Nothing, ""),
        Fault("spacings that are replaced", "a.nrrd", with_nrrd("spacings: 1 x\n"), Spacing, ""),
        Fault("kinds of two axes", "a.nrrd", with_nrrd("kinds: domain domain\n"), Nothing, ""),
        Fault("a range that is no number", "a.nrrd", with_nrrd("min: about 0\nold max: many\n"), Nothing, ""),
        Fault("directions that are replaced", "a.nrrd", with_nrrd("space: RAS\nspace directions: (1,0,0) (1,0,0) (0,0,1)\n"), Up, ""),
        Fault("a tail", "a.nrrd", with_nrrd("").into_iter().chain(*b"\r\n\0\0").collect(), Nothing, "4 bytes behind the last voxel"),
        Fault("a byte order of bytes", "a.nrrd", with_nrrd("endian: middle\n"), Nothing, ""),

        Fault("a comment in Latin-1", "a.mha", latin(&metaimage("MET_UCHAR", "Comment = K\u{f6}ln\nName = \u{e9}\n", "LOCAL"), &DATA), Nothing, ""),
        Fault("CR LF throughout", "a.mha", attached(&carriage_returns(&metaimage("MET_UCHAR", "", "LOCAL")), &DATA), Nothing, ""),
        Fault("spacings that are replaced", "a.mha", with_mha("ElementSpacing = 1 1\n"), Spacing, ""),
        Fault("sizes of voxels for bad spacings", "a.mha", with_mha("ElementSpacing = a b c\nElementSize = 1 2 3\n"), Nothing, "`ElementSize`"),
        Fault("an offset that is none", "a.mha", with_mha("Offset = nan nan nan\n"), Nothing, "is no position"),
        Fault("a matrix that is replaced", "a.mha", with_mha("TransformMatrix = 1 0 0 0 1 0 0 0 0\n"), Up, ""),
        Fault("ends that are no numbers", "a.mha", with_mha("ElementMin = low\nElementMax =\nCompressedDataSize = x\n"), Nothing, ""),
        Fault("no blanks around =", "a.mha", attached("ObjectType=Image\nNDims=3\nDimSize=3 2 2\nElementType=MET_UCHAR\nElementDataFile=LOCAL\n", &DATA), Nothing, ""),

        Fault("a quaternion of NaN", "a.nii", data_of(nifti_u8(|header| header.i16(252, 1).f32(256, f32::NAN))), Nothing, "is no rotation"),
        Fault("an origin of NaN", "a.nii", data_of(nifti_u8(|header| header.i16(252, 1).f32(268, f32::NAN))), Nothing, "is no position"),
        Fault("spacings beside a sform", "a.nii", data_of(nifti_u8(|header| header.f32(80, f32::NAN).i16(254, 1).f32(280, 1.0).f32(300, 2.0).f32(320, 3.0))), Nothing, ""),
        Fault("words in no encoding", "a.nii", data_of(nifti_u8(|header| header.put(148, b"K\xf6ln\xff\xfe").put(228, &[0xff; 8]))), Nothing, ""),
        Fault("no time along a fourth axis", "a.nii", data_of(nifti_u8(|header| header.i16(40, 4).i16(48, 0))), Nothing, ""),
        Fault("a tail behind the packed file", "a.nii.gz", [gzip(&data_of(nifti_u8(|header| header))), b"tail".to_vec()].concat(), Nothing, ""),
        Fault("a range that is none", "a.nii", data_of(nifti_u8(|header| header.f32(124, f32::NAN).f32(128, f32::INFINITY))), Nothing, ""),

        Fault("another order, other quotes, other keys", "a.npy", with_npy("{\"shape\":(2,2,3),\"fortran_order\":False,\"descr\":\"|u1\",\"by\":\"K\u{f6}ln\"}"), Nothing, ""),
        Fault("a byte order of bytes", "a.npy", with_npy("{'descr': '<u1', 'fortran_order': False, 'shape': (2, 2, 3)}"), Nothing, ""),
        Fault("the machine's order", "a.npy", with_npy("{'descr': '=u1', 'fortran_order': False, 'shape': (2, 2, 3)}"), Nothing, ""),

        Fault("letters in Latin-1", "a.vti", latin(&with_vti("Spacing=\"1 2 3\"", "", ""), &[]), Nothing, ""),
        Fault("CR LF and a tail", "a.vti", format!("{}\r\n\r\n", carriage_returns(&with_vti("Spacing=\"1 2 3\"", "", ""))).into_bytes(), Nothing, ""),
        Fault("spacings that are replaced", "a.vti", with_vti("Spacing=\"1 2\"", "", "").into_bytes(), Spacing, ""),
        Fault("a range of no numbers", "a.vti", with_vti("", "RangeMin=\"nan\" RangeMax=\"-\"", "").into_bytes(), Nothing, ""),
        Fault("another array that is broken", "a.vti", with_vti("", "", "<DataArray type=\"Float9\" Name=\"b\" format=\"ascii\">x</DataArray>\n").into_bytes(), Nothing, ""),
        Fault("an origin that is none", "a.vti", with_vti("Origin=\"nan 0 0\"", "", "").into_bytes(), Nothing, "is no position"),

        Fault("a title in Latin-1", "a.vtk", latin(&with_vtk("", ""), &[]), Nothing, ""),
        Fault("spacings that are replaced", "a.vtk", with_vtk("SPACING 1 1\n", "").into_bytes(), Spacing, ""),
        Fault("a broken array behind", "a.vtk", with_vtk("", vtk_end).into_bytes(), Nothing, ""),
        Fault("CR LF and blank lines", "a.vtk", carriage_returns(&with_vtk("\n\nSPACING 1 2 3\n\n", "\n\n")).into_bytes(), Nothing, ""),
        Fault("an origin that is none", "a.vtk", with_vtk("ORIGIN nan 0 0\n", "").into_bytes(), Nothing, "is no position"),

        Fault("a spacing that is no number", "a.tif", with_tiff(270, Value::Text("ImageJ=1.5\nspacing=wide\nimages=2\n"), &[]), Nothing, ""),
        Fault("a count of images that is none", "a.tif", with_tiff(270, Value::Text("ImageJ=1.5\r\nimages=9\r\nslices=9\r\n"), &[]), Nothing, ""),
        Fault("OME-XML that ends early", "a.tif", with_tiff(270, Value::Text("<?xml version=\"1.0\"?><OME><Image><Pixels SizeZ=\"2\""), &[]), Nothing, ""),
        Fault("a resolution of nothing", "a.tif", with_tiff(282, Value::Rational(0, 0), &[]), Nothing, ""),
        Fault("an unknown unit, and a tail", "a.tif", with_tiff(296, Value::Short(77), &[0; 64]), Nothing, ""),
    ];
    let mut wrong = String::new();
    for Fault(what, name, bytes, asked, told) in faults {
        match open_bytes(name, &bytes, &asked.options()) {
            Ok(volume) => {
                let facts = volume.source.assumptions.facts().join("; ");
                let expected: Vec<f32> = DATA.iter().map(|&value| f32::from(value)).collect();
                if volume.dimensions != [3, 2, 2] || values(&volume) != expected || !facts.contains(told) {
                    wrong += &format!("{name}, {what}: {:?}, {facts}\n", values(&volume));
                }
                if matches!(asked, Spacing) && volume.spacing != [2.0, 3.0, 4.0] {
                    wrong += &format!("{name}, {what}: {:?}\n", volume.spacing);
                }
            }
            Err(error) => wrong += &format!("{name}, {what}: {error}\n"),
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// A NIfTI file of 12 bytes with the samples of [`DATA`].
fn data_of(mut file: Vec<u8>) -> Vec<u8> {
    let start = file.len() - 12;
    file[start..].copy_from_slice(&DATA);
    file
}

#[test]
fn what_decides_still_fails() {
    for (what, name, bytes, words) in [
        ("spacings of words", "a.nrrd", with_nrrd("spacings: 1 x 2\n"), "`1 x 2` is not 3 numbers"),
        ("spacings of two axes", "a.mha", with_mha("ElementSpacing = 1 1\n"), "is not 3 numbers"),
        ("a matrix of eight", "a.mha", with_mha("TransformMatrix = 1 0 0 0 1 0 0 0\n"), "is not 9 numbers"),
        ("spacings of two axes", "a.vtk", with_vtk("SPACING 1 1\n", "").into_bytes(), "SPACING"),
        ("spacings of two axes", "a.vti", with_vti("Spacing=\"1 2\"", "", "").into_bytes(), "Spacing"),
        ("an infinite slope", "a.nii", data_of(nifti_u8(|header| header.f32(112, f32::INFINITY))), "scl_slope is inf"),
        (
            "words of no order",
            "a.npy",
            with_npy("{'descr': '|u2', 'fortran_order': False, 'shape': (1, 2, 3)}"),
            "no byte order",
        ),
    ] {
        match open_bytes(name, &bytes, &OpenOptions::default()) {
            Err(error) => assert!(error.to_string().contains(words), "{name}, {what}: {error}"),
            Ok(volume) => panic!("{name}, {what}: {:?}", volume.source.assumptions.facts()),
        }
    }
}

#[test]
fn slices_of_dicom_are_read_whatever_is_wrong_beside_their_pixels() {
    type Change = fn(usize, &mut Dicom);
    #[rustfmt::skip]
    let changes: [(&str, Change, Asked, &str); 8] = [
        ("names in Latin-1", |_, slice| { slice.text((0x0010, 0x0010), "PN", "K\u{f6}ln^J\u{fc}rgen").remove((0x0008, 0x0005)); }, Nothing, ""),
        ("a thickness that is none", |_, slice| { slice.text((0x0018, 0x0050), "DS", "thin"); }, Nothing, ""),
        ("a window of words", |_, slice| { slice.text((0x0028, 0x1050), "DS", "soft").text((0x0028, 0x1051), "DS", "wide"); }, Nothing, ""),
        ("numbers that are none", |_, slice| { slice.text((0x0020, 0x0013), "IS", "first"); }, Nothing, ""),
        ("times that are none", |_, slice| { slice.text((0x0008, 0x0032), "TM", "noon").text((0x0018, 0x1060), "DS", "-"); }, Nothing, ""),
        ("distances of pixels that are replaced", |_, slice| { slice.text((0x0028, 0x0030), "DS", "0\\0"); }, Spacing, ""),
        ("distances of pixels that are none", |_, slice| { slice.text((0x0028, 0x0030), "DS", "0\\0"); }, Nothing, "no distance of pixels"),
        ("a slope of nothing beside no intercept", |_, slice| { slice.text((0x0028, 0x1054), "LO", "US"); }, Nothing, ""),
    ];
    let mut wrong = String::new();
    for (what, change, asked, told) in changes {
        let folder = Folder::new();
        for index in 0..3_usize {
            let start = 6 * index as u8;
            let mut slice = Dicom::slice(2.0 * index as f64, &[0, 1, 2, 3, 4, 5].map(|value| value + start));
            change(index, &mut slice);
            let padded = [slice.bytes(), element((0xfffc, 0xfffc), "OB", &[0; 64])].concat();
            folder.write(&format!("slice{index}"), padded);
        }
        match vitrum_io::open(&folder.path("."), &asked.options()) {
            Ok(volume) => {
                let expected: Vec<f32> = (0..18_u8).map(f32::from).collect();
                let facts = volume.source.assumptions.facts().join("; ");
                if values(&volume) != expected || !facts.contains(told) {
                    wrong += &format!("{what}: {:?}: {facts}\n", values(&volume));
                }
            }
            Err(error) => wrong += &format!("{what}: {error}\n"),
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The pieces of a collection: two points in time, the first of [`DATA`].
fn collection(timesteps: &[(&str, &str)]) -> String {
    let sets =
        timesteps.iter().map(|(time, file)| format!("<DataSet timestep=\"{time}\" part=\"0\" file=\"{file}\"/>\n"));
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n<Collection>\n{}</Collection>\n</VTKFile>\n",
        sets.collect::<String>()
    )
}

#[test]
fn collections_are_read_as_far_as_their_files_are_there() {
    let folder = Folder::new();
    folder.write("a.vti", with_vti("Spacing=\"1 2 3\"", "", ""));
    folder.write("b.vti", with_vti("Spacing=\"1 2 3\"", "", "").replace(NUMBERS, "2 2 3 4 5 6 7 8 9 10 11 12"));
    let whole = collection(&[("0", "a.vti"), ("0.5", "b.vti")]);
    for (what, text) in [
        ("CR LF", carriage_returns(&whole)),
        ("a byte-order mark", format!("\u{feff}{whole}")),
        ("a later file that is missing", collection(&[("0", "a.vti"), ("0.5", "gone.vti")])),
        ("moments that are no numbers", collection(&[("first", "a.vti"), ("second", "b.vti")])),
        ("no moments", whole.replace("timestep=\"0\" ", "").replace("timestep=\"0.5\" ", "")),
        ("blank lines at the end", format!("{whole}\n\n  \n")),
    ] {
        let path = folder.write("c.pvd", text);
        let volume = vitrum_io::open(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_eq!(values(&volume)[0], 1.0, "{what}");
    }
}

#[test]
fn meshes_are_read_whatever_is_wrong_beside_their_triangles() {
    let shape = cuboid([0.0; 3], [1.0; 3]);
    let text = obj(&shape);
    let ascii = stl_ascii(&shape);
    let of = |wanted: &str| {
        let all = files(&shape);
        all.into_iter().find(|(name, _)| *name == wanted).map(|(_, bytes)| bytes).expect("a format")
    };
    let ply = |line: &str| String::from_utf8(of("ascii.ply")).expect("text").replacen("comment of a test\n", line, 1);
    let gltf = |from: &str, to: &str| {
        let text = String::from_utf8(of("a.gltf")).expect("text");
        assert!(text.contains(from), "{text}");
        text.replacen(from, to, 1).into_bytes()
    };
    let mut normals = stl_binary(b"solid by a name that texts begin with", &shape);
    normals[84..96].fill(0xff);
    #[rustfmt::skip]
    let faults: Vec<(&str, &str, Vec<u8>)> = vec![
        ("statements that are no mesh's", "a.obj", format!("{text}l 1 2\np 1\ncurv 0 1 1 2\ns off\nvp 0.1\nmg 1 x\nshadow_obj a\n").into_bytes()),
        ("a line that goes on, and CR LF", "a.obj", carriage_returns(&text.replacen("v 0 0 0", "v 0 \\\n0 0", 1)).into_bytes()),
        ("coordinates that are too few", "a.obj", format!("{text}vt\nvn 0 0\nvt x y\n").into_bytes()),
        ("colours that are none", "a.obj", text.replacen("v 0 0 0", "v 0 0 0 red green blue", 1).into_bytes()),
        ("a comment in Latin-1", "a.obj", latin(&text.replacen("# a shape", "# K\u{f6}ln", 1), &[])),
        ("tabs and blanks", "a.obj", text.replace("v ", "  v\t").replace("f ", "\tf   ").into_bytes()),
        ("CR LF", "a.ply", carriage_returns(&ply("obj_info x\n")).into_bytes()),
        ("a comment in Latin-1", "a.ply", latin(&ply("comment K\u{f6}ln\n"), &[])),
        ("blank lines", "a.ply", ply("\n\n").replace("end_header\n", "end_header\n\n").into_bytes()),
        ("an element behind the faces, of an unknown type", "b.ply", unknown_behind(&of("little.ply"))),
        ("a tail", "b.ply", [of("big.ply"), vec![0; 100]].concat()),
        ("capitals, CR LF, blank lines, a tail", "a.stl", format!("\r\n{}\r\n\r\n\0\0", carriage_returns(&ascii.to_uppercase())).into_bytes()),
        ("normals of NaN", "a.stl", ascii.replacen("normal 0 0 0", "normal nan nan nan", 1).into_bytes()),
        ("a name in Latin-1", "a.stl", latin(&ascii.replacen("solid ", "solid K\u{f6}ln ", 1), &[])),
        ("a header like a text's, and a normal of NaN", "b.stl", normals.clone()),
        ("a tail", "b.stl", [&normals[..], &[1; 77]].concat()),
        ("a byte-order mark and CR LF", "a.gltf", [&b"\xef\xbb\xbf"[..], &of("a.gltf"), b"\r\n\r\n"].concat()),
        ("an unknown extension that is used", "a.gltf", gltf("{", "{\"extensionsUsed\":[\"EXT_unknown\"],\"extras\":{\"a\":[1]},")),
        ("a picture that is missing", "a.gltf", gltf("{", "{\"images\":[{\"uri\":\"../gone.png\"}],\"textures\":[{\"source\":7}],")),
        ("a camera and a light that are none", "a.gltf", gltf("{", "{\"cameras\":[{\"type\":\"odd\"}],\"animations\":[{\"channels\":[],\"samplers\":[]}],")),
        ("a tail", "a.glb", [of("a.glb"), vec![0; 64]].concat()),
    ];
    let mut wrong = String::new();
    for (what, name, bytes) in faults {
        match open_mesh_bytes(name, &bytes, &OpenOptions::default()) {
            Ok(mesh) if mesh.triangles.len() == 12 && mesh.topology().is_closed() => {}
            Ok(mesh) => wrong += &format!("{name}, {what}: {} triangles\n", mesh.triangles.len()),
            Err(error) => wrong += &format!("{name}, {what}: {error}\n"),
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// A binary file with an element behind the faces whose numbers have an unknown size.
fn unknown_behind(file: &[u8]) -> Vec<u8> {
    let end = b"end_header\n";
    let at = file.windows(end.len()).position(|window| window == end).expect("a header");
    [&file[..at], b"element mark 1\nproperty half weight\n", &file[at..], &[0, 60]].concat()
}
