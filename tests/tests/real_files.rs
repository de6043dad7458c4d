//! Real scans and simulations: size, stored range and spacing as their providers state them.

use vitrum_conformance::data::shared;
use vitrum_io::{OpenOptions, Volume, open};

/// File, voxels along each axis, range, spacing.
type Stated = (&'static str, [u32; 3], [f32; 2], [f32; 3]);

const FILES: &[Stated] = &[
    ("volumes/stent.nrrd", [128, 128, 256], [0.0, 1.0], [1.0, 1.0, 1.0]),
    ("volumes/fuel.nhdr", [64, 64, 64], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/neghip.nhdr", [64, 64, 64], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/silicium.nhdr", [98, 34, 34], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/headsq_nrrd/quarter.nhdr", [64, 64, 93], [0.0, 3926.0], [3.2, 3.2, 1.5]),
    ("volumes/engine.nii.gz", [256, 256, 128], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/bonsai.nii.gz", [256, 256, 256], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/heptane.nii.gz", [302, 302, 302], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/iguana_head_ct.nii.gz", [210, 256, 179], [0.0, 229.0], [0.1018, 0.1018, 0.1018]),
    ("volumes/HeadMRVolume.mhd", [48, 62, 42], [0.0, 255.0], [4.0, 4.0, 4.0]),
    // Its CompressedDataSize is too small.
    ("volumes/frogtissue.mhd", [500, 470, 136], [0.0, 29.0], [1.0, 1.0, 1.5]),
    ("volumes/headsq.vti", [64, 64, 93], [0.0, 3926.0], [3.2, 3.2, 1.5]),
    ("volumes/hydrogen.vti", [64, 64, 64], [0.0, 1.0], [1.0, 1.0, 1.0]),
    ("volumes/aneurism.vti", [256, 256, 256], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/bucky_32x32x32_uint8.raw", [32, 32, 32], [0.0, 255.0], [1.0, 1.0, 1.0]),
    ("volumes/mrhead_256x256x109_uint8.raw.gz", [256, 256, 109], [0.0, 255.0], [1.0, 1.0, 1.0]),
    // Oblique slices, whose positions are rounded to 0.1 mm.
    ("volumes/dicom_brain", [256, 256, 12], [0.0, 1059.0], [0.859375, 0.859375, 6.9992]),
    ("volumes/tiff_banana/banana_stack_deflate.tif", [384, 384, 25], [0.0, 2992.0], [1.0, 1.0, 1.0]),
];

#[test]
fn real_volumes_open_as_they_are_described() {
    for (name, dimensions, range, spacing) in FILES {
        let Some(path) = shared(name) else { continue };
        let volume = open(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(volume.dimensions, *dimensions, "{name}");
        assert_eq!(volume.range, *range, "{name}");
        for (found, stated) in volume.spacing.iter().zip(spacing) {
            assert!((found - stated).abs() < 1e-3 * stated, "{name}: spacing {:?}", volume.spacing);
        }
    }
}

fn opened(name: &str) -> Option<Volume> {
    let path = shared(name)?;
    Some(open(&path, &OpenOptions::default()).unwrap_or_else(|error| panic!("{error}")))
}

/// The values of a slice, row by row.
fn slice(volume: &Volume, z: u32) -> Vec<Vec<f32>> {
    let [width, height, _] = volume.dimensions;
    (0..height).map(|y| (0..width).map(|x| volume.value(x, y, z)).collect()).collect()
}

#[test]
fn the_same_head_comes_out_of_two_formats() {
    let (Some(vti), Some(nrrd)) = (opened("volumes/headsq.vti"), opened("volumes/headsq_nrrd/quarter.nhdr")) else {
        return;
    };
    assert_eq!(vti.dimensions, nrrd.dimensions);
    for z in 0..vti.dimensions[2] {
        let mut flipped = slice(&vti, z);
        flipped.reverse();
        assert!(flipped == slice(&nrrd, z), "slice {z}");
    }
}

/// Position of a voxel's centre, from the middle of the grid.
fn place(volume: &Volume, index: [u32; 3]) -> [f32; 3] {
    let steps =
        [0, 1, 2].map(|axis| (index[axis] as f32 - 0.5 * (volume.dimensions[axis] - 1) as f32) * volume.spacing[axis]);
    [0, 1, 2].map(|component| (0..3).map(|axis| steps[axis] * volume.axes[axis][component]).sum())
}

/// One of the files is mirrored against the other, and says so by `space: 3D-left-handed`.
#[test]
fn the_same_head_lies_the_same_way_in_two_formats() {
    let (Some(vti), Some(nrrd)) = (opened("volumes/headsq.vti"), opened("volumes/headsq_nrrd/quarter.nhdr")) else {
        return;
    };
    for index in [[0, 0, 0], [63, 0, 0], [7, 50, 91]] {
        let [x, y, z] = index;
        for (found, expected) in place(&nrrd, index).iter().zip(place(&vti, [x, 63 - y, z])) {
            // Sums of three terms of at most 101 mm.
            assert!((found - expected).abs() < 1e-4, "{index:?}: {found} is not {expected}");
        }
    }
}

#[test]
fn numbered_files_are_neighbouring_slices_of_the_stack() {
    let Some(stack) = opened("volumes/tiff_banana/banana_stack_deflate.tif") else { return };
    for name in ["banana0012.tif", "banana0013.tif", "banana0014.tif"] {
        let Some(series) = opened(&format!("volumes/tiff_banana/{name}")) else { return };
        assert_eq!(series.dimensions, [384, 384, 3], "{name}");
        assert_eq!(series.spacing, [0.390625, 0.390625, 1.0], "{name}");
        let first = (0..25).find(|&z| slice(&stack, z) == slice(&series, 0)).expect("the first slice");
        for z in 1..3 {
            assert!(slice(&stack, first + z) == slice(&series, z), "{name}, slice {z}");
        }
    }
}
