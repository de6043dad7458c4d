//! `vitrum keys`: the scene keys, described.

use crate::failure::{Failure, Status};
use crate::output;
use clap::Args;
use serde_json::json;
use std::process::ExitCode;
use vitrum::scene::{KeyDescription, describe_keys};
use vitrum::suggest::nearest;

/// List the scene keys, for scene files and --set: unit, range, default and meaning of each
#[derive(Debug, Args)]
pub struct Arguments {
    /// The beginning of a key or of a table, such as camera or light.0, or a word inside of keys; all keys if absent
    #[arg(value_name = "PREFIX", add = crate::complete::keys())]
    prefix: Option<String>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let all = describe_keys();
    let keys = match &arguments.prefix {
        Some(prefix) => matching(&all, prefix)?,
        None => all.iter().collect(),
    };
    if arguments.json {
        let entry = |key: &&KeyDescription| {
            let KeyDescription { path, unit, range, default, meaning, .. } = key;
            json!({ "key": path, "unit": unit, "range": plain(range), "default": plain(default), "meaning": meaning })
        };
        output::print_json(&keys.iter().map(entry).collect())?;
    } else {
        output::print(&keys.iter().map(|key| text(key)).collect::<Vec<_>>().join("\n"))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The keys that begin with `prefix`, else those that have it inside.
fn matching<'a>(all: &'a [KeyDescription], prefix: &str) -> Result<Vec<&'a KeyDescription>, Failure> {
    // Any index of a list stands for all, and may be left out.
    let is_index = |segment: &&str| segment.parse::<u32>().is_ok();
    let bare = |path: &str| path.split('.').filter(|segment| !is_index(segment)).collect::<Vec<_>>().join(".");
    let wanted = bare(prefix.trim_end_matches('.'));
    let having = |test: &dyn Fn(&str) -> bool| all.iter().filter(|key| test(&bare(&key.path))).collect::<Vec<_>>();
    for keys in [
        having(&|path| path == wanted || path.starts_with(&format!("{wanted}."))),
        having(&|path| path.starts_with(&wanted)),
        having(&|path| path.contains(&wanted)),
    ] {
        if !keys.is_empty() {
            return Ok(keys);
        }
    }
    let names = all.iter().flat_map(|key| [key.path.as_str(), key.name.as_str(), key.table.as_str()]);
    let help = match nearest(prefix, names.filter(|name| !name.is_empty())) {
        Some(near) => format!("did you mean `vitrum keys {near}`?"),
        None => "`vitrum keys` lists all of them".to_owned(),
    };
    Err(Failure::new(Status::WrongUse, format!("no scene key begins with `{prefix}` or has it inside"), help))
}

/// A key in a paragraph: its facts, and its meaning below.
fn text(key: &KeyDescription) -> String {
    let KeyDescription { path, unit, range, default, meaning, .. } = key;
    let default = match default.as_str() {
        "required" => "required".to_owned(),
        "—" => "no default".to_owned(),
        value => format!("default {}", plain(value)),
    };
    let unit = if unit.is_empty() { String::new() } else { format!("{unit}; ") };
    format!("{path}  ({unit}{}; {default})\n{}", plain(range), wrapped(meaning))
}

fn plain(markdown: &str) -> String {
    markdown.replace('`', "")
}

/// The text in indented lines of up to 100 letters.
fn wrapped(text: &str) -> String {
    const LONGEST: usize = 100;
    const INDENT: &str = "    ";
    let mut lines = String::new();
    let mut line = String::from(INDENT);
    for word in text.split_whitespace() {
        if line.chars().count() + 1 + word.chars().count() > LONGEST {
            lines += &format!("{}\n", line.trim_end());
            line = String::from(INDENT);
        }
        line += word;
        line.push(' ');
    }
    lines + line.trim_end() + "\n"
}
