//! Legacy VTK structured points: every type comes back, as text and as bytes, in its place.

mod common;

use common::vtk::vtk;
use common::{Folder, check, samples, values};
use vitrum_io::{OpenOptions, Setting, Volume, Voxels};

fn open(content: impl AsRef<[u8]>) -> Volume {
    Folder::new().open("a.vtk", content).unwrap_or_else(|error| panic!("{error}"))
}

fn text() -> String {
    String::from_utf8(vtk("ASCII", "unsigned_char", b"1 2 3 4 5 6\n7 8 9 10 11 12\n")).unwrap()
}

/// The sample type's name in VTK.
fn vtk_name(name: &str) -> &str {
    match name {
        "int8" => "char",
        "uint8" => "unsigned_char",
        "int16" => "short",
        "uint16" => "unsigned_short",
        "int32" => "int",
        "uint32" => "unsigned_int",
        "int64" => "vtktypeint64",
        "uint64" => "unsigned_long",
        other => other,
    }
}

#[test]
fn every_type_comes_back_as_text_and_bytes() {
    for sample in samples() {
        check(&open(vtk("ASCII", vtk_name(sample.name), sample.text.as_bytes())), &sample);
        check(&open(vtk("BINARY", vtk_name(sample.name), &sample.big)), &sample);
        let windows = String::from_utf8(vtk("BINARY", vtk_name(sample.name), b"")).unwrap().replace('\n', "\r\n");
        check(&open([windows.as_bytes(), &sample.big].concat()), &sample);
    }
}

#[test]
fn the_grid_lies_where_the_file_says() {
    let volume = open(text());
    assert_eq!((volume.spacing, volume.origin), ([1.0, 2.0, 3.0], [5.0, 6.0, 7.0]));
    assert_eq!(volume.source.format, "legacy VTK");
    assert!(matches!(&volume.source.assumptions[..], [note] if note.fact.contains("no orientation")));
    let old = open(text().replace("SPACING", "ASPECT_RATIO").to_lowercase());
    assert_eq!(old, Volume { name: old.name.clone(), source: old.source.clone(), ..volume });
    let bare = open(text().replace("SPACING 1 2 3\n", "").replace("ORIGIN 5 6 7\n", "\n"));
    assert_eq!((bare.spacing, bare.origin), ([1.0; 3], [-1.0, -0.5, -0.5]));
    assert!(bare.source.assumptions[0].fact.contains("no spacing"));
}

#[test]
fn values_of_cells_lie_at_their_centres() {
    let volume = open(text().replace("POINT_DATA", "CELL_DATA").replace("3 2 2", "4 3 3"));
    assert_eq!((volume.dimensions, volume.origin), ([3, 2, 2], [5.5, 7.0, 8.5]));
    assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("cells")));
}

#[test]
fn more_fields_may_surround_the_scalars() {
    let before = text().replace("POINT_DATA", "METADATA\nINFORMATION 0\n\nPOINT_DATA");
    assert_eq!(values(&open(before))[11], 12.0);
    let behind = open(text() + "METADATA\nINFORMATION 0\n\n");
    assert_eq!(values(&behind)[11], 12.0);
    let bytes = open(vtk("BINARY", "unsigned_char", &[&[7; 12][..], b"\nVECTORS v float\n"].concat()));
    assert_eq!(bytes.voxels, Voxels::U8(vec![7; 12].into()));
    assert!(bytes.source.assumptions.iter().any(|note| note.setting == Some(Setting::Array) && note.choices == "`v`"));
    let components = text().replace("unsigned_char\n", "unsigned_char 1\n");
    assert_eq!(values(&open(components))[11], 12.0);
}

/// Scalars, more scalars, vectors and an array of a field.
fn several(binary: bool) -> Vec<u8> {
    let data = |values: Vec<u8>| match binary {
        true => [&values[..], b"\n"].concat(),
        false => (values.iter().map(|value| format!("{value} ")).collect::<String>() + "\n").into_bytes(),
    };
    let ones = |value: u8, count: usize| data(vec![value; count]);
    [
        &vtk(if binary { "BINARY" } else { "ASCII" }, "unsigned_char", &ones(1, 12))[..],
        b"SCALARS other%20name char 1\nLOOKUP_TABLE default\n",
        &ones(2, 12),
        b"VECTORS flow unsigned_char\n",
        &ones(3, 36),
        b"FIELD FieldData 2\npair 2 12 unsigned_char\n",
        &ones(4, 24),
        b"\nlast 1 12 unsigned_char\n",
        &ones(5, 12),
    ]
    .concat()
}

#[test]
fn an_array_is_picked_by_its_name() {
    let folder = Folder::new();
    for binary in [false, true] {
        let path = folder.write("a.vtk", several(binary));
        let open = |array: Option<&str>| {
            vitrum_io::open(&path, &OpenOptions { array: array.map(str::to_owned), ..OpenOptions::default() })
        };
        for (array, value) in [(None, 1.0), (Some("density"), 1.0), (Some("other name"), 2.0), (Some("last"), 5.0)] {
            assert_eq!(values(&open(array).unwrap()), [value; 12], "{array:?}, binary {binary}");
        }
        let volume = open(None).unwrap();
        let taken = volume.source.assumptions.iter().find(|note| note.setting == Some(Setting::Array)).unwrap();
        let note = "the array `density` was taken; others are: `other name`, `flow`, `pair`, `last`";
        assert_eq!(taken.to_string(), note);
        let error = |array| open(Some(array)).unwrap_err().to_string();
        assert_eq!(open(Some("desity")).unwrap_err().setting(), Some(Setting::Array));
        assert!(error("desity").contains("there is no array `desity`; did you mean `density`?"));
        assert!(error("zzz").contains("the arrays are: `density`, `other name`"), "{}", error("zzz"));
        assert!((values(&open(Some("flow")).unwrap())[0] - 3.0).abs() < 1e-6);
    }
    let field = "FIELD FieldData 1\nonly 1 12 float\n0 1 2 3 4 5 6 7 8 9 10 11\n";
    let volume = open(text().split("SCALARS").next().unwrap_or_default().to_owned() + field);
    assert_eq!(values(&volume)[11], 11.0);
}
