//! Series of files by number: `flow_0000.vti`, `flow_0001.vti` and so on, as simulations write points in time.

use std::fs;
use std::path::{Path, PathBuf};

use super::Vti;
use crate::error::{Error, Place, Report};
use crate::input::Input;
use crate::moments::Moments;
use crate::options::OpenOptions;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::time::{Clock, Times};
use crate::volume::Volume;

/// More files than these are not looked through.
const MOST_FILES: usize = 100_000;

/// Reads a file, or another of its series where the options ask for a point in time.
pub(super) fn read(input: &Input, options: &OpenOptions) -> Result<Volume, Error> {
    let series = if input.is_at_path() { Series::of(input.path()) } else { None };
    let alone = || Vti.read_alone(input, options);
    let Some(series) = series else {
        let mut told = Assumptions::default();
        Times::choose(Report::new(&input.name), Place::File, 1, &Clock::Unknown, options, &mut told)?;
        return alone();
    };
    let count = series.files.len() as u64;
    if options.time.is_none() && options.seconds.is_none() {
        let mut volume = alone()?;
        let fact = format!("the file is number {} of {count} of its name, counted from 0: it was taken", series.own);
        let choices = format!("0 to {}", count - 1);
        volume.source.assumptions.push(Assumption::replaceable(fact, Setting::Time, choices));
        volume.source.assumptions.set_moments(Moments { count, chosen: series.own, seconds: None });
        return Ok(volume);
    }
    let mut told = Assumptions::default();
    let times = Times::choose(Report::new(&input.name), Place::File, count, &Clock::Unknown, options, &mut told)?;
    // Below the count, which is that of the files.
    let path = usize::try_from(times.chosen).ok().and_then(|chosen| series.files.get(chosen));
    let path = path.map_or(input.path(), PathBuf::as_path);
    let mut file = Input::new(path, options)?;
    file.unpack(options)?;
    let mut volume = Vti.read_alone(&file, options)?;
    volume.source.assumptions.extend(told);
    volume.source.assumptions.set_moments(Moments { count, chosen: times.chosen, seconds: None });
    Ok(volume)
}

/// The files whose names differ by one number, in its order.
struct Series {
    files: Vec<PathBuf>,
    /// The place of the file itself.
    own: u64,
}

impl Series {
    /// `None` where the name has no number at its end, or no other file has such a name.
    fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let (stem, extension) = parts(name)?;
        let digits = stem.len() - stem.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let prefix = stem.get(..stem.len() - digits).filter(|_| digits > 0)?;
        let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        let mut files: Vec<(u64, String)> = Vec::new();
        for entry in fs::read_dir(folder).ok()?.take(MOST_FILES) {
            let Some(other) = entry.ok().and_then(|entry| entry.file_name().into_string().ok()) else { continue };
            let number = parts(&other).filter(|(_, end)| *end == extension).and_then(|(stem, _)| {
                let digits = stem.strip_prefix(prefix)?;
                let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
                plain.then(|| digits.parse().ok()).flatten()
            });
            files.extend(number.map(|number| (number, other)));
        }
        files.sort();
        let own = files.iter().position(|(_, other)| other == name)? as u64;
        let beside = |(_, other): (u64, String)| path.with_file_name(other);
        (files.len() > 1).then(|| Self { files: files.into_iter().map(beside).collect(), own })
    }
}

/// A name without its extensions, and these.
fn parts(name: &str) -> Option<(&str, &str)> {
    let end = name.to_ascii_lowercase().rfind(".vti")?;
    Some((name.get(..end)?, name.get(end..)?))
}
