//! What shells offer while somebody types: names that the program knows.

use crate::arguments::Arguments;
use crate::bash::BashWithColons;
use clap::CommandFactory;
use clap::builder::StyledStr;
use clap_complete::CompleteEnv;
use clap_complete::engine::{ArgValueCompleter, CompletionCandidate, PathCompleter, ValueCompleter};
use clap_complete::env::{Elvish, Fish, Powershell, Shells, Zsh};
use std::ffi::{OsStr, OsString};
use vitrum::scene::describe_keys;
use vitrum::{builtin, method, preset};

/// The variable of the environment by which a shell asks, with the shell's name.
const VARIABLE: &str = "VITRUM_COMPLETE";

const SHELLS: Shells<'static> = Shells(&[&BashWithColons, &Elvish, &Fish, &Powershell, &Zsh]);

/// Answers a shell that asks for completions, and says whether one did.
pub fn answer_shell(words: &[OsString]) -> bool {
    let completion = CompleteEnv::with_factory(Arguments::command).var(VARIABLE).shells(SHELLS);
    let folder = std::env::current_dir().ok();
    completion.try_complete(words.iter().cloned(), folder.as_deref()).unwrap_or_else(|error| error.exit())
}

/// The script by which a shell asks the program; empty for a shell that there is not.
pub fn script(shell: &str) -> String {
    let mut script = Vec::new();
    if let Some(completer) = SHELLS.completer(shell) {
        // Writing to memory does not fail.
        let _ = completer.write_registration(VARIABLE, "vitrum", "vitrum", "vitrum", &mut script);
    }
    String::from_utf8_lossy(&script).into_owned()
}

/// Names of presets, of volumes and of meshes.
pub fn presets() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| {
        named(typed, "", [preset::names(), preset::mesh_names()].concat().into_iter())
    })
}

/// Names of media.
pub fn media() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| named(typed, "", preset::medium_names().iter().copied()))
}

/// Files, and the built-in scenes as `builtin:NAME`.
pub fn inputs() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| {
        let mut candidates = PathCompleter::any().complete(typed);
        candidates.extend(named(typed, "builtin:", builtin::names().iter().copied()));
        candidates
    })
}

/// Scene keys, by their paths.
pub fn keys() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| described_keys(typed, ""))
}

/// Scene keys with `=` behind them, as `--set` takes them.
pub fn settings() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| described_keys(typed, "="))
}

/// Named outputs with `=` behind them, as `--aov` takes them.
pub fn outputs() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| {
        let mut names: Vec<_> =
            method::outputs().map(|(_, output)| (format!("{}=", output.name), output.description)).collect();
        // Methods share names; the sort keeps the first description of each.
        names.sort_by(|one, other| one.0.cmp(&other.0));
        names.dedup_by(|one, other| one.0 == other.0);
        names.iter().filter_map(|(name, help)| candidate(typed, name, help)).collect()
    })
}

/// Names of the adapters that are here.
pub fn adapters() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| {
        let names = crate::device::adapter_names();
        names.iter().filter_map(|name| candidate(typed, name, "")).collect()
    })
}

fn described_keys(typed: &OsStr, end: &str) -> Vec<CompletionCandidate> {
    let keys = describe_keys();
    keys.iter().filter_map(|key| candidate(typed, &format!("{}{end}", key.path), &key.meaning)).collect()
}

fn named<'a>(typed: &OsStr, prefix: &str, names: impl Iterator<Item = (&'a str, &'a str)>) -> Vec<CompletionCandidate> {
    names.filter_map(|(name, help)| candidate(typed, &format!("{prefix}{name}"), help)).collect()
}

/// The candidate, if what is typed begins it.
fn candidate(typed: &OsStr, name: &str, help: &str) -> Option<CompletionCandidate> {
    let sentence = help.split_once(". ").map_or(help, |(first, _)| first);
    let help = (!sentence.is_empty()).then(|| StyledStr::from(sentence.to_owned()));
    name.starts_with(typed.to_str()?).then(|| CompletionCandidate::new(name).help(help))
}
