//! `--aov NAME=FILE`.

use std::path::PathBuf;
use std::str::FromStr;
use vitrum::suggest::nearest;
use vitrum::{Output, method};

/// A named output, and the file that it goes to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AovRequest {
    pub name: &'static str,
    /// Whether the output holds vectors, which may be negative.
    pub is_vector: bool,
    /// Whether the output holds lengths or numbers, which go beyond 1.
    pub is_measure: bool,
    pub file: PathBuf,
}

impl FromStr for AovRequest {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let expected = || "expected NAME=FILE, such as depth=depth.exr".to_owned();
        let (name, file) = text.split_once('=').filter(|(_, file)| !file.is_empty()).ok_or_else(expected)?;
        match method::outputs().map(|(_, output)| output).find(|output| output.name == name) {
            Some(&Output { name, is_vector, is_measure, .. }) => {
                Ok(Self { name, is_vector, is_measure, file: file.into() })
            }
            None if name == "medium" => Err("the output `medium` is now `transmittance`".to_owned()),
            None => Err(match nearest(name, names()) {
                Some(near) => format!("there is no output `{name}`, did you mean `{near}`?"),
                None => format!("there is no output `{name}`, expected one of {}", names().join(", ")),
            }),
        }
    }
}

/// The names of all methods' outputs, each once.
fn names() -> Vec<&'static str> {
    let mut names: Vec<&str> = Vec::new();
    for (_, output) in method::outputs() {
        if !names.contains(&output.name) {
            names.push(output.name);
        }
    }
    names
}

/// The help of `--aov`, with the outputs of each method.
pub fn long_help() -> String {
    let width = names().iter().map(|name| name.len()).max().unwrap_or(0);
    let mut text =
        "Also write a named output, such as depth=depth.exr; repeatable. Values are linear. The names:".to_owned();
    for method in method::ALL {
        text.push_str(&format!("\n\nMethod {}:", method.name().as_str()));
        for output in method.outputs() {
            text.push_str(&format!("\n  {:width$}  {}", output.name, output.description));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::AovRequest;

    #[test]
    fn requests_are_a_known_name_and_a_file() {
        let request: AovRequest = "depth=a=b.exr".parse().expect("a file name may hold `=`");
        assert_eq!((request.name, request.file.to_str()), ("depth", Some("a=b.exr")));
        assert_eq!("medium=m.exr".parse::<AovRequest>(), Err("the output `medium` is now `transmittance`".to_owned()));
        for wrong in ["depth", "depth=", "=a.exr", "colour=a.exr"] {
            assert!(wrong.parse::<AovRequest>().is_err(), "{wrong}");
        }
    }
}
