//! Slips that would go unnoticed are told, and outputs are whole, all or none.

mod common;

use common::Folder;
use std::fs;
use std::process::{Command, Stdio};

const BALL: [&str; 8] =
    ["render", "builtin:ball", "--set", "volume.resolution=16", "--size", "32x24", "--backend", "cpu"];

fn ball<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&BALL, more].concat()
}

#[test]
fn a_picture_of_the_environment_that_would_not_show_is_refused() {
    let folder = Folder::new();
    folder.succeed(&ball(&["-o", "sky.hdr"]));
    let with_file = ball(&["-o", "out.png", "--set", "environment.file=sky.hdr"]);
    folder.refuse(&with_file, 2, &["`environment.file`", "does not show", "environment.kind = \"map\""]);
    folder.succeed(&[&with_file[..], &["--set", "environment.kind=map"]].concat());
}

#[test]
fn lengths_and_numbers_are_not_written_as_light() {
    let folder = Folder::new();
    for (name, file) in [("depth", "depth.png"), ("depth", "depth.jpg"), ("status", "status.png")] {
        let aov = format!("{name}={file}");
        folder.refuse(&ball(&["-o", "out.png", "--aov", &aov]), 2, &[file, "goes beyond 1", ".exr or .tif"]);
    }
    folder.succeed(&ball(&["-o", "out.png", "--aov", "depth=depth.tif", "--aov", "opacity=opacity.png"]));
}

#[test]
fn scene_files_are_named_as_such() {
    Folder::new().refuse(&["scene", "builtin:ball", "-o", "ball.json"], 2, &["ball.json", "TOML", "name it .toml"]);
}

#[test]
fn pictures_of_another_scene_are_not_resumed() {
    let folder = Folder::new();
    let turn = |more: &[&str]| {
        let film = ["turntable", "builtin:ball", "--size", "16x16", "--backend", "cpu", "--frames", "3", "-o", "film"];
        folder.vitrum(&[&film[..], &["--set", "volume.resolution=16"], more].concat())
    };
    assert_eq!(turn(&[]).code, Some(0));
    let frame = |index: u32| folder.file(&format!("film/frame-0000{index}.png"));
    let before = fs::read(frame(1)).expect("a picture");
    fs::remove_file(frame(1)).expect("it was there");
    let other = turn(&["--resume", "--set", "ground.color=red"]);
    assert_eq!(other.code, Some(2), "{}", other.stderr);
    assert!(other.stderr.contains("frame-00000.png: this picture is of another scene"), "{}", other.stderr);
    assert!(other.stderr.contains("leave out --resume") && !frame(1).exists(), "{}", other.stderr);
    assert_eq!(turn(&["--resume"]).code, Some(0));
    assert_eq!(fs::read(frame(1)).expect("a picture"), before);
    fs::write(frame(2), "no picture").expect("writable");
    let unknown = turn(&["--resume"]);
    assert!(unknown.code == Some(2) && unknown.stderr.contains("nothing in this file says"), "{}", unknown.stderr);
}

/// The last output cannot be written: the first is not, either.
#[cfg(unix)]
#[test]
fn outputs_appear_together_or_not_at_all() {
    let folder = Folder::new();
    folder.write("out.png", "as it was");
    // 100 blocks of 512 or 1024 bytes hold the PNG, and not three floats for each of 128 x 128 pixels.
    let command = format!(
        "ulimit -f 100; exec '{}' {} -o out.png --aov direction=a.tif --stats s.json",
        env!("CARGO_BIN_EXE_vitrum"),
        BALL.join(" ").replace("32x24", "128x128")
    );
    let output = Command::new("sh").args(["-c", &command]).current_dir(folder.path()).output().expect("a shell");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("a.tif") && message.contains("ulimit -f"), "{message}");
    assert_eq!(folder.names(), ["out.png"]);
    assert_eq!(fs::read_to_string(folder.file("out.png")).expect("it is there"), "as it was");
}

#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_printed_is_a_failure() {
    for arguments in [&["--help"][..], &["--version"], &["render", "--help"], &["keys"]] {
        let full = fs::File::options().write(true).open("/dev/full").expect("Linux has it");
        let mut command = Command::new(env!("CARGO_BIN_EXE_vitrum"));
        let output = command.args(arguments).stdout(Stdio::from(full)).output().expect("the program starts");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && message.contains("standard output cannot be written"), "{message}");
    }
    let folder = Folder::new();
    assert!(folder.succeed(&["--help"]).contains("Examples:"));
    let wrong = folder.vitrum(&["rendr"]);
    assert!(wrong.code == Some(2) && wrong.stderr.contains("render"), "{}", wrong.stderr);
}

#[cfg(unix)]
#[test]
fn outputs_are_written_through_links() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    fs::create_dir(folder.file("far")).expect("writable");
    for (link, target) in [("out.png", "far/one.png"), ("again.png", "out.png"), ("new.png", "far/two.png")] {
        symlink(target, folder.file(link)).expect("links are known");
        if link != "new.png" {
            fs::write(folder.file("far/one.png"), "old").expect("writable");
        }
        folder.succeed(&ball(&["-o", link]));
        assert!(folder.file(link).is_symlink(), "{link} stays a link");
        assert!(fs::read(folder.file(target)).expect("it is there").starts_with(b"\x89PNG"), "{link}");
    }
    assert_eq!(folder.names(), ["again.png", "far", "new.png", "out.png"]);
    symlink("nowhere/out.png", folder.file("lost.png")).expect("links are known");
    folder.refuse(&ball(&["-o", "lost.png"]), 2, &["nowhere"]);
}

#[cfg(unix)]
#[test]
fn other_names_of_an_output_are_told_and_keep_the_old_file() {
    let folder = Folder::new();
    folder.write("out.png", "old");
    for other in ["kept.png", "too.png"] {
        fs::hard_link(folder.file("out.png"), folder.file(other)).expect("hard links are known");
    }
    let told = folder.vitrum(&ball(&["-o", "out.png"]));
    assert!(told.code == Some(0), "{}", told.stderr);
    assert!(told.stderr.contains("note: out.png: the file has 2 more names (hard links)"), "{}", told.stderr);
    assert!(fs::read(folder.file("out.png")).expect("it is there").starts_with(b"\x89PNG"));
    assert_eq!(fs::read(folder.file("kept.png")).expect("it is there"), b"old");
    // The new file has one name.
    let again = folder.vitrum(&ball(&["-o", "out.png"]));
    assert!(again.code == Some(0) && !again.stderr.contains("hard link"), "{}", again.stderr);
    let scene = folder.vitrum(&["scene", "builtin:ball", "--write-transfer", "kept.png"]);
    assert!(scene.stderr.contains("note: kept.png: the file has 1 more name (hard links)"), "{}", scene.stderr);
}

/// The names of outputs in the commands of README.md, each of which `.gitignore` has a line for.
#[test]
fn what_the_commands_of_the_readme_write_is_ignored() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |name: &str| fs::read_to_string(root.join(name)).expect("the repository has it");
    let (readme, ignored) = (read("README.md"), read(".gitignore"));
    let mut outputs = 0;
    for line in readme.lines().filter(|line| line.starts_with("vitrum ") || line.contains("`vitrum ")) {
        let words: Vec<_> = line.split([' ', '`']).collect();
        for pair in words.windows(2).filter(|pair| matches!(pair[0], "-o" | "--aov" | "--stats" | ">")) {
            let file = pair[1].split('=').next_back().unwrap_or(pair[1]);
            let extension = format!("/*.{}", file.rsplit('.').next().unwrap_or_default());
            let known = |line: &str| line == extension || line == format!("/{file}");
            assert!(file.starts_with("/") || ignored.lines().any(known), "{file} is not ignored: {line}");
            outputs += 1;
        }
    }
    assert!(outputs > 8, "{outputs}");
}
