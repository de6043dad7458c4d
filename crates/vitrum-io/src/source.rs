//! Origin of a volume or a mesh, and the assumptions of its reader.

use std::fmt;
use std::ops::Deref;

use crate::labels::Labels;
use crate::moments::Moments;
use crate::setting::Setting;

/// The file format of a volume or a mesh and the assumptions of its reader, for people to read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Source {
    /// The file format, such as `NRRD`; empty for data that no file holds.
    pub format: &'static str,
    /// The file's sample type, such as `int16`; of a mesh the type of its coordinates.
    pub sample_type: String,
    /// Coding of the samples in the file, such as `gzip, little-endian`.
    pub encoding: String,
    /// Statements about gaps in the file, and about changes by its reader.
    pub assumptions: Assumptions,
}

impl Source {
    /// The points in time that the file has; `None` where it knows no time.
    #[must_use]
    pub fn moments(&self) -> Option<&Moments> {
        self.assumptions.moments.as_deref()
    }

    /// The labels that the values are; `None` of measurements.
    #[must_use]
    pub fn labels(&self) -> Option<&Labels> {
        self.assumptions.labels()
    }
}

/// A statement about something that a file does not say, or that its reader changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Assumption {
    /// The statement, without a full stop.
    pub fact: String,
    /// The field of [`OpenOptions`](crate::OpenOptions) that replaces the assumption, where one does.
    pub setting: Option<Setting>,
    /// Other values that the field may have, such as the names of the other arrays or `0 to 2`; empty where any value is possible.
    pub choices: String,
}

impl Assumption {
    /// An assumption that a field of [`OpenOptions`](crate::OpenOptions) replaces.
    pub(crate) fn replaceable(fact: impl Into<String>, setting: Setting, choices: impl Into<String>) -> Self {
        Self { fact: fact.into(), setting: Some(setting), choices: choices.into() }
    }
}

impl From<String> for Assumption {
    fn from(fact: String) -> Self {
        Self { fact, setting: None, choices: String::new() }
    }
}

impl fmt::Display for Assumption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.fact)?;
        if self.choices.is_empty() { Ok(()) } else { write!(f, "; others are: {}", self.choices) }
    }
}

/// A fact about the data, and where the file says it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fact {
    /// Name of the fact: `spacing`, `orientation`, `unit`, `values`, or one of the format's own, such as `series`.
    pub name: &'static str,
    /// Value for people to read; empty where the volume holds it.
    pub value: String,
    /// The part of the file that says it, such as `the sform`.
    pub from: String,
}

/// A list of assumptions, in the order in which they were made, of the facts that needed none, and of the points in time among which one was taken.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Assumptions {
    assumptions: Vec<Assumption>,
    facts: Vec<Fact>,
    moments: Option<Box<Moments>>,
    labels: Option<Box<Labels>>,
}

impl Assumptions {
    /// Appends an assumption.
    pub fn push(&mut self, assumption: impl Into<Assumption>) {
        self.assumptions.push(assumption.into());
    }

    /// Says which points in time there are.
    pub(crate) fn set_moments(&mut self, moments: Moments) {
        self.moments = Some(Box::new(moments));
    }

    /// Says that the values are labels.
    pub(crate) fn set_labels(&mut self, labels: Labels) {
        self.labels = Some(Box::new(labels));
    }

    pub(crate) fn labels(&self) -> Option<&Labels> {
        self.labels.as_deref()
    }

    /// The statements alone.
    #[must_use]
    pub fn facts(&self) -> Vec<&str> {
        self.assumptions.iter().map(|assumption| assumption.fact.as_str()).collect()
    }

    /// The facts that the file says by itself, with where it says them.
    #[must_use]
    pub fn stated(&self) -> &[Fact] {
        &self.facts
    }

    /// Notes where the file says something that the volume holds.
    pub(crate) fn note_origin(&mut self, name: &'static str, from: impl Into<String>) {
        self.note_fact(name, "", from);
    }

    /// Notes that something else than the file says what the volume holds.
    pub(crate) fn replace_origin(&mut self, name: &'static str, from: &str) {
        self.facts.retain(|fact| fact.name != name);
        self.note_origin(name, from);
    }

    /// Notes a fact that the file says; the first one of a name counts.
    pub(crate) fn note_fact(&mut self, name: &'static str, value: impl Into<String>, from: impl Into<String>) {
        if self.facts.iter().all(|fact| fact.name != name) {
            self.facts.push(Fact { name, value: value.into(), from: from.into() });
        }
    }

    /// Removes all assumptions.
    pub(crate) fn clear(&mut self) {
        self.assumptions.clear();
        self.facts.clear();
    }
}

impl Deref for Assumptions {
    type Target = [Assumption];

    fn deref(&self) -> &[Assumption] {
        &self.assumptions
    }
}

impl<T: Into<Assumption>> Extend<T> for Assumptions {
    fn extend<I: IntoIterator<Item = T>>(&mut self, assumptions: I) {
        self.assumptions.extend(assumptions.into_iter().map(Into::into));
    }
}

impl IntoIterator for Assumptions {
    type Item = Assumption;
    type IntoIter = std::vec::IntoIter<Assumption>;

    fn into_iter(self) -> Self::IntoIter {
        self.assumptions.into_iter()
    }
}
