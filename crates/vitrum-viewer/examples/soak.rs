//! A long while of random input in a window without a display: prints the memory that the process takes, and ends in a panic where the window does.
//!
//! `cargo run --release -p vitrum-viewer --example soak -- --minutes 10`

#[path = "../tests/random_user/mod.rs"]
mod random_user;

use clap::Parser;
use random_user::RandomUser;
use std::time::{Duration, Instant};

#[derive(Debug, Parser)]
struct Arguments {
    /// How long it goes on
    #[arg(long, default_value_t = 10.0)]
    minutes: f64,

    /// What is done follows from this number
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// Memory of the process that is in use, in MiB, where the system says so.
fn memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok()? / 1024)
}

fn tell(what: &str, deeds: u64) {
    match memory() {
        Some(memory) => println!("{what}: {deeds} deeds, {memory} MiB"),
        None => println!("{what}: {deeds} deeds"),
    }
}

fn main() {
    let arguments = Arguments::parse();
    let mut user = RandomUser::new(arguments.seed);
    user.rest("builtin:ball");
    tell("start", 0);
    let start = Instant::now();
    let mut deeds = 0;
    let mut minutes = 0;
    while start.elapsed() < Duration::from_secs_f64(arguments.minutes * 60.0) {
        user.act();
        deeds += 1;
        if start.elapsed().as_secs() / 60 > minutes {
            minutes += 1;
            tell(&format!("after {minutes} min"), deeds);
        }
    }
    user.rest("builtin:ball");
    tell("end", deeds);
}
