//! The Vulkan driver that the GPU backend's tests need.
//!
//! Mesa's lavapipe runs Vulkan on the processor, so a machine without a GPU tests both backends too. On Debian and
//! Ubuntu, and if the user is root, a missing driver is installed, unless the user forbids it.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{program, run};
use crate::distribution::Distribution;
use crate::failure::Failure;

/// Whether a missing driver may be installed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Installation {
    /// It may, where xtask knows how and the user is root.
    Allowed,
    /// Nothing is installed, and a machine without a driver does without.
    Forbidden,
}

/// The driver that tests of the GPU backend run on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Driver {
    /// Its manifest, or another name.
    Found(String),
    /// There is none: the missing part, and the command that installs it.
    Missing(String),
}

/// The course that xtask takes on a machine without a driver.
#[derive(Debug, PartialEq, Eq)]
enum Course {
    Install(&'static [&'static str]),
    GoWithout,
    Fail,
}

impl Course {
    fn of(installation: Installation, distribution: Distribution, is_root: bool) -> Self {
        match (installation, distribution.installation()) {
            (Installation::Forbidden, _) => Self::GoWithout,
            (Installation::Allowed, Some(command)) if distribution == Distribution::Debian && is_root => {
                Self::Install(command)
            }
            (Installation::Allowed, _) => Self::Fail,
        }
    }
}

/// Makes sure that there is a Vulkan loader and a driver.
pub fn require_driver() -> Result<(), Failure> {
    driver(Installation::Allowed).map(drop)
}

/// The machine's driver. One that is missing is installed where that is allowed and possible; the commands are shown first.
///
/// Fails where it is missing and allowed, but not possible.
pub fn driver(installation: Installation) -> Result<Driver, Failure> {
    if !cfg!(target_os = "linux") {
        return Ok(Driver::Found("the operating system's own".to_owned()));
    }
    let missing = match find_driver() {
        Ok(driver) => return Ok(Driver::Found(driver)),
        Err(failure) => failure.message,
    };
    let distribution = Distribution::of_this_machine();
    match Course::of(installation, distribution, is_root()) {
        Course::Install(command) => {
            eprintln!(
                "xtask: {missing}; Mesa's software driver will be installed (--no-install of `test` goes without):"
            );
            eprintln!("  {}\n  {}", UPDATE.join(" "), command.join(" "));
            [UPDATE, command].into_iter().try_for_each(run_apt)?;
            find_driver().map(Driver::Found)
        }
        Course::GoWithout => Ok(Driver::Missing(format!("{missing}; {}", distribution.advice()))),
        Course::Fail => Err(Failure::setup(format!(
            "{missing}: {}; `cargo xtask test --no-install` runs the tests that need none",
            distribution.advice()
        ))),
    }
}

/// The driver that the Vulkan loader finds, or an error that names the missing part.
fn find_driver() -> Result<String, Failure> {
    if !has_loader() {
        return Err(Failure::setup("there is no Vulkan loader (libvulkan.so.1)"));
    }
    let places = manifest_places();
    let manifests = manifests(&places);
    let lavapipe = manifests.iter().find(|path| file_name(path).starts_with("lvp_icd"));
    lavapipe.or(manifests.first()).map(|manifest| manifest.display().to_string()).ok_or_else(|| {
        let places: Vec<String> = places.iter().map(|place| place.display().to_string()).collect();
        Failure::setup(format!(
            "there is no Vulkan driver (no manifest such as lvp_icd.*.json in {})",
            places.join(", ")
        ))
    })
}

/// The command that fetches Debian's lists of packages, without which it may find none.
pub const UPDATE: &[&str] = &["apt-get", "update"];

pub fn run_apt(command: &[&str]) -> Result<(), Failure> {
    run(program(command[0]).args(&command[1..]).env("DEBIAN_FRONTEND", "noninteractive"))
}

pub fn is_root() -> bool {
    Command::new("id").arg("-u").output().is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

/// Whether the dynamic linker finds the Vulkan loader.
fn has_loader() -> bool {
    let cached = ["ldconfig", "/sbin/ldconfig"].into_iter().any(|ldconfig| {
        let output = Command::new(ldconfig).arg("-p").output();
        output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).contains("libvulkan.so.1"))
    });
    let folders = env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let folders = env::split_paths(&folders).chain(["/usr/lib", "/usr/lib64", "/usr/local/lib"].map(PathBuf::from));
    cached || folders.into_iter().any(|folder| folder.join("libvulkan.so.1").exists())
}

/// The folders in which the Vulkan loader looks for manifests of drivers: the ones in the environment's variables, or else the usual
/// ones.
fn manifest_places() -> Vec<PathBuf> {
    let named = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"].into_iter().find_map(env::var_os);
    if let Some(named) = named {
        return env::split_paths(&named).collect();
    }
    let home = env::var_os("HOME").map(|home| Path::new(&home).join(".local/share"));
    let data = env::var_os("XDG_DATA_DIRS").unwrap_or_else(|| "/usr/local/share:/usr/share".into());
    let folders = home.into_iter().chain(["/etc".into()]).chain(env::split_paths(&data));
    folders.map(|folder| folder.join("vulkan/icd.d")).collect()
}

/// The manifests in these places, each a manifest or a folder of them.
fn manifests(places: &[PathBuf]) -> Vec<PathBuf> {
    let is_manifest = |path: &PathBuf| path.is_file() && path.extension().is_some_and(|extension| extension == "json");
    let mut manifests: Vec<PathBuf> = Vec::new();
    for place in places {
        let entries = place.read_dir().into_iter().flatten().flatten().map(|entry| entry.path());
        manifests.extend(entries.chain([place.clone()]).filter(is_manifest));
    }
    manifests.sort();
    manifests
}

fn file_name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn manifests_are_found_in_folders_and_by_name() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["lvp_icd.x86_64.json", "readme.txt", "a_icd.json"] {
            fs::write(folder.path().join(name), "{}").unwrap();
        }
        let names = |places: &[PathBuf]| -> Vec<String> {
            manifests(places).iter().map(|path| file_name(path).to_owned()).collect()
        };
        assert_eq!(names(&[folder.path().to_owned()]), ["a_icd.json", "lvp_icd.x86_64.json"]);
        assert_eq!(names(&[folder.path().join("lvp_icd.x86_64.json")]), ["lvp_icd.x86_64.json"]);
    }

    #[test]
    fn only_root_on_debian_installs_and_only_where_that_is_allowed() {
        let installs = |installation, distribution, is_root| matches!(Course::of(installation, distribution, is_root), Course::Install(command) if command.contains(&"libvulkan1"));
        assert!(installs(Installation::Allowed, Distribution::Debian, true));
        for (distribution, is_root) in
            [(Distribution::Debian, false), (Distribution::Fedora, true), (Distribution::Other, true)]
        {
            assert_eq!(Course::of(Installation::Allowed, distribution, is_root), Course::Fail);
        }
        for distribution in [Distribution::Debian, Distribution::Other] {
            assert_eq!(Course::of(Installation::Forbidden, distribution, true), Course::GoWithout);
        }
    }

    #[test]
    fn what_is_not_there_is_not_found() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(manifests(&[folder.path().join("nothing"), folder.path().to_owned()]), Vec::<PathBuf>::new());
    }
}
