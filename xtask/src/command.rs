//! Commands, run in the workspace's root.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

use crate::failure::Failure;

/// The workspace's root folder.
pub fn root() -> PathBuf {
    let xtask = env::var("CARGO_MANIFEST_DIR").unwrap_or_else(|_| env!("CARGO_MANIFEST_DIR").to_owned());
    PathBuf::from(xtask).parent().expect("xtask lies in the workspace").to_owned()
}

/// The folder that cargo builds in.
pub fn target() -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// A program in the workspace's root.
pub fn program(name: &str) -> Command {
    let mut command = Command::new(name);
    command.current_dir(root());
    command
}

/// The cargo that runs this task.
pub fn cargo<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Command {
    let mut command = program(&env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    command.args(arguments);
    command
}

/// A task of this program, as a process of its own.
pub fn this_program<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Result<Command, Failure> {
    let path = env::current_exe().map_err(|error| Failure::setup(format!("the program's own path: {error}")))?;
    let mut command = program(&path.to_string_lossy());
    command.args(arguments);
    Ok(command)
}

/// Shows the command, runs it, and fails with its exit code if it fails.
pub fn run(command: &mut Command) -> Result<(), Failure> {
    announce(command);
    let status = command.status().map_err(|error| not_started(command, &error))?;
    require_success(command, status)
}

/// Shows the command on stderr.
pub fn announce(command: &Command) {
    eprintln!("$ {}", line(command));
}

/// The failure of a command that could not be started.
pub fn not_started(command: &Command, error: &std::io::Error) -> Failure {
    Failure::setup(format!("{} could not be started: {error}", command.get_program().display()))
}

/// Fails with the command's exit code if it failed.
pub fn require_success(command: &Command, status: ExitStatus) -> Result<(), Failure> {
    if status.success() {
        return Ok(());
    }
    let code = match status.code().map(u8::try_from) {
        // Cargo's own code says no more than that something, such as a lint, failed.
        Some(Ok(101)) | Some(Err(_)) | None => 1,
        Some(Ok(code)) => code,
    };
    Err(Failure { code, message: format!("`{}` failed: {status}", line(command)) })
}

/// The command as one would type it, variables included.
fn line(command: &Command) -> String {
    let mut words = Vec::new();
    for (name, value) in command.get_envs() {
        let value = value.unwrap_or_default().display().to_string();
        let value = if value.contains(' ') { format!("'{value}'") } else { value };
        words.push(format!("{}={value}", name.display()));
    }
    let program = Path::new(command.get_program());
    words.push(program.file_name().unwrap_or(program.as_os_str()).display().to_string());
    words.extend(command.get_args().map(|argument| argument.display().to_string()));
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_program_gives_its_exit_code() {
        let failure = run(program("sh").args(["-c", "exit 4"])).unwrap_err();
        assert_eq!(failure.code, 4);
    }

    #[test]
    fn a_failed_cargo_command_is_a_check_that_said_no() {
        let failure = run(&mut cargo(["no-such-command"])).unwrap_err();
        assert_eq!(failure.code, 1);
        assert!(failure.message.contains("cargo no-such-command"), "{}", failure.message);
    }

    #[test]
    fn a_missing_program_is_a_matter_of_setup() {
        let failure = run(&mut program("no-such-program")).unwrap_err();
        assert_eq!(failure.code, 2);
        assert!(failure.message.contains("no-such-program could not be started"), "{}", failure.message);
    }

    #[test]
    fn a_command_is_shown_as_one_would_type_it() {
        let mut command = program("/usr/bin/env");
        command.args(["-u", "HOME"]).env("RUSTDOCFLAGS", "-D warnings");
        assert_eq!(line(&command), "RUSTDOCFLAGS='-D warnings' env -u HOME");
    }
}
