//! The machine and the date of a measurement.

use std::fs;
use std::process::Command;
use std::thread;
use std::time::{SystemTime, UNIX_EPOCH};

/// Processor, system, version and date, a line each, for the head of a table.
#[must_use]
pub fn description() -> String {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let build = if cfg!(debug_assertions) { "with debug assertions: not for comparison" } else { "release" };
    format!(
        "- processor: {}, {} threads\n- system: {}\n- Vitrum {}{}, {build}\n- date: {}",
        processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned()),
        threads(),
        release().map_or(system.clone(), |release| format!("{system}, {release}")),
        env!("CARGO_PKG_VERSION"),
        commit().map_or(String::new(), |commit| format!(" ({commit})")),
        today(),
    )
}

/// Threads that run at once.
#[must_use]
pub fn threads() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Forgets the most memory that this process has had, so that it can be measured anew; whether the system can (Linux).
pub fn forget_peak_memory() -> bool {
    fs::write("/proc/self/clear_refs", "5").is_ok()
}

fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// The distribution's name for itself.
fn release() -> Option<String> {
    let text = fs::read_to_string("/etc/os-release").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="))?;
    Some(line.trim_matches('"').to_owned())
}

/// The commit that is checked out, and whether files have changed since.
fn commit() -> Option<String> {
    let mut git = Command::new("git");
    git.current_dir(crate::root()).args(["--no-optional-locks", "describe", "--always", "--dirty"]);
    let output = git.output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}

/// The date in UTC.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (year, month, day) = date(seconds / 86_400);
    format!("{year}-{month:02}-{day:02}")
}

/// Year, month and day, so many days after 1 January 1970.
///
/// H. Hinnant, "chrono-compatible low-level date algorithms", `civil_from_days`: years begin in March, so that the leap day
/// is the last of a year.
fn date(days: u64) -> (u64, u64, u64) {
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 { month_from_march + 3 } else { month_from_march - 9 };
    (era * 400 + year_of_era + u64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_those_of_the_calendar() {
        let expected = [(0, (1970, 1, 1)), (59, (1970, 3, 1)), (11_016, (2000, 2, 29)), (11_017, (2000, 3, 1))];
        for (days, date_then) in expected {
            assert_eq!(date(days), date_then);
        }
        assert_eq!((date(20_453), date(20_454)), ((2025, 12, 31), (2026, 1, 1)));
    }

    #[test]
    fn the_description_names_the_version() {
        let text = description();
        assert!(text.lines().count() == 4 && text.contains(env!("CARGO_PKG_VERSION")), "{text}");
    }
}
