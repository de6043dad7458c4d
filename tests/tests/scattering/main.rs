//! The reference for scattered light: closed forms of single and multiple scattering, and its two estimators against
//! each other.

mod airlight;
mod half_space;
mod picture;
mod picture_table;
mod table;
mod twice;
mod walk;

use vitrum_conformance::scattering::{Camera, Lamp, Medium, Scene};
use vitrum_kernels::glam::DVec3;

/// A lamp of 40 W at (0, 0, 4) that shines equally to all sides.
const LAMP: Lamp = Lamp::Point { position: DVec3::new(0.0, 0.0, 4.0), intensity: 10.0 / std::f64::consts::PI };

/// The eye.
const EYE: DVec3 = DVec3::new(0.0, -9.0, 0.5);

/// Fog of σ_s = 0.1 and σ_a = 0.02 in a box.
fn fog(low: DVec3, high: DVec3, anisotropy: f64) -> Medium {
    Medium { low, high, scattering: 0.1, absorption: 0.02, anisotropy }
}

/// A lamp in a cube of fog whose edges are 10 long, around the origin.
fn lamp_in_fog(anisotropy: f64) -> Scene {
    Scene { medium: fog(DVec3::splat(-5.0), DVec3::splat(5.0), anisotropy), lamp: LAMP, ball: None }
}

/// A view of the origin from the eye.
fn camera(edge: usize) -> Camera {
    Camera::new(EYE, DVec3::new(0.0, 0.0, -0.3), 40.0, [edge; 2])
}

/// The root mean square of differences in standard errors is 1 if these are right; that of 64 numbers varies by 9 %
/// from seed to seed, and the standard errors themselves are sure to 9 %.
const ROOT_MEAN_SQUARE: std::ops::Range<f64> = 0.7..1.35;

/// The largest difference of one of many numbers, in standard errors: of 256, one in sixty would be off by more.
const STANDARD_ERRORS: f64 = 4.0;

/// Holds differences in standard errors.
fn hold(off: &[f64], what: &str) {
    let root_mean_square = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
    let largest = off.iter().fold(0.0_f64, |largest, off| largest.max(off.abs()));
    println!("{what}: {root_mean_square:.2} standard errors, at most {largest:.1}");
    assert!(ROOT_MEAN_SQUARE.contains(&root_mean_square), "{what}: {root_mean_square} standard errors");
    assert!(largest <= STANDARD_ERRORS, "{what}: {largest} standard errors");
}
