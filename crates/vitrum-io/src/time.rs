//! Files with several points in time, of which one is read.

use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};

/// The points in time of a file, one after the other, and the one that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Times {
    pub count: u64,
    /// The chosen point in time, counted from 0 and below `count`.
    pub chosen: u64,
}

impl Times {
    /// The point that `options` ask for, else the first, which is said among the assumptions.
    pub fn choose(
        report: Report,
        place: Place,
        count: u64,
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Self, Error> {
        let last = count.saturating_sub(1);
        if options.time.is_none() && count > 1 {
            let fact = format!("the file has {count} points in time: the first was taken");
            assumptions.push(Assumption::replaceable(fact, Setting::Time, format!("0 to {last}")));
        }
        let chosen = u64::from(options.time.unwrap_or(0));
        if chosen > last {
            let problem = format!("the point in time {chosen} is asked for, and the file has {count}, counted from 0");
            let advice = format!("give a time from 0 to {last}");
            return Err(report.unsupported(place, problem, advice).with_setting(Setting::Time));
        }
        Ok(Self { count, chosen })
    }

    /// Bytes in front of the chosen point, and bytes of all, of `bytes` each.
    pub fn spans(self, report: Report, place: Place, bytes: u64) -> Result<(u64, u64), Error> {
        let all = bytes.checked_mul(self.count).filter(|&all| all <= u64::MAX >> 1).ok_or_else(|| {
            let problem = format!("{} points in time of {bytes} bytes are more than any file holds", self.count);
            report.invalid(place, problem, "correct the sizes")
        })?;
        // Less than all.
        Ok((bytes * self.chosen, all))
    }

    /// Whether the chosen point is the last.
    pub fn is_last(self) -> bool {
        self.chosen + 1 == self.count
    }
}
