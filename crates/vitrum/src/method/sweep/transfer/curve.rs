//! Piecewise linear functions of a scalar.

use super::window::Window;

/// A function of a scalar, linear between its points and constant beyond the first and the last. Two points at one place make a step.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::method::sweep) struct Curve<const N: usize> {
    /// Scalars in ascending order, and the values there; one point at least.
    points: Vec<(f64, [f64; N])>,
}

impl<const N: usize> Curve<N> {
    /// The function through `points`, or `otherwise` everywhere where there are none.
    pub(in crate::method::sweep) fn new(
        points: impl IntoIterator<Item = (f32, [f32; N])>,
        otherwise: [f32; N],
    ) -> Self {
        let points = points.into_iter().map(|(value, y)| (f64::from(value), y.map(f64::from)));
        let mut curve = Self { points: Vec::new() };
        points.for_each(|point| curve.push(point));
        if curve.points.is_empty() {
            curve.push((0.0, otherwise.map(f64::from)));
        }
        curve
    }

    /// Adds a point behind the others; of more than two points at one place, the first and the last count.
    fn push(&mut self, point: (f64, [f64; N])) {
        if let [.., one, other] = self.points[..]
            && one.0 == point.0
            && other.0 == point.0
        {
            self.points.pop();
        }
        self.points.push(point);
    }

    /// The places of its points.
    pub(in crate::method::sweep) fn places(&self) -> impl Iterator<Item = f64> {
        self.points.iter().map(|point| point.0)
    }

    /// The values at its points.
    pub(in crate::method::sweep) fn values(&self) -> impl Iterator<Item = [f64; N]> {
        self.points.iter().map(|point| point.1)
    }

    /// The first and the last place between which it changes; `None` where it is constant.
    pub(in crate::method::sweep) fn support(&self) -> Option<[f64; 2]> {
        match self.points[..] {
            [first, .., last] => Some([first.0, last.0]),
            _ => None,
        }
    }

    /// The value at `x`; at a step, the one behind it.
    pub(in crate::method::sweep) fn at(&self, x: f64) -> [f64; N] {
        let after = self.points.partition_point(|point| point.0 <= x);
        self.between(after, x)
    }

    /// The value just before `x`.
    fn before(&self, x: f64) -> [f64; N] {
        let after = self.points.partition_point(|point| point.0 < x);
        self.between(after, x)
    }

    /// The value at `x`, which lies between the points `after` − 1 and `after`.
    fn between(&self, after: usize, x: f64) -> [f64; N] {
        let Some(&(x1, y1)) = self.points.get(after) else {
            return self.points[after - 1].1;
        };
        let Some(&(x0, y0)) = after.checked_sub(1).and_then(|before| self.points.get(before)) else {
            return y1;
        };
        let t = (x - x0) / (x1 - x0);
        std::array::from_fn(|i| y0[i] + (y1[i] - y0[i]) * t)
    }

    /// The function of the values of three functions, of A, B and N − A − B values.
    pub(in crate::method::sweep) fn of_three<const A: usize, const B: usize, const C: usize>(
        a: &Curve<A>,
        b: &Curve<B>,
        c: &Curve<C>,
    ) -> Self {
        let joined = |a: [f64; A], b: [f64; B], c: [f64; C]| {
            let mut all = a.into_iter().chain(b).chain(c);
            std::array::from_fn(|_| all.next().unwrap_or_default())
        };
        let mut places: Vec<f64> = a.places().chain(b.places()).chain(c.places()).collect();
        places.sort_unstable_by(f64::total_cmp);
        places.dedup();
        let sides = places.into_iter().flat_map(|x| {
            let (before, at) = (joined(a.before(x), b.before(x), c.before(x)), joined(a.at(x), b.at(x), c.at(x)));
            std::iter::once((x, before)).chain((before != at).then_some((x, at)))
        });
        Self { points: sides.collect() }
    }

    /// The same function without the points at its ends that do not change what `seen` makes of it.
    pub(in crate::method::sweep) fn trimmed<T: PartialEq>(mut self, seen: impl Fn([f64; N]) -> T) -> Self {
        let same = |pair: &[(f64, [f64; N])]| seen(pair[0].1) == seen(pair[1].1);
        let first = self.points.windows(2).position(|pair| !same(pair)).unwrap_or(self.points.len() - 1);
        let last = self.points.windows(2).rposition(|pair| !same(pair)).map_or(first, |at| at + 1);
        self.points.truncate(last + 1);
        self.points.drain(..first);
        self
    }

    /// The same function over normalised scalars, in single precision. A step becomes a ramp of at most the width `ramp` before it, of which the
    /// last quarter is left out: at the step itself the second value holds, also where rounding shifts the scalar a little.
    pub(in crate::method::sweep) fn normalised(&self, window: Window, ramp: f64) -> Self {
        let mut points: Vec<(f64, [f64; N])> = Vec::with_capacity(self.points.len());
        for (i, &(x, y)) in self.points.iter().enumerate() {
            let place = window.normalised(x);
            let neighbour = |at: Option<usize>| at.and_then(|at| self.points.get(at)).is_some_and(|other| other.0 == x);
            let before = points.last().map(|point| point.0);
            let place = if neighbour(Some(i + 1)) {
                before.map_or(place - 1.25 * ramp, |before| (place - 1.25 * ramp).max(f64::midpoint(before, place)))
            } else if neighbour(i.checked_sub(1)) {
                before.map_or(place, |before| before + 0.8 * (place - before))
            } else {
                place
            };
            // Rounding must not bring points together.
            let least = before.map_or(f32::MIN, |before| (before as f32).next_up());
            points.push((f64::from((place as f32).max(least)), y));
        }
        Self { points }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[(f32, f32)]) -> Curve<1> {
        Curve::new(points.iter().map(|&(x, y)| (x, [y])), [7.0])
    }

    #[test]
    fn it_is_linear_between_points_and_constant_beyond() {
        let ramp = curve(&[(1.0, 0.0), (3.0, 1.0), (3.0, 5.0), (3.0, 4.0)]);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 9.0].map(|x| ramp.at(x)[0]), [0.0, 0.0, 0.5, 4.0, 4.0]);
        assert_eq!(ramp.before(3.0), [1.0]);
        assert_eq!(curve(&[]).at(3.0), [7.0]);
    }

    #[test]
    fn what_changes_nothing_is_no_support() {
        let peak = [(-9.0, 0.0), (1.0, 0.0), (2.0, 1.0), (3.0, 0.0), (1e9, 0.0)];
        assert_eq!(curve(&peak).trimmed(|y| y).support(), Some([1.0, 3.0]));
        assert_eq!(curve(&[(0.0, 2.0), (1.0, 2.0)]).trimmed(|y| y).support(), None);
        assert_eq!(curve(&[(4.0, 1.0), (4.0, 2.0), (6.0, 2.0)]).trimmed(|y| y).support(), Some([4.0, 4.0]));
        assert_eq!(curve(&[]).support(), None);
    }

    #[test]
    fn joined_functions_keep_their_steps() {
        let (a, b) = (curve(&[(0.0, 0.0), (2.0, 2.0)]), curve(&[(1.0, 5.0), (1.0, 6.0)]));
        let joined = Curve::<3>::of_three(&a, &b, &curve(&[]));
        assert_eq!(joined.places().collect::<Vec<_>>(), [0.0, 1.0, 1.0, 2.0]);
        assert_eq!((joined.before(1.0), joined.at(1.0)), ([1.0, 5.0, 7.0], [1.0, 6.0, 7.0]));
    }

    #[test]
    fn steps_become_ramps_before_them() {
        let window = Window { origin: 10.0, width: 10.0 };
        let step = curve(&[(10.0, 0.0), (15.0, 0.0), (15.0, 1.0), (20.0, 1.0)]).normalised(window, 1e-3);
        let places: Vec<f64> = step.places().collect();
        assert!(places.is_sorted_by(|a, b| a < b) && places[0] == 0.0 && places[3] == 1.0, "{places:?}");
        assert!((places[1] - 0.498_75).abs() < 1e-7 && (places[2] - 0.499_75).abs() < 1e-7, "{places:?}");
        assert_eq!((step.at(0.5), step.at(0.49)), ([1.0], [0.0]));
        // No place for the ramp.
        let tight = curve(&[(10.0, 0.0), (10.001, 0.5), (10.001, 1.0)]).normalised(window, 1e-3);
        assert!(tight.places().is_sorted_by(|a, b| a < b) && tight.at(1e-4) == [1.0]);
    }
}
