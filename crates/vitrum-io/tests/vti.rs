//! VTK XML image data: every type, byte order and encoding comes back, in its place in the world.

mod common;

use common::vtk::{LITTLE, appended, base64, vti, vti_text, word, zlib_blocks};
use common::{Folder, check, samples, values};
use vitrum_io::{OpenOptions, Setting, Volume, Voxels};

fn open(text: &str) -> Volume {
    Folder::new().open("a.vti", text).unwrap_or_else(|error| panic!("{error}"))
}

/// The sample type's name in VTK.
fn vtk_name(name: &str) -> String {
    match name {
        "float" => "Float32".to_owned(),
        "double" => "Float64".to_owned(),
        _ => name.replace("uint", "UInt").replace("int", "Int"),
    }
}

#[test]
fn every_type_endian_and_encoding_comes_back() {
    let folder = Folder::new();
    for sample in samples() {
        let array = |format: &str| format!("type=\"{}\" format=\"{format}\"", vtk_name(sample.name));
        let text = vti(LITTLE, &array("ascii"), &sample.text, b"");
        check(&folder.open("a.vti", text).unwrap(), &sample);
        for (big, data) in [(false, &sample.little), (true, &sample.big)] {
            for (size, header_type) in [(4, "UInt32"), (8, "UInt64")] {
                let order = if big { "BigEndian" } else { "LittleEndian" };
                let file = format!("byte_order=\"{order}\" header_type=\"{header_type}\"");
                let plain = [word(data.len() as u64, size, big), data.clone()].concat();
                check_encodings(&folder, &sample, &file, &array, &base64(&plain), &plain);
                let file = format!("{file} compressor=\"vtkZLibDataCompressor\"");
                for block in [8, 40, 1 << 15] {
                    let (header, data) = zlib_blocks(data, block, size, big);
                    let characters = base64(&header) + &base64(&data);
                    check_encodings(&folder, &sample, &file, &array, &characters, &[header, data].concat());
                }
            }
        }
    }
}

fn check_encodings(
    folder: &Folder,
    sample: &common::Sample,
    file: &str,
    array: &dyn Fn(&str) -> String,
    characters: &str,
    bytes: &[u8],
) {
    let inline = vti(file, &array("binary"), characters, b"");
    // Something else stands in front of the array, as where there are several.
    let behind = array("appended") + " offset=\"4\"";
    let text = vti(file, &behind, "", &appended("base64", format!("AAAA{characters}").as_bytes()));
    let raw = vti(file, &behind, "", &appended("raw", &[b"<&]>", bytes].concat()));
    for content in [inline, text, raw] {
        check(&folder.open("a.vti", content).unwrap_or_else(|error| panic!("{file} {error}")), sample);
    }
}

#[test]
fn the_header_may_be_padded_by_itself() {
    let characters = base64(&word(12, 4, false)) + "\n  " + &base64(&[7; 12]);
    let file = vti(LITTLE, "type=\"UInt8\" format=\"binary\"", &characters, b"");
    assert_eq!(Folder::new().open("a.vti", file).unwrap().voxels, Voxels::U8(vec![7; 12].into()));
}

#[test]
fn the_grid_lies_where_the_file_says() {
    let volume = open(&vti_text());
    assert_eq!((volume.spacing, volume.origin), ([1.0, 2.0, 3.0], [5.0, 6.0, 7.0]));
    assert_eq!(volume.source.format, "VTK image data");
    assert!(matches!(&volume.source.assumptions[..], [note] if note.fact.contains("no orientation")));
    let shifted = vti_text().replace("0 2 0 1 0 1", "-1 1 10 11 0 1");
    assert_eq!(open(&shifted).origin, [4.0, 26.0, 7.0]);
    // The first row is what x, y and z of the index axes add to the world's x.
    let turned = vti_text().replace("Spacing=", "Direction=\"0 -1 0 1 0 0 0 0 1\" Spacing=");
    let volume = open(&turned);
    assert!(volume.source.assumptions.is_empty(), "{:?}", volume.source.assumptions);
    assert_eq!(volume.axes, [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(volume.spacing, [1.0, 2.0, 3.0]);
    let bare = open(&vti_text().replace(" Origin=\"5 6 7\" Spacing=\"1 2 3\"", ""));
    assert_eq!((bare.spacing, bare.origin), ([1.0; 3], [-1.0, -0.5, -0.5]));
    assert!(bare.source.assumptions.iter().any(|note| note.fact.contains("no spacing")));
}

#[test]
fn values_of_cells_lie_at_their_centres() {
    let cells = vti_text().replace("PointData", "CellData").replace("0 2 0 1 0 1", "0 3 0 2 4 6");
    let volume = open(&cells);
    assert_eq!(volume.dimensions, [3, 2, 2]);
    assert_eq!(volume.origin, [5.5, 7.0, 7.0 + 4.5 * 3.0]);
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("cells")));
}

#[test]
fn the_active_scalars_are_read_of_several_arrays() {
    let other = |attributes: &str| {
        format!(
            "<DataArray type=\"UInt8\" format=\"ascii\" {attributes}>0 0 0 0 0 0 0 0 0 0 0 0</DataArray>\n<DataArray Name=\"density\""
        )
    };
    let vector = "Name=\"velocity\" NumberOfComponents=\"3\"";
    let with = |attributes: &str| vti_text().replace("<DataArray Name=\"density\"", &other(attributes));
    for text in [with("Name=\"mask\""), with(vector), with(vector).replace(" Scalars=\"density\"", "")] {
        let volume = open(&text);
        assert_eq!(values(&volume)[11], 12.0);
        let taken = &volume.source.assumptions[0];
        assert_eq!((taken.fact.as_str(), taken.setting), ("the array `density` was taken", Some(Setting::Array)));
        assert!(taken.choices.starts_with('`'), "{taken}");
    }
    let missing = open(&with("Name=\"mask\"").replace("Scalars=\"density\"", "Scalars=\"none\""));
    assert_eq!(values(&missing), [0.0; 12]);
    assert!(missing.source.assumptions[0].fact.contains("the active scalars `none` are not there"));
}

#[test]
fn an_array_is_picked_by_its_name() {
    let mask = "<DataArray type=\"UInt8\" format=\"ascii\" Name=\"mask\">0 0 0 0 0 0 0 0 0 0 0 9</DataArray>\n<DataArray Name=\"density\"";
    let folder = Folder::new();
    let path = folder.write("a.vti", vti_text().replace("<DataArray Name=\"density\"", mask));
    let open =
        |array: &str| vitrum_io::open(&path, &OpenOptions { array: Some(array.to_owned()), ..OpenOptions::default() });
    assert_eq!(values(&open("mask").unwrap())[11], 9.0);
    assert_eq!(values(&open("density").unwrap())[11], 12.0);
    assert!(open("mas").unwrap_err().to_string().contains("there is no array `mas`; did you mean `mask`?"));
    assert!(open("other").unwrap_err().to_string().contains("the arrays are: `mask`, `density`"));
}

#[test]
fn data_may_follow_information_about_it() {
    let key = "format=\"ascii\">\n<InformationKey name=\"RANGE\" length=\"1\">\n<Value index=\"0\">\n255\n</Value>\n</InformationKey>";
    let text = vti_text().replace("format=\"ascii\">", key);
    assert_eq!(values(&open(&text))[..3], [1.0, 2.0, 3.0]);
    let field =
        "<FieldData><DataArray type=\"Float64\" Name=\"TIME\" format=\"ascii\">1</DataArray></FieldData>\n<Piece";
    assert_eq!(values(&open(&vti_text().replace("<Piece", field)))[11], 12.0);
}
