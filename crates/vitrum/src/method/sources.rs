//! Directions in which a light of finite angular radius shines.

use glam::DVec3;

/// Unit directions that stand for a distant source around `direction` whose angular radius is given in degrees: `direction` alone if
/// `count` is 1, else a sunflower's seeds over the source's disc, each for the same share of its area (Vogel 1979).
pub(super) fn sources(direction: DVec3, angular_radius: f32, count: u32) -> Vec<[f32; 3]> {
    let tangent = libm::tan(f64::from(angular_radius).to_radians());
    let (across, up) = direction.any_orthonormal_pair();
    let golden = std::f64::consts::PI * (3.0 - 5.0f64.sqrt());
    (0..count)
        .map(|seed| {
            let radius = if count == 1 { 0.0 } else { ((f64::from(seed) + 0.5) / f64::from(count)).sqrt() * tangent };
            let (sin, cos) = libm::sincos(golden * f64::from(seed));
            let towards = direction + (across * cos + up * sin) * radius;
            // Adding 0 leaves no negative zero, by which unrefracted light would seem to move.
            (towards.normalize().as_vec3() + glam::Vec3::ZERO).to_array()
        })
        .collect()
}
