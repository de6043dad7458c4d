//! The pages of one volume, among those of several channels and points in time by ImageJ.

use super::spacing::Notes;
use crate::arrays::listed;
use crate::error::{Error, Place, Report, clip};
use crate::options::OpenOptions;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::time::{Clock, Times};

/// Every so many pages of a file, counted without its thumbnails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Selection {
    first: u64,
    step: u64,
    pub count: u64,
}

impl Selection {
    /// The pages of one channel at one point in time among the `pages` of a file, all of them if there is one of each: ImageJ writes
    /// channels first, then slices, then times.
    pub fn of(
        report: Report,
        notes: &Notes,
        pages: u64,
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Self, Error> {
        let Axes { counts: [channels, slices, frames], mut strides, names, by } = Axes::of(notes);
        let several_times = slices > 1 && frames > 1;
        if frames > 1 && slices <= 1 {
            assumptions.push("the pages are points in time, and were taken for slices".to_owned());
        }
        let all = channels.checked_mul(slices).and_then(|pages| pages.checked_mul(frames));
        let several = channels > 1 || several_times;
        // Further images may stand behind the first.
        let fits = all == Some(pages) || notes.ome.as_ref().is_some_and(|ome| ome.images > 1) && all < Some(pages);
        if several && !fits {
            return Err(report.invalid(
                Place::File,
                format!(
                    "the pages are {channels} channels of {slices} slices at {frames} points in time, as {by} says, \
                     and {pages} are there"
                ),
                "get the whole file and those that belong to it, or write it anew by ImageJ",
            ));
        }
        let channel = channel(report, channels, &names, options, assumptions)?;
        let count = if several_times { frames } else { 1 };
        let times = Times::choose(report, Place::File, count, &Clock::Unknown, options, assumptions)?;
        let counted = if several && fits { slices.saturating_mul(frames) / count } else { pages };
        let images = notes.count("images");
        if notes.ome.is_none() && images != 1 && images != pages {
            assumptions
                .push(format!("ImageJ's description says {images} images, and {pages} are there: these were taken"));
        }
        if let Some(ome) = notes.ome.as_ref().filter(|ome| ome.images > 1) {
            assumptions.push(format!("the file has {} images, by OME-XML: the first was taken", ome.images));
        }
        if !several && fits && all < Some(pages) {
            return Ok(Self { first: 0, step: 1, count: slices.saturating_mul(frames) });
        }
        // Points in time that are taken for slices follow as these do.
        if !several_times && slices <= 1 {
            strides[1] = strides[2];
        }
        let step = if several { strides[1] } else { 1 };
        Ok(Self { first: channel * strides[0] + strides[2] * times.chosen, step, count: counted })
    }

    /// Whether a page is one of the slices.
    pub fn contains(self, page: u64) -> bool {
        page.checked_sub(self.first)
            .is_some_and(|behind| behind.is_multiple_of(self.step) && behind / self.step < self.count)
    }
}

/// The axes of a file that change from page to page.
struct Axes {
    /// Channels, slices and points in time, each at least 1.
    counts: [u64; 3],
    /// Pages from one of them to the next.
    strides: [u64; 3],
    /// Names of the channels, as far as they have some.
    names: Vec<String>,
    /// Who says so.
    by: &'static str,
}

impl Axes {
    fn of(notes: &Notes) -> Self {
        if let Some(ome) = &notes.ome {
            let counts = [ome.channels, ome.slices, ome.frames];
            return Self { counts, strides: ome.strides(), names: ome.names.clone(), by: "OME-XML" };
        }
        let [channels, slices, frames] = ["channels", "slices", "frames"].map(|name| notes.count(name).max(1));
        let strides = [1, channels, channels.saturating_mul(slices)];
        Self { counts: [channels, slices, frames], strides, names: Vec::new(), by: "ImageJ" }
    }
}

/// The channel that is asked for by its name, or by its number, as ImageJ counts them from 1; counted from 0.
fn channel(
    report: Report,
    channels: u64,
    names: &[String],
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<u64, Error> {
    let named: Vec<&str> = names.iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
    let shown = if named.is_empty() { String::new() } else { format!(" ({})", listed(named.iter().copied())) };
    let Some(asked) = &options.array else {
        if channels > 1 {
            let fact = format!("the file has {channels} channels{shown}: the first was taken");
            assumptions.push(Assumption::replaceable(fact, Setting::Array, format!("1 to {channels}")));
        }
        return Ok(0);
    };
    let by_name = names.iter().position(|name| name == asked).map(|index| index as u64);
    let number = asked.parse().ok().filter(|number| channels > 1 && (1..=channels).contains(number));
    let chosen = by_name.filter(|&index| index < channels).or_else(|| number.map(|number: u64| number - 1));
    chosen.ok_or_else(|| {
        let problem = format!("the array `{}` is asked for, and the file has {channels} channels{shown}", clip(asked));
        let advice =
            if channels > 1 { format!("give a number from 1 to {channels}") } else { "leave out the array".to_owned() };
        report.unsupported(Place::File, problem, advice).with_setting(Setting::Array)
    })
}
