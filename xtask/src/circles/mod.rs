//! `cargo xtask circles`: groups of files that need each other, in each crate.
//!
//! The files of a crate and their uses of each other's items make a graph. Files that reach each other along its arrows
//! are a circle: none of them can be read, moved or tested without the others. A circle is small, or it is a fault.

mod components;
mod names;
mod source;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use self::components::components;
use self::names::Use;
use self::source::Modules;
use crate::command::root;
use crate::failure::Failure;

/// Files of the largest circle that passes.
const LARGEST: usize = 3;

/// Print the groups of files that use each other in a circle, for each crate, and fail where one has more than three files.
#[derive(clap::Args, Default)]
pub struct Arguments {
    /// Crates by their names; all if there is none.
    crates: Vec<String>,
    /// Print the items for which each file of a circle uses another.
    #[arg(long)]
    uses: bool,
    /// Count also what a file names by a path relative to its own submodules.
    #[arg(long)]
    relative: bool,
}

/// Prints the circles, and fails where one is too large.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let roots = crate_roots(&root())?;
    if let Some(unknown) = arguments.crates.iter().find(|name| !roots.iter().any(|(known, _)| known == *name)) {
        let known: BTreeSet<&str> = roots.iter().map(|(name, _)| name.as_str()).collect();
        let known = known.into_iter().collect::<Vec<_>>().join(", ");
        return Err(Failure::setup(format!("there is no crate `{unknown}`; the crates are: {known}")));
    }
    let chosen = |(name, _): &(String, PathBuf)| arguments.crates.is_empty() || arguments.crates.contains(name);
    check(&roots.into_iter().filter(chosen).collect::<Vec<_>>(), arguments)
}

/// Prints the circles of crates, given by their names and root modules, and fails where one is too large.
fn check(crates: &[(String, PathBuf)], arguments: &Arguments) -> Result<(), Failure> {
    let mut too_large = Vec::new();
    for (name, file) in crates {
        let graph = Graph::of_crate(file, arguments.relative)?;
        print!("{}", graph.describe(name, arguments.uses));
        let largest = graph.circles().iter().map(Vec::len).max().unwrap_or(0);
        if largest > LARGEST {
            too_large.push(format!("{name} ({largest} files)"));
        }
    }
    if too_large.is_empty() {
        return Ok(());
    }
    let crates = too_large.join(", ");
    Err(Failure::check(format!("circles of more than {LARGEST} files: {crates}; `--uses` shows why")))
}

/// The files of a crate, and their uses of each other's items.
struct Graph {
    /// Paths relative to the crate's source folder.
    files: Vec<String>,
    uses: Vec<Use>,
}

impl Graph {
    /// The graph of the crate whose root module is `file`; [`names::uses`] says what `relative` adds.
    fn of_crate(file: &Path, relative: bool) -> Result<Self, Failure> {
        let modules = Modules::read(file)?;
        let base = file.parent().unwrap_or(Path::new(""));
        let inside = |file: &PathBuf| file.strip_prefix(base).unwrap_or(file).display().to_string();
        Ok(Self { files: modules.files.iter().map(inside).collect(), uses: names::uses(&modules, relative) })
    }

    /// Sets of at least two files that reach each other, the largest first, as indices of files.
    fn circles(&self) -> Vec<Vec<usize>> {
        let arrows: BTreeSet<(usize, usize)> = self.uses.iter().map(|used| (used.from, used.to)).collect();
        let mut circles = components(self.files.len(), &arrows);
        circles.retain(|circle| circle.len() > 1);
        circles.sort_by_key(|circle| (std::cmp::Reverse(circle.len()), circle.clone()));
        circles
    }

    /// A line for the crate, and one for each circle; with `uses`, one for each arrow in it.
    fn describe(&self, name: &str, uses: bool) -> String {
        let circles = self.circles();
        let mut text = match &circles[..] {
            [] => format!("{name}: {} files, no circles\n", self.files.len()),
            [largest, ..] => {
                let (files, count, largest) = (self.files.len(), circles.len(), largest.len());
                format!("{name}: {files} files, {count} circles, the largest of {largest} files\n")
            }
        };
        for circle in &circles {
            let files: Vec<&str> = circle.iter().map(|&file| self.files[file].as_str()).collect();
            text.push_str(&format!("  {}: {}\n", files.len(), files.join(", ")));
            let inside = |used: &&Use| circle.contains(&used.from) && circle.contains(&used.to);
            let mut arrows: Vec<(usize, usize, Vec<&str>)> = Vec::new();
            for used in self.uses.iter().filter(inside).filter(|_| uses) {
                match arrows.iter_mut().find(|(from, to, _)| (*from, *to) == (used.from, used.to)) {
                    Some((.., names)) => names.push(&used.name),
                    None => arrows.push((used.from, used.to, vec![&used.name])),
                }
            }
            for (from, to, names) in arrows {
                text.push_str(&format!("    {} uses {} of {}\n", self.files[from], names.join(", "), self.files[to]));
            }
        }
        text
    }
}

/// Names and root modules of the crates under `crates` and of `shaders-rs`; a crate with a library and a program has two.
fn crate_roots(workspace: &Path) -> Result<Vec<(String, PathBuf)>, Failure> {
    let folder = workspace.join("crates");
    let unreadable = |error| Failure::setup(format!("{}: {error}", folder.display()));
    let entries = fs::read_dir(&folder).and_then(Iterator::collect::<Result<Vec<_>, _>>).map_err(unreadable)?;
    let mut folders: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path()).collect();
    folders.push(workspace.join("shaders-rs"));
    folders.sort();
    let mut roots = Vec::new();
    for folder in folders {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let files = ["src/lib.rs", "src/main.rs"].map(|file| folder.join(file));
        roots.extend(files.into_iter().filter(|file| file.is_file()).map(|file| (name.clone(), file)));
    }
    Ok(roots)
}
