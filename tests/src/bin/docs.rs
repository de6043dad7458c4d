//! Writes the files in `docs/` that are made from the code, or checks that they are current.

use std::process::ExitCode;

use clap::Parser;
use vitrum_conformance::{Failure, docs};

/// Write what is made from the code in `docs/`: the scene's schema, and tables of keys, of names and of bounds.
#[derive(Parser)]
#[command(name = "docs", bin_name = "cargo xtask docs")]
struct Arguments {
    /// Write nothing, and fail if a committed file is not current.
    #[arg(long)]
    check: bool,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(failure) => {
            eprintln!("docs: {failure}");
            ExitCode::from(2)
        }
    }
}

/// Whether all files are current, in the end.
fn run(arguments: &Arguments) -> Result<bool, Failure> {
    let mut current = true;
    for made in docs::all()? {
        if made.is_current()? {
            continue;
        }
        if arguments.check {
            eprintln!("{} is not current; `cargo xtask docs` writes it", made.path.display());
            current = false;
        } else {
            made.write()?;
            println!("{}", made.path.display());
        }
    }
    Ok(current)
}
