//! Refusals of the program: exit codes and messages, and no file left behind.

mod common;

use common::{Folder, nrrd};

const BALL: [&str; 4] = ["render", "builtin:ball", "-o", "out.png"];

fn ball<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&BALL, more].concat()
}

#[test]
fn scene_files_with_mistakes_exit_3_and_name_the_line() {
    let folder = Folder::new();
    let render = ["render", "scene.toml", "-o", "out.png"];
    folder.write("scene.toml", "volume.builtin = \"ball\"\n\n[[light]]\nangular_radiu = 3\n");
    folder.refuse(
        &render,
        3,
        &["scene.toml, line 4", "`light.0.angular_radiu`", "unknown key", "did you mean `light.0.angular_radius`?"],
    );
    folder.write("scene.toml", "volume.builtin = \"ball\"\nfilm.width = 0\n");
    folder.refuse(&render, 3, &["line 2", "`film.width`", "found 0", "1 to 16384"]);
    folder.write("scene.toml", "volume.builtin = \"ball\"\nsweep.light = \"texels\"\n[film]\nwidth = 16384\nheight = 16384\nsupersampling = 4\n");
    folder.refuse(&render, 3, &["16384 x 16384", "4294967296", "67108863"]);
    folder.write("scene.toml", "volume.builtin = \"ball\nlight = 3");
    folder.refuse(&render, 3, &["scene.toml, line 1"]);
    folder.write("scene.toml", "volume.file = \"missing.nrrd\"\n");
    folder.refuse(&render, 3, &["missing.nrrd", "cannot be read"]);
    folder.write("scene.toml", "volume.builtin = \"bal\"\n");
    folder.refuse(&render, 3, &["bal"]);
    folder.write("scene.toml", b"\xff\xfe");
    folder.refuse(&render, 3, &["scene.toml", "UTF-8"]);
    folder.refuse(&["render", "missing.toml", "-o", "out.png"], 3, &["missing.toml", "cannot be read"]);
}

#[test]
fn lights_that_cannot_be_rendered_exit_3() {
    let folder = Folder::new();
    for (light, words) in [
        ("kind = \"point\"", &["scene.toml, line 3", "a point light needs a `position`"][..]),
        ("kind = \"spot\"\nposition = [0, 0, 9]\ncone_angle = 0", &["line 6", "found 0", "0.1 to 89"]),
        ("kind = \"spot\"\nposition = [0, 0, 9]\ncone_angle = 180", &["line 6", "found 180", "0.1 to 89"]),
        ("kind = \"spot\"\nposition = [0, 0, 9]\ncone_angle = 90", &["line 6", "found 90", "0.1 to 89"]),
        ("kind = \"point\"\nposition = [0, 0, 9]\nintensity = -1", &["line 6", "found -1"]),
        (
            "kind = \"point\"\nposition = [0.1, 0, 0.2]",
            &["[0.1, 0.0, 0.2]", "inside the box around the mesh", "shadows = false"],
        ),
        ("kind = \"spot\"\nposition = [0, 0, 9]\ntexture = \"missing.png\"", &["missing.png", "cannot be read"]),
    ] {
        folder.write(
            "scene.toml",
            format!("method = \"voxels\"\nmesh = [{{ builtin = \"torus\" }}]\n[[light]]\n{light}\n"),
        );
        folder.refuse(&["render", "scene.toml", "-o", "out.png"], 3, words);
    }
}

#[test]
fn more_lights_than_a_scene_has_room_for_exit_3() {
    let folder = Folder::new();
    let render = ["render", "scene.toml", "-o", "out.png"];
    let lights = |count: usize| format!("volume.builtin = \"ball\"\n{}", "[[light]]\n".repeat(count));
    folder.write("scene.toml", lights(17));
    folder.refuse(&render, 3, &["scene.toml", "`light`", "a list of 17 items", "at most 16 items"]);
    folder.write("scene.toml", "volume.builtin = \"ball\"\n[[light]]\nintensity = -0.5\n");
    folder.refuse(&render, 3, &["line 3", "`light.0.intensity`", "found -0.5", "0 to 1"]);
    for (value, words) in [("257", "found 257"), ("-1", "found -1"), ("2.5", "found 2.5"), ("\"all\"", "found \"all\"")]
    {
        folder.write("scene.toml", format!("volume.builtin = \"ball\"\n[environment]\nlights = {value}\n"));
        folder.refuse(&render, 3, &["line 3", "`environment.lights`", words, "0 to 256"]);
    }
}

#[test]
fn wrong_flags_exit_2() {
    let folder = Folder::new();
    for (flags, words) in [
        (&["--size", "0x32"][..], &["the width is 0 pixels", "1 to 16384"][..]),
        (&["--size", "100000x100000"], &["the width is 100000 pixels", "1 to 16384"]),
        (&["--size", "32"], &["WIDTHxHEIGHT"]),
        (
            &["--size", "16384x16384", "--set", "film.supersampling=2", "--set", "sweep.light=texels"],
            &["1073741824", "67108863"],
        ),
        (&["--set", "light.0.angular_radius"], &["there is no `=`", "KEY=VALUE"]),
        (&["--set", "light.0.angular_radiu=3"], &["unknown key", "did you mean `light.0.angular_radius`?"]),
        (&["--set", "light.0.angular_radius=90"], &["found 90", "0 to 45"]),
        (&["--set", "light.0.angular_radius=nan"], &["found nan", "0 to 45"]),
        (
            &["--set", "light.softness=3"],
            &["this key is now `light.0.angular_radius`", "write `light.0.angular_radius`"],
        ),
        (&["--set", "light.0.kind=point"], &["`light.0`", "a point light needs a `position`"]),
        (
            &["--set", "sweep.light=texels", "--set", "light.0.kind=spot", "--set", "light.0.position=[0, 0, 9]"],
            &["a sweep carries distant lights alone on texels", "set `sweep.light = \"forward\"`"],
        ),
        (
            &["--set", "medium.scattering=[1, 1, 1]"],
            &["the method `sweep` renders no participating medium", "set `method = \"beams\"`"],
        ),
        (&["--set", "volume.file=x.nrrd"], &["both `file` and `builtin`"]),
        (&["--aov", "medium=m.exr"], &["the output `medium` is now `transmittance`"]),
        (&["--preset", "ambr"], &["no preset `ambr`", "did you mean `amber`?"]),
        (&["--preset", "zzz"], &["no preset `zzz`", "plain, bone, amber, glass, xray, mip, haze"]),
        (&["--aov", "dept=d.exr"], &["no output `dept`", "did you mean `depth`?"]),
        (&["--aov", "depth"], &["NAME=FILE"]),
        (&["--aov", "depth=out.png"], &["out.png", "two outputs"]),
        (&["--aov", "direction=d.png"], &["d.png", "`direction` is a vector", "write it to .exr or .tif"]),
        (&["--frames", "0"], &["0 is not in 1.."]),
        (&["--threads", "0"], &["0 is not in 1.."]),
        (&["--backend", "tpu"], &["tpu", "auto, cpu, gpu"]),
        (&["--stats", "nowhere/s.json"], &["nowhere"]),
        (&["--sise", "3x3"], &["--size"]),
    ] {
        folder.refuse(&ball(flags), 2, words);
    }
    folder.refuse(
        &["render", "builtin:bal", "-o", "out.png"],
        2,
        &["no built-in scene `bal`", "did you mean `builtin:ball`?"],
    );
    folder.refuse(&["rendr"], 2, &["render"]);
}

#[test]
fn outputs_that_cannot_be_written_exit_2_before_any_work() {
    let folder = Folder::new();
    folder.refuse(&["render", "builtin:ball", "-o", "nowhere/out.png"], 2, &["out.png", "nowhere"]);
    folder.refuse(&["render", "builtin:ball", "-o", "out.bmp"], 2, &["out.bmp", ".png", ".exr"]);
    folder.refuse(&["render", "builtin:ball", "-o", "out"], 2, &["extension"]);
    folder.refuse(&["diff", "a.png", "b.png", "-o", "nowhere/out.png"], 2, &["nowhere"]);
    folder.refuse(&["scene", "builtin:ball", "-o", "nowhere/out.toml"], 2, &["nowhere"]);
}

#[test]
fn outputs_that_a_method_does_not_have_are_refused_before_any_work() {
    let folder = Folder::new();
    let outputs = ["-o", "out.png", "--aov", "bounces=b.exr"];
    folder.refuse(&[&["render", "builtin:ball"][..], &outputs].concat(), 2, &["`sweep`", "`bounces`", "transmittance"]);
    let outputs = ["-o", "out.png", "--aov", "light=l.exr"];
    folder.refuse(&[&["render", "builtin:vase"][..], &outputs].concat(), 2, &["`voxels`", "`light`", "bounces"]);
}

#[test]
fn volume_files_with_mistakes_exit_3() {
    let folder = Folder::new();
    let small = |fields: &str| nrrd("4 4 4", fields, &[7; 64]);
    let mut not_a_number =
        b"NRRD0004\ntype: float\ndimension: 3\nsizes: 2 1 1\nencoding: raw\nendian: little\n\n".to_vec();
    not_a_number.extend([f32::NAN.to_le_bytes(); 2].concat());
    folder.write("truncated.nrrd", nrrd("4 4 4", "", &[7; 63]));
    folder.write("huge.nrrd", nrrd("10000 10000 10000", "", &[7; 900]));
    folder.write("nan.nrrd", not_a_number);
    folder.write("flat.nrrd", small("spacings: 1 1\n"));
    folder.write("empty.nrrd", b"");
    folder.write("noise.nrrd", [0x9d; 300]);
    folder.write("noise.xyz", [0x9d; 300]);
    for (file, words) in [
        ("missing.nrrd", &["cannot be read"][..]),
        ("truncated.nrrd", &["63"]),
        ("huge.nrrd", &["1000000000000"]),
        ("nan.nrrd", &["all of the 2 voxels", "NaN"]),
        ("flat.nrrd", &["3 numbers"]),
        ("empty.nrrd", &[]),
        ("noise.nrrd", &[]),
        ("noise.xyz", &["NRRD"]),
        (".", &["folder"]),
    ] {
        let words = if file == "." { words.to_vec() } else { [&[file], words].concat() };
        folder.refuse(&["render", file, "-o", "out.png"], 3, &words);
        folder.refuse(&["info", file], 3, &words);
    }
}

#[test]
fn pictures_that_cannot_be_compared_exit_3() {
    let folder = Folder::new();
    folder.write("noise.png", [0x9d; 300]);
    folder.refuse(&["diff", "missing.png", "missing.png"], 3, &["missing.png", "cannot be read"]);
    folder.refuse(&["diff", "noise.png", "noise.png"], 3, &["noise.png"]);
    folder.refuse(&["diff", "a.png", "b.png", "--max-abs", "-1"], 2, &["-1"]);
    folder.refuse(&["diff", "a.png", "b.png", "--max-rmse", "nan"], 2, &["finite"]);
}

#[test]
fn an_adapter_that_is_not_there_exits_4() {
    let folder = Folder::new();
    folder.refuse(&ball(&["--backend", "gpu", "--adapter", "no adapter has this name"]), 4, &["adapter"]);
}

#[test]
fn help_names_what_the_command_has() {
    let folder = Folder::new();
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    folder.write("a.obj", cube);
    folder.write("a.nrrd", nrrd("4 4 4", "", &[7; 64]));
    let voxelize = |more: &[&'static str]| [&["voxelize", "a.obj", "-o", "b.nrrd", "--backend", "cpu"], more].concat();
    let outcome = folder.vitrum(&voxelize(&["-r", "8192"]));
    assert_eq!(outcome.code, Some(4), "{}", outcome.stderr);
    assert!(outcome.stderr.contains("help: take fewer voxels (--resolution)"), "{}", outcome.stderr);
    assert!(!outcome.stderr.contains("--size"), "{}", outcome.stderr);
    for (input, code) in [("builtin:vase", 2), ("a.obj", 3)] {
        folder.refuse(&["convert", input, "-o", "b.nrrd"], code, &[input, "this is a mesh", "vitrum voxelize"]);
    }
    folder.refuse(&["voxelize", "builtin:ball", "-r", "8", "-o", "b.nrrd"], 2, &["builtin:ball", "shows a volume"]);
    let render = |input: &'static str, preset: &'static str| ["render", input, "-o", "b.png", "--preset", preset];
    let words = ["`jade` is a preset of meshes, and none of volumes", "the presets of volumes are: plain, bone"];
    folder.refuse(&render("a.nrrd", "jade"), 2, &words);
    let words = ["`amber` is a preset of volumes, and none of meshes", "the presets of meshes are: glass, water"];
    folder.refuse(&render("a.obj", "amber"), 2, &words);
    let medium = |input: &'static str, medium: &'static str| ["render", input, "-o", "b.png", "--medium", medium];
    folder.refuse(&medium("a.obj", "zzz"), 2, &["there is no medium `zzz`", "the media are: fog, smoke, milk, sea"]);
    folder.refuse(&medium("a.obj", "fogg"), 2, &["there is no medium `fogg`", "did you mean `fog`?"]);
    folder.refuse(&medium("a.nrrd", "fog"), 2, &["`fog` is shown around meshes, and the scene shows a volume"]);
    folder.refuse(&render("a.obj", "jad"), 2, &["no preset `jad`", "did you mean `jade`?"]);
}

/// Drivers are asked for adapters by the default backend.
#[cfg(target_os = "linux")]
#[test]
fn drivers_do_not_speak_where_there_is_no_session() {
    let folder = Folder::new();
    let small = ["--set", "volume.resolution=16", "--size", "8x8", "--quiet"];
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_vitrum"));
    command.args(ball(&small)).current_dir(folder.path());
    command.env_remove("XDG_RUNTIME_DIR").env_remove("NODEVICE_SELECT").env_remove("DRI_PRIME");
    let output = command.output().expect("the program starts");
    assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stderr).as_ref()), (Some(0), ""));
}
