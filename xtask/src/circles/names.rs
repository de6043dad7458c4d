//! Resolution of paths between modules: the file that defines an item, through all re-exports.

use std::collections::BTreeSet;

use super::source::{Glob, Meaning, Modules, Names};

/// A use of an item by another file.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Use {
    /// The number of the file that uses it.
    pub from: usize,
    /// The number of the file that defines it.
    pub to: usize,
    pub name: String,
}

/// The target of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Found {
    /// The module of this number.
    Module(usize),
    /// An item that the module of this number defines.
    Item(usize),
}

/// The uses of items of one file by another: by `use` lines and by paths from `crate`, `self` or `super`; with `relative`, also
/// by paths such as `child::function()` and by names that a file re-exports and mentions.
///
/// A module by itself is no item: its file is used where something in it is.
pub fn uses(modules: &Modules, relative: bool) -> Vec<Use> {
    let mut uses = BTreeSet::new();
    for (number, module) in modules.modules.iter().enumerate() {
        let mut paths = module.paths.clone();
        if relative || module.globs.iter().any(|glob| glob.private) {
            let single = |path: &&Names| relative || path.len() == 1;
            paths.extend(module.relative_paths.iter().filter(single).cloned());
        }
        for path in paths {
            let mut resolver = Resolver { modules, visited: BTreeSet::new() };
            // A single name counts here for a glob's alone: a `use` line has it already.
            let by_glob = !relative && path.len() == 1;
            let found = if by_glob { resolver.private_globs(number, &path[0]) } else { resolver.path(number, &path) };
            for found in found {
                let Found::Item(to) = found else { continue };
                let (from, to) = (module.file, modules.modules[to].file);
                if from != to {
                    uses.insert(Use { from, to, name: path.last().cloned().unwrap_or_default() });
                }
            }
        }
    }
    uses.into_iter().collect()
}

/// Follows one path.
struct Resolver<'a> {
    modules: &'a Modules,
    /// Names of modules on the way here, since re-exports may go round.
    visited: BTreeSet<(usize, String)>,
}

impl Resolver<'_> {
    /// The targets of a path in module `number`; empty for a path into another crate.
    fn path(&mut self, number: usize, path: &[String]) -> BTreeSet<Found> {
        let mut here = BTreeSet::from([Found::Module(number)]);
        for (index, name) in path.iter().enumerate() {
            let last = index + 1 == path.len();
            let mut next = BTreeSet::new();
            for found in here {
                match found {
                    // A variant or an associated item belongs to its type.
                    Found::Item(_) => drop(next.insert(found)),
                    Found::Module(module) => next.extend(self.step(module, name)),
                }
            }
            // Before `::` stands a module where there is one of the name; functions may have the name, too.
            if !last && next.iter().any(|found| matches!(found, Found::Module(_))) {
                next.retain(|found| matches!(found, Found::Module(_)));
            }
            here = next;
        }
        here
    }

    /// One name of a path, in a module.
    fn step(&mut self, module: usize, name: &str) -> BTreeSet<Found> {
        match name {
            "crate" => BTreeSet::from([Found::Module(0)]),
            "self" => BTreeSet::from([Found::Module(module)]),
            "super" => self.modules.modules[module].parent.map(Found::Module).into_iter().collect(),
            name => self.name(module, name),
        }
    }

    fn name(&mut self, module: usize, name: &str) -> BTreeSet<Found> {
        if !self.visited.insert((module, name.to_owned())) {
            // An alias of its own name, as in `mod open; use open::open`: the module is what is left.
            let meanings = self.modules.modules[module].names.get(name).into_iter().flatten();
            let submodule = |meaning: &Meaning| match meaning {
                Meaning::Module(number) => Some(Found::Module(*number)),
                _ => None,
            };
            return meanings.filter_map(submodule).collect();
        }
        let mut found = BTreeSet::new();
        let here = &self.modules.modules[module];
        let meanings = here.names.get(name).map(Vec::as_slice).unwrap_or_default();
        for meaning in meanings {
            match meaning {
                Meaning::Module(number) => drop(found.insert(Found::Module(*number))),
                Meaning::Item => drop(found.insert(Found::Item(module))),
                Meaning::Alias(path) => found.extend(self.path(module, path)),
            }
        }
        // An item of its own hides that of a glob; a submodule hides no function.
        if meanings.iter().all(|meaning| matches!(meaning, Meaning::Module(_))) {
            for glob in &here.globs {
                found.extend(self.glob(module, glob, name));
            }
        }
        self.visited.remove(&(module, name.to_owned()));
        found
    }

    /// A name by the glob of a module.
    fn glob(&mut self, module: usize, glob: &Glob, name: &str) -> BTreeSet<Found> {
        let mut found = BTreeSet::new();
        for target in self.path(module, &glob.path) {
            if let Found::Module(target) = target {
                found.extend(self.name(target, name));
            }
        }
        found
    }

    /// A name by the globs that a module does not export again, where it has no such name itself.
    fn private_globs(&mut self, module: usize, name: &str) -> BTreeSet<Found> {
        let here = &self.modules.modules[module];
        if here.names.contains_key(name) {
            return BTreeSet::new();
        }
        here.globs.iter().filter(|glob| glob.private).flat_map(|glob| self.glob(module, glob, name)).collect()
    }
}
