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

/// The surface at a place: the point and its normal.
fn surface(place: Vec2) -> (Vec3, Vec3) {
    let (mut height, mut slope) = (0.0, Vec2::ZERO);
    for (cycles, phase, amplitude) in WAVES {
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
