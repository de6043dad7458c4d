//! A run of several steps, each timed, with a table at the end.

use std::time::{Duration, Instant};

use crate::failure::Failure;

/// The outcome of a step that found no fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Completion {
    /// The whole step was done.
    Whole,
    /// The step was left out, since the machine lacks this tool or file.
    LeftOut(String),
}

/// The steps that have run so far.
#[derive(Default)]
pub struct Steps {
    done: Vec<Done>,
}

struct Done {
    name: &'static str,
    duration: Duration,
    outcome: Result<Completion, Failure>,
}

impl Steps {
    /// Runs a step; its failure is kept for the table, so that one run shows everything that is wrong.
    pub fn run(&mut self, name: &'static str, step: impl FnOnce() -> Result<Completion, Failure>) {
        eprintln!("\n══ {name}");
        let start = Instant::now();
        let outcome = step();
        let done = Done { name, duration: start.elapsed(), outcome };
        eprintln!("══ {}", done.row());
        self.done.push(done);
    }

    /// Prints the table; fails with the first failed step's code if any failed.
    pub fn finish(self) -> Result<(), Failure> {
        println!("\n{}", self.table());
        let failed: Vec<&str> = self.done.iter().filter(|done| done.outcome.is_err()).map(|done| done.name).collect();
        let message = format!("failed: {}", failed.join(", "));
        match self.done.into_iter().find_map(|done| done.outcome.err()) {
            Some(first) => Err(Failure { code: first.code, message }),
            None => Ok(()),
        }
    }

    fn table(&self) -> String {
        let total = self.done.iter().map(|done| done.duration).sum::<Duration>();
        let mut rows: Vec<String> = self.done.iter().map(Done::row).collect();
        rows.push(format!("{:<10} {:>8.1} s", "total", total.as_secs_f64()));
        rows.join("\n")
    }
}

impl Done {
    fn row(&self) -> String {
        let seconds = self.duration.as_secs_f64();
        match &self.outcome {
            Ok(Completion::Whole) => format!("{:<10} {seconds:>8.1} s  ok", self.name),
            Ok(Completion::LeftOut(reason)) => format!("{:<10} {seconds:>8.1} s  LEFT OUT: {reason}", self.name),
            Err(failure) => format!("{:<10} {seconds:>8.1} s  FAILED: {}", self.name, failure.message),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_steps_run_and_the_first_failure_gives_the_code() {
        let mut steps = Steps::default();
        let mut ran = 0;
        steps.run("one", || Ok(Completion::Whole));
        steps.run("two", || Err(Failure::setup("no driver")));
        steps.run("three", || {
            ran += 1;
            Err(Failure::check("differs"))
        });
        assert!(steps.table().contains("FAILED: no driver"), "{}", steps.table());
        let failure = steps.finish().unwrap_err();
        assert_eq!((failure.code, failure.message.as_str(), ran), (2, "failed: two, three", 1));
    }

    #[test]
    fn success_is_possible() {
        let mut steps = Steps::default();
        steps.run("one", || Ok(Completion::Whole));
        steps.run("two", || Ok(Completion::LeftOut("no network".to_owned())));
        assert!(steps.table().contains("LEFT OUT: no network"), "{}", steps.table());
        assert!(steps.finish().is_ok());
    }
}
