//! NIfTI-2 files and pairs with one thing wrong each, and the part of the message that says so.

mod common;

use common::{Folder, NiftiHeader, gzip, nifti2_u8};

const DATA: [u8; 12] = [1; 12];

#[test]
fn broken_nifti_2_files() {
    let mut sheared = NiftiHeader::second(2, 1, true);
    sheared.i32(348, 1).f64(400, 1.0).f64(440, 1.0);
    let cases: Vec<(Vec<u8>, &str)> = vec![
        (nifti2_u8(|header| header.put(4, b"x")), "this does not start with a NIfTI header: 348"),
        (nifti2_u8(|header| header.put(0, &[0])), "this does not start with a NIfTI header"),
        (nifti2_u8(|header| header.put(5, b"i")), "byte 4: this is the header of a NIfTI pair"),
        (nifti2_u8(|header| header)[..539].to_vec(), "byte 539: the header ends here, and has 540 bytes"),
        (nifti2_u8(|header| header)[..8].to_vec(), "byte 8: the header ends here"),
        (nifti2_u8(|header| header.i64(16, 8)), "byte 16: dim[0] is 8, not a number of dimensions from 1 to 7"),
        (nifti2_u8(|header| header.i64(16, i64::MIN)), "byte 16: dim[0] is -9223372036854775808"),
        (nifti2_u8(|header| header.i64(16, 2)), "byte 16: the data has 2 dimensions"),
        (nifti2_u8(|header| header.i64(16, 6).i64(64, 30)), "byte 64: dim[6] is 30, and axes beyond the fifth"),
        (nifti2_u8(|header| header.i64(16, 5).i64(56, 65)), "byte 56: the voxels have 65 components"),
        (
            nifti2_u8(|header| header.i64(16, 5).i64(56, 3)),
            "the header promises 36 bytes of data from here, 12 are there",
        ),
        (nifti2_u8(|header| header.i64(24, 0)), "byte 24: dim[1] is 0, not a size of at least 1"),
        (nifti2_u8(|header| header.i64(32, -5)), "byte 32: dim[2] is -5"),
        (nifti2_u8(|header| header.i64(40, 1 << 40)), "byte 40: dim[3] is 1099511627776"),
        (
            nifti2_u8(|header| header.i64(24, 1 << 31).i64(32, 1 << 31).i64(40, 1 << 31)),
            "byte 24: the sizes make 9903520314283042199192993792 bytes, more than any file holds",
        ),
        (
            nifti2_u8(|header| header.i64(40, 3)),
            "byte 544: the header promises 18 bytes of data from here, 12 are there",
        ),
        (gzip(&nifti2_u8(|header| header.i64(40, 3))), "the header promises 18 bytes of data, 12 were found"),
        (gzip(&nifti2_u8(|header| header.i64(40, 1))), "the header promises 6 bytes of data, 12 were found"),
        (gzip(&nifti2_u8(|header| header.i64(24, 1 << 30))), "bytes can hold"),
        (nifti2_u8(|header| header.i16(12, 128)), "the header promises 36 bytes of data from here, 12 are there"),
        (nifti2_u8(|header| header.i16(12, 1536)), "byte 12: the samples are float128"),
        (nifti2_u8(|header| header.i64(168, 543)), "byte 168: vox_offset is 543, not a whole number from 544 to"),
        (nifti2_u8(|header| header.i64(168, i64::MAX)), "byte 168: vox_offset is 9223372036854776000"),
        (nifti2_u8(|header| header.i64(168, 10_000)), "byte 10000: the header promises 12 bytes"),
        (nifti2_u8(|header| header.f64(176, f64::INFINITY)), "byte 176: scl_slope is inf and scl_inter 0"),
        (nifti2_u8(|header| header.f64(176, 1e300)), "byte 176: scl_slope is inf"),
    ];
    let folder = Folder::new();
    for (content, expected) in cases {
        let message = folder.open("broken.nii", content).expect_err(expected).to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}

#[test]
fn broken_nifti_pairs() {
    let header = NiftiHeader::new(2, 1, false).pair().bytes;
    let second = NiftiHeader::second(2, 1, false).pair().bytes;
    let mut late = NiftiHeader::new(2, 1, false).pair();
    late.f32(108, 1.0);
    let mut before = NiftiHeader::second(2, 1, false).pair();
    before.i64(168, -1);
    let analyze = [header[..344].to_vec(), vec![0; 4]].concat();
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder.img")).unwrap();
    folder.write("short.img", &DATA[..11]);
    folder.write("short.img.gz", gzip(&DATA[..11]));
    folder.write("whole.img", DATA);
    folder.write("long.img.gz", gzip(&[1; 13]));
    folder.write("lie.img.gz", [0x1f, 0x8b, 8]);
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("missing.hdr", header.clone(), "missing.hdr, byte 344: the data file `missing.img` cannot be read"),
        ("missing.hdr.gz", gzip(&header), "byte 344: the data file `missing.img.gz` cannot be read"),
        ("missing.hdr", second.clone(), "byte 4: the data file `missing.img` cannot be read"),
        ("folder.hdr", header.clone(), "the data file `folder.img` is not a regular file"),
        (
            "short.hdr",
            header.clone(),
            "short.img, byte 0: the header promises 12 bytes of data from here, 11 are there",
        ),
        ("short.hdr", second.clone(), "short.img, byte 0: the header promises 12 bytes of data from here, 11 are"),
        ("short.hdr.gz", gzip(&header), "short.img.gz: the header promises 12 bytes of data, 11 were found"),
        ("long.hdr", header.clone(), "long.img.gz: the header promises 12 bytes of data, 13 were found"),
        ("lie.hdr", header.clone(), "lie.img.gz: the data is damaged after 0 of 12 bytes"),
        ("whole.hdr", late.bytes, "whole.img, byte 1: the header promises 12 bytes of data from here, 11 are there"),
        ("whole.hdr", before.bytes, "byte 168: vox_offset is -1, not a whole number from 0 to 1000000000000"),
        ("whole.hdr", second[..500].to_vec(), "whole.hdr, byte 500: the header ends here"),
        ("whole.hdr", analyze, "byte 344: this is the header of an ANALYZE 7.5 pair"),
        ("whole.hdr", b"#?RADIANCE\n".to_vec(), "this does not start with a NIfTI header"),
        ("whole.nii", header, "byte 344: this is the header of a NIfTI pair, with its data in an .img file"),
        (
            "data.img",
            DATA.to_vec(),
            "this is the data of a NIfTI pair, which says nothing about itself; open its header",
        ),
        ("data.img.gz", gzip(&DATA), "open its header, the .hdr file beside it"),
    ];
    for (name, content, expected) in cases {
        let message = folder.open(name, content).expect_err(expected).to_string();
        assert!(message.contains(expected), "expected: {expected}\nfound: {message}");
    }
}
