//! Points of a ray at equal angles from a point beside it.

use vitrum_kernels::glam::DVec3;

/// The least distance at which a ray passes a point, in world units: at none the light of a lamp there is infinite.
const LEAST_DISTANCE: f64 = 1e-12;

/// Points of a ray between two distances that are equally likely by the angle at which a point beside it sees them:
/// where light falls with the square of the distance from that point, all are of like weight (Kulla and Fajardo 2012).
pub(super) struct Angles {
    /// The distance along the ray at which it passes the point.
    foot: f64,
    /// The distance from the ray to the point.
    aside: f64,
    /// The angles of the two ends, from the foot.
    ends: [f64; 2],
}

impl Angles {
    /// The points of a ray of a unit direction, as seen from `beside`.
    pub(super) fn new(beside: DVec3, from: DVec3, towards: DVec3, ends: [f64; 2]) -> Self {
        let foot = (beside - from).dot(towards);
        let aside = (beside - from - towards * foot).length().max(LEAST_DISTANCE);
        Self { foot, aside, ends: ends.map(|end| ((end - foot) / aside).atan()) }
    }

    /// The distance of the point at a share of the angle.
    pub(super) fn at(&self, share: f64) -> f64 {
        let [first, last] = self.ends;
        self.foot + self.aside * (first + (last - first) * share).tan()
    }

    /// The density of points at a distance, in 1 / world unit.
    pub(super) fn density(&self, distance: f64) -> f64 {
        let [first, last] = self.ends;
        let along = distance - self.foot;
        self.aside / ((last - first) * (self.aside * self.aside + along * along))
    }
}
