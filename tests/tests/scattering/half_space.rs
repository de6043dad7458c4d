//! Light that a half-space reflects, scattered any number of times: Chandrasekhar's closed form.

use std::f64::consts::PI;
use vitrum_conformance::scattering::{Lamp, Medium, Scene, radiance};
use vitrum_kernels::glam::DVec3;

/// Paths for each viewing ray.
const SAMPLES: u64 = 1 << 17;

/// The largest error, in standard errors: of twelve, one in thirty would be off by more.
const STANDARD_ERRORS: f64 = 3.0;

/// The largest error of the sum over all orders, as a share.
const LARGEST: f64 = 0.005;

/// The cosine of the angle between parallel light and the normal.
const LIGHT: f64 = 0.8;

/// Chandrasekhar's function H for isotropic scattering, at a cosine (Radiative Transfer, 1950, chapter V): the solution
/// of 1 / H(μ) = √(1 − ω) + ω/2 ∫ μ' H(μ') / (μ + μ') dμ' by iteration, on midpoints.
fn h(albedo: f64, cosine: f64) -> f64 {
    const POINTS: usize = 500;
    let points: Vec<f64> = (0..POINTS).map(|point| (point as f64 + 0.5) / POINTS as f64).collect();
    let next = |values: &[f64], cosine: f64| {
        let sum: f64 = points.iter().zip(values).map(|(point, value)| point * value / (cosine + point)).sum();
        1.0 / ((1.0 - albedo).sqrt() + 0.5 * albedo * sum / POINTS as f64)
    };
    let mut values = vec![1.0; POINTS];
    for _ in 0..60 {
        values = points.iter().map(|&cosine| next(&values, cosine)).collect();
    }
    next(&values, cosine)
}

/// A half-space of albedo ω below light of irradiance E across it reflects the radiance ω E / 4π · μ₀ / (μ + μ₀) · H(μ)
/// H(μ₀); what was scattered once has no H. A medium 40 free paths deep and 400 wide is as good as one: light that
/// comes so far is less than 10⁻⁶.
#[test]
fn a_half_space_reflects_as_chandrasekhar_says() {
    let light = DVec3::new((1.0 - LIGHT * LIGHT).sqrt(), 0.0, -LIGHT);
    for albedo in [0.5, 0.9] {
        let medium = Medium {
            low: DVec3::new(-200.0, -200.0, -40.0),
            high: DVec3::new(200.0, 200.0, 0.0),
            scattering: albedo,
            absorption: 1.0 - albedo,
            anisotropy: 0.0,
        };
        let scene = Scene { medium, lamp: Lamp::Distant { direction: light, irradiance: 1.0 }, ball: None };
        for cosine in [0.2, 0.6, 1.0] {
            let direction = DVec3::new(0.0, f64::sqrt(1.0 - cosine * cosine), -cosine);
            let found = radiance(&scene, direction * -5.0, direction, u32::MAX, SAMPLES, 2);
            let once = albedo / (4.0 * PI) * LIGHT / (cosine + LIGHT);
            let more = once * (h(albedo, cosine) * h(albedo, LIGHT) - 1.0);
            let error = (found.once.mean + found.more.mean) / (once + more) - 1.0;
            let off = [found.once.off(once), found.more.off(more)];
            println!("ω = {albedo}, μ = {cosine}: {error:.1e}, {off:.1?} standard errors, {found:.5?}");
            assert!(error.abs() <= LARGEST, "ω = {albedo}, μ = {cosine}: {found:?}, not {once} and {more}");
            assert!(off.iter().all(|off| off.abs() <= STANDARD_ERRORS), "ω = {albedo}, μ = {cosine}: {off:?}");
        }
    }
}
