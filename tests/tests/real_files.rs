//! Real scans and simulations: size, stored range and spacing as their providers state them.

use vitrum_conformance::data::shared;
use vitrum_io::{OpenOptions, open};

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
