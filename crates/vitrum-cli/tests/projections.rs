//! Projections and crop boxes by the program's flags.

mod common;

use common::{Folder, nrrd};
use vitrum_io::read_picture;

/// Air, a faint block, and a few bright voxels in it.
fn scan() -> Vec<u8> {
    let value = |index: usize| {
        let at = [index % 16, index / 16 % 16, index / 256];
        match at {
            [9..=10, 8..=9, 7..=8] => 250,
            at if at.iter().all(|i| (4..12).contains(i)) => 90,
            _ => 3,
        }
    };
    nrrd("16 16 16", "", &(0..4096).map(value).collect::<Vec<u8>>())
}

/// The green of a picture's pixels, linear, and whether all pixels are grey.
fn greens(folder: &Folder, name: &str) -> (Vec<f32>, bool) {
    let pixels = read_picture(&folder.file(name)).expect("a picture").color();
    let grey = pixels.iter().all(|[red, green, blue]| red == green && green == blue);
    (pixels.iter().map(|pixel| pixel[1]).collect(), grey)
}

fn brightest(greens: &[f32]) -> f32 {
    greens.iter().copied().fold(0.0, f32::max)
}

#[test]
fn the_preset_mip_shows_the_largest_values_in_grey_and_a_crop_box_takes_them_away() {
    let folder = Folder::new();
    folder.write("scan.nrrd", scan());
    let render = |name: &str, more: &[&str]| {
        let flags = [
            "render",
            "scan.nrrd",
            "-o",
            name,
            "--preset",
            "mip",
            "--backend",
            "cpu",
            "--size",
            "48x48",
            "--set",
            "camera.elevation=0",
            "--set",
            "camera.azimuth=0",
        ];
        folder.vitrum(&[&flags[..], more].concat())
    };
    assert_eq!(render("whole.png", &[]).code, Some(0));
    let (whole, grey) = greens(&folder, "whole.png");
    assert!(grey && brightest(&whole) > 0.6, "{}", brightest(&whole));
    let cut = ["--set", "crop.max=[0.5,1,1]", "--set", "light.0.azimuth=9"];
    let told = render("cropped.png", &cut);
    assert!(told.code == Some(0) && told.stderr.contains("`light.0.azimuth` is left out"), "{}", told.stderr);
    let (cropped, _) = greens(&folder, "cropped.png");
    assert!(brightest(&cropped) < 0.3, "the bright voxels are cut off: {}", brightest(&cropped));
    let shown = |greens: &[f32]| greens.iter().filter(|&&green| green > 0.02).count();
    let (left, all) = (shown(&cropped), shown(&whole));
    assert!(left * 3 < all * 2 && left * 3 > all, "half of the block is left: {left} of {all}");
}
