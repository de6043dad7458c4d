//! The project's tasks: `cargo xtask <task>`.
//!
//! Exit codes: 0 done; 1 a check said no; 2 wrong use, or something that the task needs is missing; any other is that of
//! the program that the task ran.

mod accuracy;
mod bench;
mod ci;
mod circles;
mod command;
mod diff;
mod distribution;
mod docs;
mod environment;
mod failure;
mod features;
mod fuzz;
mod man;
mod package;
mod peers;
mod python;
mod screen;
mod shaders;
mod steps;
mod test;
mod toolchain;
mod vulkan;
mod wasm;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::Failure;

#[derive(Parser)]
#[command(bin_name = "cargo xtask", about = "The project's tasks", disable_help_subcommand = true)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    Shaders(shaders::Arguments),
    Test(test::Arguments),
    Diff(diff::Arguments),
    Bench(bench::Arguments),
    Accuracy(accuracy::Arguments),
    Docs(docs::Arguments),
    Fuzz(fuzz::Arguments),
    Man(man::Arguments),
    Peers(peers::Arguments),
    Python(python::Arguments),
    Circles(circles::Arguments),
    Features(features::Arguments),
    Ci(ci::Arguments),
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Shaders(arguments) => shaders::run(&arguments),
        Task::Test(arguments) => test::run(&arguments),
        Task::Diff(arguments) => diff::run(&arguments),
        Task::Bench(arguments) => bench::run(&arguments),
        Task::Accuracy(arguments) => accuracy::run(&arguments),
        Task::Docs(arguments) => docs::run(&arguments),
        Task::Fuzz(arguments) => fuzz::run(&arguments),
        Task::Man(arguments) => man::run(&arguments),
        Task::Peers(arguments) => peers::run(&arguments),
        Task::Python(arguments) => python::run(&arguments),
        Task::Circles(arguments) => circles::run(&arguments),
        Task::Features(arguments) => features::run(&arguments),
        Task::Ci(arguments) => ci::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure { code, message }) => {
            eprintln!("xtask: {message}");
            ExitCode::from(code)
        }
    }
}
