//! Directions in which a light of finite angular radius shines.

use glam::DVec3;

/// The directions of `count` sheets: `direction` alone, or a sunflower's seeds over the disc of a source with half-angle `softness`
/// (degrees), each for the same share of its area.
pub(super) fn sources(direction: DVec3, softness: f32, count: u32) -> Vec<[f32; 3]> {
    let tangent = f64::from(softness).to_radians().tan();
    let (across, up) = direction.any_orthonormal_pair();
    let golden = std::f64::consts::PI * (3.0 - 5.0f64.sqrt());
    (0..count)
        .map(|seed| {
            let radius = if count == 1 { 0.0 } else { ((f64::from(seed) + 0.5) / f64::from(count)).sqrt() * tangent };
            let angle = golden * f64::from(seed);
            let towards = direction + (across * angle.cos() + up * angle.sin()) * radius;
            // Adding 0 leaves no negative zero, by which unrefracted light would seem to move.
            (towards.normalize().as_vec3() + glam::Vec3::ZERO).to_array()
        })
        .collect()
}
