//! `vitrum convert` with its changes, against closed forms.

mod common;

use common::{Folder, nrrd};
use vitrum_io::{OpenOptions, Volume, open};

/// A grid of 12 x 10 x 8 voxels that stands obliquely in the world, of the values `value(x, y, z)`.
fn write(folder: &Folder, value: impl Fn([u8; 3]) -> u8) {
    let placed =
        "space: right-anterior-superior\nspace directions: (0,2,0) (-3,0,0) (0,0,4)\nspace origin: (10,20,30)\n";
    let places = (0..8).flat_map(|z| (0..10).flat_map(move |y| (0..12).map(move |x| [x, y, z])));
    folder.write("a.nrrd", nrrd("12 10 8", placed, &places.map(value).collect::<Vec<u8>>()));
}

fn converted(folder: &Folder, flags: &[&str]) -> Volume {
    folder.succeed(&[&["convert", "a.nrrd", "-o", "b.nrrd"], flags].concat());
    open(&folder.file("b.nrrd"), &OpenOptions::default()).expect("it was written")
}

/// Where in the world a voxel lies, or a place between voxels.
fn place(volume: &Volume, index: [f32; 3]) -> [f32; 3] {
    [0, 1, 2].map(|row| {
        let along = |axis: usize| index[axis] * volume.spacing[axis] * volume.axes[axis][row];
        volume.origin[row] + (0..3).map(along).sum::<f32>()
    })
}

fn assert_near(one: [f32; 3], other: [f32; 3]) {
    assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-4), "{one:?} and {other:?}");
}

#[test]
fn a_crop_keeps_values_and_places() {
    let folder = Folder::new();
    write(&folder, |[x, y, z]| x + 12 * y + z);
    let whole = converted(&folder, &[]);
    let part = converted(&folder, &["--crop", "3:9,:4,5:"]);
    assert_eq!((part.dimensions, part.spacing, part.axes), ([6, 4, 3], whole.spacing, whole.axes));
    assert_eq!(part.orientation, whole.orientation);
    for (x, y, z) in [(0, 0, 0), (5, 3, 2), (2, 1, 1)] {
        assert_eq!(part.value(x, y, z), whole.value(x + 3, y, z + 5));
        let index = [x, y, z].map(|index| index as f32);
        assert_near(place(&part, index), place(&whole, [index[0] + 3.0, index[1], index[2] + 5.0]));
    }
    assert_near(place(&part, [0.0; 3]), [10.0, 26.0, 50.0]);
    for wrong in ["3:3,:,:", "3:13,:,:", ":,9:2,:"] {
        folder.refuse(&["convert", "a.nrrd", "-o", "c.nrrd", "--crop", wrong], 2, &["no part of the volume"]);
    }
}

/// f(x, y, z) = 2 x + 3 y + 5 z in indices is the same function of the place on any grid, away from the faces, where values go on.
#[test]
fn a_linear_ramp_is_resampled_exactly() {
    let folder = Folder::new();
    write(&folder, |[x, y, z]| 2 * x + 3 * y + 5 * z);
    let whole = converted(&folder, &[]);
    for flags in [["--resample", "1,1,1"], ["--resample", "3.1,2.9,5"], ["--size", "24,5,8"], ["--size", "7,33,3"]] {
        let other = converted(&folder, &flags);
        let extents = |volume: &Volume| volume.extent();
        let mut compared = 0;
        for index in 0..other.voxel_count() as u32 {
            let [width, height, _] = other.dimensions;
            let at = [index % width, index / width % height, index / (width * height)];
            let there = place(&other, at.map(|index| index as f32));
            // The axes of the file: x along +y of the world, y along -x.
            let [x, y, z] = [(there[1] - 20.0) / 2.0, -(there[0] - 10.0) / 3.0, (there[2] - 30.0) / 4.0];
            // A filter of this step reaches so far at most, in old voxels.
            let margin = [0, 1, 2].map(|axis| 0.5 * other.spacing[axis] / whole.spacing[axis] + 1.0);
            let inside = |at: f32, size: f32, margin: f32| at >= margin && at <= size - 1.0 - margin;
            if inside(x, 12.0, margin[0]) && inside(y, 10.0, margin[1]) && inside(z, 8.0, margin[2]) {
                let expected = 2.0 * x + 3.0 * y + 5.0 * z;
                let found = other.value(at[0], at[1], at[2]);
                // Rounding of f32 in three passes.
                assert!(
                    (found - expected).abs() < 1e-4 * expected.abs().max(1.0),
                    "{flags:?} {at:?}: {found} for {expected}"
                );
                compared += 1;
            }
        }
        assert!(compared > 0, "{flags:?}");
        let middle = |volume: &Volume| place(volume, volume.dimensions.map(|size| 0.5 * (size as f32 - 1.0)));
        assert_near(middle(&other), middle(&whole));
        if flags[0] == "--size" {
            assert_near(extents(&other), extents(&whole));
        }
    }
}

/// An impulse becomes the product of three Gaussians, whose sum is that of the impulse.
#[test]
fn an_impulse_is_blurred_to_a_gaussian() {
    let folder = Folder::new();
    write(&folder, |at| if at == [6, 5, 4] { 200 } else { 0 });
    let sigma = 0.8_f32;
    let blurred = converted(&folder, &["--blur", "0.8"]);
    let gauss = |offset: i32| libm::expf(-0.5 * (offset * offset) as f32 / (sigma * sigma));
    let sum: f32 = (-4..=4).map(gauss).sum();
    let mut total = 0.0;
    for (x, y, z) in (0..12).flat_map(|x| (0..10).flat_map(move |y| (0..8).map(move |z| (x, y, z)))) {
        let expected =
            200.0 * [x as i32 - 6, y as i32 - 5, z as i32 - 4].map(gauss).iter().product::<f32>() / (sum * sum * sum);
        let found = blurred.value(x, y, z);
        // At the radius of 4 voxels, 5 standard deviations, the Gaussian ends.
        assert!((found - expected).abs() < 2e-4, "{x} {y} {z}: {found} for {expected}");
        total += found;
    }
    assert!((total - 200.0).abs() < 1e-2, "{total}");
    folder.refuse(&["convert", "a.nrrd", "-o", "c.nrrd", "--blur", "0"], 2, &["a blur of 0 voxels"]);
}

#[test]
fn masks_are_of_thresholds_and_of_labels() {
    let folder = Folder::new();
    write(&folder, |[x, _, _]| x);
    let mask = converted(&folder, &["--threshold", "3,5"]);
    let low = converted(&folder, &["--threshold", "3"]);
    let labels = converted(&folder, &["--labels", "4,7,11"]);
    for x in 0..12 {
        assert_eq!(mask.value(x, 1, 1), if (3..=5).contains(&x) { 1.0 } else { 0.0 });
        assert_eq!(low.value(x, 1, 1), if x >= 3 { 1.0 } else { 0.0 });
        assert_eq!(labels.value(x, 1, 1), if [4, 7, 11].contains(&x) { x as f32 } else { 0.0 });
    }
    // No value between two labels is made.
    let finer = converted(&folder, &["--labels", "4,7,11", "--size", "31,10,8"]);
    assert!((0..31).all(|x| [0.0, 4.0, 7.0, 11.0].contains(&finer.value(x, 0, 0))));
    assert!((0..31).any(|x| finer.value(x, 0, 0) == 7.0));
    folder.refuse(&["convert", "a.nrrd", "-o", "c.nrrd", "--labels", "99"], 2, &["no voxel has one of the --labels"]);
    folder.refuse(&["convert", "a.nrrd", "-o", "c.nrrd", "--resample", "1e-5,1,1"], 2, &["--resample gives"]);
}
