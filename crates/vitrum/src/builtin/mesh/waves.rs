//! A piece of the sea with waves on top, and the shafts of light below it.

use super::super::SceneEntry;
use super::in_medium;
use super::parts::clear;
use super::patches::Patches;
use crate::scene::{Attachment, Camera, Light, Medium, Scene};
use glam::{Vec2, Vec3};
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] =
    &[("ocean", "shafts of sunlight under the waves of the sea, seen from below", scene)];

fn scene() -> Scene {
    let sea = Medium {
        absorption: [0.16, 0.035, 0.02],
        scattering: [0.03, 0.05, 0.06],
        anisotropy: 0.6,
        extent: Some(7.0),
        ..Medium::default()
    };
    let mut scene = Scene {
        camera: Camera {
            position: Some([0.4, -1.9, -4.6]),
            target: Some([0.0, 0.3, -2.2]),
            field_of_view: 50.0,
            ..Camera::default()
        },
        light: vec![Light {
            attachment: Some(Attachment::World),
            direction: Some([0.15, -0.2, -1.0]),
            angular_radius: 0.0,
            intensity: 3.0,
            ..Light::default()
        }],
        ..in_medium("waves", sea)
    };
    scene.mesh[0].scale = 5.0;
    scene.beams.rays = 128;
    scene.environment.color = [0.004, 0.02, 0.035];
    scene
}

/// Half the edge.
const EDGE: f32 = 1.0;
const BOTTOM: f32 = -0.75;
/// Squares along an edge: a power of two, so that coordinates are exact and sides meet.
const SQUARES: usize = 128;

/// Waves in cycles per world unit along x and y, their phase in cycles, and their amplitude.
const WAVES: [([f32; 2], f32, f32); 5] = [
    ([1.2, 0.5], 0.10, 0.014),
    ([-0.6, 1.4], 0.37, 0.012),
    ([1.9, -1.3], 0.62, 0.006),
    ([0.9, 2.3], 0.83, 0.005),
    ([3.1, 1.1], 0.20, 0.0022),
];

/// A wave of the amplitude 1 and the period 1, and its slope: a polynomial close to a sine, three times differentiable everywhere.
fn wave(cycles: f32) -> [f32; 2] {
    let along = 2.0 * (cycles - cycles.floor()) - 1.0;
    let squared = along * along;
    // Its greatest value before it is scaled.
    const PEAK: f32 = 2.348;
    let value = along * (7.0 - squared * (10.0 - 3.0 * squared)) / PEAK;
    let slope = 2.0 * (7.0 - squared * (30.0 - 15.0 * squared)) / PEAK;
    [value, slope]
}

/// Acceleration of gravity, in metres per second squared.
const GRAVITY: f64 = 9.81;

/// The way that a wave has gone after so many seconds, in its own lengths, without the whole ones. Its frequency is that of waves in deep water,
/// ω² = g k: the bottom is a wavelength below and changes it by less than a hundred-thousandth.
fn gone(cycles: [f32; 2], seconds: f64, metres: f64) -> f32 {
    let [x, y] = cycles.map(f64::from);
    let wavelength = metres / (x * x + y * y).sqrt();
    let periods = seconds * (GRAVITY / (std::f64::consts::TAU * wavelength)).sqrt();
    // Neither a time nor a size that is infinite makes a place.
    if periods.is_finite() { (periods - periods.floor()) as f32 } else { 0.0 }
}

/// The phase of each wave, in cycles.
type Phases = [f32; WAVES.len()];

/// The surface at a place: the point and its normal.
fn surface(place: Vec2, phases: &Phases) -> (Vec3, Vec3) {
    let (mut height, mut slope) = (0.0, Vec2::ZERO);
    for ((cycles, _, amplitude), phase) in WAVES.into_iter().zip(phases) {
        let along = Vec2::from_array(cycles);
        let [value, steepness] = wave(along.x * place.x + along.y * place.y + phase);
        height += amplitude * value;
        slope += along * (amplitude * steepness);
    }
    (place.extend(height), (-slope).extend(1.0).normalize())
}

/// The place on an edge of the slab, by the way along it.
type Edge = fn(f32) -> Vec2;

/// A closed slab, 2 wide along x and y: flat below and at the sides, with waves around z = 0 on top.
pub(in super::super) fn mesh(name: &str) -> Mesh {
    at(name, 0.0, 1.0)
}

/// The slab at a moment, where its unit is `metres` long. Each wave travels along its own direction and keeps its shape.
pub(in super::super) fn at(name: &str, seconds: f64, metres: f64) -> Mesh {
    let phases = WAVES.map(|(cycles, phase, _)| phase - gone(cycles, seconds, metres));
    let surface = |place| surface(place, &phases);
    let at = |index: usize| EDGE * (2.0 * index as f32 / SQUARES as f32 - 1.0);
    let all = || (0..=SQUARES).map(at);
    let under = |place: Vec2| place.extend(BOTTOM);
    let mut patches = Patches::default();
    let top: Vec<Vec<(Vec3, Vec3)>> = all().map(|y| all().map(|x| surface(Vec2::new(x, y))).collect()).collect();
    patches.grid(&top);
    // Rows run the other way round, as it is seen from below.
    let bottom: Vec<Vec<(Vec3, Vec3)>> =
        all().map(|x| all().map(|y| (under(Vec2::new(x, y)), Vec3::NEG_Z)).collect()).collect();
    patches.grid(&bottom);
    let sides: [(Edge, Vec3); 4] = [
        (|along| Vec2::new(along, -EDGE), Vec3::NEG_Y),
        (|along| Vec2::new(EDGE, along), Vec3::X),
        (|along| Vec2::new(-along, EDGE), Vec3::Y),
        (|along| Vec2::new(-EDGE, -along), Vec3::NEG_X),
    ];
    for (place, normal) in sides {
        let low = all().map(|along| (under(place(along)), normal)).collect();
        let high = all().map(|along| (surface(place(along)).0, normal)).collect();
        patches.grid(&[low, high]);
    }
    patches.into_mesh(name, clear("water", 1.33, [0.72, 0.93, 0.96], 2.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Waves four times as long take twice the time.
    #[test]
    fn waves_travel_at_the_speed_of_deep_water() {
        for (cycles, ..) in WAVES {
            for metres in [1.0, 5.0] {
                let wavelength = metres / libm::hypot(f64::from(cycles[0]), f64::from(cycles[1]));
                let speed = (9.81 / (TAU / wavelength)).sqrt();
                for seconds in [0.1, 0.7, -3.0, 100.0] {
                    let lengths = speed * seconds / wavelength;
                    let off = f64::from(gone(cycles, seconds, metres)) - lengths;
                    assert!((off - off.round()).abs() < 1e-6, "{cycles:?}, {seconds} s: {off}");
                    assert_eq!(gone(cycles, seconds, metres), gone(cycles, 2.0 * seconds, 4.0 * metres));
                }
            }
        }
    }

    /// By the derivative of each wave: what is at x goes on along the wave's direction, ∂z/∂t = -f a w'(k x + φ - f t).
    #[test]
    fn the_surface_rises_where_crests_come() {
        let (seconds, step, metres) = (0.6, 2e-3, 2.0);
        let [before, after] = [-step, step].map(|by| at("waves", seconds + by, metres));
        let mut fastest = 0.0_f64;
        for vertex in (0..(SQUARES + 1).pow(2)).step_by(37) {
            let [x, y, _] = before.positions[vertex].map(f64::from);
            let expected: f64 = WAVES.into_iter().fold(0.0, |sum, (cycles, phase, amplitude)| {
                let [across, along] = cycles.map(f64::from);
                let frequency = (9.81 * libm::hypot(across, along) / metres / TAU).sqrt();
                let cycles = across * x + along * y + f64::from(phase) - frequency * seconds;
                let [_, slope] = wave((cycles - cycles.floor()) as f32);
                sum - frequency * f64::from(amplitude) * f64::from(slope)
            });
            let rise = f64::from(after.positions[vertex][2]) - f64::from(before.positions[vertex][2]);
            // Coordinates are rounded to 10⁻⁸, over 4 ms; the curve of a wave is the rest.
            assert!((rise / (2.0 * step) - expected).abs() < 1e-3, "{x}, {y}: {rise} and {expected}");
            fastest = fastest.max(expected.abs());
        }
        assert!(fastest > 0.05, "{fastest}");
    }

    #[test]
    fn a_moment_is_another_sea_of_the_same_triangles() {
        let still = mesh("waves");
        let moved = at("waves", 0.3, 1.0);
        assert!(still.positions != moved.positions && still.triangles == moved.triangles);
        assert_eq!(still, at("waves", 0.0, 7.0));
        assert!((moved.signed_volume() / still.signed_volume() - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_wave_is_smooth_and_its_slope_is_that_of_its_values() {
        let highest = (0..1000).map(|step| wave(step as f32 / 1000.0)[0]).fold(0.0, f32::max);
        assert!((highest - 1.0).abs() < 1e-3, "{highest}");
        for step in 0..40 {
            let cycles = 0.05 * step as f32 - 0.7;
            let [before, after] = [-5e-3, 5e-3].map(|by| wave(cycles + by)[0]);
            let [_, slope] = wave(cycles);
            assert!(((after - before) / 1e-2 - slope).abs() < 0.02, "at {cycles}: {slope}");
        }
    }
}
