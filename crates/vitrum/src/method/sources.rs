//! Samples of a light of finite size: directions, or positions.

use glam::DVec3;

/// Unit directions that stand for a distant source around `direction` whose angular radius is given in degrees: `direction` alone if
/// `count` is 1, else a sunflower's seeds over the source's disc, each for the same share of its area (Vogel 1979).
pub(super) fn sources(direction: DVec3, angular_radius: f32, count: u32) -> Vec<[f32; 3]> {
    let tangent = libm::tan(f64::from(angular_radius).to_radians());
    let (across, up) = direction.any_orthonormal_pair();
    (0..count)
        .map(|seed| {
            let radius = if count == 1 { 0.0 } else { ((f64::from(seed) + 0.5) / f64::from(count)).sqrt() * tangent };
            let (sin, cos) = libm::sincos(golden_angle() * f64::from(seed));
            let towards = direction + (across * cos + up * sin) * radius;
            // Adding 0 leaves no negative zero, by which unrefracted light would seem to move.
            (towards.normalize().as_vec3() + glam::Vec3::ZERO).to_array()
        })
        .collect()
}

/// Points of the unit ball as samples of a ball that shines: seen from any side, they are spread evenly over its disc, each for the
/// same share of its light.
///
/// A density of points 1 / √(1 − r²) is the one whose projection along any direction is the same all over the disc. It depends on the
/// distance from the middle alone, so that light that falls with the square of the distance is, all points together, that of one
/// in the middle. Radii take its shares in the order of a sequence of small discrepancy, directions are a spiral's (Vogel 1979).
pub(super) fn ball(count: u32) -> Vec<DVec3> {
    /// 1 over the root of x⁴ = x + 1: the first number of the sequence for three dimensions.
    const STEP: f64 = 0.819_172_513_396_164_4;
    let place = |index: u32| ((f64::from(index) + 0.5) * STEP).fract();
    let mut order: Vec<u32> = (0..count).collect();
    order.sort_by(|a, b| place(*a).total_cmp(&place(*b)));
    let mut points = vec![DVec3::ZERO; count as usize];
    for (rank, index) in (0..).zip(order) {
        let radius = radius_within((f64::from(rank) + 0.5) / f64::from(count));
        let (z, angle) = (1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(count), golden_angle() * f64::from(index));
        let across = (1.0 - z * z).sqrt();
        let (sin, cos) = libm::sincos(angle);
        points[index as usize] = DVec3::new(across * cos, across * sin, z) * radius;
    }
    points
}

/// The radius within which a share of the density 1 / √(1 − r²) lies, 0 to 1: with r = sin φ the share is 2 (φ − sin φ cos φ) / π.
fn radius_within(share: f64) -> f64 {
    let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let (sin, cos) = libm::sincos(middle);
        let found = (middle - sin * cos) * std::f64::consts::FRAC_2_PI;
        if found < share { low = middle } else { high = middle }
    }
    libm::sin(low)
}

/// The golden angle, in radians: the angle from one point of a sunflower to the next (Vogel 1979).
fn golden_angle() -> f64 {
    std::f64::consts::PI * (3.0 - 5.0f64.sqrt())
}

#[cfg(test)]
mod tests {
    use super::ball;
    use glam::DVec3;

    /// Area of the part of the unit disc up to `x`.
    fn segment(x: f64) -> f64 {
        0.5 + (libm::asin(x) + x * (1.0 - x * x).sqrt()) / std::f64::consts::PI
    }

    #[test]
    fn points_of_a_ball_are_spread_over_its_disc_from_every_side() {
        let points = ball(64);
        for side in ball(40).into_iter().filter_map(DVec3::try_normalize) {
            for x in (-20..=20).map(|step| f64::from(step) / 20.0) {
                let found = points.iter().filter(|point| point.dot(side) <= x).count() as f64 / 64.0;
                assert!((found - segment(x)).abs() < 0.08, "{found} up to {x} along {side}, not {}", segment(x));
            }
        }
    }

    #[test]
    fn light_of_a_ball_is_that_of_its_middle() {
        let points = ball(64);
        for from in [DVec3::X * 2.0, DVec3::new(-1.5, 2.0, 1.0), DVec3::Z * 4.0] {
            let flux = |at: DVec3| (from - at).normalize() / (from - at).length_squared();
            let mean = points.iter().map(|&at| flux(at)).sum::<DVec3>() / 64.0;
            assert!((mean - flux(DVec3::ZERO)).length() < 0.02 * flux(DVec3::ZERO).length(), "{mean}");
        }
    }
}
