//! Voxels that stay in their file: blocks are those of the whole volume, in every format that has them in one piece, and a file that is cut off
//! while it is open is told.

use std::fs;

use vitrum_io::{BrickRanges, Error, OpenOptions, Volume, Voxels, open};

const SIZE: [u32; 3] = [7, 5, 6];

fn numbers() -> Vec<i16> {
    (0..SIZE.iter().product::<u32>()).map(|index| (index.wrapping_mul(2_654_435_761) >> 17) as i16 - 9000).collect()
}

fn bytes(big: bool) -> Vec<u8> {
    numbers().into_iter().flat_map(|value| if big { value.to_be_bytes() } else { value.to_le_bytes() }).collect()
}

/// Files of the same voxels: a name, what stands before them, and whether they are big-endian.
fn files() -> Vec<(&'static str, Vec<u8>, bool)> {
    let nrrd = "NRRD0004\ntype: int16\ndimension: 3\nsizes: 7 5 6\nencoding: raw\nendian: big\n\n";
    let meta =
        "NDims = 3\nDimSize = 7 5 6\nElementType = MET_SHORT\nElementByteOrderMSB = False\nElementDataFile = LOCAL\n";
    let mut npy = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    let dictionary = "{'descr': '<i2', 'fortran_order': False, 'shape': (6, 5, 7), }";
    npy.extend(format!("{dictionary:<117}\n").bytes());
    vec![
        ("a_7x5x6_int16_le.raw", Vec::new(), false),
        ("a_7x5x6_int16_be.raw", Vec::new(), true),
        ("a.nrrd", nrrd.into(), true),
        ("a.mha", meta.into(), false),
        ("a.npy", npy, false),
        ("a.nii", nifti(), false),
    ]
}

fn nifti() -> Vec<u8> {
    let mut header = vec![0_u8; 352];
    header[..4].copy_from_slice(&348_i32.to_le_bytes());
    for (index, value) in [3_i16, 7, 5, 6, 1, 1, 1, 1].into_iter().enumerate() {
        header[40 + 2 * index..][..2].copy_from_slice(&value.to_le_bytes());
    }
    header[70..72].copy_from_slice(&4_i16.to_le_bytes());
    header[72..74].copy_from_slice(&16_i16.to_le_bytes());
    for index in 0..4 {
        header[76 + 4 * index..][..4].copy_from_slice(&1_f32.to_le_bytes());
    }
    header[108..112].copy_from_slice(&352_f32.to_le_bytes());
    header[344..348].copy_from_slice(b"n+1\0");
    header
}

fn paged() -> OpenOptions {
    OpenOptions { paged: true, ..OpenOptions::default() }
}

/// The stored voxels of a block of a whole volume.
fn block(whole: &Volume, low: [u32; 3], size: [u32; 3]) -> Voxels {
    let Voxels::U16(voxels) = &whole.voxels else { panic!("voxels of 16 bits") };
    let [width, height, _] = SIZE;
    let at = |x, y, z| voxels[((z * height + y) * width + x) as usize];
    let rows = (low[2]..low[2] + size[2]).flat_map(|z| (low[1]..low[1] + size[1]).map(move |y| (y, z)));
    let block: Vec<u16> = rows.flat_map(|(y, z)| (low[0]..low[0] + size[0]).map(move |x| at(x, y, z))).collect();
    block.into()
}

#[test]
fn blocks_are_those_of_the_whole_volume() {
    let folder = tempfile::tempdir().unwrap();
    for (name, mut content, big) in files() {
        content.extend(bytes(big));
        let path = folder.path().join(name);
        fs::write(&path, content).unwrap();
        let whole = open(&path, &OpenOptions::default()).unwrap();
        let volume = open(&path, &paged()).unwrap();
        let paged = volume.paged.as_ref().unwrap_or_else(|| panic!("{name} was read whole"));
        assert_eq!((volume.range, volume.value_offset), (whole.range, whole.value_offset), "{name}");
        assert_eq!((volume.origin, volume.spacing, volume.axes), (whole.origin, whole.spacing, whole.axes), "{name}");
        for (low, size) in [([0; 3], SIZE), ([0; 3], [7, 2, 3]), ([2, 1, 3], [3, 4, 2]), ([6, 4, 5], [1; 3])] {
            assert_eq!(paged.read(low, size), Some(block(&whole, low, size)), "{name}: {size:?} from {low:?}");
        }
        assert_eq!(volume.value(3, 4, 5), whole.value(3, 4, 5), "{name}");
        let BrickRanges::U16(ranges) = &paged.ranges else { panic!("{name}: ranges of another type") };
        let Voxels::U16(first) = block(&whole, [0; 3], [4; 3]) else { panic!("16 bits") };
        let ends = (*first.iter().min().unwrap(), *first.iter().max().unwrap());
        assert_eq!((ranges.len(), ranges[0]), (8, ends), "{name}");
        assert!(volume.clone().blurred(1.0).is_err(), "{name}: a blur needs all voxels");
        assert_eq!(paged.take_failure().map(|error| error.to_string()), None);
    }
}

#[test]
fn a_file_that_is_cut_off_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a_7x5x6_int16_le.raw");
    fs::write(&path, bytes(false)).unwrap();
    let volume = open(&path, &paged()).unwrap();
    fs::write(&path, [0; 7]).unwrap();
    let paged = volume.paged.as_ref().unwrap();
    assert_eq!(paged.read([0; 3], SIZE), None);
    let failure = paged.take_failure().unwrap();
    assert!(matches!(failure, Error::Unreadable { .. }), "{failure}");
    assert!(failure.to_string().contains("a_7x5x6_int16_le.raw"), "{failure}");
    assert!(paged.take_failure().is_none());
}

#[test]
fn what_is_not_finite_does_not_stay_in_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a_2x2x2_float32_le.raw");
    fs::write(&path, [0_f32, 1.0, f32::NAN, 3.0, 4.0, 5.0, 6.0, 7.0].map(f32::to_le_bytes).concat()).unwrap();
    let error = open(&path, &paged()).unwrap_err();
    assert!(error.to_string().contains("NaN or infinite"), "{error}");
}
