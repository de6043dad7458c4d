//! What the program tells about itself: scene keys, completions, examples, and what was meant by a slip.

mod common;

use common::Folder;
use serde_json::Value;
use std::process::Command;

#[test]
fn keys_are_listed_with_unit_range_default_and_meaning() {
    let folder = Folder::new();
    let azimuth = folder.succeed(&["keys", "light.0.azimuth"]);
    assert!(azimuth.starts_with("light.0.azimuth  (degrees; any; default "), "{azimuth}");
    assert!(azimuth.contains("\n    Side that a distant light comes from"), "{azimuth}");
    assert_eq!(folder.succeed(&["keys", "light.azimuth"]), azimuth, "an index may be left out");
    let camera = folder.succeed(&["keys", "camera"]);
    assert!(
        camera
            .lines()
            .filter(|line| !line.starts_with(' ') && !line.is_empty())
            .all(|line| line.starts_with("camera."))
    );
    assert!(folder.succeed(&["keys", "radius"]).contains("light.0.angular_radius"), "words inside of keys are found");
    let all: Value = serde_json::from_str(&folder.succeed(&["keys", "--json"])).expect("JSON");
    let all = all.as_array().expect("a list");
    // Every key of the schema: those that a scene of the defaults has are a part of them.
    assert!(all.len() > 120, "{}", all.len());
    for key in all {
        assert!(key["meaning"].as_str().is_some_and(|meaning| meaning.len() > 8), "{key}");
        let setting = key["key"].as_str().expect("a path");
        let refused = folder.vitrum(&["scene", "builtin:ball", "--set", &format!("{setting}={{}}")]);
        assert!(!refused.stderr.contains("unknown key"), "{setting} is a key: {}", refused.stderr);
    }
    folder.refuse(&["keys", "camera.azimut2"], 2, &["did you mean `vitrum keys camera.azimuth`?"]);
}

/// What the program offers at the last of `words`.
fn offered(folder: &Folder, words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_vitrum"))
        .env("VITRUM_COMPLETE", "fish")
        .args(["--", "vitrum"])
        .args(words)
        .current_dir(folder.path())
        .output()
        .expect("the program starts");
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn shells_are_offered_names() {
    let folder = Folder::new();
    folder.write("scan.nrrd", "");
    for (words, expected) in [
        (&["render", "builtin:superno"][..], "builtin:supernova/3"),
        (&["render", "sc"], "scan.nrrd"),
        (&["render", "--preset", "am"], "amber"),
        (&["render", "--medium", "fo"], "fog"),
        (&["render", "--set", "camera.azi"], "camera.azimuth="),
        (&["render", "--aov", "dep"], "depth="),
        (&["keys", "sweep.lig"], "sweep.light"),
    ] {
        let offered = offered(&folder, words);
        assert!(offered.lines().any(|line| line.split('\t').next() == Some(expected)), "{words:?}: {offered}");
    }
}

#[cfg(unix)]
#[test]
fn bash_completes_words_with_colons() {
    let folder = Folder::new();
    if Command::new("bash").arg("--version").output().is_err() {
        return;
    }
    folder.write("completions.bash", folder.succeed(&["completions", "bash"]));
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_vitrum")).parent().expect("a folder").display().to_string();
    let complete = |words: &str, current: &str| {
        let script = format!(
            "PATH={program}:$PATH; . ./completions.bash; COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); \
             _clap_complete_vitrum vitrum '{current}'; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        );
        let output = Command::new("bash").args(["-c", &script]).current_dir(folder.path()).output().expect("bash");
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    assert_eq!(complete("vitrum render builtin : lune", "lune"), "luneburg\nluneburg/fog\n");
    assert!(complete("vitrum render builtin :", "").lines().any(|line| line == "ball"));
    assert!(complete("vitrum render --preset bo", "bo").lines().any(|line| line == "bone"));
}

#[test]
fn what_was_meant_is_told() {
    let folder = Folder::new();
    let set = |setting: &str, words: &[&str]| {
        folder.refuse(&["scene", "builtin:ball", "--set", setting], 2, words);
    };
    set("zoom=2", &["`zoom`", "unknown key", "did you mean `camera.zoom`?"]);
    set("angular_radius=2", &["did you mean `light.0.angular_radius`?"]);
    set("camera.zom=2", &["did you mean `camera.zoom`?"]);
    set("ground.color=whitish", &["or a colour such as \"white\" or \"#fff\""]);
    folder.refuse(&["info", "supernova"], 3, &["did you mean `builtin:supernova`?"]);
    folder.refuse(&["scene", "builtin:supernva"], 2, &["did you mean `builtin:supernova`?"]);
    folder.refuse(&["scene", "builtin:ball", "--set", "volume.builtin=bal"], 3, &["did you mean `ball`?"]);
}

#[test]
fn colors_are_written_by_name() {
    let folder = Folder::new();
    let scene = folder.succeed(&["scene", "builtin:ball", "--set", "ground.color=red", "--set", "light.0.color=#ff0"]);
    assert!(scene.contains("color = [1.0, 0.0, 0.0]") && scene.contains("color = [1.0, 1.0, 0.0]"), "{scene}");
}

#[test]
fn scenes_are_written_briefly_with_comments() {
    let folder = Folder::new();
    let change = ["scene", "builtin:ball", "--set", "camera.azimuth=40"];
    let brief = folder.succeed(&change);
    let all = folder.succeed(&[&change[..], &["--all"]].concat());
    assert!(brief.contains("azimuth = 40.0") && !brief.contains("supersampling"), "{brief}");
    assert!(all.contains("azimuth = 40.0") && all.contains("supersampling = 1"), "{all}");
    assert!(brief.lines().any(|line| line.starts_with("# ") && line.contains("degrees")), "{brief}");
    folder.write("brief.toml", &brief);
    assert_eq!(folder.succeed(&["scene", "brief.toml", "--all"]), all, "nothing is lost");
}

#[test]
fn topics_are_told_from_one_text() {
    let folder = Folder::new();
    let program = folder.succeed(&["--help"]);
    let (_, listed) = program.split_once("Topics of `vitrum help TOPIC`:\n").expect("topics are listed");
    let topics: Vec<&str> = listed.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert_eq!(topics, ["scene", "presets", "files", "transfer", "output", "exit-codes"]);
    for topic in &topics {
        let text = folder.succeed(&["help", topic]);
        assert!(text.lines().count() > 5, "{topic}: {text}");
        assert!(text.lines().all(|line| line.chars().count() <= 110 || line.starts_with("  ")), "{topic}: {text}");
        // What it names is there: commands and flags.
        for command in text.lines().filter_map(|line| line.strip_prefix("  vitrum ")) {
            let name = command.split(' ').next().expect("a word");
            let help = folder.succeed(&[name, "--help"]);
            for flag in command.split(' ').filter(|word| word.starts_with("--")) {
                assert!(help.contains(flag), "{topic}: vitrum {command}");
            }
        }
    }
    let render = folder.succeed(&["render", "--help"]);
    for (topic, names) in [
        ("transfer", &["--window", "--level", "--threshold", "--colormap", "--transfer"][..]),
        ("files", &["--raw", "--spacing", "--up", "--array", "--time", ".nii.gz", ".stl"]),
        ("output", &["--aov", "--stats", "--bits", "--annotations", "hard links"]),
        ("presets", &["amber", "jade", "fog", "viridis"]),
        ("scene", &["Usage: vitrum scene", "--set camera.azimuth=60"]),
    ] {
        let text = folder.succeed(&["help", topic]);
        for name in names {
            assert!(text.contains(name), "{topic} tells of {name}: {text}");
            assert!(!name.starts_with("--") || name.contains(' ') || render.contains(name), "{name} is a flag");
        }
    }
    // The exit codes are those of the program's help, whichever way they are written.
    let codes = folder.succeed(&["help", "exit", "codes"]);
    assert_eq!(codes, folder.succeed(&["help", "Exit-Codes"]));
    let program = program.split_whitespace().collect::<Vec<_>>().join(" ");
    for line in codes.lines().filter(|line| line.starts_with("  ")) {
        let told = line.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(program.contains(&told), "{told}");
    }
    // Commands are told of as ever, and slips are found.
    assert!(folder.succeed(&["help", "render"]).contains("Usage: vitrum render"));
    folder.refuse(&["help", "transfr"], 2, &["there is no command and no topic `transfr`", "`vitrum help transfer`?"]);
}
