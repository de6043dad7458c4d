//! `vitrum devices`: what can render here.

use crate::failure::Failure;
use crate::output;
use clap::Args;
use std::process::ExitCode;
use vitrum::backend;

/// List the devices that can render; the one that `--backend auto` takes is marked with `*`
#[derive(Debug, Args)]
pub struct Arguments {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let devices = backend::devices();
    if arguments.json {
        // Texts, numbers and truth values always have a JSON form.
        output::print_json(&serde_json::to_value(&devices).unwrap_or_default())?;
    } else {
        let rows = devices.iter().map(|device| {
            let mark = if device.chosen_by_auto { '*' } else { ' ' };
            let course = if device.passes_through { "" } else { "; shaders translated" };
            format!("{mark} {:4} {}  ({}; {}{course})\n", device.backend, device.name, device.kind, device.driver)
        });
        output::print(&rows.collect::<String>())?;
    }
    Ok(ExitCode::SUCCESS)
}
