//! Files with several points in time, of which one is read.

use crate::error::{Error, Place, Report};
use crate::moments::Moments;
use crate::options::OpenOptions;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};

/// The statements of a file about when its points in time are.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Clock {
    /// None.
    Unknown,
    /// The first moment and the distance to the next, in seconds.
    Steps { start: f64, step: f64 },
    /// Each moment in seconds.
    Stated(Vec<f64>),
}

impl Clock {
    /// Steps of a file; unknown where they are none.
    pub fn steps(start: f64, step: f64) -> Self {
        if step.is_finite() && step > 0.0 {
            Self::Steps { start: if start.is_finite() { start } else { 0.0 }, step }
        } else {
            Self::Unknown
        }
    }

    /// The moments of `count` points; `None` where they are unknown, or more than anyone goes through.
    fn moments(&self, count: u64) -> Option<Vec<f64>> {
        const MOST: u64 = 1 << 20;
        match self {
            Self::Steps { start, step } if count <= MOST => {
                Some((0..count).map(|index| start + index as f64 * step).collect())
            }
            Self::Stated(moments) if moments.len() as u64 == count && moments.is_sorted() => Some(moments.clone()),
            _ => None,
        }
    }
}

/// Seconds per unit of time, where the name is known.
pub(crate) fn seconds(unit: &str) -> Option<f64> {
    match unit.trim().to_lowercase().as_str() {
        "s" | "sec" | "secs" | "second" | "seconds" => Some(1.0),
        "ms" | "msec" | "millisecond" | "milliseconds" => Some(1e-3),
        "us" | "µs" | "μs" | "usec" | "microsecond" | "microseconds" => Some(1e-6),
        "ns" | "nsec" | "nanosecond" | "nanoseconds" => Some(1e-9),
        "min" | "minute" | "minutes" => Some(60.0),
        "h" | "hr" | "hour" | "hours" => Some(3600.0),
        _ => None,
    }
}

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
        clock: &Clock,
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Self, Error> {
        let last = count.saturating_sub(1);
        let moments = clock.moments(count);
        if let Some(asked) = options.seconds {
            let chosen = nearest(report, place, asked, count, moments.as_deref(), assumptions)?;
            assumptions.set_moments(Moments { count, chosen, seconds: moments });
            return Ok(Self { count, chosen });
        }
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
        assumptions.set_moments(Moments { count, chosen, seconds: moments });
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

/// The point that is nearest to a moment.
fn nearest(
    report: Report,
    place: Place,
    asked: f64,
    count: u64,
    moments: Option<&[f64]>,
    assumptions: &mut Assumptions,
) -> Result<u64, Error> {
    let refuse =
        |problem: String, advice: String| Err(report.unsupported(place, problem, advice).with_setting(Setting::Time));
    let Some(moments) = moments else {
        let problem =
            format!("the moment {asked} s is asked for, and the file does not say when its points in time are");
        return refuse(problem, format!("give a time from 0 to {} by its number", count.saturating_sub(1)));
    };
    let [first, last] = [moments.first(), moments.last()].map(|moment| moment.copied().unwrap_or_default());
    // Half a step beyond the ends still is the nearest of them.
    let margin = 0.5 * (last - first) / (moments.len().max(2) - 1) as f64 + 1e-9 * last.abs();
    if !(first - margin..=last + margin).contains(&asked) {
        let problem = format!("the moment {asked} s is asked for, and the file goes from {first} s to {last} s");
        return refuse(problem, "give a moment between".to_owned());
    }
    let distance = |index: &usize| (moments[*index] - asked).abs();
    let chosen = (0..moments.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default();
    if moments[chosen] != asked {
        assumptions
            .push(format!("the point in time at {} s is the nearest to {asked} s: it was taken", moments[chosen]));
    }
    Ok(chosen as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_time_are_known() {
        for (unit, expected) in [("s", 1.0), ("sec", 1.0), ("ms", 1e-3), ("msec", 1e-3), ("us", 1e-6), ("min", 60.0)] {
            assert_eq!(seconds(unit), Some(expected), "{unit}");
        }
        assert!(["", "m", "mm", "ppm"].iter().all(|unit| seconds(unit).is_none()));
    }

    #[test]
    fn the_nearest_moment_is_taken_and_told() {
        let options = |seconds| OpenOptions { seconds: Some(seconds), ..OpenOptions::default() };
        let clock = Clock::steps(1.0, 0.5);
        let choose = |clock: &Clock, seconds| {
            let mut told = Assumptions::default();
            let times = Times::choose(Report::new("a"), Place::File, 4, clock, &options(seconds), &mut told);
            (times.map(|times| times.chosen), told.facts().join(""))
        };
        assert_eq!(choose(&clock, 2.0).0.ok(), Some(2));
        assert_eq!(choose(&clock, 2.0).1, "");
        let (chosen, told) = choose(&clock, 1.6);
        assert!(chosen.is_ok_and(|chosen| chosen == 1) && told.contains("at 1.5 s is the nearest to 1.6 s"), "{told}");
        let beyond = choose(&clock, 3.0).0.expect_err("beyond the end");
        assert!(beyond.to_string().contains("from 1 s to 2.5 s"), "{beyond}");
        assert!(choose(&Clock::Unknown, 1.0).0.is_err());
    }
}
