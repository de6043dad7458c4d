//! A conformance run: what was compared so far.

use std::fmt::Write as _;
use std::path::PathBuf;

use serde_json::{Value, json};
use vitrum::method;
use vitrum::scene::MethodName;
use vitrum_compare::Bound;

use crate::Failure;
use crate::evidence;
use crate::raster::Raster;
use crate::report::Pictures;
use crate::table::{self, Row};

/// The names of the methods that are compared.
pub fn methods() -> impl Iterator<Item = &'static str> {
    method::ALL.into_iter().map(|method| method.name().as_str())
}

/// The description of two rasters that are compared.
#[derive(Debug, Clone, Copy)]
pub struct About<'a> {
    /// The tier, such as `T2`.
    pub tier: &'static str,
    /// The scene.
    pub scene: &'a str,
    /// The kernel or the output.
    pub item: &'a str,
    /// The names of a record's components, of which the rasters have a plane each; none if they are no records.
    pub components: &'a [&'static str],
}

/// Rows, and where breaches left their evidence.
#[derive(Debug)]
pub struct Run {
    folder: PathBuf,
    against: String,
    method: &'static str,
    rows: Vec<Row>,
    evidence: Vec<PathBuf>,
    keeps_pictures: bool,
    pictures: Vec<Pictures>,
}

impl Run {
    /// A run that leaves the evidence of breaches in `folder`.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        let (rows, evidence, pictures) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            folder,
            against: String::new(),
            method: MethodName::default().as_str(),
            rows,
            evidence,
            keeps_pictures: false,
            pictures,
        }
    }

    /// Says what all further comparisons are with, such as an adapter; their evidence gets a folder of that name.
    pub fn against(&mut self, what: &str) {
        what.clone_into(&mut self.against);
    }

    /// Says which method all further comparisons are of.
    pub fn method(&mut self, method: MethodName) {
        self.method = method.as_str();
    }

    /// Keeps the pictures of all further comparisons, for a report.
    pub fn keep_pictures(&mut self) {
        self.keeps_pictures = true;
    }

    /// Compares two rasters and holds them to a bound. A breach leaves its evidence at once, so that a run that is
    /// interrupted has it, too.
    ///
    /// # Errors
    /// If the rasters differ in size, or evidence cannot be written.
    pub fn hold(&mut self, about: About, bound: Bound, reference: &Raster, other: &Raster) -> Result<(), Failure> {
        let About { tier, scene, item, components } = about;
        let what = || format!("{tier} {scene} {item}");
        let comparison = reference.compare(other).map_err(|error| Failure::Compare { what: what(), error })?;
        let (scene, method, item) = (scene.to_owned(), self.method.to_owned(), item.to_owned());
        let values = comparison.width as usize * comparison.height as usize / components.len().max(1);
        let first = comparison.ulps.first_difference.and_then(|first| components.get(first / values.max(1)).copied());
        let against = self.against.clone();
        let row = Row { tier, scene, method, item, component: first, comparison, bound, against };
        if !row.verdict().passed() {
            let written = evidence::write(&self.folder, &row, &reference.colors(), &other.colors());
            self.evidence.push(written.map_err(|error| Failure::Output { path: self.folder.clone(), error })?);
        }
        if self.keeps_pictures {
            let pictures = Pictures::new(self.rows.len(), reference, other);
            self.pictures.extend(pictures.map_err(|error| Failure::Output { path: self.folder.clone(), error })?);
        }
        self.rows.push(row);
        Ok(())
    }

    /// Compares outputs of the same names, one by one, and holds each to a bound that may depend on whether it is shown.
    ///
    /// # Errors
    /// If the outputs are not the same or differ in size, or evidence cannot be written.
    pub fn hold_all(
        &mut self,
        (tier, scene): (&'static str, &str),
        bound: impl Fn(bool) -> Bound,
        reference: &[(String, Raster)],
        other: &[(String, Raster)],
    ) -> Result<(), Failure> {
        let names = |outputs: &[(String, Raster)]| outputs.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        if names(reference) != names(other) {
            let (first, second) = (names(reference).join(", "), names(other).join(", "));
            return Err(Failure::Setup(format!("{tier} {scene}: one has the outputs {first}, the other {second}")));
        }
        for ((item, reference), (_, other)) in reference.iter().zip(other) {
            self.hold(About { tier, scene, item, components: &[] }, bound(reference.is_shown()), reference, other)?;
        }
        Ok(())
    }

    /// Every comparison so far.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Every comparison so far, together with those with the same thing.
    pub fn groups(&self) -> impl Iterator<Item = &[Row]> {
        self.rows.chunk_by(|row, next| row.against == next.against)
    }

    /// The pictures that were kept.
    #[must_use]
    pub fn pictures(&self) -> &[Pictures] {
        &self.pictures
    }

    /// The comparisons whose bound does not hold.
    #[must_use]
    pub fn breaches(&self) -> Vec<Row> {
        self.rows.iter().filter(|row| !row.verdict().passed()).cloned().collect()
    }

    /// Whether something was compared, and every bound holds.
    #[must_use]
    pub fn passed(&self) -> bool {
        !self.rows.is_empty() && self.evidence.is_empty()
    }

    /// The number of comparisons, and the folders with the evidence of breaches.
    #[must_use]
    pub fn summary(&self) -> String {
        let equal = self.rows.iter().filter(|row| row.comparison.ulps.equal() == row.comparison.ulps.total()).count();
        let mut text = format!("{} comparisons, {equal} equal to the last bit", self.rows.len());
        let _ = match self.evidence.len() {
            0 => write!(text, ", no breach"),
            breaches => write!(text, ", {breaches} breaches; evidence:"),
        };
        for folder in &self.evidence {
            let _ = write!(text, "\n  {}", folder.display());
        }
        text
    }

    /// Panics if something does not hold, with the table of breaches: for tests.
    ///
    /// # Panics
    /// If a bound does not hold, or nothing was compared.
    pub fn assert_passed(&self) {
        assert!(self.passed(), "{}\n{}", self.summary(), table::markdown(&self.breaches()));
    }

    /// The rows as JSON.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({ "passed": self.passed(), "rows": self.rows.iter().map(Row::json).collect::<Vec<_>>() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ABOUT: About<'static> = About { tier: "T2", scene: "ball", item: "depth", components: &[] };

    #[test]
    fn a_breach_is_kept_with_its_evidence() {
        let folder = tempfile::tempdir().unwrap();
        let mut run = Run::new(folder.path().to_owned());
        let raster = Raster::stacked(1, [[1.0].as_slice()]);
        run.hold(ABOUT, Bound::BitEqual, &raster, &raster).unwrap();
        assert!(run.passed() && run.breaches().is_empty(), "{}", run.summary());
        let other = Raster::stacked(1, [[1.0f32.next_up()].as_slice()]);
        run.hold(ABOUT, Bound::BitEqual, &raster, &other).unwrap();
        assert!(!run.passed() && run.breaches().len() == 1);
        assert!(folder.path().join("T2-ball-sweep-depth/numbers.json").exists());
        assert!(run.summary().contains("2 comparisons, 1 equal to the last bit, 1 breaches"), "{}", run.summary());
        assert_eq!(run.json()["passed"], false);
    }

    #[test]
    fn what_was_compared_with_stays_apart() {
        let folder = tempfile::tempdir().unwrap();
        let mut run = Run::new(folder.path().to_owned());
        let [one, other] = [1.0, 2.0].map(|value: f32| Raster::stacked(1, [[value].as_slice()]));
        for adapter in ["llvmpipe (LLVM)", "radeon"] {
            run.against(adapter);
            run.hold(ABOUT, Bound::BitEqual, &one, &other).unwrap();
        }
        assert_eq!(run.groups().map(<[Row]>::len).collect::<Vec<_>>(), [1, 1]);
        assert_eq!(run.json()["rows"][1]["against"], "radeon");
        for name in ["llvmpipe__LLVM_", "radeon"] {
            assert!(folder.path().join(name).join("T2-ball-sweep-depth/numbers.json").exists());
        }
    }

    #[test]
    fn outputs_must_be_the_same() {
        let mut run = Run::new(PathBuf::new());
        let outputs = |names: &[&str]| -> Vec<(String, Raster)> {
            names.iter().map(|name| ((*name).to_owned(), Raster::stacked(1, [[1.0].as_slice()]))).collect()
        };
        let (one, two) = (outputs(&["depth"]), outputs(&["depth", "status"]));
        assert!(run.hold_all(("T2", "ball"), |_| Bound::BitEqual, &two, &two).is_ok());
        assert!(run.hold_all(("T2", "ball"), |_| Bound::BitEqual, &one, &two).is_err());
        assert_eq!(run.rows().len(), 2);
    }

    #[test]
    fn a_run_that_compared_nothing_has_not_passed() {
        assert!(!Run::new(PathBuf::new()).passed());
    }
}
