//! Small VTK files.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// A 3 x 2 x 2 `.vti` file, spacings 1, 2, 3, with one array: more attributes of the file and of
/// the array, the array's content, and what stands behind the image.
pub fn vti(file: &str, array: &str, content: &str, tail: &[u8]) -> Vec<u8> {
    let head = format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"ImageData\" version=\"1.0\" {file}>\n\
         <ImageData WholeExtent=\"0 2 0 1 0 1\" Origin=\"5 6 7\" Spacing=\"1 2 3\">\n\
         <Piece Extent=\"0 2 0 1 0 1\">\n\
         <PointData Scalars=\"density\">\n\
         <DataArray Name=\"density\" {array}>\n\
         {content}\n\
         </DataArray>\n</PointData>\n</Piece>\n</ImageData>\n"
    );
    [head.as_bytes(), tail, b"\n</VTKFile>\n"].concat()
}

/// The VTI file of `vti` with 12 bytes of uint8, written as text.
pub fn vti_text() -> String {
    let bytes = vti(LITTLE, "type=\"UInt8\" format=\"ascii\"", "1 2 3 4 5 6\n7 8 9 10 11 12", b"");
    String::from_utf8(bytes).expect("text")
}

pub const LITTLE: &str = "byte_order=\"LittleEndian\"";

/// `AppendedData` behind an image.
pub fn appended(encoding: &str, data: &[u8]) -> Vec<u8> {
    let head = format!("<AppendedData encoding=\"{encoding}\">\n  _");
    [head.as_bytes(), data, b"\n</AppendedData>"].concat()
}

pub fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let groups = bytes.chunks(3).map(|group| {
        let bits = (0..3).fold(0, |bits, index| bits << 8 | u32::from(group.get(index).copied().unwrap_or(0)));
        let digit = |index: usize| match index <= group.len() {
            true => char::from(DIGITS[(bits >> (18 - 6 * index)) as usize & 63]),
            false => '=',
        };
        (0..4).map(digit).collect::<String>()
    });
    groups.collect()
}

/// A number of a data header, of 4 or 8 bytes.
pub fn word(value: u64, size: usize, big: bool) -> Vec<u8> {
    match (size, big) {
        (4, false) => (value as u32).to_le_bytes().to_vec(),
        (4, true) => (value as u32).to_be_bytes().to_vec(),
        (_, false) => value.to_le_bytes().to_vec(),
        (_, true) => value.to_be_bytes().to_vec(),
    }
}

pub fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).and_then(|()| encoder.finish()).expect("compression in memory")
}

/// Header and blocks of `block` bytes each.
pub fn zlib_blocks(data: &[u8], block: usize, size: usize, big: bool) -> (Vec<u8>, Vec<u8>) {
    let blocks: Vec<_> = data.chunks(block).map(zlib).collect();
    let numbers = [blocks.len(), block, data.len() % block];
    let numbers = numbers.into_iter().chain(blocks.iter().map(Vec::len));
    (numbers.flat_map(|number| word(number as u64, size, big)).collect(), blocks.concat())
}

/// A legacy file of 3 x 2 x 2 points, spacings 1, 2, 3.
pub fn vtk(kind: &str, sample: &str, data: &[u8]) -> Vec<u8> {
    let head = format!(
        "# vtk DataFile Version 3.0\na title\n{kind}\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 5 6 7\n\
         SPACING 1 2 3\nPOINT_DATA 12\nSCALARS density {sample}\nLOOKUP_TABLE default\n"
    );
    [head.as_bytes(), data].concat()
}
