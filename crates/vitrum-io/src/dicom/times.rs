//! Series with several points in time: the same places again and again.

use std::collections::BTreeMap;

use glam::DVec3;

use super::image::{Slice, TIMES, normal};
use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::source::Assumptions;
use crate::time::{Clock, Times};

/// The slices of the chosen point in time. All of them, where no two lie at one place, or nothing tells points in time apart: the
/// check of the distances then says which lie at one place.
pub(super) fn choose<'a>(
    report: Report,
    slices: Vec<Slice<'a>>,
    options: &OpenOptions,
    assumptions: &mut Assumptions,
) -> Result<Vec<Slice<'a>>, Error> {
    let found = places(&slices).and_then(|places| split(&slices, &places));
    let Some((groups, by)) = found else {
        Times::choose(report, Place::File, 1, &Clock::Unknown, options, assumptions)?;
        return Ok(slices);
    };
    let times =
        Times::choose(report, Place::File, groups.len() as u64, &clock(&slices, &groups, by), options, assumptions)?;
    assumptions.push(format!("the points in time were told apart by their {by}"));
    let chosen = &groups[times.chosen as usize];
    Ok(chosen.iter().map(|&index| slices[index].clone()).collect())
}

/// When points in time are: trigger times are in milliseconds, acquisition and content times are times of the day.
fn clock(slices: &[Slice], groups: &[Vec<usize>], by: &str) -> Clock {
    let Some(attribute) = TIMES.iter().position(|&(_, name)| name == by) else { return Clock::Unknown };
    let firsts = groups.iter().map(|group| slices.get(*group.first()?)?.times[attribute]);
    let Some(values) = firsts.collect::<Option<Vec<f64>>>() else { return Clock::Unknown };
    match by {
        "trigger times" => Clock::Stated(values.iter().map(|milliseconds| milliseconds * 1e-3).collect()),
        "acquisition times" | "content times" => {
            let moments = values.iter().map(|&value| {
                let whole = value.trunc();
                let (hours, minutes) = ((whole / 1e4).trunc(), (whole / 1e2).trunc() % 100.0);
                3600.0 * hours + 60.0 * minutes + value % 100.0
            });
            let moments: Vec<f64> = moments.collect();
            let first = moments.first().copied().unwrap_or_default();
            Clock::Stated(moments.iter().map(|moment| moment - first).collect())
        }
        _ => Clock::Unknown,
    }
}

/// The number of each slice's place, counted from the lowest; `None` where places are not known, or each is there once.
fn places(slices: &[Slice]) -> Option<Vec<usize>> {
    let axis = DVec3::from(normal(slices.first()?.orientation?));
    let heights: Vec<f64> = slices
        .iter()
        .map(|slice| slice.position.map(|position| DVec3::from(position).dot(axis)))
        .collect::<Option<_>>()?;
    let mut sorted = heights.clone();
    sorted.sort_by(f64::total_cmp);
    // Positions are written with some digits, and differ by less than a slice.
    let widest = sorted.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let tolerance = (1e-2 * widest).max(1e-4);
    sorted.dedup_by(|next, first| *next - *first <= tolerance);
    (sorted.len() < slices.len()).then(|| {
        let place = |height: &f64| sorted.partition_point(|place| *place <= *height + 1e-9).max(1) - 1;
        heights.iter().map(place).collect()
    })
}

/// The slices of each point in time, and what tells them apart: the first attribute of which each value has each place once.
fn split(slices: &[Slice], places: &[usize]) -> Option<(Vec<Vec<usize>>, &'static str)> {
    let count = places.iter().max()? + 1;
    for (attribute, &(_, name)) in TIMES.iter().enumerate() {
        let mut groups: BTreeMap<u64, Vec<usize>> = BTreeMap::new();
        let is_last = attribute + 1 == TIMES.len();
        if is_last {
            // Numbers of images count on over all of them: at each place, the first is of the first point in time.
            return in_turn(slices, places, count).map(|groups| (groups, name));
        }
        let Some(values) = slices.iter().map(|slice| slice.times[attribute]).collect::<Option<Vec<f64>>>() else {
            continue;
        };
        for (index, value) in values.iter().enumerate() {
            // In the order of the numbers: the sign bit turned over, and all bits below zero.
            let bits = (value + 0.0).to_bits();
            let key = if bits >> 63 == 0 { bits | 1 << 63 } else { !bits };
            groups.entry(key).or_default().push(index);
        }
        let is_whole = |group: &Vec<usize>| {
            let mut seen = vec![false; count];
            group.len() == count && group.iter().all(|&index| !std::mem::replace(&mut seen[places[index]], true))
        };
        if groups.len() > 1 && groups.values().all(is_whole) {
            return Some((groups.into_values().collect(), name));
        }
    }
    None
}

/// The slices in turn by their instance numbers, where each place is there equally often.
fn in_turn(slices: &[Slice], places: &[usize], count: usize) -> Option<Vec<Vec<usize>>> {
    let times = slices.len() / count;
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); count];
    (0..slices.len()).for_each(|index| at[places[index]].push(index));
    if times < 2 || at.iter().any(|group| group.len() != times) {
        return None;
    }
    let number = |index: &usize| slices[*index].times[TIMES.len() - 1];
    for group in &mut at {
        // Without numbers, or with equal ones, nothing says which comes first.
        let mut numbers: Vec<f64> = group.iter().map(number).collect::<Option<_>>()?;
        numbers.sort_by(f64::total_cmp);
        if numbers.windows(2).any(|pair| pair[0] == pair[1]) {
            return None;
        }
        group.sort_by(|a, b| number(a).unwrap_or_default().total_cmp(&number(b).unwrap_or_default()));
    }
    Some((0..times).map(|time| at.iter().map(|group| group[time]).collect()).collect())
}
