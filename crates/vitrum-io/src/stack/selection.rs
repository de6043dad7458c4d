//! The pages of one volume, among those of several channels and points in time by ImageJ.

use super::spacing::Notes;
use crate::error::{Error, Place, Report, clip};
use crate::options::OpenOptions;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::time::Times;

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
        let [images, channels, slices, frames] =
            ["images", "channels", "slices", "frames"].map(|name| notes.count(name));
        if images > 1 && pages == 1 {
            return Err(report.unsupported(
                Place::File,
                format!("ImageJ wrote {images} images behind one page, as it does beyond 4 GiB"),
                "write it as BigTIFF, for example by Bio-Formats, or as several files",
            ));
        }
        let several_times = slices > 1 && frames > 1;
        if frames > 1 && slices <= 1 {
            assumptions.push("the pages are points in time, and were taken for slices".to_owned());
        }
        let all = channels.checked_mul(slices).and_then(|pages| pages.checked_mul(frames));
        if (channels > 1 || several_times) && all != Some(pages) {
            return Err(report.invalid(
                Place::File,
                format!(
                    "the pages are {channels} channels of {slices} slices at {frames} points in time, as ImageJ says, \
                     and {pages} are there"
                ),
                "get the whole file, or write it anew by ImageJ",
            ));
        }
        let channels = channels.max(1);
        let channel = channel(report, channels, options, assumptions)?;
        let count = if several_times { frames } else { 1 };
        let times = Times::choose(report, Place::File, count, options, assumptions)?;
        // Divides without rest: where there are several of either, the product is checked above.
        let slices = pages / channels / times.count;
        Ok(Self { first: channel + channels * slices * times.chosen, step: channels, count: slices })
    }

    /// Whether a page is one of the slices.
    pub fn contains(self, page: u64) -> bool {
        page.checked_sub(self.first)
            .is_some_and(|behind| behind.is_multiple_of(self.step) && behind / self.step < self.count)
    }
}

/// The channel that is asked for by its number, as ImageJ counts them from 1; counted from 0.
fn channel(report: Report, channels: u64, options: &OpenOptions, assumptions: &mut Assumptions) -> Result<u64, Error> {
    let Some(asked) = &options.array else {
        if channels > 1 {
            let fact = format!("the file has {channels} channels: the first was taken");
            assumptions.push(Assumption::replaceable(fact, Setting::Array, format!("1 to {channels}")));
        }
        return Ok(0);
    };
    let number = asked.parse().ok().filter(|number| channels > 1 && (1..=channels).contains(number));
    number.map(|number: u64| number - 1).ok_or_else(|| {
        let problem = format!("the array `{}` is asked for, and the file has {channels} channels", clip(asked));
        let advice =
            if channels > 1 { format!("give a number from 1 to {channels}") } else { "leave out the array".to_owned() };
        report.unsupported(Place::File, problem, advice).with_setting(Setting::Array)
    })
}
