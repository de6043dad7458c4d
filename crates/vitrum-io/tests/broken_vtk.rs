//! VTK files with one thing wrong each, and the part of the message that says so.

mod common;

use common::check_refused;
use common::vtk::{LITTLE, appended, base64, vti, vti_text, vtk, word, zlib_blocks};

/// A valid file with one replacement.
fn changed(from: &str, to: &str) -> Vec<u8> {
    let text = vti_text();
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1).into_bytes()
}

/// A uint8 file with base64 data.
fn binary(characters: &str) -> Vec<u8> {
    vti(LITTLE, "type=\"UInt8\" format=\"binary\"", characters, b"")
}

/// A uint8 file with raw data behind it.
fn raw(array: &str, encoding: &str, data: &[u8]) -> Vec<u8> {
    vti(LITTLE, &format!("type=\"UInt8\" format=\"appended\" {array}"), "", &appended(encoding, data))
}

/// A uint8 file with blocks, and a header before them.
fn blocks(header: &[u64], data: &[u8]) -> Vec<u8> {
    let header: Vec<u8> = header.iter().flat_map(|&number| word(number, 4, false)).collect();
    let compressor = format!("{LITTLE} compressor=\"vtkZLibDataCompressor\"");
    let tail = appended("raw", &[&header, data].concat());
    vti(&compressor, "type=\"UInt8\" format=\"appended\" offset=\"0\"", "", &tail)
}

#[test]
fn broken_documents() {
    let deep = "<a>".repeat(40);
    let bomb = "<!DOCTYPE x [<!ENTITY a \"aaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n<VTKFile";
    let long = format!("<!-- {} -->\n<Piece", "x".repeat(5 << 20));
    let second = "</Piece>\n<Piece Extent=\"0 2 0 1 0 1\"/>";
    check_refused(
        "broken.vti",
        vec![
            (b"".to_vec(), "line 1: the document has no element"),
            (b"<VTKFile".to_vec(), "line 1: this is not well-formed XML"),
            (b"<svg/>".to_vec(), "line 1: the outermost element is `svg`, not `VTKFile`"),
            (changed("type=\"ImageData\"", "type=\"PolyData\""), "line 2: the file holds `PolyData`, and only"),
            (changed("type=\"ImageData\"", ""), "line 2: the file holds ``"),
            (changed("<VTKFile", bomb), "line 2: document types and entities are not read"),
            (changed("<Piece", "&bomb;<Piece"), "line 4: document types and entities are not read"),
            (changed("Name=\"density\"", "Name=\"&bomb;\""), "line 6: an attribute is not well-formed"),
            (changed("Name=\"density\"", "Name=density"), "line 6: an attribute is not well-formed"),
            (changed("</PointData>", "</CellData>"), "line 10: this is not well-formed XML"),
            (changed("<Piece", &deep), "line 4: elements lie more than 32 deep"),
            (changed("<Piece", &long), "the markup goes on beyond 4194304 bytes"),
            (changed("</Piece>", second), "line 12: this is a second `Piece` after that in line 4"),
            (changed("<ImageData", "<Other"), "this is not well-formed XML"),
            (vti_text().replace("ImageData W", "Grid W").replace("/ImageData", "/Grid").into(), "no `ImageData` in it"),
            (vti_text().replace("Piece", "Part").into_bytes(), "line 2: there is no `Piece` in it"),
            (changed("<Piece Extent=\"0 2", "<Piece Extent=\"0 1"), "line 4: the piece has the extent `0 1 0 1 0 1`"),
            (
                vti_text().split("</Piece>").next().unwrap_or_default().into(),
                "line 11: the file ends inside of `Piece`",
            ),
        ],
    );
}

#[test]
fn broken_images() {
    let extent = |to: &str| vti_text().replace("0 2 0 1 0 1", to).into_bytes();
    check_refused(
        "broken.vti",
        vec![
            (extent("0 2 0 1"), "line 3: `WholeExtent` of `ImageData` is `0 2 0 1`, not 6 whole numbers in range"),
            (extent("0 2 0 1 1 0"), "line 3: `WholeExtent` from 1 to 0 along an axis has no voxels"),
            (extent("0 2 0 1 0 99999999999"), "not 6 whole numbers in range"),
            (extent("0 2 0 1 -2147483648 2147483647"), "has no voxels"),
            (extent("0 2000000000 0 2000000000 0 2000000000"), "more than any file holds"),
            (extent("0 2 0 1 0 2"), "the header promises 18 numbers"),
            (extent("0 999 0 999 0 999"), "promises 1000000000 numbers from here, and"),
            (extent("0 2 0 1 0 0"), "`7` follows the 6 numbers that the header promises"),
            (changed("\"1 2 3\"", "\"1 2\""), "line 3: `Spacing` of `ImageData` is `1 2`, not 3 numbers"),
            (changed("LittleEndian", "Middle"), "line 2: `byte_order` is `Middle`, neither"),
            (changed(LITTLE, "header_type=\"UInt16\""), "line 2: `header_type` is `UInt16`, neither"),
            (changed("UInt8", "String"), "line 6: the type `String` is not a number's"),
            (changed("ascii", "hex"), "line 6: the format `hex` is none of ascii, binary, appended"),
            (
                changed("Name=\"density\"", "Name=\"density\" NumberOfComponents=\"3\""),
                "the header promises 36 numbers, 12 were found",
            ),
            (
                vti_text().replace("Name=", "NumberOfComponents=\"9\" Name=").replace(" Scalars", " Was").into_bytes(),
                "the header promises 108 numbers, 12 were found",
            ),
            (
                vti_text().replace("PointData", "Data").into_bytes(),
                "line 3: there is no array with one component, no array",
            ),
            (changed("7 8", "seven 8"), "number 7 of the data, `seven`, is not a uint8"),
            (changed("7 8", "256 8"), "number 7 of the data, `256`, is not a uint8"),
        ],
    );
}

#[test]
fn broken_data() {
    let plain = [word(12, 4, false), vec![1; 12]].concat();
    let (_, whole) = zlib_blocks(&[1; 12], 12, 4, false);
    let size = whole.len() as u64;
    let mut damaged = whole.clone();
    damaged[whole.len() - 1] ^= 0xff;
    let compressor = |name: &str| changed(LITTLE, &format!("{LITTLE} compressor=\"{name}\""));
    let unknown = String::from_utf8(compressor("vtkLZ4DataCompressor")).unwrap().replace("ascii", "binary");
    check_refused(
        "broken.vti",
        vec![
            (binary(""), "the header promises 22 bytes of data from here, 0 are there"),
            (binary(&base64(&plain)[..18]), "the header promises 22 bytes of data from here, "),
            (binary(&base64(&plain).replace('A', "?")), "the data is damaged after 0 of 12 bytes: `?` is not a base64"),
            (binary(&base64(&[word(11, 4, false), vec![1; 12]].concat())), "the array says to have 11 bytes, and 12"),
            (
                binary(&(base64(&plain)[..16].to_owned() + "        ")),
                "the header promises 12 bytes of data, 8 were found",
            ),
            (raw("offset=\"0\"", "rot13", &plain), "line 12: the encoding `rot13` is neither raw nor base64"),
            (raw("", "raw", &plain), "line 6: `offset` of `DataArray` is ``, not a whole number in range"),
            (raw("offset=\"-1\"", "raw", &plain), "line 6: `offset` of `DataArray` is `-1`"),
            (raw("offset=\"900\"", "raw", &plain), "the header promises 16 bytes of data from here, 0 are there"),
            (raw("offset=\"18446744073709551615\"", "raw", &plain), "16 bytes of data from here, 0 are there"),
            (raw("offset=\"4\"", "raw", &plain), "the array says to have 16843009 bytes, and 12 voxels take 12"),
            (
                vti(LITTLE, "type=\"UInt8\" format=\"appended\" offset=\"0\"", "", b""),
                "line 6: the array's data is appended, and there is no `AppendedData`",
            ),
            (
                vti(LITTLE, "type=\"UInt8\" format=\"appended\" offset=\"0\"", "", b"<AppendedData encoding=\"raw\">x"),
                "line 12: `AppendedData` does not start with an underscore",
            ),
            (unknown.into_bytes(), "line 2: the compressor `vtkLZ4DataCompressor` is not vtkZLibDataCompressor"),
            (blocks(&[1, 12, 0, size], &damaged), "the data is damaged after 0 of 12 bytes: corrupt deflate stream"),
            (blocks(&[1, 12, 0, size], &[0xff; 20]), "the data is damaged after 0 of 12 bytes"),
            (blocks(&[1, 12, 0, size - 6], &whole), "the data is damaged after"),
            (blocks(&[1, 12, 0, 900], &whole), "the header promises 900 bytes of data from here"),
            (
                blocks(&[2, 12, 0, size, size], &whole),
                "the array's 2 blocks inflate to 24 bytes, and its voxels take 12",
            ),
            (blocks(&[u32::MAX.into(), 12, 0], &whole), "blocks inflate to 51539607540 bytes"),
            (blocks(&[0, 0, 0], &whole), "the array's 0 blocks inflate to 0 bytes"),
            (blocks(&[1, 12, 0, 0], &whole), "the header promises 12 bytes of data, and the 0 compressed bytes"),
            (
                blocks(&[2, 11, 1, size, size], &[whole.clone(), whole.clone()].concat()),
                "a block inflates to more than its header promises",
            ),
        ],
    );
}

#[test]
fn broken_legacy_files() {
    let text = String::from_utf8(vtk("ASCII", "unsigned_char", b"1 2 3 4 5 6 7 8 9 10 11 12\n")).unwrap();
    let changed = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1).into_bytes()
    };
    let long = format!("METADATA\n{}\nPOINT_DATA", "x\n".repeat(1 << 20));
    check_refused(
        "broken.vtk",
        vec![
            (b"".to_vec(), "line 1: `` is not `# vtk DataFile Version` and a version"),
            (changed("# vtk", "# ply"), "line 1: `# ply DataFile Version 3.0` is not"),
            (changed("ASCII", "TEXT"), "line 3: `TEXT` is neither ASCII nor BINARY"),
            (changed("STRUCTURED_POINTS", "POLYDATA"), "line 4: the dataset is `POLYDATA`, and only STRUCTURED_POINTS"),
            (changed("DATASET STRUCTURED_POINTS\n", ""), "the header has no DATASET before the data"),
            (changed("DIMENSIONS 3 2 2\n", ""), "the header has no DIMENSIONS before the data"),
            (changed("POINT_DATA 12\n", ""), "the header has no POINT_DATA before the data"),
            (changed("3 2 2", "3 2"), "line 5: `DIMENSIONS 3 2` is not a keyword and 3 whole number(s) in range"),
            (changed("3 2 2", "3 -2 2"), "line 5: `DIMENSIONS 3 -2 2` is not"),
            (changed("3 2 2", "3 0 2"), "line 5: DIMENSIONS without voxels"),
            (changed("3 2 2", "3 2 3"), "line 8: 12 values for the 18 voxels of DIMENSIONS"),
            (changed("3 2 2", "4294967295 4294967295 4294967295"), "line 5: the sizes make"),
            (
                changed("2\nORIGIN 5 6 7\nSPACING 1 2 3\nPOINT_DATA 12", "2000\nPOINT_DATA 12000"),
                "12000 numbers from here",
            ),
            (changed("SPACING 1 2 3", "SPACING 1 2 x"), "line 7: `SPACING 1 2 x` is not a keyword and 3 number(s)"),
            (changed("SCALARS", "VECTORS"), "number 1 of the data, `LOOKUP_TABLE`, is not a uint8"),
            (
                changed("SCALARS", "FIELD data 1\nSCALARS"),
                "line 10: `SCALARS density unsigned_char` is not a keyword and 2",
            ),
            (changed("SCALARS", "SCALER"), "line 9: `SCALER` is no keyword of structured points"),
            (changed("unsigned_char", "bit"), "line 9: the type `bit` is not read"),
            (changed("unsigned_char", "float 3"), "the header promises 36 numbers, 12 were found"),
            (changed("LOOKUP_TABLE default\n", ""), "line 10: `1 2 3 4 5 6 7 8 9 10 11 12` stands behind SCALARS"),
            (text.split("LOOKUP").next().unwrap_or_default().into(), "the header ends without SCALARS"),
            (changed("POINT_DATA", &long), "the header goes on beyond 1048576 bytes"),
            (changed("\n1 2 3 4", "\n1 2 3 four"), "number 4 of the data, `four`, is not a uint8"),
            (changed(" 11 12", "      "), "the header promises 12 numbers, 10 were found"),
            (changed(" 11 12", " 11 12 13"), "`13` follows the 12 numbers that the header promises"),
            (vtk("BINARY", "short", &[1; 23]), "the header promises 24 bytes of data from here, 23 are there"),
            (vtk("BINARY", "float", &[0xff; 48]), "all of the 12 voxels are NaN"),
        ],
    );
}
