//! A mirroring ring: its caustic on the floor, and the light that it throws through fog.

use super::mirror_table::{EYE, FLOOR, FLOOR_BY_LAMP, LAMP, Place, Row, SUN};
use super::thin::Thin;
use super::{case, on_the_cpu, rms};
use std::f64::consts::{PI, TAU};
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::{self, ErrorBound, larger};
use vitrum_io::Mesh;
use vitrum_kernels::glam::DVec3;

/// Light along (cos 40°, 0, −sin 40°), of an irradiance of 1.
pub const BY_SUN: &str = "light.0={kind='distant',attachment='world',angular_radius=0,intensity=0.3183098861837907,\
                      direction=[0.766044443118978,0,-0.6427876096865394]}";

/// A lamp of intensity 10, which is 10 / π for a scene, above the rim.
const BY_LAMP: &str = "light.0={kind='point',position=[-1,0,1.5],intensity=3.183098861837907}";

/// The largest error with 512 rays of light along an edge, as a share. At the rim beams have all of a texel's light or none, and nearest the cusp
/// beams are the least linear.
const LARGEST: f64 = 0.02;

/// The largest error, root mean square.
const LARGEST_RMS: f64 = 0.01;

/// The largest error on the floor, as a share. A thin ray sees the light of one texel, or near the borders of texels, whose parallelograms touch without a
/// seam only where light is linear, of none or of two.
const LARGEST_ON_FLOOR: f64 = 0.03;

/// The largest irradiance where there is none: rounding.
const DARK: f64 = 1e-5;

/// An open cylinder with its normals; 1024 facets lie within the circle by 5 · 10⁻⁶.
fn ring() -> Mesh {
    const SIDES: u32 = 1024;
    let corner = |side: u32, height: f64| {
        let (sin, cos) = (TAU * f64::from(side) / f64::from(SIDES)).sin_cos();
        DVec3::new(cos, sin, height).as_vec3().to_array()
    };
    let positions: Vec<_> = (0..SIDES).flat_map(|side| [corner(side, 0.0), corner(side, 0.7)]).collect();
    let quad = |side: u32| {
        let (a, b) = (2 * side, 2 * ((side + 1) % SIDES));
        [[a, a + 1, b], [b, a + 1, b + 1]]
    };
    let normals = positions.iter().map(|[x, y, _]| [-x, -y, 0.0]).collect();
    let mut mesh = Mesh::new("ring", positions, (0..SIDES).flat_map(quad).collect()).expect("a valid mesh");
    mesh.normals = Some(normals);
    mesh
}

/// The ring on a floor of a reflectance. Light is mirrored once.
pub fn scene(light: &str, floor: f64, settings: &[&str]) -> Result<Case, Failure> {
    let ground = format!("ground={{height=0,color={:?}}}", [floor; 3]);
    let usual = [
        light,
        &ground,
        "beams.rays=512",
        "beams.bounces=1",
        "beams.segments=1",
        "beams.pyramid=false",
        "material=[{mirror=true,color=[0.9,0.9,0.9]}]",
    ];
    case(ring(), 1, &[&usual, settings].concat())
}

pub fn fog(anisotropy: f64) -> String {
    format!("medium={{absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],anisotropy={anisotropy},extent=3}}")
}

#[test]
fn a_ring_throws_light_through_fog() -> Result<(), Failure> {
    let all: [(&str, &[Row]); 2] = [(BY_SUN, &SUN), (BY_LAMP, &LAMP)];
    on_the_cpu(|backend| {
        for (light, rows) in all {
            for (number, anisotropy) in [0.0, 0.7].into_iter().enumerate() {
                let mut thin = Thin::new(scene(light, 0.0, &[&fog(anisotropy)])?, backend);
                let mut errors = Vec::new();
                for (through, expected) in rows {
                    let found = thin.look(DVec3::from_array(EYE), DVec3::from_array(*through))?.caustics[0];
                    errors.push(found / expected[number] - 1.0);
                }
                let mean = rms(errors.iter().copied());
                println!("{light}, g = {anisotropy}: {mean:.2e}, {errors:.4?}");
                for (error, (through, _)) in errors.iter().zip(rows) {
                    assert!(error.abs() <= LARGEST, "{light}, g = {anisotropy}, through {through:?}: {error:.2e}");
                }
                assert!(mean <= LARGEST_RMS, "{light}, g = {anisotropy}: off by {mean:.2e}");
                if light == BY_SUN && anisotropy == 0.0 {
                    table::BEAMS_RING.hold(mean, backend);
                }
            }
        }
        Ok(())
    })
}

/// Holds the irradiance of a white floor, less what `direct` says of a point's direct light, and of the transmittance of a length of fog; the largest error, as a
/// share of the irradiance, also to a line of the table if it is of it.
fn hold_floor(
    light: &str,
    settings: &[&str],
    places: &[Place],
    direct: impl Fn(DVec3) -> f64,
    fog: f64,
    line: Option<ErrorBound>,
) -> Result<(), Failure> {
    let case = scene(light, 1.0, settings)?;
    on_the_cpu(|backend| {
        let mut thin = Thin::new(case.clone(), backend);
        let mut worst = 0.0;
        for &([x, y], expected) in places {
            let (eye, point) = (DVec3::from_array(EYE), DVec3::new(x, y, 0.0));
            let seen = thin.look(eye, point)?.surfaces[0] * PI / (-fog * (point - eye).length()).exp();
            let (found, bound) = (seen - direct(point), (LARGEST_ON_FLOOR * expected).max(DARK));
            println!("{light}, at ({x}, {y}): {found:.5}, {expected:.5} by theory");
            assert!((found - expected).abs() <= bound, "{light}, at ({x}, {y}): {found}, not {expected} ± {bound:.1e}");
            worst = larger((found - expected).abs() * LARGEST_ON_FLOOR / bound, worst);
        }
        line.iter().for_each(|line| line.hold(worst, backend));
        Ok(())
    })
}

/// The nephroid, in vacuum. Of direct light there is sin 40° everywhere.
#[test]
fn a_ring_has_a_nephroid_on_the_floor() -> Result<(), Failure> {
    hold_floor(BY_SUN, &[], &FLOOR, |_| 40f64.to_radians().sin(), 0.0, Some(table::BEAMS_NEPHROID))
}

/// The cardioid, behind fog. A lamp of intensity I makes the irradiance I cos θ / d², which fog attenuates.
#[test]
fn a_ring_has_a_cardioid_on_the_floor() -> Result<(), Failure> {
    let direct = |point: DVec3| {
        let way = DVec3::new(-1.0, 0.0, 1.5) - point;
        10.0 * way.z / way.length().powi(3) * (-0.12 * way.length()).exp()
    };
    hold_floor(BY_LAMP, &[&fog(0.0)], &FLOOR_BY_LAMP, direct, 0.12, None)
}
