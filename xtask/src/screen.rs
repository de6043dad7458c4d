//! The programs by which the real window is tested: a display in memory, and a hand for it.
//!
//! The test leaves itself out without them, so that nothing fails where they cannot be installed.

use crate::distribution::Distribution;
use crate::vulkan::{Installation, UPDATE, is_root, run_apt};
use std::env;
use std::path::Path;

/// The programs, and Debian's packages of the same purpose.
const PROGRAMS: [(&str, &str); 2] = [("Xvfb", "xvfb"), ("xdotool", "xdotool")];

/// Installs what is missing, where that is allowed and possible; the command is shown first.
pub fn install_missing(installation: Installation) {
    let path = env::var_os("PATH").unwrap_or_default();
    let folders: Vec<_> = env::split_paths(&path).collect();
    let missing = missing(|program| folders.iter().any(|folder| folder.join(program).is_file()));
    if missing.is_empty() || !may_install(installation, Distribution::of_this_machine(), is_root()) {
        return;
    }
    let command = [&["apt-get", "install", "--yes", "--no-install-recommends"], missing.as_slice()].concat();
    eprintln!("xtask: the real window is tested by {}, which will be installed:", missing.join(" and "));
    eprintln!("  {}\n  {}", UPDATE.join(" "), command.join(" "));
    if let Err(failure) = [UPDATE, &command].into_iter().try_for_each(run_apt) {
        eprintln!("xtask: {}; the test of the real window leaves itself out", failure.message);
    }
}

/// The packages of the programs that are not there.
fn missing(is_there: impl Fn(&Path) -> bool) -> Vec<&'static str> {
    PROGRAMS.iter().filter(|(program, _)| !is_there(Path::new(program))).map(|(_, package)| *package).collect()
}

fn may_install(installation: Installation, distribution: Distribution, is_root: bool) -> bool {
    cfg!(target_os = "linux")
        && installation == Installation::Allowed
        && distribution == Distribution::Debian
        && is_root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_is_known_by_its_package() {
        assert_eq!(missing(|_| true), Vec::<&str>::new());
        assert_eq!(missing(|program| program == Path::new("xdotool")), ["xvfb"]);
    }

    #[test]
    fn nothing_is_installed_where_that_is_forbidden_or_impossible() {
        for (installation, distribution, is_root) in [
            (Installation::Forbidden, Distribution::Debian, true),
            (Installation::Allowed, Distribution::Fedora, true),
            (Installation::Allowed, Distribution::Debian, false),
        ] {
            assert!(!may_install(installation, distribution, is_root));
        }
    }
}
