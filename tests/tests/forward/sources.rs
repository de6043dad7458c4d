//! Points and spots on a wall: the inverse square of the distance, the cosine, and a spot's cone.

use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::on_both;
use crate::shot::{Shot, vector};

/// The kinds of light, besides distant ones, that a sweep takes.
const KINDS: &[&str] = &["point", "spot"];

const REFLECTANCE: f64 = 0.5;
const WALL: f64 = 1.25;
const INTENSITY: f64 = 3.0;
const CONE: f64 = 30.0;
const PENUMBRA: f64 = 0.3;
/// In front of the volume, which holds nothing, and out of its middle.
const POSITION: DVec3 = DVec3::new(0.4, 1.8, 0.3);

/// The radiance of the wall at a point.
fn radiance(kind: &str, at: DVec3) -> f64 {
    let way = at - POSITION;
    let cosine = -way.y / way.length();
    // The axis is across the wall.
    let tangent = way.x.hypot(way.z) / -way.y;
    let edge = CONE.to_radians().tan();
    let inner = (CONE * (1.0 - PENUMBRA)).to_radians().tan();
    let t = ((edge - tangent) / (edge - inner)).clamp(0.0, 1.0);
    let cone = if kind == "spot" { t * t * (3.0 - 2.0 * t) } else { 1.0 };
    REFLECTANCE * INTENSITY * cone * cosine / way.length_squared()
}

/// Half a percent of the brightest: a cell of an irradiance map a twentieth of the distance wide sees the fall of the light to its square.
#[test]
fn points_and_spots_light_a_wall_by_the_inverse_square() -> Result<(), Failure> {
    let mut volume = cube(32, 2.0, |_| 0.0);
    volume.range = [0.0, 1.0];
    for kind in KINDS {
        let mut settings = vec![
            format!("light.0={{kind='{kind}',intensity={INTENSITY}}}"),
            vector("light.0.position", POSITION),
            "transfer.opacity=[{value=0.5,opacity=0}]".to_owned(),
            format!("wall={{distance={WALL},color=[{REFLECTANCE},{REFLECTANCE},{REFLECTANCE}]}}"),
            "camera.azimuth=20".to_owned(),
            "camera.zoom=0.8".to_owned(),
        ];
        if *kind == "spot" {
            settings.push(vector("light.0.direction", DVec3::NEG_Y));
            settings.extend([format!("light.0.cone_angle={CONE}"), format!("light.0.penumbra={PENUMBRA}")]);
        }
        let shot = Shot::new(volume.clone(), 64, &settings)?;
        on_both(|backend, held| {
            let pixels = shot.render(backend)?;
            let brightest = radiance("point", DVec3::new(POSITION.x, -WALL, POSITION.z));
            let mut worst = 0.0f64;
            for ((from, along), red) in shot.rays().zip(&pixels.red) {
                let seen = from + along * ((-WALL - from.y) / along.y);
                worst = worst.max((red - radiance(kind, seen)).abs() / brightest);
            }
            held.at_most(backend, &format!("radiance of a wall in the light of a {kind}, relative"), worst, 0.005);
            Ok(())
        })?;
    }
    Ok(())
}

/// The reference itself: at the foot of the light the inverse square, at 45° of it half the distance's square and a cosine of √½; at a
/// spot's edge nothing.
#[test]
fn the_reference_is_the_inverse_square() {
    let distance = POSITION.y + WALL;
    let foot = DVec3::new(POSITION.x, -WALL, POSITION.z);
    let at = |kind, x: f64| radiance(kind, foot + DVec3::X * x) * distance * distance / (REFLECTANCE * INTENSITY);
    assert!((at("point", 0.0) - 1.0).abs() < 1e-12 && (at("point", distance) - 0.125f64.sqrt()).abs() < 1e-12);
    let edge = distance * CONE.to_radians().tan();
    assert!((at("spot", 0.0) - 1.0).abs() < 1e-12 && at("spot", edge * 1.001) == 0.0 && at("spot", edge * 0.98) > 0.0);
}
