//! Failures around a render: time that runs out, full disks, folders that cannot be written, signals. After each of them, a path has a
//! whole output or its previous content.

#![cfg(unix)]

mod common;

use common::Folder;
use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const SMALL: [&str; 7] = ["builtin:ball", "--set", "volume.resolution=16", "--size", "64x48", "--backend", "cpu"];

/// Work that no test waits for: what ends it is the matter.
const ENDLESS: [&str; 2] = ["--frames", "100000"];

fn arguments<'a>(command: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&[command][..], &SMALL, more].concat()
}

fn start(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vitrum"));
    command.args(arguments).current_dir(folder.path()).stderr(Stdio::null());
    command.spawn().expect("the program starts")
}

/// Waits until something holds, for as long as the slowest machine may take.
fn wait_until(mut holds: impl FnMut() -> bool) {
    let start = Instant::now();
    while !holds() {
        assert!(start.elapsed() < Duration::from_secs(120), "it did not come to that");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn parts(folder: &Folder) -> usize {
    folder.names().iter().filter(|name| name.ends_with(".part")).count()
}

#[test]
fn a_timeout_exits_124_and_leaves_no_output() {
    let folder = Folder::new();
    let limit = ["--timeout", "0.5", "--quiet"];
    for more in [&["-o", "out.png", "--stats", "out.json"][..], &["-o", "out.exr"]] {
        folder.refuse(&[&arguments("render", more)[..], &ENDLESS, &limit].concat(), 124, &["--timeout", "--size"]);
    }
    folder.refuse(&[&arguments("turntable", &["-o", "out.gif"])[..], &ENDLESS, &limit].concat(), 124, &["--timeout"]);
    folder.write("out.png", "old");
    folder.refuse(&[&arguments("render", &["-o", "out.png"])[..], &ENDLESS, &limit].concat(), 124, &["--timeout"]);
    assert_eq!(fs::read(folder.file("out.png")).expect("it is still there"), b"old");
    // Work that takes less time is not touched by the limit.
    folder.succeed(&arguments("render", &["-o", "out.png", "--timeout", "600"]));
    for wrong in ["0", "-1", "nan", "soon"] {
        let outcome = folder.vitrum(&arguments("render", &["-o", "other.png", "--timeout", wrong]));
        assert_eq!(outcome.code, Some(2), "{}", outcome.stderr);
    }
}

#[test]
fn pictures_in_a_folder_are_whole_when_it_is_interrupted() {
    let folder = Folder::new();
    let mut child = start(&folder, &[&arguments("turntable", &["-o", "turn"])[..], &ENDLESS].concat());
    wait_until(|| folder.file("turn/frame-00002.png").exists());
    let killed = Command::new("kill").args(["-TERM", &child.id().to_string()]).status();
    assert!(killed.expect("kill is there").success());
    assert_eq!(child.wait().expect("the program ends").code(), Some(130));
    for entry in fs::read_dir(folder.file("turn")).expect("the folder is there") {
        vitrum_io::read_picture(&entry.expect("an entry").path()).expect("a whole picture, and nothing else");
    }
}

/// A limit on the size of files stops a write in its middle as a full disk does, and needs no disk to fill.
#[test]
fn a_disk_that_fills_up_leaves_the_old_file_and_no_other() {
    let folder = Folder::new();
    for (name, command) in
        [("out.png", "render"), ("out.exr", "render"), ("out.tif", "render"), ("out.gif", "turntable")]
    {
        folder.write(name, "old");
        let script = "trap '' XFSZ; ulimit -f 1; exec \"$@\"";
        let output = Command::new("sh")
            .args(["-c", script, "sh", env!("CARGO_BIN_EXE_vitrum")])
            .args(arguments(command, &["-o", name, "--frames", "3"]))
            .current_dir(folder.path())
            .output()
            .expect("a shell");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(message.contains(&format!("error: {name}: cannot be written: ")), "{message}");
        assert!(message.contains("help: check the free space on the disk"), "{message}");
        assert_eq!(fs::read(folder.file(name)).expect("it is still there"), b"old", "{name}");
    }
    assert_eq!(folder.names(), ["out.exr", "out.gif", "out.png", "out.tif"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_behind_standard_output_exits_2() {
    let folder = Folder::new();
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
    for arguments in [&["schema"][..], &["info", "builtin:ball", "--json"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_vitrum"));
        let output = command.args(arguments).current_dir(folder.path()).stdout(full()).stderr(Stdio::piped()).output();
        let output = output.expect("the program starts");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("standard output cannot be written"), "{message}");
    }
    // A device is no place for a file that is renamed into it.
    folder.refuse(&arguments("render", &["-o", "out.png", "--stats", "/dev/full"]), 2, &["/dev/full", "device"]);
}

#[test]
fn folders_that_cannot_be_written_are_refused_before_any_work() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let locked = folder.file("locked");
    fs::create_dir(&locked).expect("the folder is writable");
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o555)).expect("it is ours");
    let mut places = vec!["locked"];
    // The system's administrator may write there all the same, but not to where no files are.
    if fs::write(locked.join("probe"), "").is_ok() {
        fs::remove_file(locked.join("probe")).expect("it was just written");
        places.clear();
    }
    if cfg!(target_os = "linux") {
        places.push("/proc");
    }
    for place in places {
        for (command, file) in [("render", "out.png"), ("turntable", "out.gif"), ("turntable", "out.png")] {
            let path = format!("{place}/{file}");
            folder.refuse(
                &[&arguments(command, &["-o", &path])[..], &ENDLESS].concat(),
                2,
                &[file, "cannot be", place],
            );
        }
    }
}

#[test]
fn signals_in_the_middle_of_a_film_leave_what_was_there() {
    for (signal, code, left) in
        [("TERM", Some(130), 0), ("INT", Some(130), 0), ("HUP", Some(130), 0), ("KILL", None, 1)]
    {
        let folder = Folder::new();
        folder.write("out.png", "old");
        let mut child = start(&folder, &[&arguments("turntable", &["-o", "out.png"])[..], &ENDLESS].concat());
        let part = |folder: &Folder| folder.names().into_iter().find(|name| name.ends_with(".part"));
        // Frames are being added.
        wait_until(|| {
            part(&folder).is_some_and(|name| fs::metadata(folder.file(&name)).is_ok_and(|file| file.len() > 9000))
        });
        let killed = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status();
        assert!(killed.expect("kill is there").success());
        assert_eq!(child.wait().expect("the program ends").code(), code, "{signal}");
        assert_eq!(fs::read(folder.file("out.png")).expect("it is still there"), b"old", "{signal}");
        // Nothing can clean up behind a program that was killed; the next one is not in its way.
        assert_eq!(parts(&folder), left, "{signal}");
        folder.succeed(&arguments("turntable", &["-o", "out.png", "--frames", "2"]));
        assert!(fs::read(folder.file("out.png")).expect("an animation").starts_with(b"\x89PNG"));
    }
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status();
    assert!(sent.expect("kill is there").success());
}

/// The messages of an interrupted program, whose exit code is 130 and whose outputs do not exist.
fn interrupted(child: Child) -> String {
    let output = child.wait_with_output().expect("the program ends");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(130), "{message}");
    assert!(message.contains("error: interrupted\nhelp: no unfinished output was written"), "{message}");
    message
}

#[test]
fn signals_end_every_command_and_leave_no_unfinished_file() {
    for signal in ["TERM", "INT", "HUP"] {
        let folder = Folder::new();
        folder.write("out.nrrd", "old");
        // Seconds of compression.
        folder.write("ball.toml", "[volume]\nbuiltin = \"phantom\"\nresolution = 384\n");
        let mut command = Command::new(env!("CARGO_BIN_EXE_vitrum"));
        command.args(["convert", "ball.toml", "-o", "out.nrrd"]).current_dir(folder.path()).stderr(Stdio::piped());
        let child = command.spawn().expect("the program starts");
        let part = || folder.names().into_iter().find(|name| name.ends_with(".part"));
        wait_until(|| part().is_some_and(|name| fs::metadata(folder.file(&name)).is_ok_and(|file| file.len() > 0)));
        send(signal, &child);
        interrupted(child);
        assert_eq!(folder.names(), ["ball.toml", "out.nrrd"], "{signal}");
        assert_eq!(fs::read(folder.file("out.nrrd")).expect("it is still there"), b"old", "{signal}");
    }
}

/// The program with a standard input that goes on for ever, whose temporary files lie in `folder`.
fn reads_for_ever(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vitrum"));
    command.args(arguments).current_dir(folder.path()).env("TMPDIR", folder.path());
    let mut child = command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    // Ends when the program does.
    std::thread::spawn(move || {
        while std::io::Write::write_all(&mut stdin, &[7; 1 << 16]).is_ok() {
            std::thread::sleep(Duration::from_millis(20));
        }
    });
    child
}

#[test]
fn reading_ends_at_once_and_leaves_no_temporary_file() {
    let folder = Folder::new();
    let spooled = || folder.names().iter().any(|name| name.starts_with("vitrum-"));
    let child = reads_for_ever(&folder, &["info", "-"]);
    wait_until(spooled);
    send("TERM", &child);
    interrupted(child);
    assert_eq!(folder.names(), [""; 0]);
    let render = ["render", "-", "-o", "out.png", "--timeout", "1"];
    let output = reads_for_ever(&folder, &render).wait_with_output().expect("the program ends");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(124), "{message}");
    assert!(message.contains("the time of --timeout is over"), "{message}");
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn a_second_signal_ends_what_does_not_come_to_look() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    // In the role of ffmpeg: one that takes no frame, and makes the program wait.
    fs::create_dir(folder.file("programs")).expect("the folder is writable");
    folder.write("programs/ffmpeg", "#!/bin/sh\n: > started\nexec /bin/sleep 15\n");
    let all = fs::Permissions::from_mode(0o755);
    fs::set_permissions(folder.file("programs/ffmpeg"), all).expect("it is ours");
    let mut command = Command::new(env!("CARGO_BIN_EXE_vitrum"));
    // A frame is larger than what a pipe holds.
    let animation =
        [&["turntable"], &SMALL[..3], &["--size", "256x128", "--backend", "cpu", "-o", "out.mp4"], &ENDLESS];
    let animation = animation.concat();
    command.args(animation).current_dir(folder.path()).env("PATH", folder.file("programs")).stderr(Stdio::piped());
    let child = command.spawn().expect("the program starts");
    wait_until(|| folder.file("started").exists());
    // Long enough for the first frame to be on its way; where it is not yet, the first signal ends the program.
    std::thread::sleep(Duration::from_secs(2));
    send("TERM", &child);
    std::thread::sleep(Duration::from_millis(300));
    let _ = Command::new("kill").args(["-TERM", &child.id().to_string()]).stderr(Stdio::null()).status();
    let message = interrupted(child);
    assert!(!message.contains("panicked"), "{message}");
    assert_eq!(folder.names(), ["programs", "started"]);
}
