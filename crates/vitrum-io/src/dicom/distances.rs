//! Distances of the slices of a series: whether they make a grid, and positions that do.

use glam::DVec3;

use super::image::Slice;
use crate::error::{Error, Place, Report};
use crate::source::Assumptions;

/// Distances of slices that differ by less than this share are rounded ones.
const EVEN: f64 = 0.02;

/// The largest distance may be so many times the smallest: with a slice missing it is twice.
const UNEVEN: f64 = 1.5;

/// Fails where two slices lie at one place, or one seems to be missing.
pub(super) fn check_distances(slices: &[Slice], order: &[usize], heights: &[f64]) -> Result<(), Error> {
    let mut gaps: Vec<f64> = heights.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let name = |index: usize| {
        let Slice { file, index: [_, frame], .. } = &slices[order[index]];
        let name = file.short_name();
        if file.frames.len() > 1 { format!("frame {} of {name}", frame + 1) } else { name }
    };
    let refuse = |index: usize, problem: String, advice: &str| {
        let report = Report::new(&slices[order[index]].file.name);
        Err(report.invalid(Place::File, problem, advice))
    };
    let widest = gaps.iter().copied().fold(0.0, f64::max);
    if let Some(index) = gaps.iter().position(|&gap| gap <= 1e-3 * widest || gap < 1e-6) {
        let problem = format!("{} and {} lie at the same place", name(index), name(index + 1));
        return refuse(index, problem, "keep one of them: each point in time or echo needs a folder of its own");
    }
    let unsorted = gaps.clone();
    gaps.sort_by(f64::total_cmp);
    let Some((&smallest, &usual)) = gaps.first().zip(gaps.get(gaps.len() / 2)) else { return Ok(()) };
    if widest <= UNEVEN * smallest {
        return Ok(());
    }
    let index = unsorted.iter().position(|&gap| gap == widest).unwrap_or(0);
    let (below, above) = (name(index), name(index + 1));
    let missing = (widest / usual).round() - 1.0;
    // A whole number of slices at the usual distance would fit in between.
    let fits = (widest - (missing + 1.0) * usual).abs() < 0.1 * usual && smallest * UNEVEN > usual;
    let between = format!("{widest:.3} mm between {below} and {above}");
    if missing >= 1.0 && fits {
        let problem = format!("{missing} slice(s) seem to be missing: {between}, and {usual:.3} mm elsewhere");
        return refuse(index, problem, "get the whole series");
    }
    refuse(
        index,
        format!(
            "the slices lie too unevenly: from {smallest:.3} mm to {between}, and at most {UNEVEN} times the smallest \
             distance is evened out"
        ),
        "get the whole series, or resample it by a program that knows it",
    )
}

/// Fails where slices lie beside the line from the first to the last.
pub(super) fn check_line(
    slices: &[Slice],
    order: &[usize],
    positions: &[[f64; 3]],
    heights: &[f64],
    spacing: [f64; 2],
) -> Result<(), Error> {
    let last = positions.len() - 1;
    let (start, end) = (positions[0], positions[last]);
    let length = heights[last] - heights[0];
    // As far as a rounded position may be off, and no more than shows.
    let most = 0.25 * spacing[0].min(spacing[1]).max(0.4);
    for (index, position) in positions.iter().enumerate().take(last).skip(1) {
        let share = (heights[index] - heights[0]) / length;
        let off = [0, 1, 2].map(|axis| position[axis] - start[axis] - share * (end[axis] - start[axis]));
        let off = DVec3::from(off).length();
        if off > most {
            return Err(Report::new(&slices[order[index]].file.name).invalid(
                Place::File,
                format!("the slice lies {off:.3} mm beside the line through the others, and {most:.3} mm are let pass"),
                "put only the slices of one volume into the series",
            ));
        }
    }
    Ok(())
}

/// Positions of the slices of an even grid among the file's slices; empty where these are even.
pub(super) fn uneven(heights: &[f64], assumptions: &mut Assumptions) -> Vec<f64> {
    let last = heights.len() - 1;
    let mean = (heights[last] - heights[0]) / last.max(1) as f64;
    let gaps = || heights.windows(2).map(|pair| pair[1] - pair[0]);
    if gaps().all(|gap| (gap - mean).abs() <= EVEN * mean) {
        return Vec::new();
    }
    let (smallest, largest) = (gaps().fold(f64::INFINITY, f64::min), gaps().fold(0.0, f64::max));
    assumptions.push(format!(
        "the slices lie unevenly, {smallest:.3} to {largest:.3} mm apart: they were interpolated linearly to {mean:.3} mm"
    ));
    let place = |index: usize| {
        let height = heights[0] + index as f64 * mean;
        let below = heights.partition_point(|&other| other <= height).clamp(1, last) - 1;
        let share = (height - heights[below]) / (heights[below + 1] - heights[below]);
        below as f64 + share.clamp(0.0, 1.0)
    };
    (0..=last).map(place).collect()
}
