//! Animations: key frames, MP4 and finer pictures.

mod common;

use common::Folder;
use std::fs;
use std::process::Command;
use vitrum_io::read_picture;

const TURN: [&str; 8] =
    ["turntable", "builtin:ball", "--set", "volume.resolution=16", "--size", "33x24", "--backend", "cpu"];

fn turn<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&TURN, more].concat()
}

#[test]
fn key_frames_make_the_pictures_that_settings_make() {
    let folder = Folder::new();
    folder.write(
        "keys.toml",
        "[[key]]\nframe = 0\ncamera.azimuth = 10\nlight.0.angular_radius = 0\n[[key]]\ntime = 0.5\ncamera.azimuth = 50\nlight.0.angular_radius = 4\n",
    );
    folder.succeed(&turn(&["-o", "animation", "--keys", "keys.toml", "--rate", "8"]));
    assert_eq!(fs::read_dir(folder.file("animation")).expect("a folder").count(), 5, "frames 0 to 4");
    let render = [&["render"], &TURN[1..]].concat();
    for (frame, azimuth, softness) in [(0, 10, 0), (2, 30, 2), (4, 50, 4)] {
        let settings = [format!("camera.azimuth={azimuth}"), format!("light.0.angular_radius={softness}")];
        folder.succeed(&[&render[..], &["-o", "still.png", "--set", &settings[0], "--set", &settings[1]]].concat());
        let animation = read_picture(&folder.file(&format!("animation/frame-0000{frame}.png"))).expect("a picture");
        assert_eq!(
            animation.color(),
            read_picture(&folder.file("still.png")).expect("a picture").color(),
            "frame {frame}"
        );
    }
    // Fewer frames are its beginning, and more rest at its end.
    folder.succeed(&turn(&["-o", "long", "--keys", "keys.toml", "--rate", "8", "--frames", "7"]));
    let picture = |name: &str| fs::read(folder.file(name)).expect("a picture");
    assert_eq!(picture("long/frame-00006.png"), picture("animation/frame-00004.png"));
}

/// A scene of the sea whose pictures take a moment.
const SEA: [&str; 9] =
    ["builtin:ocean", "--set", "beams.rays=16", "--set", "beams.views=1", "--size", "16x12", "--backend", "cpu"];

#[test]
fn waves_move_along_key_frames() {
    let folder = Folder::new();
    folder.write("sea.toml", "[[key]]\ntime = 0\nmesh.0.time = 0\n[[key]]\ntime = 1\nmesh.0.time = 2\n");
    let animation = [&["turntable"], &SEA[..], &["-o", "animation", "--keys", "sea.toml", "--rate", "2"]].concat();
    folder.succeed(&animation);
    let render = [&["render"], &SEA[..], &["-o", "still.png"]].concat();
    let picture = |name: &str| read_picture(&folder.file(name)).expect("a picture").color();
    let mut still = Vec::new();
    for (frame, settings) in [(0, &[][..]), (0, &["--set", "mesh.0.time=0"]), (1, &["--set", "mesh.0.time=1"])] {
        folder.succeed(&[&render[..], settings].concat());
        still.push(picture("still.png"));
        let name = format!("animation/frame-0000{frame}.png");
        assert_eq!(still.last(), Some(&picture(&name)), "frame {frame}, {settings:?}");
    }
    assert_ne!(still[0], still[2], "nothing moves");
}

#[test]
fn moments_that_a_mesh_does_not_have_are_refused() {
    let folder = Folder::new();
    let still = "`waves`";
    for (mesh, words) in [
        ("builtin = \"waves\"\ntime = nan", &["scene.toml, line 4", "`mesh.0.time`", "found nan", "finite"][..]),
        ("builtin = \"waves\"\ntime = inf", &["scene.toml, line 4", "`mesh.0.time`", "found inf", "finite"]),
        ("builtin = \"waves\"\ntime = 1e39", &["scene.toml, line 4", "`mesh.0.time`", "finite"]),
        ("builtin = \"waves\"\ntime = \"noon\"", &["scene.toml, line 4", "`mesh.0.time`", "noon", "number"]),
        ("file = \"sea.obj\"\ntime = 0", &["scene.toml, line 4", "`mesh.0.time`", "from a file does not move", still]),
        ("builtin = \"torus\"\ntime = 1", &["scene.toml, line 4", "`mesh.0.time`", "`torus` does not move", still]),
        ("builtin = \"wave\"\ntime = 1", &["no built-in mesh `wave`"]),
    ] {
        folder.write("scene.toml", format!("method = \"beams\"\n[[mesh]]\n{mesh}\n"));
        folder.refuse(&["render", "scene.toml", "-o", "out.png"], 3, words);
    }
    for (input, time, words) in [
        ("builtin:ocean", "nan", &["keys.toml, line 3", "mesh.0.time", "found nan"][..]),
        ("builtin:ocean", "-inf", &["keys.toml, line 3", "mesh.0.time", "found -inf"]),
        ("builtin:torus", "1", &["keys.toml, frame 0", "`mesh.0.time`", "`torus` does not move"]),
    ] {
        folder.write("keys.toml", format!("[[key]]\nframe = 0\nmesh.0.time = {time}\n"));
        folder.refuse(&["turntable", input, "-o", "animation.gif", "--keys", "keys.toml"], 3, words);
    }
    // A time however far away is one.
    let far = [&["render"], &SEA[..], &["-o", "far.png", "--set", "mesh.0.time=-3e38"]].concat();
    folder.succeed(&far);
}

#[test]
fn wrong_key_frames_are_refused_before_any_work() {
    let folder = Folder::new();
    let keys = |text: &str| folder.write("keys.toml", text);
    let animation = turn(&["-o", "animation.gif", "--keys", "keys.toml"]);
    folder.refuse(&animation, 3, &["keys.toml", "cannot be read"]);
    keys("[[key]]\nframe = 0\ncamera.azimut = 1\n");
    folder.refuse(&animation, 3, &["keys.toml, line 3", "camera.azimut", "did you mean `camera.azimuth`?"]);
    keys("[[key]]\nframe = 0\nfilm.width = 1\n");
    folder.refuse(&animation, 3, &["keys.toml, line 3", "the same for the whole animation"]);
    // Only one frame of many has no scene.
    keys("[[key]]\nframe = 0\ncamera.up = [0, 0, 1]\n[[key]]\nframe = 8\ncamera.up = [0, 0, -1]\n");
    folder.refuse(&animation, 3, &["keys.toml, frame 4", "camera.up"]);
    keys("[[key]]\nframe = 0\ncamera.azimuth = 1\n");
    folder.refuse(&[&animation[..], &["--turn", "90"]].concat(), 2, &["--turn", "--keys"]);
    folder.write("keys.toml", b"\xff");
    folder.refuse(&animation, 3, &["keys.toml", "UTF-8"]);
}

/// Seen from the other side, light that stays in the world shines towards the camera.
#[test]
fn a_film_that_would_break_off_is_refused_before_its_first_frame() {
    let folder = Folder::new();
    // Light on texels goes away from the camera alone.
    let scene = ["builtin:ball", "--set", "sweep.light=texels"];
    let turning = ["--set", "light.0.attachment=world", "--set", "light.0.azimuth=0", "--frames", "12"];
    let animation = [&["turntable"][..], &scene, &turning, &["-o", "animation"]].concat();
    folder.refuse(&animation, 3, &["frame 4 of 12", "85"]);
    folder.refuse(
        &["scene", "builtin:ball", "--set", "sweep.light=texels", "--set", "light.0.azimuth=180"],
        3,
        &["85", "light.0.azimuth"],
    );
}

#[test]
fn finer_pictures_have_16_bits() {
    let folder = Folder::new();
    // Bits per channel are the ninth byte of the first chunk's content.
    let bits = |name: &str| fs::read(folder.file(name)).expect("a picture")[24];
    folder.succeed(&turn(&["-o", "animation", "--frames", "1", "--bits", "16"]));
    let render = [&["render"], &TURN[1..]].concat();
    folder.succeed(&[&render[..], &["-o", "a.exr", "--bits", "16", "--aov", "opacity=a.png"]].concat());
    folder.succeed(&[&render[..], &["-o", "b.png", "--bits", "16"]].concat());
    folder.succeed(&[&render[..], &["-o", "c.png"]].concat());
    assert_eq!(["animation/frame-00000.png", "a.png", "b.png", "c.png"].map(bits), [16, 16, 16, 8]);
    // A gradient has more values than 8 bits tell apart.
    let values = |name: &str| {
        let picture = read_picture(&folder.file(name)).expect("a picture");
        let mut values: Vec<_> = picture.color().into_iter().flatten().map(f32::to_bits).collect();
        values.sort_unstable();
        values.dedup();
        values.len()
    };
    assert!(values("b.png") > 256 && values("c.png") <= 256);
    folder.refuse(&[&render[..], &["-o", "d.exr", "--bits", "16"]].concat(), 2, &["--bits 16", "PNG"]);
    folder.refuse(&[&render[..], &["-o", "d.png", "--bits", "12"]].concat(), 2, &["--bits", "12"]);
    folder.refuse(&turn(&["-o", "animation.gif", "--bits", "16"]), 2, &["8 bits per channel"]);
    folder.refuse(&turn(&["-o", "animation.gif", "--rate", "60"]), 2, &["60 frames a second", "at most 50"]);
}

#[cfg(unix)]
#[test]
fn mp4_goes_through_ffmpeg() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let with_ffmpeg = |script: Option<&str>| {
        fs::create_dir_all(folder.file("programs")).expect("the folder is writable");
        let ffmpeg = folder.file("programs/ffmpeg");
        match script {
            Some(script) => {
                fs::write(&ffmpeg, format!("#!/bin/sh\n{script}\n")).expect("a program");
                fs::set_permissions(&ffmpeg, fs::Permissions::from_mode(0o755)).expect("it is ours");
            }
            None => drop(fs::remove_file(&ffmpeg)),
        }
        let output = Command::new(env!("CARGO_BIN_EXE_vitrum"))
            .args(turn(&["-o", "out.mp4", "--frames", "3", "--rate", "12"]))
            .current_dir(folder.path())
            // The shell's own commands alone: no other ffmpeg is found.
            .env("PATH", folder.file("programs"))
            .output()
            .expect("the program starts");
        (output.status.code(), String::from_utf8(output.stderr).expect("UTF-8"))
    };
    let names = || {
        folder.names().into_iter().filter(|name| name.contains("mp4") || name.ends_with(".part")).collect::<Vec<_>>()
    };

    let (code, message) = with_ffmpeg(None);
    assert_eq!(code, Some(2), "{message}");
    assert!(message.contains("error: out.mp4: cannot be written: it takes the program ffmpeg"), "{message}");
    assert!(message.contains("help: install ffmpeg, or write .gif"), "{message}");
    assert_eq!(names(), [""; 0]);

    // In the role of ffmpeg: what it is asked for, and then all frames, go to the file.
    let recorder = "for last; do :; done; file=${last#file:}\necho \"$@\" > arguments\nexec /bin/cat > \"$file\"";
    let (code, message) = with_ffmpeg(Some(recorder));
    assert_eq!(code, Some(0), "{message}");
    let frames = fs::read(folder.file("out.mp4")).expect("an animation");
    assert_eq!(frames.len(), 3 * 33 * 24 * 4);
    let asked = fs::read_to_string(folder.file("arguments")).expect("they were recorded");
    for word in ["-f rawvideo", "-pixel_format rgba", "-video_size 33x24", "-framerate 12", "-f mp4", "yuv420p"] {
        assert!(asked.contains(word), "no `{word}` in: {asked}");
    }
    // The first frame is the picture that `render` makes.
    let render = [&["render"], &TURN[1..], &["-o", "still.png"]].concat();
    folder.succeed(&render);
    let still = read_picture(&folder.file("still.png")).expect("a picture");
    let codes =
        still.color().into_iter().flatten().map(|value| (vitrum_io::linear_to_srgb(value) * 255.0).round() as u8);
    let colors = frames[..33 * 24 * 4].chunks(4).flat_map(|pixel| pixel[..3].to_vec());
    assert!(codes.eq(colors));
    assert_eq!(names(), ["out.mp4"]);

    // One that gives up: at once, and at the end.
    folder.write("out.mp4", "old");
    for script in ["echo 'Unknown encoder' >&2; exit 8", "/bin/cat > /dev/null; echo 'Unknown encoder' >&2; exit 8"] {
        let (code, message) = with_ffmpeg(Some(script));
        assert_eq!(code, Some(2), "{message}");
        assert!(
            message.contains("out.mp4: cannot be written: ffmpeg failed") && message.contains("Unknown encoder"),
            "{message}"
        );
        assert_eq!(fs::read(folder.file("out.mp4")).expect("it is still there"), b"old");
        assert_eq!(names(), ["out.mp4"], "{message}");
    }
}

#[test]
fn manual_pages_are_there_for_every_command() {
    let folder = Folder::new();
    let page = folder.succeed(&["man"]);
    assert!(page.contains(".TH vitrum 1") && page.contains("Exit codes: 0 done"), "{page}");
    let page = folder.succeed(&["man", "render"]);
    assert!(page.contains(".TH vitrum-render 1") && page.contains("\\-\\-output"), "{page}");
    folder.succeed(&["man", "-o", "pages/man1"]);
    let pages =
        fs::read_dir(folder.file("pages/man1")).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut pages: Vec<_> = pages.map(|name| name.to_string_lossy().into_owned()).collect();
    pages.sort();
    for command in [
        "render",
        "turntable",
        "view",
        "info",
        "diff",
        "scene",
        "devices",
        "presets",
        "scenes",
        "schema",
        "completions",
        "man",
    ] {
        assert!(pages.contains(&format!("vitrum-{command}.1")), "{command}: {pages:?}");
    }
    assert!(pages.contains(&"vitrum.1".to_owned()), "{pages:?}");
    folder.refuse(&["man", "rendr"], 2, &["no command `rendr`", "did you mean `render`?"]);
    folder.refuse(&["man", "-o", "/proc/pages"], 2, &["cannot be written"]);
}
