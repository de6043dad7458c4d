//! NIfTI-1 and -2: every type and byte order comes back, plain and gzipped, in its place in the world.

mod common;

use common::{Folder, NiftiHeader, check, gzip, nifti_u8, nifti2_u8, samples, values};
use vitrum_io::{Error, OpenOptions, Volume, Voxels};

fn open(bytes: Vec<u8>) -> Volume {
    Folder::new().open("a.nii", bytes).unwrap()
}

fn assert_near(a: [f32; 3], b: [f32; 3]) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5 * (1.0 + b.abs())), "{a:?} is not {b:?}");
}

#[test]
fn every_type_and_endian_comes_back() {
    let folder = Folder::new();
    for sample in samples() {
        for (big, data) in [(false, &sample.little), (true, &sample.big)] {
            for version in [NiftiHeader::new, NiftiHeader::second] {
                let file = version(sample.nifti_code, sample.size, big).with(data);
                check(&folder.open("a.nii", &file).unwrap(), &sample);
                // The content decides: gzip without `.gz` is no obstacle.
                check(&folder.open("a.nii", gzip(&file)).unwrap(), &sample);
                check(&folder.open("a.nii.gz", gzip(&file)).unwrap(), &sample);
            }
        }
    }
}

#[test]
fn data_starts_where_vox_offset_says() {
    let file = |offset: f32, extension: usize| {
        let mut header = NiftiHeader::new(2, 1, false);
        header.f32(108, offset);
        [header.bytes, vec![9; extension], vec![7; 12]].concat()
    };
    let sevens = Voxels::U8(vec![7; 12].into());
    for (offset, extension) in [(352.0, 0), (0.0, 0), (368.0, 16)] {
        assert_eq!(open(file(offset, extension)).voxels, sevens);
        assert_eq!(open(gzip(&file(offset, extension))).voxels, sevens);
    }
}

#[test]
fn slope_and_intercept_make_physical_values() {
    let scaled = |slope: f32, intercept: f32| open(nifti_u8(|header| header.f32(112, slope).f32(116, intercept)));
    assert_eq!(values(&scaled(0.5, 10.0)), [13.5; 12]);
    assert_eq!(values(&scaled(-1.0, 0.0)), [-7.0; 12]);
    // 0 and NaN mean that there is none.
    assert_eq!(values(&scaled(0.0, 10.0)), [7.0; 12]);
    assert_eq!(values(&scaled(f32::NAN, 10.0)), [7.0; 12]);
    let mut header = NiftiHeader::new(4, 2, false);
    header.f32(112, 2.0).f32(116, 1.0);
    let volume = open(header.with(&(-3_i16).to_le_bytes().repeat(12)));
    assert_eq!(values(&volume), [-5.0; 12]);
    assert_eq!(volume.range, [-5.0, -5.0]);
}

#[test]
fn the_sform_is_preferred() {
    let volume = open(nifti_u8(|header| {
        header.i16(252, 1).i16(254, 2);
        let rows = [[0.0, 0.0, 3.0, 10.0], [-1.0, 0.0, 0.0, 20.0], [0.0, 2.0, 0.0, 30.0]];
        for (row, values) in rows.into_iter().enumerate() {
            for (column, value) in values.into_iter().enumerate() {
                header.f32(280 + 16 * row + 4 * column, value);
            }
        }
        header
    }));
    assert_near(volume.spacing, [1.0, 2.0, 3.0]);
    assert_near(volume.axes[0], [0.0, -1.0, 0.0]);
    assert_near(volume.axes[1], [0.0, 0.0, 1.0]);
    assert_near(volume.axes[2], [1.0, 0.0, 0.0]);
    assert_near(volume.origin, [10.0, 20.0, 30.0]);
}

#[test]
fn the_qform_rotates_and_mirrors() {
    // A quarter turn about z takes x to y: quaternion (cos 45°, 0, 0, sin 45°).
    let turned = |handedness: f32| {
        open(nifti_u8(|header| {
            header.i16(252, 1).f32(76, handedness).f32(264, std::f32::consts::FRAC_1_SQRT_2);
            header.f32(268, 5.0).f32(272, 6.0).f32(276, 7.0)
        }))
    };
    for handedness in [1.0, -1.0, 0.0] {
        let volume = turned(handedness);
        assert_near(volume.spacing, [1.0, 2.0, 3.0]);
        assert_near(volume.axes[0], [0.0, 1.0, 0.0]);
        assert_near(volume.axes[1], [-1.0, 0.0, 0.0]);
        assert_near(volume.axes[2], [0.0, 0.0, if handedness < 0.0 { -1.0 } else { 1.0 }]);
        assert_near(volume.origin, [5.0, 6.0, 7.0]);
    }
}

#[test]
fn lengths_turn_into_millimetres() {
    for (code, scale) in [(0, 1.0), (1, 1000.0), (2, 1.0), (3, 0.001)] {
        // The bits of the unit of time are set as well: seconds.
        let volume = open(nifti_u8(|header| header.put(123, &[code | 8])));
        assert_near(volume.spacing, [scale, 2.0 * scale, 3.0 * scale]);
        assert_near(volume.origin, [-scale, -scale, -1.5 * scale]);
    }
}

#[test]
fn four_dimensions_are_fine_where_the_fourth_is_1() {
    assert_eq!(open(nifti_u8(|header| header.i16(40, 4))).dimensions, [3, 2, 2]);
}

#[test]
fn every_pair_comes_back() {
    for sample in samples() {
        for (big, data) in [(false, &sample.little), (true, &sample.big)] {
            for version in [NiftiHeader::new, NiftiHeader::second] {
                let header = version(sample.nifti_code, sample.size, big).pair().bytes;
                // The extension bytes behind the header are there in some files.
                let longer = [header.clone(), vec![0; 4]].concat();
                let cases = [
                    ("a.hdr", header.clone(), "a.img", data.clone()),
                    ("b.hdr", longer, "b.img.gz", gzip(data)),
                    ("c.hdr.gz", gzip(&header), "c.img.gz", gzip(data)),
                    ("d.hdr.gz", gzip(&header), "d.img", data.clone()),
                    ("E.HDR", header.clone(), "E.IMG", data.clone()),
                    ("f.hdr", header, "f.img", gzip(data)),
                ];
                let folder = Folder::new();
                for (name, header, image_name, image) in cases {
                    folder.write(image_name, image);
                    check(&folder.open(name, header).unwrap(), &sample);
                }
            }
        }
    }
}

#[test]
fn the_image_of_a_pair_may_start_late() {
    let folder = Folder::new();
    folder.write("a.img", [vec![9; 5], vec![7; 12], vec![9; 2]].concat());
    for mut header in [NiftiHeader::new(2, 1, false).pair(), NiftiHeader::second(2, 1, true).pair()] {
        if header.bytes.len() == 540 {
            header.i64(168, 5)
        } else {
            header.f32(108, 5.0)
        };
        let volume = folder.open("a.hdr", header.bytes).unwrap();
        assert_eq!(volume.voxels, Voxels::U8(vec![7; 12].into()));
        assert!(volume.source.assumptions.iter().any(|note| note.fact.contains("2 bytes behind")));
    }
}

#[test]
fn of_two_images_that_compressed_as_the_header_is_taken() {
    let folder = Folder::new();
    folder.write("a.img", [1; 12]);
    folder.write("a.img.gz", gzip(&[2; 12]));
    let header = NiftiHeader::new(2, 1, false).pair().bytes;
    assert_eq!(folder.open("a.hdr.gz", gzip(&header)).unwrap().voxels, Voxels::U8(vec![2; 12].into()));
    assert_eq!(folder.open("a.hdr", header).unwrap().voxels, Voxels::U8(vec![1; 12].into()));
}

#[test]
fn nifti_2_says_the_same_in_wider_fields() {
    for big in [false, true] {
        let open_with = |change: fn(&mut NiftiHeader) -> &mut NiftiHeader| {
            let mut header = NiftiHeader::second(2, 1, big);
            change(&mut header);
            open(header.with(&[7; 12]))
        };
        let volume = open_with(|header| {
            header.i32(344, 1).i32(348, 2);
            let rows = [[0.0, 0.0, 3.0, 10.0], [-1.0, 0.0, 0.0, 20.0], [0.0, 2.0, 0.0, 30.0]];
            for (index, value) in rows.as_flattened().iter().enumerate() {
                header.f64(400 + 8 * index, *value);
            }
            header
        });
        assert_eq!(volume.source.format, "NIfTI-2");
        assert_near(volume.spacing, [1.0, 2.0, 3.0]);
        assert_near(volume.axes[0], [0.0, -1.0, 0.0]);
        assert_near(volume.axes[1], [0.0, 0.0, 1.0]);
        assert_near(volume.axes[2], [1.0, 0.0, 0.0]);
        assert_near(volume.origin, [10.0, 20.0, 30.0]);
        // A quarter turn about z, mirrored, in metres.
        let volume = open_with(|header| {
            header.i32(344, 1).f64(104, -1.0).f64(368, std::f64::consts::FRAC_1_SQRT_2).i32(500, 1 | 8);
            header.f64(376, 5.0).f64(384, 6.0).f64(392, 7.0)
        });
        assert_near(volume.spacing, [1e3, 2e3, 3e3]);
        assert_near(volume.axes[0], [0.0, 1.0, 0.0]);
        assert_near(volume.axes[1], [-1.0, 0.0, 0.0]);
        assert_near(volume.axes[2], [0.0, 0.0, -1.0]);
        assert_near(volume.origin, [5e3, 6e3, 7e3]);
        assert_eq!(values(&open_with(|header| header.f64(176, 0.5).f64(184, 10.0))), [13.5; 12]);
        assert_eq!(open_with(|header| header.i64(16, 4)).dimensions, [3, 2, 2]);
        assert_eq!(open_with(|header| header.i64(168, 0)).voxels, Voxels::U8(vec![7; 12].into()));
    }
    let extended = [nifti2_u8(|header| header.i64(168, 560))[..544].to_vec(), vec![9; 16], vec![7; 12]].concat();
    assert_eq!(open(extended.clone()).voxels, Voxels::U8(vec![7; 12].into()));
    assert_eq!(open(gzip(&extended)).voxels, Voxels::U8(vec![7; 12].into()));
}

#[test]
fn the_limit_is_on_decoded_bytes() {
    let folder = Folder::new();
    folder.write("a.img.gz", gzip(&[0; 96]));
    let path = folder.write("a.hdr", NiftiHeader::second(64, 8, false).pair().bytes);
    let open =
        |max_bytes| vitrum_io::open(&path, &OpenOptions { max_bytes: Some(max_bytes), ..OpenOptions::default() });
    assert_eq!(values(&open(48).unwrap()), [0.0; 12]);
    assert!(matches!(open(47), Err(Error::TooLarge { needed: 48, limit: 47, .. })));
}
