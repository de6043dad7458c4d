//! The cubic spline through values at equal distances, of many lines side by side.
//!
//! It is the one with continuous second derivatives, which a cubic B-spline with a prefilter is, too (Ruijters and Thévenaz 2012), and straight at both ends:
//! values along a straight line stay there up to the ends, where an even continuation would bend them.

/// How far a spline may go beyond two neighbouring values where it has an extremum between them, over the least of the second differences around. An
/// extremum of a parabola goes beyond by an eighth; farther away from that of a wave second differences are smaller.
const BEYOND: f32 = 0.5;

/// Places before one and behind the next that are looked at between the two.
pub(super) const AROUND: usize = 2;

/// Lanes of many lines: for each place along the lines, the values of all of them.
pub(super) type Lanes<'a> = &'a [f32];

/// The second derivatives of the spline, in values over squared distances. `of` gives the lanes of a place, out of `count`; `to` gets those of
/// all places, one behind the other.
pub(super) fn curvatures<'a>(count: usize, of: impl Fn(usize) -> Lanes<'a>, to: &mut [f32]) {
    to.fill(0.0);
    if count < 3 {
        return;
    }
    let lanes = to.len() / count;
    // Gaussian elimination in the matrix of 1, 4, 1 (Thomas 1949).
    let mut pivots = vec![0.0_f32; count];
    for at in 1..count - 1 {
        pivots[at] = 1.0 / (4.0 - pivots[at - 1]);
        let (before, here, next) = (of(at - 1), of(at), of(at + 1));
        let (done, own) = to.split_at_mut(at * lanes);
        let last = &done[(at - 1) * lanes..];
        for (lane, own) in own[..lanes].iter_mut().enumerate() {
            let second = (before[lane] - here[lane]) + (next[lane] - here[lane]);
            *own = (6.0 * second - last[lane]) * pivots[at];
        }
    }
    for at in (1..count - 1).rev() {
        let (own, behind) = to.split_at_mut((at + 1) * lanes);
        for (own, behind) in own[at * lanes..].iter_mut().zip(&behind[..lanes]) {
            *own -= pivots[at] * behind;
        }
    }
}

/// A place between those of values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Between {
    /// Beyond the outermost value, or on it: it goes on.
    End(usize),
    /// Behind value `usize`, by a share of the way to the next one.
    Behind(usize, f32),
}

impl Between {
    /// Place number `index` of a grid that is `factor` times as fine as that of `count` values, and covers the same cells.
    pub(super) fn new(index: usize, factor: u32, count: usize) -> Self {
        let factor = factor as usize;
        // Twice the place, over the factor: a place of value 0 is half a cell from the end.
        let halves = 2 * index + 1;
        if halves <= factor || halves >= (2 * count - 1) * factor {
            return Self::End(if halves <= factor { 0 } else { count - 1 });
        }
        let beyond = halves - factor;
        let behind = beyond / (2 * factor);
        Self::Behind(behind, (beyond % (2 * factor)) as f32 / (2 * factor) as f32)
    }
}

/// Writes the lanes of the spline at a place. `of` gives the lanes of the values, `count` places of them, and `curvatures` those that [`curvatures`] has found.
///
/// A spline swings beyond steep edges, where values that nobody measured would be matter of another kind. So between two values it stays between them, but
/// for an extremum that the second differences at both and at their neighbours speak for: those of an edge, or of a plate of two values, do not.
pub(super) fn evaluate<'a>(
    at: Between,
    count: usize,
    of: impl Fn(usize) -> Lanes<'a>,
    curvatures: &[f32],
    to: &mut [f32],
) {
    let (behind, share) = match at {
        Between::End(end) => return to.copy_from_slice(&of(end)[..to.len()]),
        Between::Behind(behind, share) => (behind, share),
    };
    let lanes = to.len();
    let (here, next) = (of(behind), of(behind + 1));
    // Beyond the ends values go on, and nothing speaks for an extremum.
    let at = |step: usize| of((behind + step).saturating_sub(AROUND).min(count - 1));
    let around = [at(0), at(1), here, next, at(4), at(5)];
    let (first, second) = (&curvatures[behind * lanes..][..lanes], &curvatures[(behind + 1) * lanes..][..lanes]);
    let bulge = share * (1.0 - share) / 6.0;
    let (of_first, of_second) = (bulge * (2.0 - share), bulge * (1.0 + share));
    for (lane, to) in to.iter_mut().enumerate() {
        let (a, b) = (here[lane], next[lane]);
        let spline = a + (b - a) * share - of_first * first[lane] - of_second * second[lane];
        let differs = |at: usize| (around[at - 1][lane] - around[at][lane]) + (around[at + 1][lane] - around[at][lane]);
        let (one, two, three, four) = (differs(1), differs(2), differs(3), differs(4));
        let hollow = one.min(two).min(three).min(four).max(0.0);
        let hump = one.max(two).max(three).max(four).min(0.0);
        *to = spline.clamp(a.min(b) - BEYOND * hollow, a.max(b) - BEYOND * hump);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spline(values: &[f32], factor: u32) -> Vec<f32> {
        let count = values.len();
        let of = |at: usize| &values[at..=at];
        let mut found = vec![0.0; count];
        curvatures(count, of, &mut found);
        let places = (0..count * factor as usize).map(|index| Between::new(index, factor, count));
        places
            .map(|place| {
                let mut value = [0.0];
                evaluate(place, count, of, &found, &mut value);
                value[0]
            })
            .collect()
    }

    #[test]
    fn places_are_the_middles_of_finer_cells() {
        assert_eq!(Between::new(0, 2, 3), Between::End(0));
        assert_eq!(Between::new(1, 2, 3), Between::Behind(0, 0.25));
        assert_eq!(Between::new(2, 2, 3), Between::Behind(0, 0.75));
        assert_eq!(Between::new(4, 2, 3), Between::Behind(1, 0.75));
        assert_eq!(Between::new(5, 2, 3), Between::End(2));
        assert_eq!([0, 1, 2].map(|index| Between::new(index, 3, 1)), [Between::End(0); 3]);
        assert_eq!(Between::new(4, 3, 3), Between::Behind(1, 0.0));
    }

    #[test]
    fn values_and_straight_lines_stay() {
        let values = [3.0, -1.0, 4.0, 1.0, -5.0, 9.0, 2.0];
        let fine = spline(&values, 3);
        for (at, value) in values.iter().enumerate() {
            assert_eq!(fine[3 * at + 1], *value);
        }
        let line: Vec<f32> = (0..9).map(|at| at as f32 * 0.5 - 1.0).collect();
        for (index, value) in spline(&line, 4).into_iter().enumerate() {
            let exact = ((index as f32 + 0.5) / 4.0 - 0.5).clamp(0.0, 8.0) * 0.5 - 1.0;
            assert!((value - exact).abs() < 1e-6, "{index}: {value}, exactly {exact}");
        }
        assert_eq!((spline(&[7.0], 2), spline(&[1.0, 3.0], 2)), (vec![7.0; 2], vec![1.0, 1.5, 2.5, 3.0]));
    }

    #[test]
    fn edges_have_no_swings_and_extrema_do() {
        let edge = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let fine = spline(&edge, 4);
        assert!(fine.iter().all(|value| (0.0..=1.0).contains(value)), "{fine:?}");
        assert!(fine.windows(2).all(|pair| pair[0] <= pair[1]), "{fine:?}");
        let plate = spline(&[0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0], 4);
        assert!(plate.iter().all(|value| (0.0..=1.0).contains(value)), "{plate:?}");
        // The top of a parabola between two values that are 1/4 below: the nearest place is a tenth away from it.
        let top: Vec<f32> = (0..12).map(|at| at as f32 - 5.5).map(|from_top| -from_top * from_top).collect();
        let fine = spline(&top, 5);
        let highest = fine.iter().copied().fold(f32::MIN, f32::max);
        assert!((highest + 0.01).abs() < 1e-3, "{highest}");
    }
}
