//! The Vulkan driver that the GPU backend's tests need.
//!
//! Mesa's lavapipe runs Vulkan on the processor, so a machine without a GPU tests both backends too. On Debian and
//! Ubuntu, and if the user is root, a missing driver is installed.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{program, run};
use crate::distribution::Distribution;
use crate::failure::Failure;

/// Makes sure that there is a Vulkan loader and a driver, and says which.
pub fn require_driver() -> Result<String, Failure> {
    if !cfg!(target_os = "linux") {
        return Ok("the operating system's own".to_owned());
    }
    find_driver().or_else(|missing| {
        let distribution = Distribution::of_this_machine();
        if distribution == Distribution::Debian && is_root() {
            eprintln!("xtask: {}; installing Mesa's software driver", missing.message);
            install_on_debian()?;
            return find_driver();
        }
        Err(Failure::setup(format!("{}: {}", missing.message, distribution.advice())))
    })
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

fn install_on_debian() -> Result<(), Failure> {
    let packages = ["mesa-vulkan-drivers", "libvulkan1"];
    run(program("apt-get").arg("update"))?;
    let mut install = program("apt-get");
    install.args(["install", "--yes", "--no-install-recommends"]).args(packages);
    run(install.env("DEBIAN_FRONTEND", "noninteractive"))
}

fn is_root() -> bool {
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
    fn what_is_not_there_is_not_found() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(manifests(&[folder.path().join("nothing"), folder.path().to_owned()]), Vec::<PathBuf>::new());
    }
}
