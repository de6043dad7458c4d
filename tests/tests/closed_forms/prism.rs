//! Dispersion: the minimum deviation of a 60° prism, δ = 2 asin(n sin 30°) − 60°, at two wavelengths.

use crate::setup::{backends, cube, end, render, straight_on};
use vitrum::backend::Backend;
use vitrum::scene::{IorPoint, OpacityPoint, Scene};
use vitrum_conformance::closed_forms::table::{self, larger};

/// Crown glass, N-BK7: η for yellow light, Abbe number.
const CROWN: (f32, f32) = (1.5168, 64.17);
/// Hydrogen's lines F and C, in micrometres.
const LINES: [f64; 2] = [0.486_13, 0.656_27];
/// The prism's angle.
const APEX: f64 = std::f64::consts::FRAC_PI_3;

/// The deviation of light that meets the first face at angle `incidence`, by Snell's law at both.
fn deviation(n: f64, incidence: f64) -> f64 {
    let first = (incidence.sin() / n).asin();
    incidence + (n * (APEX - first).sin()).asin() - APEX
}

fn smallest_deviation(n: f64) -> f64 {
    2.0 * (n * (0.5 * APEX).sin()).asin() - APEX
}

/// What light of a wavelength does in a prism of 96³ voxels that it meets at angle `incidence`, travelling along −y: its deviation.
fn found(wavelength: f64, incidence: f64, backend: &mut dyn Backend) -> f64 {
    const SIZE: f32 = 2.0;
    const VOXELS: u32 = 96;
    // Faces twelve voxels thick: within them light bends as much as at a crisp face.
    let thickness = 12.0 * f64::from(SIZE) / f64::from(VOXELS);
    // The first face's normal against the light's direction, turned by the angle; the second beyond the apex.
    let normal = |angle: f64| [angle.sin(), angle.cos()];
    let (first, second) = (normal(incidence), normal(incidence + std::f64::consts::PI - APEX));
    let volume = cube(VOXELS, SIZE, |[x, y, _]| {
        let inside = |n: [f64; 2]| {
            let t = ((0.3 - (n[0] * x + n[1] * y)) / thickness + 0.5).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        };
        inside(first) * inside(second)
    });
    let frame = render(&dispersing().at_wavelength(wavelength), &volume, backend);
    let middle = end(&frame, frame.width / 2, frame.height / 2);
    assert_eq!(middle.status, 0.0, "the ray got through");
    let [x, y, z] = middle.direction;
    assert!(y.abs() < 1e-3, "{y}: nothing bends up or down");
    x.abs().atan2(-z)
}

fn dispersing() -> Scene {
    let mut scene = straight_on(32);
    let glass = IorPoint { abbe: Some(CROWN.1), ..IorPoint::new(1.0, CROWN.0) };
    scene.transfer.ior = vec![IorPoint::new(0.0, 1.0), glass];
    scene.transfer.opacity = vec![OpacityPoint { value: 0.0, opacity: 0.0 }];
    scene.shading.specular = 0.0;
    scene.sweep.sample_distance = 0.5;
    scene
}

#[test]
fn a_prism_deviates_each_colour_by_its_own_angle() {
    let scene = dispersing();
    let index = |wavelength: f64| scene.transfer.ior[1].ior_at(wavelength);
    for mut backend in backends() {
        let mut smallest = [0.0; 2];
        let (mut worst, mut worst_turned) = (0.0f64, 0.0f64);
        for (smallest, wavelength) in smallest.iter_mut().zip(LINES) {
            let n = index(wavelength);
            let best = 0.5 * (smallest_deviation(n) + APEX);
            assert!((deviation(n, best) - smallest_deviation(n)).abs() < 1e-12);
            for turned in [-5.0f64, 0.0, 5.0] {
                let incidence = best + turned.to_radians();
                let (found, truth) = (found(wavelength, incidence, backend.as_mut()), deviation(n, incidence));
                let (found, truth) = (found.to_degrees(), truth.to_degrees());
                println!(
                    "{}: {wavelength} µm, n = {n:.4}, {turned:+}°: {found:.3}°, truth {truth:.3}°",
                    backend.name()
                );
                let error = if turned == 0.0 { &mut worst } else { &mut worst_turned };
                *error = larger(*error, (found - truth).abs());
                if turned == 0.0 {
                    *smallest = found;
                }
            }
        }
        // The lines are 0.58° apart.
        table::PRISM_LEAST.hold(worst, backend.as_ref());
        table::PRISM_TURNED.hold(worst_turned, backend.as_ref());
        assert!(smallest[0] - smallest[1] > 0.5, "blue bends more than red: {smallest:?}");
    }
}
