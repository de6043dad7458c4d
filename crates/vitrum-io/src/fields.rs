//! Text headers with one field a line: the names and texts of the fields, without their meaning.

use std::any::type_name;
use std::str::FromStr;

use crate::error::{Error, Place, Report, clip};

/// Longest header that is read; real ones are a few hundred bytes, and those that list a data
/// file for each slice a few hundred kilobytes.
pub(crate) const MAX_BYTES: u64 = 16 << 20;

/// One line that gives a name a value.
#[derive(Debug, Clone)]
pub(crate) struct Field {
    pub name: String,
    pub text: String,
    pub line: usize,
}

impl Field {
    pub fn place(&self) -> Place {
        Place::Line(self.line)
    }

    /// Exactly `count` numbers.
    pub fn numbers<T: FromStr>(&self, report: Report, count: usize) -> Result<Vec<T>, Error> {
        let parsed = self.text.split_whitespace().map(str::parse).collect::<Result<Vec<T>, _>>();
        parsed.ok().filter(|values| values.len() == count).ok_or_else(|| {
            // The types in use are f64 and the integers.
            let float = type_name::<T>().starts_with('f');
            let expected = match (float, count) {
                (true, _) => format!("{count} numbers"),
                (false, 1) => "a whole number in range".to_owned(),
                (false, _) => format!("{count} whole numbers in range"),
            };
            report.invalid(
                self.place(),
                format!("`{}` is not {expected}", clip(&self.text)),
                format!("write {expected}"),
            )
        })
    }
}

/// The fields of a header. Look-ups ignore the case of names.
#[derive(Debug, Default)]
pub(crate) struct Fields(Vec<Field>);

impl Fields {
    pub fn add(&mut self, report: Report, field: Field) -> Result<(), Error> {
        if let Some(first) = self.get(&field.name) {
            // The same once more contradicts nothing.
            if first.text == field.text {
                return Ok(());
            }
            return Err(report.invalid(
                field.place(),
                format!("`{}` was given in line {} already", clip(&field.name), first.line),
                "keep one of the two",
            ));
        }
        self.0.push(field);
        Ok(())
    }

    pub fn get(&self, name: &str) -> Option<&Field> {
        self.0.iter().find(|field| field.name.eq_ignore_ascii_case(name))
    }

    /// Changes the text of a field, where there is one.
    pub fn change(&mut self, name: &str, change: impl Fn(&str) -> String) {
        let field = self.0.iter_mut().find(|field| field.name.eq_ignore_ascii_case(name));
        if let Some(field) = field {
            field.text = change(&field.text);
        }
    }

    /// The field of a name; if it is missing, an error that shows the expected form by an example.
    pub fn require(&self, report: Report, name: &str, example: &str) -> Result<&Field, Error> {
        self.get(name).ok_or_else(|| {
            report.invalid(
                Place::File,
                format!("the header has no `{name}`"),
                format!("add a line such as `{example}`"),
            )
        })
    }

    /// A sentence for [`crate::Source::assumptions`] for each field that is not among `known`.
    pub fn unknown_notes<'a>(&'a self, known: &'a [&str]) -> impl Iterator<Item = String> {
        let names = self.0.iter().map(|field| field.name.as_str());
        names
            .filter(|name| !known.iter().any(|known| name.eq_ignore_ascii_case(known)))
            .map(|name| format!("the field `{}` was left out of account", clip(name)))
    }
}
