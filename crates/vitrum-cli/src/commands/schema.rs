//! `vitrum schema`: the keys of scene files, for editors and programs.

use crate::failure::Failure;
use crate::output;
use clap::Args;
use std::process::ExitCode;
use vitrum::scene::Scene;

/// Print the JSON schema of scene files, for completion and checks in editors
#[derive(Debug, Args)]
pub struct Arguments {}

pub fn run(_arguments: &Arguments) -> Result<ExitCode, Failure> {
    output::print(&format!("{}\n", Scene::json_schema()))?;
    Ok(ExitCode::SUCCESS)
}
