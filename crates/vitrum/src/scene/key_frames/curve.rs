//! Smooth curves through points that never go beyond them.

/// Knots, in increasing order of place, and the numbers at each.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    places: Vec<f64>,
    /// For each component, its values at the knots and its slopes there.
    components: Vec<Component>,
}

#[derive(Debug, Clone, PartialEq)]
struct Component {
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Curve {
    /// A curve through `knots`, not empty, all with as many numbers as the first.
    pub fn new(knots: &[(f64, Vec<f64>)]) -> Self {
        let places: Vec<_> = knots.iter().map(|(place, _)| *place).collect();
        let width = knots.first().map_or(0, |(_, values)| values.len());
        let components = (0..width).map(|index| {
            let values: Vec<_> = knots.iter().map(|(_, values)| values[index]).collect();
            Component { slopes: slopes(&places, &values), values }
        });
        Self { components: components.collect(), places }
    }

    /// The numbers at a place; before the first knot and after the last one, the numbers of that knot.
    pub fn at(&self, place: f64) -> Vec<f64> {
        let next = self.places.partition_point(|&knot| knot <= place);
        let [first, last] = [0, self.places.len() - 1];
        if next == first || next > last {
            let knot = if next == first { first } else { last };
            return self.components.iter().map(|component| component.values[knot]).collect();
        }
        let span = self.places[next] - self.places[next - 1];
        let t = (place - self.places[next - 1]) / span;
        let [t2, t3] = [t * t, t * t * t];
        let hermite = |component: &Component| {
            let [from, to] = [next - 1, next].map(|knot| component.values[knot]);
            let [leaving, arriving] = [next - 1, next].map(|knot| component.slopes[knot] * span);
            let value = (2.0 * t3 - 3.0 * t2 + 1.0) * from
                + (t3 - 2.0 * t2 + t) * leaving
                + (3.0 * t2 - 2.0 * t3) * to
                + (t3 - t2) * arriving;
            // Exactly between, rounding included.
            value.clamp(from.min(to), from.max(to))
        };
        self.components.iter().map(hermite).collect()
    }
}

/// Slopes that keep the curve monotone between knots: the weighted harmonic mean of the chords on both sides (Fritsch and
/// Butland 1984), 0 where they point in opposite directions, and at the ends, where the motion begins and comes to rest with
/// the one-sided three-point estimate, limited alike.
fn slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let spans: Vec<_> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chords: Vec<_> = values.windows(2).zip(&spans).map(|(pair, span)| (pair[1] - pair[0]) / span).collect();
    let end = |[near, far]: [f64; 2], [chord, beyond]: [f64; 2]| {
        let slope = ((2.0 * near + far) * chord - near * beyond) / (near + far);
        if slope * chord <= 0.0 {
            0.0
        } else if chord * beyond < 0.0 && slope.abs() > 3.0 * chord.abs() {
            3.0 * chord
        } else {
            slope
        }
    };
    let knots = places.len();
    (0..knots)
        .map(|knot| match (knot, knots) {
            (_, 1) => 0.0,
            (_, 2) => chords[0],
            (0, _) => end([spans[0], spans[1]], [chords[0], chords[1]]),
            (knot, _) if knot + 1 == knots => {
                end([spans[knot - 1], spans[knot - 2]], [chords[knot - 1], chords[knot - 2]])
            }
            _ => {
                let [before, after] = [chords[knot - 1], chords[knot]];
                if before * after <= 0.0 {
                    return 0.0;
                }
                let weights = [2.0 * spans[knot] + spans[knot - 1], spans[knot] + 2.0 * spans[knot - 1]];
                (weights[0] + weights[1]) / (weights[0] / before + weights[1] / after)
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::Curve;

    fn curve(knots: &[(f64, f64)]) -> Curve {
        Curve::new(&knots.iter().map(|&(place, value)| (place, vec![value])).collect::<Vec<_>>())
    }

    #[test]
    fn it_goes_through_its_knots_and_rests_beyond_them() {
        let curve = curve(&[(1.0, 3.0), (2.0, 5.0), (7.0, -4.0)]);
        for (place, value) in [(-9.0, 3.0), (1.0, 3.0), (2.0, 5.0), (7.0, -4.0), (99.0, -4.0)] {
            assert_eq!(curve.at(place), [value]);
        }
    }

    /// Closed form: where all chords are alike, so are the slopes, and a cubic with them is the line. The bound is rounding.
    #[test]
    fn evenly_moving_knots_give_a_line() {
        let curve = curve(&[(0.0, 10.0), (3.0, 16.0), (4.0, 18.0), (10.0, 30.0)]);
        for step in 0..=100 {
            let place = f64::from(step) / 10.0;
            assert!((curve.at(place)[0] - (10.0 + 2.0 * place)).abs() < 1e-12, "{place}");
        }
    }

    #[test]
    fn it_never_goes_beyond_its_knots_and_has_no_corners() {
        let knots = [(0.0, 0.0), (1.0, 0.0), (2.0, 100.0), (2.5, 100.5), (9.0, 101.0), (10.0, -50.0), (11.0, 0.0)];
        let curve = curve(&knots);
        for pair in knots.windows(2) {
            let [(from, low), (to, high)] = [pair[0], pair[1]];
            let mut previous = low;
            for step in 0..=1000 {
                let value = curve.at(from + (to - from) * f64::from(step) / 1000.0)[0];
                assert!((value - previous) * (high - low) >= -1e-9, "not monotone from {from} to {to}");
                previous = value;
            }
        }
        // Slopes on both sides of a knot, by differences of 1e-6: the second derivative is below 1e4 here.
        for &(knot, value) in &knots[1..knots.len() - 1] {
            let [before, after] = [-1e-6, 1e-6].map(|step| (curve.at(knot + step)[0] - value) / step);
            assert!((before - after).abs() < 1e-2, "a corner at {knot}: {before} and {after}");
        }
    }

    #[test]
    fn components_do_not_mix() {
        let both = Curve::new(&[(0.0, vec![1.0, 8.0]), (1.0, vec![2.0, 8.0]), (5.0, vec![9.0, 8.0])]);
        let one = curve(&[(0.0, 1.0), (1.0, 2.0), (5.0, 9.0)]);
        assert_eq!(both.at(3.3), [one.at(3.3)[0], 8.0]);
    }
}
