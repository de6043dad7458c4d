//! `--aov NAME=FILE`.

use std::path::PathBuf;
use std::str::FromStr;
use vitrum::suggest::nearest;
use vitrum::{Frame, Output};

/// A named output, and the file that it goes to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AovRequest {
    pub output: &'static Output,
    pub file: PathBuf,
}

impl FromStr for AovRequest {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let expected = || "expected NAME=FILE, such as depth=depth.exr".to_owned();
        let (name, file) = text.split_once('=').filter(|(_, file)| !file.is_empty()).ok_or_else(expected)?;
        let names = || Frame::OUTPUTS.iter().map(|output| output.name);
        match Frame::OUTPUTS.iter().find(|output| output.name == name) {
            Some(output) => Ok(Self { output, file: file.into() }),
            None if name == "medium" => Err("the output `medium` is now `transmittance`".to_owned()),
            None => Err(match nearest(name, names()) {
                Some(near) => format!("there is no output `{name}`, did you mean `{near}`?"),
                None => {
                    let names: Vec<_> = names().collect();
                    format!("there is no output `{name}`, expected one of {}", names.join(", "))
                }
            }),
        }
    }
}

/// The help of `--aov`, with all names.
pub fn long_help() -> String {
    let width = Frame::OUTPUTS.iter().map(|output| output.name.len()).max().unwrap_or(0);
    let rows: String = Frame::OUTPUTS
        .iter()
        .map(|Output { name, description, .. }| format!("\n  {name:width$}  {description}"))
        .collect();
    format!("Also write a named output, such as depth=depth.exr; repeatable. Values are linear. The names:\n{rows}")
}

#[cfg(test)]
mod tests {
    use super::AovRequest;

    #[test]
    fn requests_are_a_known_name_and_a_file() {
        let request: AovRequest = "depth=a=b.exr".parse().expect("a file name may hold `=`");
        assert_eq!((request.output.name, request.file.to_str()), ("depth", Some("a=b.exr")));
        assert_eq!("medium=m.exr".parse::<AovRequest>(), Err("the output `medium` is now `transmittance`".to_owned()));
        for wrong in ["depth", "depth=", "=a.exr", "colour=a.exr"] {
            assert!(wrong.parse::<AovRequest>().is_err(), "{wrong}");
        }
    }
}
