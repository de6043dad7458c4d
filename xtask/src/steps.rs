//! A run of several steps, each timed, with a table at the end.

use std::io::{self, Read as _, Write as _};
use std::process::{Child, Command};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::command::{not_started, require_success};
use crate::failure::Failure;

/// The outcome of a step that found no fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Completion {
    /// The whole step was done.
    Whole,
    /// The step was left out, since the machine lacks this tool or file.
    LeftOut(String),
}

/// The steps that have run so far, and those that run beside them.
pub struct Steps {
    start: Instant,
    done: Vec<Done>,
    beside: Vec<JoinHandle<Beside>>,
}

/// A step that has run beside others, and what it has printed.
struct Beside {
    done: Done,
    output: Vec<u8>,
}

impl Default for Steps {
    fn default() -> Self {
        Self { start: Instant::now(), done: Vec::new(), beside: Vec::new() }
    }
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

    /// Starts a command that runs beside the steps that follow. What it prints is shown whole at the end, so that it does not mix with theirs.
    pub fn start(&mut self, name: &'static str, mut command: Command) {
        eprintln!("\n══ {name}, beside the steps that follow; what it prints is shown at the end");
        let start = Instant::now();
        let run = move || {
            let mut output = Vec::new();
            let outcome = captured(&mut command, &mut output).map(|()| Completion::Whole);
            Beside { done: Done { name, duration: start.elapsed(), outcome }, output }
        };
        self.beside.push(thread::spawn(run));
    }

    /// Waits for the steps that run beside others.
    fn wait(&mut self) {
        for beside in self.beside.drain(..) {
            let Beside { done, output } = beside.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            eprintln!("\n══ {}", done.name);
            // A closed stderr must not end the steps.
            let _ = io::stderr().write_all(&output);
            eprintln!("══ {}", done.row());
            self.done.push(done);
        }
    }

    /// Waits for all steps and prints the table; fails with the first failed step's code if any failed.
    pub fn finish(mut self) -> Result<(), Failure> {
        self.wait();
        println!("\n{}", self.table());
        let failed: Vec<&str> = self.done.iter().filter(|done| done.outcome.is_err()).map(|done| done.name).collect();
        let message = format!("failed: {}", failed.join(", "));
        match self.done.into_iter().find_map(|done| done.outcome.err()) {
            Some(first) => Err(Failure { code: first.code, message }),
            None => Ok(()),
        }
    }

    fn table(&self) -> String {
        let total = self.start.elapsed();
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

/// Runs a command, and keeps what it prints on both its outputs, in order.
fn captured(command: &mut Command, output: &mut Vec<u8>) -> Result<(), Failure> {
    let started = |command: &mut Command| -> io::Result<(Child, io::PipeReader)> {
        let (reader, writer) = io::pipe()?;
        let child = command.stdout(writer.try_clone()?).stderr(writer).spawn();
        // The writers go with these, so that the pipe ends when the command does.
        command.stdout(io::stderr()).stderr(io::stderr());
        Ok((child?, reader))
    };
    let (mut child, mut reader) = started(command).map_err(|error| not_started(command, &error))?;
    let read = reader.read_to_end(output);
    let status = read.and_then(|_| child.wait()).map_err(|error| not_started(command, &error))?;
    require_success(command, status)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::program;

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

    #[test]
    fn a_step_runs_beside_others() {
        let mut steps = Steps::default();
        let mut command = program("sh");
        command.args(["-c", "echo out; echo err >&2; exit 4"]);
        let mut output = Vec::new();
        assert_eq!(captured(&mut command, &mut output).unwrap_err().code, 4);
        assert_eq!(output, b"out\nerr\n");
        steps.start("one", command);
        steps.run("two", || Ok(Completion::Whole));
        steps.wait();
        assert!(steps.table().contains("two") && steps.table().contains("FAILED"), "{}", steps.table());
        assert_eq!(steps.finish().unwrap_err().code, 4);
    }

    #[test]
    fn a_step_that_cannot_start_fails() {
        let mut steps = Steps::default();
        steps.start("one", program("no-such-program"));
        assert_eq!(steps.finish().unwrap_err().code, 2);
    }
}
