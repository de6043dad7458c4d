//! Functions of a file as pieces of straight lines.

use super::check_points;
use super::color_space::{ColorSpace, color_at, linear};
use crate::error::{Error, Place, Report};
use crate::source::Assumptions;

/// Most points of a function that is handed on: tables of the renderer have fewer entries.
const MOST: usize = 512;

/// A point of VTK's functions: the way to the next point is bent by `midpoint` and `sharpness`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point<const N: usize> {
    pub x: f64,
    pub y: [f64; N],
    /// Where between this point and the next the middle value is, from 0 to 1.
    pub midpoint: f64,
    /// From 0, a line, to 1, a step.
    pub sharpness: f64,
    pub place: Place,
}

impl<const N: usize> Point<N> {
    pub fn new(x: f64, y: [f64; N], place: Place) -> Self {
        Self { x, y, midpoint: 0.5, sharpness: 0.0, place }
    }

    pub fn bent(self, midpoint: f64, sharpness: f64) -> Self {
        Self { midpoint, sharpness, ..self }
    }

    /// The share of the way between the values at a share of the way between the scalars, as `vtkPiecewiseFunction` has it.
    fn share(&self, t: f64) -> f64 {
        let (middle, sharpness) = (self.midpoint.clamp(1e-5, 1.0 - 1e-5), self.sharpness.clamp(0.0, 1.0));
        let s = if t < middle { 0.5 * t / middle } else { 0.5 + 0.5 * (t - middle) / (1.0 - middle) };
        if sharpness > 0.99 {
            return if s < 0.5 { 0.0 } else { 1.0 };
        }
        if sharpness < 0.01 {
            return s;
        }
        let power = 1.0 + 10.0 * sharpness;
        let s = if s < 0.5 { 0.5 * libm::pow(2.0 * s, power) } else { 1.0 - 0.5 * libm::pow(2.0 - 2.0 * s, power) };
        let (square, cube) = (s * s, s * s * s);
        // A cubic of Hermite between 0 and 1 with the slope 1 − sharpness at either end.
        let ends = -2.0 * cube + 3.0 * square;
        ends + (1.0 - sharpness) * (2.0 * cube - 3.0 * square + s)
    }

    /// The parts into which the way to the next point is divided; 1 where it is a line.
    fn parts(&self) -> u32 {
        match () {
            () if self.sharpness >= 0.01 => 24,
            () if (self.midpoint - 0.5).abs() > 1e-6 => 16,
            () => 1,
        }
    }
}

/// The colours of a file, in sRGB code values.
#[derive(Debug, Default)]
pub(super) struct Colors {
    pub points: Vec<Point<3>>,
    pub space: ColorSpace,
}

/// The opacities of a file.
#[derive(Debug, Default)]
pub(super) struct Opacities {
    pub points: Vec<Point<1>>,
}

impl Colors {
    pub fn sampled(mut self, report: Report, assumptions: &mut Assumptions) -> Result<Vec<(f32, [f32; 3])>, Error> {
        check(report, &mut self.points, "colours", assumptions)?;
        let space = self.space;
        let color = |from: &Point<3>, to: &Point<3>, t: f64| linear(color_at(space, from.y, to.y, from.share(t)));
        let parts = |from: &Point<3>, to: &Point<3>| match space {
            ColorSpace::Step => 1,
            _ if from.y == to.y => 1,
            // Straight in code values is bent in linear light.
            ColorSpace::Rgb => from.parts().max(12),
            ColorSpace::Diverging | ColorSpace::Lab | ColorSpace::Hsv => 32,
        };
        let points = match space {
            ColorSpace::Step => steps(&self.points),
            _ => sampled(&self.points, parts, color),
        };
        Ok(limited(&points))
    }
}

/// The colour of each point up to the next.
fn steps(points: &[Point<3>]) -> Vec<(f32, [f32; 3])> {
    let mut all = Vec::with_capacity(2 * points.len());
    for (index, point) in points.iter().enumerate() {
        if let Some(before) = index.checked_sub(1).and_then(|before| points.get(before)) {
            all.push((point.x as f32, linear(before.y)));
        }
        all.push((point.x as f32, linear(point.y)));
    }
    all
}

impl Opacities {
    pub fn sampled(mut self, report: Report, assumptions: &mut Assumptions) -> Result<Vec<(f32, f32)>, Error> {
        check(report, &mut self.points, "opacities", assumptions)?;
        let value =
            |from: &Point<1>, to: &Point<1>, t: f64| [(from.y[0] + (to.y[0] - from.y[0]) * from.share(t)) as f32];
        let parts = |from: &Point<1>, to: &Point<1>| if from.y == to.y { 1 } else { from.parts() };
        let points = limited(&sampled(&self.points, parts, value));
        Ok(points.into_iter().map(|(x, [opacity])| (x, opacity)).collect())
    }
}

/// Fails where a scalar or a value is none; sorts the points, and brings values into 0 to 1, both of which is told.
fn check<const N: usize>(
    report: Report,
    points: &mut [Point<N>],
    what: &str,
    assumptions: &mut Assumptions,
) -> Result<(), Error> {
    check_points(report, points.first().map_or(Place::File, |point| point.place), points.len())?;
    for point in points.iter() {
        let whole = (point.x as f32).is_finite() && point.y.iter().all(|value| value.is_finite());
        if !whole || point.midpoint.is_nan() || point.sharpness.is_nan() {
            let problem = format!("a point of the {what} is not finite: {} at {}", shown(&point.y), point.x);
            return Err(report.invalid(point.place, problem, "write finite numbers"));
        }
    }
    let outside = |value: &&mut f64| !(0.0..=1.0).contains(&**value);
    let mut clamped = 0;
    for value in points.iter_mut().flat_map(|point| &mut point.y).filter(outside) {
        *value = value.clamp(0.0, 1.0);
        clamped += 1;
    }
    if clamped > 0 {
        assumptions
            .push(format!("{clamped} values of the {what} are not between 0 and 1: they were given the nearer end"));
    }
    if !points.is_sorted_by(|a, b| a.x <= b.x) {
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        assumptions.push(format!("the points of the {what} are not in order: they were sorted"));
    }
    Ok(())
}

fn shown(values: &[f64]) -> String {
    values.iter().map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
}

fn sampled<const N: usize, const M: usize>(
    points: &[Point<N>],
    parts: impl Fn(&Point<N>, &Point<N>) -> u32,
    value: impl Fn(&Point<N>, &Point<N>, f64) -> [f32; M],
) -> Vec<(f32, [f32; M])> {
    let Some(last) = points.last() else { return Vec::new() };
    // A function of very many points is fine enough as it is.
    let fine = points.len() > MOST;
    let mut all = Vec::new();
    for pair in points.windows(2) {
        let [from, to] = [&pair[0], &pair[1]];
        let parts = if fine { 1 } else { parts(from, to) };
        for part in 0..parts {
            let t = f64::from(part) / f64::from(parts);
            let x = from.x + (to.x - from.x) * t;
            all.push((x as f32, value(from, to, t)));
        }
    }
    all.push((last.x as f32, value(last, last, 0.0)));
    all
}

/// At most `MOST` points, with the least error that this takes.
fn limited<const N: usize>(points: &[(f32, [f32; N])]) -> Vec<(f32, [f32; N])> {
    let mut tolerance = 5e-4;
    let mut fewer = simplify(points, tolerance);
    while fewer.len() > MOST && tolerance < 1.0 {
        tolerance *= 2.0;
        fewer = simplify(points, tolerance);
    }
    fewer
}

/// The points without those that lines between the others meet within `tolerance`. Ends and steps stay.
#[must_use]
pub fn simplify<const N: usize>(points: &[(f32, [f32; N])], tolerance: f32) -> Vec<(f32, [f32; N])> {
    let mut kept = vec![false; points.len()];
    let mut spans = Vec::new();
    // Steps part the function.
    let mut first = 0;
    for index in 0..points.len() {
        let jumps = points.get(index + 1).is_none_or(|next| next.0 == points[index].0);
        if jumps {
            (kept[first], kept[index]) = (true, true);
            spans.push((first, index));
            first = index + 1;
        }
    }
    while let Some((start, end)) = spans.pop() {
        let (from, to) = (points[start], points[end]);
        let error = |index: &usize| {
            let (x, y) = points[*index];
            let t = if to.0 > from.0 { (x - from.0) / (to.0 - from.0) } else { 0.0 };
            (0..N).map(|i| (from.1[i] + (to.1[i] - from.1[i]) * t - y[i]).abs()).fold(0.0, f32::max)
        };
        let worst = (start + 1..end).max_by(|a, b| error(a).total_cmp(&error(b)));
        if let Some(worst) = worst.filter(|worst| error(worst) > tolerance) {
            kept[worst] = true;
            spans.extend([(start, worst), (worst, end)]);
        }
    }
    points.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bent_ways_are_those_of_vtk() {
        let point = |midpoint, sharpness| Point::new(0.0, [0.0], Place::File).bent(midpoint, sharpness);
        for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
            assert!((point(0.5, 0.0).share(t) - t).abs() < 1e-12);
        }
        assert_eq!(point(0.25, 0.0).share(0.25), 0.5);
        assert_eq!([0.4, 0.6].map(|t| point(0.5, 1.0).share(t)), [0.0, 1.0]);
        // At half the sharpness the middle is the middle, and the way there is flat at first.
        let half = point(0.5, 0.5);
        assert!((half.share(0.5) - 0.5).abs() < 1e-12 && half.share(0.25) < 0.05 && half.share(0.75) > 0.95);
    }

    #[test]
    fn simplified_points_are_met_within_the_tolerance() {
        let square: Vec<_> = (0..=100).map(|i| i as f32 / 100.0).map(|x| (x, [x * x])).collect();
        let fewer = simplify(&square, 1e-3);
        assert!(
            fewer.len() < 25 && fewer.first() == square.first() && fewer.last() == square.last(),
            "{}",
            fewer.len()
        );
        for (x, [y]) in square {
            let after = fewer.partition_point(|point| point.0 < x).max(1);
            let (a, b) = (fewer[after - 1], fewer[after]);
            let met = a.1[0] + (b.1[0] - a.1[0]) * (x - a.0) / (b.0 - a.0);
            assert!((met - y).abs() <= 1.001e-3, "{x}: {met}");
        }
        let step = [(0.0, [0.0]), (1.0, [0.0]), (1.0, [1.0]), (2.0, [1.0])];
        assert_eq!(simplify(&step, 0.5), step);
    }
}
