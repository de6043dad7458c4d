//! MetaImage files with one thing wrong each, and the part of the message that says so.

mod common;

use common::{Folder, attached, gzip, metaimage, zlib};
use vitrum_io::Error;

const DATA: [u8; 12] = [1; 12];

/// A valid file of unsigned bytes with one replacement in its header.
fn changed(from: &str, to: &str) -> Vec<u8> {
    let header = metaimage("MET_UCHAR", "", "LOCAL");
    assert!(header.contains(from), "{from}");
    attached(&header.replace(from, to), &DATA)
}

/// A header of unsigned bytes with more lines, which start at line 5.
fn with(more: &str) -> Vec<u8> {
    attached(&metaimage("MET_UCHAR", more, "LOCAL"), &DATA)
}

fn compressed(data: &[u8]) -> Vec<u8> {
    attached(&metaimage("MET_UCHAR", "CompressedData = True\n", "LOCAL"), data)
}

fn text(data: &str) -> Vec<u8> {
    attached(&metaimage("MET_UCHAR", "BinaryData = False\n", "LOCAL"), data.as_bytes())
}

#[test]
fn broken_files() {
    let mut damaged = zlib(&DATA);
    let end = damaged.len() - 1;
    damaged[end] ^= 0xff;
    let nan: Vec<u8> = [f32::NAN; 12].iter().flat_map(|value| value.to_le_bytes()).collect();
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (changed("ObjectType = Image", "ObjectType = Tube"), "line 1: the object is a `Tube`, not an `Image`"),
        (changed("NDims = 3\n", ""), "the header has no `NDims`; add a line such as `NDims = 3`"),
        (changed("NDims = 3", "NDims 3"), "line 2: `NDims 3` is not `Name = value`"),
        (changed("NDims = 3", "NDims = three"), "line 2: `three` is not a whole number in range"),
        (changed("NDims = 3", "NDims = 2"), "line 2: the data has 2 dimensions, and a volume has 3"),
        (changed("NDims = 3", "NDims = 99999999999"), "line 2: NDims is 99999999999, and the format has 10 at most"),
        (changed("DimSize = 3 2 2\n", ""), "the header has no `DimSize`"),
        (changed("3 2 2", "3 2"), "line 3: `3 2` is not 3 whole numbers in range"),
        (changed("3 2 2", "3 -2 2"), "line 3: `3 -2 2` is not 3"),
        (changed("3 2 2", "3 0 2"), "line 3: `DimSize = 3 0 2` has no voxels"),
        (changed("3 2 2", "3 2 3"), "the header promises 18 bytes of data from here, 12 are there"),
        (changed("3 2 2", "10000 10000 10000"), "promises 1000000000000 bytes of data from here, 12 are there"),
        (changed("3 2 2", "4294967295 4294967295 4294967295"), "line 3: the sizes make"),
        (changed("ElementType = MET_UCHAR\n", ""), "the header has no `ElementType`"),
        (changed("MET_UCHAR", "MET_UCHAR_ARRAY"), "line 4: `MET_UCHAR_ARRAY` is not a type of one number"),
        (changed("ElementDataFile = LOCAL\n", ""), "the header has no `ElementDataFile`"),
        (
            b"NDims = 3\nDimSize = 3 2 2\nElementType = MET_UCHAR\n".to_vec(),
            "the header has no `ElementDataFile`; end it by `ElementDataFile = LOCAL`",
        ),
        (with("DimSize = 3 2 3\n"), "line 5: `DimSize` was given in line 3 already"),
        (with("ElementNumberOfChannels = 0\n"), "line 5: the voxels have 0 components, and from 1 to 64 are read"),
        (with("ElementNumberOfChannels = x\n"), "line 5: `x` is not a whole number"),
        (with("BinaryDataByteOrderMSB = middle\n"), "line 5: `middle` is neither True nor False"),
        (with("CompressedData = zip\n"), "line 5: `zip` is neither True nor False"),
        (
            with("BinaryData = False\nCompressedData = True\n"),
            "line 6: `CompressedData = True` with `BinaryData = False`",
        ),
        (with("ElementSpacing = 1 1\n"), "line 5: `1 1` is not 3 numbers"),
        (with("ElementSpacing = 1 1 1e38\n"), "the volume is 2e38 long, and 1e18 is the most"),
        (with("TransformMatrix = 1 0 0 0 1 0\n"), "line 5: `1 0 0 0 1 0` is not 9 numbers"),
        (with("TransformMatrix = 1 0 0 0 1 0 1 1 0\n"), "line 5: the axis directions"),
        (with("Orientation = 0 0 0 0 0 0 0 0 0\n"), "do not span space"),
        (with("Offset = 1 2\n"), "line 5: `1 2` is not 3 numbers"),
        (with("HeaderSize = 4\n"), "line 5: `HeaderSize = 4` with LOCAL data, which starts at byte"),
        (with("HeaderSize = 9000\n"), "byte 9000: the header promises 12 bytes of data from here, 0 are there"),
        (with("HeaderSize = -2\n"), "line 5: `HeaderSize = -2` with raw data"),
        (with("HeaderSize = -1\nCompressedData = True\n"), "line 5: `HeaderSize = -1` with zlib data"),
        (compressed(&DATA), "the data is damaged after 0 of 12 bytes"),
        (compressed(&zlib(&DATA[..11])), "the header promises 12 bytes of data, 11 were found"),
        (compressed(&zlib(&[1; 20])), "the header promises 12 bytes of data, 20 were found"),
        (compressed(&zlib(&[1; 1 << 20])), "12 bytes of data, at least 65548 were found"),
        (compressed(&damaged), "the data is damaged after 0 of 12 bytes: corrupt deflate stream"),
        (compressed(&gzip(&DATA)[..19]), "the data is damaged after"),
        (compressed(b""), "the header promises 12 bytes of data, and the 0 compressed bytes can hold 0 at most"),
        (
            attached(
                &metaimage("MET_UCHAR", "CompressedData = True\n", "LOCAL").replace("3 2 2", "10000 10000 10000"),
                &zlib(&DATA),
            ),
            "the header promises 1000000000000 bytes of data, and the",
        ),
        (text("1 2 3 4 5 6 7 8 9 10      "), "the header promises 12 numbers, 10 were found"),
        (text("1 2 3"), "the header promises 12 numbers from here, and 5 bytes are there"),
        (text("1 2 3 256 5 6 7 8 9 10 11 12"), "number 4 of the data, `256`, is not a uint8"),
        (text("1 2 3 4 5 6 7 8 9 10 11 12 13"), "`13` follows the 12 numbers"),
        (attached(&metaimage("MET_FLOAT", "", "LOCAL"), &nan), "all of the 12 voxels are NaN"),
        (b"not a header\n".to_vec(), "the header has no `ElementDataFile`"),
        (b"".to_vec(), "the header has no `ElementDataFile`"),
    ];
    let folder = Folder::new();
    for (content, expected) in cases {
        let error = folder.open("broken.mha", content).expect_err(expected);
        let message = error.to_string();
        assert!(message.starts_with(&folder.shown("broken.mha")), "{message}");
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
        assert!(matches!(error, Error::Invalid { .. } | Error::Unsupported { .. }), "{error:?}");
    }
}

#[test]
fn broken_data_files() {
    let folder = Folder::new();
    let below = folder.path("below");
    std::fs::create_dir(&below).unwrap();
    folder.write("data", DATA);
    folder.write("slice1", &DATA[..6]);
    folder.write("slice2", &DATA[..5]);
    let absolute = folder.path("data");
    let absolute = absolute.display().to_string();
    let cases = [
        ("missing", "line 5: the data file `missing` cannot be read"),
        ("../data", "the data file `../data` is not below the header"),
        ("x/../../data", "the data file `x/../../data` is not below the header"),
        (absolute.as_str(), "is not below the header"),
        ("", "the data file `` is not below the header"),
        ("below", "the data file `below` is not a regular file"),
        ("slice1", "slice1, byte 0: the header promises 12 bytes of data from here, 6 are there"),
        ("slice%d 1 2 1", "slice2, byte 0: the header promises 6 bytes of data from here, 5 are there"),
        ("slice%d 1 3 1", "3 data files for 2 slices"),
        ("slice%d 1 2 0", "0 data files for 2 slices"),
        ("slice%d 2 1 1", "0 data files for 2 slices"),
        ("slice%d 0 2147483647 1", "2147483648 data files for 2 slices"),
        ("slice%s 1 2 1", "`slice%s` is not a name with one number"),
        ("slice%999d 1 2 1", "is not a name with one number"),
        ("slice%d 1 2 1 1", "the data file `slice%d 1 2 1 1` cannot be read"),
        ("LIST\nslice1", "1 data files for 2 slices"),
        ("LIST 1\nslice1\nslice2", "2 data files for 4 rows"),
        ("LIST 7\nslice1", "`7` is not the dimension of a file's data, 1 to 3"),
        ("LIST\nslice1\n../slice1", "`../slice1` is not below the header"),
    ];
    for (data_file, expected) in cases {
        let header = metaimage("MET_UCHAR", "", data_file);
        let message = folder.open("broken.mhd", header.trim_end()).expect_err(data_file).to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}
