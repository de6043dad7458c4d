//! Volumes at the ends of what there is: tiny ones, and ones with a voxel that is far brighter than all others.

mod common;

use common::Folder;
use serde_json::Value;

const PRESETS: [&str; 6] = ["plain", "bone", "amber", "glass", "xray", "haze"];

/// Voxels along an edge.
const SIZE: usize = 24;

/// A ball of two shells in the void, and its voxel at `odd` in another brightness.
fn write(folder: &Folder, name: &str, odd: Option<f32>) {
    let voxel = |index: usize| {
        let place = [index % SIZE, index / SIZE % SIZE, index / (SIZE * SIZE)];
        let squared: i32 = place.iter().map(|&at| (2 * at as i32 - SIZE as i32 + 1).pow(2)).sum();
        match (odd, place) {
            (Some(value), [3, 4, 5]) => value,
            _ if squared < 120 => 900.0,
            _ if squared < 340 => 400.0,
            _ => 10.0 + (index % 7) as f32,
        }
    };
    let header = format!(
        "NRRD0004\ntype: float\ndimension: 3\nsizes: {SIZE} {SIZE} {SIZE}\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n"
    );
    let voxels = (0..SIZE.pow(3)).flat_map(|index| voxel(index).to_le_bytes());
    folder.write(name, header.into_bytes().into_iter().chain(voxels).collect::<Vec<u8>>());
}

fn render(folder: &Folder, volume: &str, picture: &str, preset: &str, more: &[&str]) {
    let command = ["render", volume, "-o", picture, "--preset", preset, "--size", "40x40", "--backend", "cpu", "-q"];
    folder.succeed(&[&command[..], more].concat());
}

fn rmse(folder: &Folder, one: &str, other: &str) -> f64 {
    let told: Value = serde_json::from_str(&folder.succeed(&["diff", one, other, "--json"])).expect("JSON");
    told["rmse"].as_f64().expect("a number")
}

/// The picture does not depend on the unit of length.
#[test]
fn tiny_volumes_give_the_same_pictures() {
    let folder = Folder::new();
    write(&folder, "a.nrrd", None);
    for preset in PRESETS {
        render(&folder, "a.nrrd", "a.exr", preset, &[]);
        for spacing in ["1e-6,1e-6,1e-6", "1e-9,1e-9,1e-9", "1e6,1e6,1e6"] {
            render(&folder, "a.nrrd", "b.exr", preset, &["--spacing", spacing]);
            // Rounding alone, of which some moves a ray that grazes a surface.
            let difference = rmse(&folder, "a.exr", "b.exr");
            assert!(difference < 5e-3, "{preset} at {spacing}: {difference}");
        }
    }
}

/// One voxel that is brighter than all others by far changes the picture where it lies, and nowhere else.
#[test]
fn a_bright_voxel_spoils_no_preset() {
    let folder = Folder::new();
    write(&folder, "a.nrrd", None);
    for preset in PRESETS {
        // The voxel is visible, and would be in the frame, too.
        let whole = ["--set", "camera.framing=whole"];
        render(&folder, "a.nrrd", "a.exr", preset, &whole);
        for odd in [3e4, 1e9, -1e9] {
            write(&folder, "b.nrrd", Some(odd));
            render(&folder, "b.nrrd", "b.exr", preset, &whole);
            // Interpolated, the voxel is 1 / 12 of the edge: it covers less than 1 % of the picture, shadow included, and differs there by
            // up to 0.5. A preset that is fitted to it shows nothing of the ball, which is 0.1 and more.
            let difference = rmse(&folder, "a.exr", "b.exr");
            assert!(difference < 0.05, "{preset} with {odd}: {difference}");
        }
    }
}
