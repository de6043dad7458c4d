//! Figures: annotations, backgrounds, the camera's matrices, sides of a patient and the contact sheet.

mod common;

use common::{Folder, nrrd};
use serde_json::Value;
use std::fs;
use vitrum_io::{Picture, read_picture};

/// Voxels along each edge of the test's volumes.
const N: usize = 24;

/// A patient's volume of voxels of 1 x 1 x 2 mm, those of `bright` 250 and others 0.
fn write_volume(folder: &Folder, name: &str, bright: impl Fn([usize; 3]) -> bool) {
    let voxel = |index: usize| if bright([index % N, index / N % N, index / (N * N)]) { 250 } else { 0 };
    let fields = "space: right-anterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: (-10,3,40)\n\
                  space units: \"mm\" \"mm\" \"mm\"\n";
    folder.write(name, nrrd("24 24 24", fields, &(0..N * N * N).map(voxel).collect::<Vec<u8>>()));
}

fn ball([x, y, z]: [usize; 3]) -> bool {
    let squared = |at: usize| (2 * at as i32 - 23).pow(2);
    squared(x) + squared(y) + squared(z) < 300
}

/// A scene of opaque white matter above a value of 100 without a ground, which is left out by items 8 and 9, with the whole grid in the picture.
const OPAQUE: [&str; 16] = [
    "--set",
    "transfer.opacity=[{value=99,opacity=0},{value=101,opacity=1}]",
    "--set",
    "transfer.filter=[]",
    "--set",
    "transfer.ior=[]",
    "--set",
    "transfer.color=[]",
    "--set",
    "ground=none",
    "--set",
    "camera.framing=whole",
    "--backend",
    "cpu",
    "--quiet",
    "--set=camera.projection=orthographic",
];

fn picture(folder: &Folder, name: &str) -> Picture {
    read_picture(&folder.file(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn stats(folder: &Folder) -> Value {
    let text = fs::read_to_string(folder.file("stats.json")).expect("the statistics were written");
    serde_json::from_str(&text).expect("they are JSON")
}

/// Half the diagonal of the volume's box, in mm.
fn radius() -> f64 {
    let edges = [24.0_f64, 24.0, 48.0];
    0.5 * edges.iter().map(|edge| edge * edge).sum::<f64>().sqrt()
}

#[test]
fn a_scale_bar_is_as_long_as_the_spacing_says() {
    let folder = Folder::new();
    write_volume(&folder, "ball.nrrd", ball);
    let bar = ["--set", "annotation=[{kind='scale_bar',length=10,color='#f00'}]", "--set", "background=white"];
    let size = ["render", "ball.nrrd", "-o", "bar.png", "--size", "400x300", "--stats", "stats.json"];
    folder.succeed(&[&size[..], &["--annotations", "bar.svg"], &bar, &OPAQUE].concat());
    // The picture's height holds 0.87 of the sphere around the volume on each side, as framing `whole` has it.
    let pixel = 2.0 * 0.87 * radius() / 300.0;
    let told = stats(&folder)["camera"]["pixel_size"].as_f64().expect("the statistics say it");
    assert!((told / pixel - 1.0).abs() < 1e-5, "{told} and {pixel}");
    let exact = 10.0 / pixel;
    let seen = picture(&folder, "bar.png");
    // The bar's rows: red takes the white away from green and blue; a pixel that is half covered counts half.
    let covered = |row: &[[f32; 3]]| {
        let code = |value: f32| f64::from(vitrum_io::linear_to_srgb(value));
        row.iter().filter(|[r, g, b]| *r > 0.99 && (g - b).abs() < 1e-3).map(|[_, g, _]| 1.0 - code(*g)).sum::<f64>()
    };
    let rows: Vec<f64> = seen.color().chunks(400).map(covered).collect();
    let longest = rows.iter().copied().fold(0.0, f64::max);
    // Its left end is on a pixel's edge, and the right one is drawn to a quarter of a pixel.
    assert!((longest - exact).abs() < 0.14, "the bar takes {longest} pixels, and 10 mm are {exact}");
    let svg = fs::read_to_string(folder.file("bar.svg")).expect("the document was written");
    let (_, width) =
        svg.split_once("class=\"scale-bar\"").expect("the bar is in it").1.split_once("width=\"").expect("a width");
    let width: f64 = width.split('"').next().and_then(|number| number.parse().ok()).expect("a number");
    assert!((width - exact).abs() < 1e-3 && svg.contains(">10 mm</text>"), "{svg}");
}

#[test]
fn annotations_are_for_pictures_of_the_screen() {
    let folder = Folder::new();
    write_volume(&folder, "ball.nrrd", ball);
    let small = ["render", "ball.nrrd", "--size", "64x48"];
    let caption = ["--set", "annotation=[{kind='caption', text='B & W', size=12}]"];
    folder.succeed(&[&small[..], &["-o", "plain.exr"], &OPAQUE].concat());
    folder.succeed(&[&small[..], &["-o", "caption.exr"], &caption, &OPAQUE].concat());
    assert_eq!(picture(&folder, "plain.exr").color(), picture(&folder, "caption.exr").color());
    folder.succeed(&[&small[..], &["-o", "plain.png"], &OPAQUE].concat());
    folder.succeed(&[&small[..], &["-o", "caption.png", "--bits", "16"], &caption, &OPAQUE].concat());
    let [plain, with] = ["plain.png", "caption.png"].map(|name| picture(&folder, name).color());
    let differ = |rows: std::ops::Range<usize>| {
        let pixels = rows.start * 64..rows.end * 64;
        pixels.filter(|&at| (0..3).any(|c| (plain[at][c] - with[at][c]).abs() > 0.01)).count()
    };
    assert_eq!(differ(0..40), 0, "only the caption's place changes");
    assert!(differ(40..48) > 10);
    folder.refuse(&[&small[..], &["-o", "a.png", "--annotations", "a.svg"], &OPAQUE].concat(), 2, &["no annotations"]);
    let wrong = ["--set", "annotation.0.kind=caption"];
    folder.refuse(
        &[&small[..], &["-o", "a.png"], &wrong, &OPAQUE].concat(),
        2,
        &["annotation.0.text", "a caption has a text"],
    );
    let wrong = ["--set", "annotation.0.color=whit"];
    folder.refuse(&[&small[..], &["-o", "a.png"], &wrong, &OPAQUE].concat(), 2, &["annotation.0.color", "#rrggbb"]);
    let mesh = ["render", "builtin:vase", "-o", "a.png", "--set", "annotation.0.kind=legend", "--backend", "cpu"];
    folder.refuse(&mesh, 2, &["annotation.0", "a mesh has no transfer function"]);
}

#[test]
fn a_background_is_white_or_nothing() {
    let folder = Folder::new();
    write_volume(&folder, "ball.nrrd", ball);
    // Darker than white, so that nothing outshines the page.
    let small = ["render", "ball.nrrd", "--size", "64x64", "--set=film.exposure=-1"];
    folder.succeed(&[&small[..], &["-o", "white.png", "--set", "background=white"], &OPAQUE].concat());
    folder.succeed(&[&small[..], &["-o", "clear.png", "--set", "background=transparent"], &OPAQUE].concat());
    let [white, clear] = ["white.png", "clear.png"].map(|name| picture(&folder, name));
    let alpha = |picture: &Picture, at: usize| picture.layers[0].channel("A").map_or(1.0, |plane| plane[at]);
    let (corner, middle) = (0, 32 * 64 + 32);
    assert_eq!((white.color()[corner], alpha(&white, corner)), ([1.0; 3], 1.0));
    assert!(alpha(&clear, corner) == 0.0 && alpha(&clear, middle) > 0.98);
    // The edge of the ball over white is what the clear picture gives over a white page, up to 8 bits of both.
    for at in 0..64 * 64 {
        let share = alpha(&clear, at);
        let over = clear.color()[at].map(|value| value * share + 1.0 - share);
        for (over, white) in over.iter().zip(white.color()[at]) {
            let code = |value: f32| vitrum_io::linear_to_srgb(value) * 255.0;
            assert!((code(*over) - code(white)).abs() < 4.0, "pixel {at}: {over} and {white}");
        }
    }
    let jpeg = [&small[..], &["-o", "a.jpg", "--set", "background=transparent"], &OPAQUE].concat();
    folder.refuse(&jpeg, 2, &["transparency"]);
    folder.refuse(
        &[&small[..], &["-o", "a.png", "--set", "background=whit"], &OPAQUE].concat(),
        2,
        &["background", "transparent"],
    );
}

#[test]
fn a_ground_that_catches_shadows_leaves_them_in_the_alpha() {
    let folder = Folder::new();
    write_volume(&folder, "ball.nrrd", ball);
    let render = ["render", "ball.nrrd", "--size", "80x80", "--set", "camera.elevation=40", "--set=ground.height=44"];
    let render =
        [&render[..], &["--quality=draft", "--set=light.0={azimuth=70,elevation=50,attachment='world'}"]].concat();
    let opaque = [&OPAQUE[..8], &OPAQUE[10..]].concat();
    folder.succeed(&[&render[..], &["-o", "with.exr", "--set", "background=black"], &opaque].concat());
    let catcher = ["-o", "caught.exr", "--set", "background=transparent", "--set", "ground.shadow_catcher=true"];
    folder.succeed(&[&render[..], &catcher, &opaque].concat());
    let [with, caught] = ["with.exr", "caught.exr"].map(|name| picture(&folder, name));
    let alpha = caught.layers[0].channel("A").expect("it has an alpha").to_vec();
    let (with, caught) = (with.color(), caught.color());
    // The lit ground, which all of the picture shows but the ball and its shadow.
    let clear: Vec<usize> = (0..6400).filter(|&at| alpha[at] < 0.01).collect();
    assert!(clear.len() > 2000, "{} pixels are in the light", clear.len());
    let page = with[clear[0]];
    // Ambient light has a colour of its own, which is added.
    let is_dark = |at: usize| alpha[at] > 0.2 && caught[at].iter().all(|light| *light < 0.1 * page[0]);
    let dark = (0..6400).filter(|&at| is_dark(at)).count();
    assert!(dark > 100, "{dark} pixels are in the shadow");
    for at in 0..6400 {
        for channel in 0..3 {
            let over = caught[at][channel] + (1.0 - alpha[at]) * page[channel];
            assert!(
                (over - with[at][channel]).abs() < 0.02 * page[channel],
                "pixel {at}: {over} and {}",
                with[at][channel]
            );
        }
    }
    let without = [&render[..], &["-o", "a.png", "--set", "ground.shadow_catcher=true"], &opaque].concat();
    folder.refuse(&without, 2, &["ground.shadow_catcher", "set `background`"]);
}

#[test]
fn frames_of_a_turntable_are_annotated() {
    let folder = Folder::new();
    write_volume(&folder, "ball.nrrd", ball);
    let turn =
        ["turntable", "ball.nrrd", "-o", "frames", "--frames", "2", "--size", "64x48", "--set", "background=white"];
    let cube = [
        "--set",
        "annotation=[{kind='orientation',style='cube',extent=30},{kind='caption',text='■■■',size=20,color='red'}]",
    ];
    folder.succeed(&[&turn[..], &cube, &OPAQUE].concat());
    for frame in ["frames/frame-00000.png", "frames/frame-00001.png"] {
        let color = picture(&folder, frame).color();
        let red = color.iter().filter(|[r, g, b]| *r > 0.9 && *g < 0.3 && *b < 0.3).count();
        assert!(red > 3, "{frame} has {red} red pixels");
    }
}

#[test]
fn the_matrices_lead_from_a_voxel_to_its_pixel() {
    let folder = Folder::new();
    let voxel = [5, 16, 18];
    write_volume(&folder, "voxel.nrrd", |at| at == voxel);
    for projection in ["perspective", "orthographic"] {
        let camera = format!("--set=camera.projection={projection}");
        let render = ["render", "voxel.nrrd", "-o", "voxel.png", "--size", "200x160", "--stats", "stats.json"];
        let opaque = &OPAQUE[..OPAQUE.len() - 1];
        let view = ["--set", "camera.roll=10", "--set", "background=black", &camera];
        let value = ["--set", "transfer.opacity=[{value=99,opacity=0},{value=150,opacity=1}]"];
        folder.succeed(&[&render[..], opaque, &view, &value].concat());
        let matrix = |name: &str| {
            let rows = serde_json::from_value::<[[f64; 4]; 4]>(stats(&folder)["camera"][name].clone());
            rows.expect("the statistics have the matrix")
        };
        let [view, project] = ["view", "projection"].map(matrix);
        let apply =
            |rows: [[f64; 4]; 4], at: [f64; 4]| rows.map(|row| row.iter().zip(at).map(|(a, b)| a * b).sum::<f64>());
        let world = [-10.0 + 5.0, 3.0 + 16.0, 40.0 + 2.0 * 18.0, 1.0];
        let clip = apply(project, apply(view, world));
        let [x, y] = [100.0 * (1.0 + clip[0] / clip[3]), 80.0 * (1.0 - clip[1] / clip[3])];
        let seen = picture(&folder, "voxel.png").color();
        let weights = || seen.iter().enumerate().map(|(at, pixel)| (at, f64::from(pixel[0])));
        let sum: f64 = weights().map(|(_, weight)| weight).sum();
        assert!(sum > 0.1, "{projection}: the voxel is not seen");
        let across = weights().map(|(at, weight)| ((at % 200) as f64 + 0.5) * weight).sum::<f64>() / sum;
        let down = weights().map(|(at, weight)| ((at / 200) as f64 + 0.5) * weight).sum::<f64>() / sum;
        // Light comes from a side, so that the middle of what is seen is up to half a voxel, some 2 pixels, off the voxel's.
        assert!(
            (across - x).abs() < 2.0 && (down - y).abs() < 2.0,
            "{projection}: seen at {across}, {down}, told {x}, {y}"
        );
    }
    let bytes = fs::read(folder.file("voxel.png")).expect("the picture is there");
    for key in ["vitrum.pixel_size", "vitrum.view", "vitrum.projection"] {
        assert!(bytes.windows(key.len()).any(|window| window == key.as_bytes()), "{key} is not in the PNG");
    }
}

#[test]
fn a_patient_is_seen_from_its_sides() {
    let folder = Folder::new();
    // A bright half on the patient's left, world −x.
    write_volume(&folder, "left.nrrd", |[x, y, z]| x < 6 && (8..16).contains(&y) && (8..16).contains(&z));
    let seen = |side: &str| {
        let render =
            ["render", "left.nrrd", "-o", "side.png", "--size", "60x60", "--view", side, "--set", "background=black"];
        folder.succeed(&[&render[..], &OPAQUE].concat());
        let color = picture(&folder, "side.png").color();
        let [sum, moment] = color.iter().enumerate().fold([0.0, 0.0], |[sum, moment], (at, pixel)| {
            [sum + pixel[0], moment + pixel[0] * ((at % 60) as f32 - 29.5)]
        });
        moment / sum
    };
    // The viewer's right is the patient's left from the front and from below, as in a radiograph and a slice.
    assert!(seen("anterior") > 3.0 && seen("inferior") > 3.0 && seen("posterior") < -3.0 && seen("superior") < -3.0);
    assert!(seen("left").abs() < 1.0 && seen("right").abs() < 1.0);
    let unknown = ["render", "builtin:ball", "-o", "a.png", "--view", "left"];
    folder.refuse(&unknown, 2, &["left view", "--set camera.azimuth=90"]);
    folder.refuse(&["render", "left.nrrd", "-o", "a.png", "--view", "top"], 2, &["anterior, posterior, left"]);
}

#[test]
fn a_contact_sheet_shows_every_preset() {
    let folder = Folder::new();
    write_volume(&folder, "ball.nrrd", ball);
    folder.succeed(&["presets", "ball.nrrd", "-o", "sheet.png", "--size", "90x70", "--backend", "cpu", "--quiet"]);
    let sheet = picture(&folder, "sheet.png");
    let names = folder.succeed(&["presets", "--json"]);
    let names: Vec<Value> = serde_json::from_str(&names).expect("it is JSON");
    // Presets of other values than these have no picture.
    let is_of_volumes = |entry: &&Value| {
        let text = entry["description"].as_str().unwrap_or_default();
        let is_fitted = !entry["name"].as_str().is_some_and(|name| name.starts_with("ct-"));
        is_fitted && !["a medium", "of a mesh", "a map of colours"].iter().any(|kind| text.starts_with(kind))
    };
    let names: Vec<&str> = names.iter().filter(is_of_volumes).filter_map(|entry| entry["name"].as_str()).collect();
    assert!(names.len() > 5, "{names:?}");
    let tiles = sheet.color();
    for name in names {
        folder.succeed(&[
            "render",
            "ball.nrrd",
            "-o",
            "one.png",
            "--size",
            "90x70",
            "--quality",
            "draft",
            "--preset",
            name,
            "--backend",
            "cpu",
            "--quiet",
        ]);
        let one = picture(&folder, "one.png").color();
        let at = |x: usize, y: usize| {
            (0..70).all(|row| tiles[(y + row) * sheet.width as usize + x..][..90] == one[row * 90..][..90])
        };
        let places =
            (0..=sheet.width as usize - 90).flat_map(|x| (0..=sheet.height as usize - 70).map(move |y| (x, y)));
        assert_eq!(places.filter(|&(x, y)| at(x, y)).count(), 1, "the sheet shows {name} once");
    }
    folder.refuse(&["presets", "-o", "a.png"], 2, &["INPUT"]);
}
