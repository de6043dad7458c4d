//! Pictures that are well-formed and yet wrong: without pixels, or too large for their limit.

mod common;

use common::Folder;
use vitrum_io::{Channel, Error, Layer, OpenOptions, Picture, read_picture, read_picture_with, write_picture};

#[test]
fn pictures_without_pixels_are_refused() {
    let folder = Folder::new();
    for size in ["-Y 0 +X 5", "-Y 5 +X 0"] {
        let file = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}\n");
        let result = read_picture(&folder.write("a.hdr", file));
        assert!(matches!(result, Err(Error::Invalid { .. })), "{size}: {result:?}");
    }
}

#[test]
fn the_limit_counts_what_is_decoded() {
    let folder = Folder::new();
    let picture = Picture::rgb(64, 64, vec![[0.5; 3]; 4096]);
    for extension in ["png", "exr", "hdr", "jpg", "tif"] {
        let path = folder.path(&format!("a.{extension}"));
        write_picture(&path, &picture, &[]).unwrap();
        let read = |max_bytes| read_picture_with(&path, &OpenOptions { max_bytes: Some(max_bytes) });
        // Three to four channels of float32, twice, and as much again for the decoder.
        let result = read(64 * 64 * 4 * 16);
        assert!(result.is_ok(), "{extension}: {result:?}");
        let result = read(64 * 64 * 4 * 3);
        assert!(matches!(result, Err(Error::TooLarge { .. })), "{extension}: {result:?}");
    }
}

/// Each layer alone would fit.
#[test]
fn the_layers_of_an_openexr_file_count_together() {
    let folder = Folder::new();
    let layer = |name: String| Layer { name, channels: vec![Channel { name: "Y".to_owned(), data: vec![0.0; 4096] }] };
    let layers = (0..16).map(|index| layer(format!("layer {index}"))).collect();
    let path = folder.path("a.exr");
    write_picture(&path, &Picture { width: 64, height: 64, layers }, &[]).unwrap();
    let read = |max_bytes| read_picture_with(&path, &OpenOptions { max_bytes: Some(max_bytes) });
    assert!(read(16 * 4096 * 8).is_ok());
    let result = read(4 * 4096 * 8);
    assert!(matches!(result, Err(Error::TooLarge { .. })), "{result:?}");
}
