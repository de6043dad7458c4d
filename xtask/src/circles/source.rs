//! The modules of a crate as their files write them: names, and the paths that they use.

use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Expr, Item, ItemMod, ItemUse, Lit, Macro, Meta, UseTree, Visibility};

use crate::failure::Failure;

/// A path of names, such as `crate::error::Error`.
pub type Names = Vec<String>;

/// The meaning of a name in a module.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Meaning {
    /// The module of this number.
    Module(usize),
    /// An item that the module defines.
    Item,
    /// The path that a `use` line names.
    Alias(Names),
}

/// A `use` line for all names of a module or an enum.
#[derive(Debug, Clone)]
pub struct Glob {
    pub path: Names,
    /// Whether the `use` line is private: no re-export.
    pub private: bool,
}

/// A module: a file, or a part of one.
#[derive(Debug, Default)]
pub struct Module {
    /// The number of its file.
    pub file: usize,
    pub parent: Option<usize>,
    /// A name may stand for a module, a type and a function at once.
    pub names: HashMap<String, Vec<Meaning>>,
    pub globs: Vec<Glob>,
    /// The paths of `use` lines that are no re-exports, and those that begin with `crate`, `self` or `super`. A re-export is no
    /// use by itself: whoever names the item uses it.
    pub paths: BTreeSet<Names>,
    /// The other paths, single names among them.
    pub relative_paths: BTreeSet<Names>,
    /// The folder of the files of its submodules.
    folder: PathBuf,
}

/// The modules of a crate, the root first, without modules of tests.
#[derive(Debug, Default)]
pub struct Modules {
    pub files: Vec<PathBuf>,
    pub modules: Vec<Module>,
}

impl Modules {
    /// Reads the modules of the crate whose root is `file`.
    pub fn read(file: &Path) -> Result<Self, Failure> {
        let mut modules = Self::default();
        modules.add_file(file, None, file.parent().unwrap_or(Path::new("")).to_owned())?;
        Ok(modules)
    }

    /// Adds the module of a file, whose submodules lie in `folder`, and these; its number.
    fn add_file(&mut self, path: &Path, parent: Option<usize>, folder: PathBuf) -> Result<usize, Failure> {
        let text = fs::read_to_string(path).map_err(|error| Failure::setup(format!("{}: {error}", path.display())))?;
        let parsed = syn::parse_file(&text).map_err(|error| Failure::setup(format!("{}: {error}", path.display())))?;
        self.files.push(path.to_owned());
        let file = self.files.len() - 1;
        self.add(Module { file, parent, folder, ..Module::default() }, &parsed.items)
    }

    fn add(&mut self, module: Module, items: &[Item]) -> Result<usize, Failure> {
        let number = self.modules.len();
        self.modules.push(module);
        let mut reader = Reader { modules: self, number, failure: None };
        items.iter().for_each(|item| reader.visit_item(item));
        reader.failure.map_or(Ok(number), Err)
    }
}

/// Walks through the items of a module.
struct Reader<'a> {
    modules: &'a mut Modules,
    number: usize,
    failure: Option<Failure>,
}

impl Reader<'_> {
    fn module(&mut self) -> &mut Module {
        &mut self.modules.modules[self.number]
    }

    fn define(&mut self, name: String, meaning: Meaning) {
        let meanings = self.module().names.entry(name).or_default();
        if !meanings.contains(&meaning) {
            meanings.push(meaning);
        }
    }

    fn submodule(&mut self, item: &ItemMod) -> Result<(), Failure> {
        let name = item.ident.to_string();
        let (file, folder) = (self.module().file, self.module().folder.clone());
        let parent = Some(self.number);
        let number = match (&item.content, path_attribute(&item.attrs)) {
            (Some((_, items)), _) => {
                let module = Module { file, parent, folder: folder.join(&name), ..Module::default() };
                self.modules.add(module, items)?
            }
            (None, Some(path)) => {
                let file = self.modules.files[file].parent().unwrap_or(Path::new("")).join(path);
                let folder = file.parent().unwrap_or(Path::new("")).to_owned();
                self.modules.add_file(&file, parent, folder)?
            }
            (None, None) => {
                let inside = folder.join(&name);
                let candidates = [folder.join(format!("{name}.rs")), inside.join("mod.rs")];
                let Some(file) = candidates.iter().find(|file| file.is_file()) else {
                    let shown = self.modules.files[file].display();
                    return Err(Failure::setup(format!("{shown}: the module `{name}` has no file")));
                };
                self.modules.add_file(file, parent, inside)?
            }
        };
        self.define(name, Meaning::Module(number));
        Ok(())
    }

    /// Records a `use` line behind the path `before`.
    fn use_tree(&mut self, before: &Names, tree: &UseTree, private: bool) {
        let then = |name: &syn::Ident| {
            let name = name.to_string();
            // `use a::{self}` names `a`.
            if name == "self" && !before.is_empty() { before.clone() } else { [before.as_slice(), &[name]].concat() }
        };
        match tree {
            UseTree::Path(path) => self.use_tree(&then(&path.ident), &path.tree, private),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.use_tree(before, tree, private)),
            UseTree::Glob(_) => self.module().globs.push(Glob { path: before.clone(), private }),
            UseTree::Name(_) | UseTree::Rename(_) => {
                let (ident, alias) = match tree {
                    UseTree::Rename(rename) => (&rename.ident, rename.rename.to_string()),
                    UseTree::Name(name) => (&name.ident, name.ident.to_string()),
                    _ => return,
                };
                let path = then(ident);
                let alias = if alias == "self" { path.last().cloned().unwrap_or_default() } else { alias };
                if private {
                    self.module().paths.insert(path.clone());
                }
                self.define(alias, Meaning::Alias(path));
            }
        }
    }

    /// Takes in the paths among tokens, as of a macro's arguments.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path = Names::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Ident(ident) => {
                    if colons != 2 {
                        self.path(std::mem::take(&mut path));
                    }
                    path.push(ident.to_string());
                    colons = 0;
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' => colons += 1,
                other => {
                    self.path(std::mem::take(&mut path));
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.tokens(group.stream());
                    }
                }
            }
        }
        self.path(path);
    }

    fn path(&mut self, path: Names) {
        let absolute = |first: &String| matches!(first.as_str(), "crate" | "self" | "super");
        match path.first() {
            Some(first) if path.len() > 1 && absolute(first) => self.module().paths.insert(path),
            Some(_) => self.module().relative_paths.insert(path),
            None => false,
        };
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let Some((attributes, name)) = described(item) else { return visit::visit_item(self, item) };
        if attributes.iter().any(is_for_tests) {
            return;
        }
        if let Some(name) = name {
            self.define(name, Meaning::Item);
        }
        visit::visit_item(self, item);
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        if let Err(failure) = self.submodule(item) {
            self.failure.get_or_insert(failure);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        // A line that begins with `::` names another crate.
        if item.leading_colon.is_none() {
            let private = matches!(item.vis, Visibility::Inherited);
            self.use_tree(&Names::new(), &item.tree, private);
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.path(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, item: &'ast Macro) {
        self.visit_path(&item.path);
        self.tokens(item.tokens.clone());
    }
}

/// An item's attributes, and the name that it defines where it is neither a module nor a `use`.
fn described(item: &Item) -> Option<(&[Attribute], Option<String>)> {
    let (attributes, name) = match item {
        Item::Const(item) => (&item.attrs, Some(&item.ident)),
        Item::Enum(item) => (&item.attrs, Some(&item.ident)),
        Item::Fn(item) => (&item.attrs, Some(&item.sig.ident)),
        Item::Impl(item) => (&item.attrs, None),
        Item::Macro(item) => (&item.attrs, item.ident.as_ref()),
        Item::Mod(item) => (&item.attrs, None),
        Item::Static(item) => (&item.attrs, Some(&item.ident)),
        Item::Struct(item) => (&item.attrs, Some(&item.ident)),
        Item::Trait(item) => (&item.attrs, Some(&item.ident)),
        Item::Type(item) => (&item.attrs, Some(&item.ident)),
        Item::Union(item) => (&item.attrs, Some(&item.ident)),
        Item::Use(item) => (&item.attrs, None),
        _ => return None,
    };
    Some((attributes, name.map(ToString::to_string)))
}

/// Whether this is `#[cfg(test)]`, perhaps with further conditions.
fn is_for_tests(attribute: &Attribute) -> bool {
    let Meta::List(list) = &attribute.meta else { return false };
    fn has(tokens: TokenStream, word: &str) -> bool {
        tokens.into_iter().any(|token| match token {
            TokenTree::Ident(ident) => ident == word,
            TokenTree::Group(group) => has(group.stream(), word),
            _ => false,
        })
    }
    list.path.is_ident("cfg") && has(list.tokens.clone(), "test") && !has(list.tokens.clone(), "not")
}

/// The file that `#[path = "..."]` names.
fn path_attribute(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| {
        let Meta::NameValue(pair) = &attribute.meta else { return None };
        let Expr::Lit(literal) = &pair.value else { return None };
        let Lit::Str(text) = &literal.lit else { return None };
        pair.path.is_ident("path").then(|| text.value())
    })
}
