//! Light rays through a field of which the index of refraction is a formula, in double precision.

/// The slope of η²/2 at a point of a plane, `[across, along]`.
pub type Slope<'a> = &'a dyn Fn([f64; 2]) -> [f64; 2];

/// A ray that has left the field: its place at `along` = `at`, and how far it moves across for each unit along.
#[derive(Debug, Clone, Copy)]
pub struct Left {
    /// Place across.
    pub across: f64,
    /// Place along.
    pub at: f64,
    /// Change of the place across over the place along.
    pub slope: f64,
}

impl Left {
    /// Where it is farther on.
    #[must_use]
    pub fn across_at(&self, along: f64) -> f64 {
        self.across + self.slope * (along - self.at)
    }
}

/// Follows a ray in a plane from `across` at `along` = `from`, where η is 1 and light travels straight along, to where it has passed `to`, by
/// the classical Runge–Kutta rule on dx/dσ = v, dv/dσ = ½∇η². `None` if it turns back.
#[must_use]
pub fn follow(slope: Slope<'_>, across: f64, ends: [f64; 2], step: f64) -> Option<Left> {
    follow_towards(slope, across, [0.0, 1.0], ends, step)
}

/// As [`follow`], for a ray that sets out in the unit direction `towards`.
#[must_use]
pub fn follow_towards(
    slope: Slope<'_>,
    across: f64,
    towards: [f64; 2],
    [from, to]: [f64; 2],
    step: f64,
) -> Option<Left> {
    let (mut x, mut v) = ([across, from], towards);
    let moved = |a: [f64; 2], b: [f64; 2], by: f64| [a[0] + b[0] * by, a[1] + b[1] * by];
    while x[1] < to {
        let (k1, a1) = (v, slope(x));
        let (k2, a2) = (moved(v, a1, 0.5 * step), slope(moved(x, k1, 0.5 * step)));
        let (k3, a3) = (moved(v, a2, 0.5 * step), slope(moved(x, k2, 0.5 * step)));
        let (k4, a4) = (moved(v, a3, step), slope(moved(x, k3, step)));
        for axis in 0..2 {
            x[axis] += step / 6.0 * (k1[axis] + 2.0 * k2[axis] + 2.0 * k3[axis] + k4[axis]);
            v[axis] += step / 6.0 * (a1[axis] + 2.0 * a2[axis] + 2.0 * a3[axis] + a4[axis]);
        }
        if v[1] <= 0.0 {
            return None;
        }
    }
    Some(Left { across: x[0], at: x[1], slope: v[0] / v[1] })
}
