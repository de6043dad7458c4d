//! Properties: whatever the bytes are, opening them ends, in a volume, a picture or an error.

mod common;
#[path = "readers/seeds.rs"]
mod seeds;
#[path = "readers/whole.rs"]
mod whole;

use std::sync::LazyLock;

use common::vtk::vtk;
use common::{Folder, NiftiHeader, attached, gzip, metaimage, npy_with, nrrd};
use proptest::collection::vec;
use proptest::prelude::*;
use ruzstd::encoding::{CompressionLevel, compress_to_vec};
use vitrum_io::{OpenOptions, read_picture};
use whole::Whole;

/// Largest memory that a file may ask for, in bytes.
const MOST: u64 = 1 << 20;

/// Bytes to overwrite, as positions and values, and how much to cut off the end.
type Damage = (Vec<(usize, u8)>, usize);

fn damage() -> impl Strategy<Value = Damage> {
    (vec((any::<usize>(), any::<u8>()), 1..12), prop_oneof![4 => Just(0_usize), 1 => any::<usize>()])
}

fn damaged(file: &[u8], (changes, cut): &Damage) -> Vec<u8> {
    let mut file = file.to_vec();
    for (position, value) in changes {
        let position = position % file.len();
        file[position] = *value;
    }
    file.truncate(file.len() - cut % file.len());
    file
}

/// The seeds of fuzzing of all these targets.
fn seeds_of(targets: &[&str]) -> Vec<Vec<u8>> {
    targets.iter().flat_map(|target| seeds::seeds(target)).collect()
}

/// Files of each picture format, written once.
static PICTURES: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| seeds_of(&["png", "exr", "hdr", "jpeg", "tiff"]));

fn open(folder: &Folder, name: &str, content: &[u8]) {
    let path = folder.write(name, content);
    let options = OpenOptions { max_bytes: Some(MOST), ..OpenOptions::default() };
    if let Ok(volume) = vitrum_io::open(&path, &options) {
        volume.assert_whole(MOST);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_volumes(damage in damage()) {
        let folder = Folder::new();
        folder.write("slice1", [1; 6]);
        folder.write("slice2", [2; 6]);
        for file in seeds_of(&["nrrd", "nifti", "metaimage", "numpy"]) {
            open(&folder, "a", &damaged(&file, &damage));
        }
    }

    #[test]
    fn damaged_pairs(damage in damage(), image in damage()) {
        let folder = Folder::new();
        for header in [NiftiHeader::new(2, 1, false), NiftiHeader::second(2, 1, true)] {
            folder.write("a.img", damaged(&gzip(&[1; 12]), &image));
            open(&folder, "a.hdr", &damaged(&header.pair().bytes, &damage));
        }
    }

    #[test]
    fn damaged_vtk_files(damage in damage()) {
        let folder = Folder::new();
        for file in seeds_of(&["vti", "vtk"]) {
            open(&folder, "a", &damaged(&file, &damage));
        }
    }

    #[test]
    fn random_metaimage_lines(lines in vec("(ElementSpacing|ElementSize|Offset|TransformMatrix|HeaderSize|CompressedData|BinaryData|ElementByteOrderMSB|ElementNumberOfChannels|DistanceUnits|ElementDataFile)[:= ]{1,3}[-0-9a-zLIST%., ]{0,24}", 0..6)) {
        let header = metaimage("MET_UCHAR", &format!("{}\n", lines.join("\n")), "LOCAL");
        open(&Folder::new(), "a.mha", &attached(&header, &[1; 12]));
    }

    #[test]
    fn random_numpy_dictionaries(text in "[{}()'\"<>|, :a-zA-Z0-9\\[\\]µ]{0,60}", version in 1_u8..4) {
        let folder = Folder::new();
        open(&folder, "a.npy", &npy_with((version, 0), &text, &[1; 12]));
        let entries = format!("{{'descr': '|u1', 'fortran_order': False, 'shape': {text}}}");
        open(&folder, "a.npy", &npy_with((version, 0), &entries, &[1; 12]));
    }

    #[test]
    fn damaged_dicom_files(damage in damage()) {
        let folder = Folder::new();
        for file in seeds_of(&["dicom"]) {
            open(&folder, "a.dcm", &damaged(&file, &damage));
        }
    }

    #[test]
    fn damaged_packed_files(damage in damage()) {
        let folder = Folder::new();
        let file = attached(&nrrd("uint8", "raw", ""), &[1; 12]);
        for packed in [gzip(&file), compress_to_vec(&file[..], CompressionLevel::Fastest)] {
            open(&folder, "a", &damaged(&packed, &damage));
        }
        let nifti = NiftiHeader::new(2, 1, false).with(&[1; 12]);
        open(&folder, "a", &damaged(&compress_to_vec(&nifti[..], CompressionLevel::Fastest), &damage));
    }

    #[test]
    fn any_layout(text in "[0-9]{1,3}x[0-9]x[0-9]:[uif](8|16|32|64)(:[lb]e)?(:skip=[0-9]{1,20})?|[0-9x:a-z=-]{0,20}", bytes in vec(any::<u8>(), 0..99)) {
        if let Ok(raw) = text.parse() {
            let path = Folder::new();
            let file = path.write("a", &bytes);
            let _ = vitrum_io::open(&file, &OpenOptions { raw: Some(raw), max_bytes: Some(MOST), ..OpenOptions::default() });
        }
    }

    #[test]
    fn random_vtk_lines(lines in vec("(SCALARS|VECTORS|FIELD|LOOKUP_TABLE|COLOR_SCALARS|TEXTURE_COORDINATES|METADATA|CELL_DATA|POINT_DATA|a)( [a-z0-9_]{1,5}){0,3}", 0..8)) {
        for kind in ["ASCII", "BINARY"] {
            let file = vtk(kind, "unsigned_char", format!("{}\n", "1 ".repeat(12)).as_bytes());
            open(&Folder::new(), "a.vtk", &[&file[..], lines.join("\n").as_bytes()].concat());
        }
    }

    #[test]
    fn damaged_stacks(damage in damage()) {
        let folder = Folder::new();
        for file in seeds_of(&["stack"]) {
            open(&folder, "a", &damaged(&file, &damage));
        }
    }

    #[test]
    fn any_bytes_under_a_raw_name(bytes in vec(any::<u8>(), 0..99), name in "[a-z_]{0,3}[0-9]{0,2}x[0-9]x[0-9](_[uif](8|16|32))?(_[lb]e)?\\.(raw|bin)(\\.gz)?") {
        let folder = Folder::new();
        open(&folder, &name, &bytes);
        open(&folder, &name, &gzip(&bytes));
    }

    #[test]
    fn random_header_lines(lines in vec("(type|sizes|space|spacings|encoding|endian|data ?file|byte skip|line skip|space directions|space origin|units|kinds|LIST)[:= ]{1,3}[-0-9a-z%., ()\"]{0,24}", 0..6)) {
        let header = nrrd("uint8", "raw", "");
        let header: String = header.lines().filter(|line| {
            let name = line.split(':').next().unwrap_or_default();
            name.is_empty() || !lines.iter().any(|other| other.starts_with(name))
        }).map(|line| format!("{line}\n")).collect();
        let header = format!("{}{}\n\n", header.trim_end_matches('\n').to_owned() + "\n", lines.join("\n"));
        open(&Folder::new(), "a.nrrd", &attached(&header, &[1; 12]));
    }

    #[test]
    fn random_bytes(bytes in vec(any::<u8>(), 0..700), extension in "nrrd|nhdr|nii|nii\\.gz|hdr|img|mha|mhd|npy|vti|vtk|tif|raw|png|x") {
        let folder = Folder::new();
        open(&folder, &format!("a.{extension}"), &bytes);
        let _ = read_picture(&folder.path(&format!("a.{extension}")));
    }

    #[test]
    fn damaged_pictures(damage in damage()) {
        let folder = Folder::new();
        for file in PICTURES.iter() {
            let path = folder.write("a", damaged(file, &damage));
            if let Ok(picture) = read_picture(&path) {
                assert_eq!(picture.color().len() as u64, u64::from(picture.width) * u64::from(picture.height));
            }
        }
    }
}
