//! Advice of the program: the flags that do what errors and assumptions of the library ask for.

use vitrum::backend::BackendError;
use vitrum::io::{Assumption, Error, Found, Setting};

/// The advice on a failure of a backend.
pub fn on_backend(error: &BackendError) -> Option<&'static str> {
    match error {
        BackendError::NoAdapter { .. } => Some(
            "use --backend cpu, or install a Vulkan driver (Debian: mesa-vulkan-drivers libvulkan1); `vitrum devices` lists what is found",
        ),
        BackendError::Unsupported { .. } | BackendError::DeviceLost { .. } => {
            Some("use --backend cpu, or another adapter (--adapter)")
        }
        BackendError::TooLarge { .. } | BackendError::OutOfMemory { .. } => Some(
            "use --backend cpu, a smaller picture (--size), a smaller volume, or fewer `beams.rays` and `beams.segments`",
        ),
        BackendError::VolumeLimit { asked_for: true, .. } => Some("allow as much (--memory-limit), or set no limit"),
        BackendError::VolumeLimit { asked_for: false, .. } => Some("use --backend cpu, or a smaller volume"),
        BackendError::Threads { .. } => Some("ask for fewer (--threads)"),
        BackendError::Misuse { .. } | BackendError::Cancelled => None,
    }
}

/// The message of a file's error, and this program's advice.
pub fn on_error(error: &Error) -> (String, Option<String>) {
    match error {
        Error::UnknownFormat { file, found, expected } => {
            let help = match found {
                Found::Folder => "give a folder that has them, TIFF files in it and not below it, or a file".to_owned(),
                Found::Mesh => "make a volume of it by `vitrum voxelize`, or say by --raw how voxels without a header \
                                are laid out"
                    .to_owned(),
                _ => {
                    format!(
                        "convert it to one of: {expected}; or say by --raw how voxels without a header are laid out"
                    )
                }
            };
            (format!("{file}: {found}"), Some(help))
        }
        Error::UnknownLayout { file, problem } => {
            let help = "say it by --raw, such as --raw 256x256x109:u8 or 64x64x32:i16:be:skip=512, or rename the file, \
                        such as NAME_256x256x109_uint8.raw; if a header lies beside it, open that";
            (format!("{file}: {problem}"), Some(help.to_owned()))
        }
        error => {
            let mut message = error.to_string();
            let Some(advice) = error.advice().filter(|advice| !advice.is_empty()) else { return (message, None) };
            // The library's messages end in their advice.
            if let Some(head) = message.strip_suffix(advice).and_then(|head| head.strip_suffix("; ")) {
                message.truncate(head.len());
            }
            let help = match error.setting().and_then(flag) {
                Some(flag) => format!("{advice} ({flag})"),
                None => advice.to_owned(),
            };
            (message, Some(help))
        }
    }
}

/// An assumption of a reader, with the flag that replaces it.
pub fn on_assumption(assumption: &Assumption) -> String {
    let Assumption { fact, choices, .. } = assumption;
    match assumption.setting {
        Some(Setting::Up) => format!(
            "{fact}; --up turns it, such as --up -z where the picture stands on its head, and --up y or --up -y where it lies"
        ),
        Some(Setting::Spacing) => format!("{fact}; --spacing X,Y,Z says it"),
        Some(setting) => match flag(setting) {
            Some(flag) if choices.is_empty() => format!("{fact}; {flag} takes another"),
            Some(flag) => format!("{fact}; {flag} takes another: {choices}"),
            None => assumption.to_string(),
        },
        None => assumption.to_string(),
    }
}

/// The assumptions of a reader, and what it left out, each under a name that stands before the first of its kind.
pub fn on_assumptions(assumptions: &[Assumption]) -> Vec<(&'static str, String)> {
    const LEFT_OUT: &str = "left out: ";
    let mut rows = Vec::new();
    for (name, is_left_out) in [("assumed", false), ("left out", true)] {
        let kind = assumptions.iter().filter(|assumption| assumption.fact.starts_with(LEFT_OUT) == is_left_out);
        for (index, assumption) in kind.enumerate() {
            let told = on_assumption(assumption);
            let told = told.strip_prefix(LEFT_OUT).map(str::to_owned).unwrap_or(told);
            rows.push((if index == 0 { name } else { "" }, told));
        }
    }
    rows
}

/// The flag that sets a choice of the library.
fn flag(setting: Setting) -> Option<&'static str> {
    match setting {
        Setting::Raw => Some("--raw"),
        Setting::Array => Some("--array"),
        Setting::Time => Some("--time"),
        Setting::Spacing => Some("--spacing"),
        Setting::Up => Some("--up"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use vitrum::io::{OpenOptions, open_bytes};

    #[test]
    fn the_advice_of_errors_names_flags() {
        let options = OpenOptions { time: Some(1), ..OpenOptions::default() };
        for (name, options, message, help) in [
            (
                "a.dat",
                &OpenOptions::default(),
                "a.dat: neither the content nor the extension",
                "convert it to one of: NRRD",
            ),
            ("a.dat", &OpenOptions::default(), "volume format", "or say by --raw how voxels"),
            ("a.stl", &OpenOptions::default(), "this is a mesh", "`vitrum voxelize`, or say by --raw"),
            (
                "a.raw",
                &OpenOptions::default(),
                "a.raw: the file has no header",
                "say it by --raw, such as --raw 256x256x109:u8",
            ),
            (
                "a_1x1x1_uint8.raw",
                &options,
                "the point in time 1 is asked for",
                "leave out the time, or give 0 (--time)",
            ),
        ] {
            let error = open_bytes(name, &[1], options).expect_err(name);
            let told = on_error(&error);
            assert!(told.0.contains(message) && !told.0.contains("--"), "{told:?}");
            assert!(told.1.as_ref().is_some_and(|told| told.contains(help)), "{told:?}");
        }
        let error = vitrum::io::open(Path::new("no such file"), &OpenOptions::default()).expect_err("no file");
        assert_eq!(on_error(&error).1.as_deref(), Some("check the path"));
    }

    #[test]
    fn assumptions_name_the_flag_that_replaces_them() {
        let volume = open_bytes("a_1x1x1_uint8.raw", &[1], &OpenOptions::default()).expect("a voxel");
        let told: Vec<_> = volume.source.assumptions.iter().map(on_assumption).collect();
        assert!(told.iter().any(|note| note.contains("no orientation") && note.contains("--up -z")), "{told:?}");
        let header = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 1 1 1 3\nencoding: raw\n\nabc";
        let volume = open_bytes("a.nrrd", header.as_bytes(), &OpenOptions::default()).expect("a voxel at three times");
        let told: Vec<_> = volume.source.assumptions.iter().map(on_assumption).collect();
        assert!(
            told.iter().any(|note| note.ends_with("the first was taken; --time takes another: 0 to 2")),
            "{told:?}"
        );
    }
}
