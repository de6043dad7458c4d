//! A round brilliant of 57 facets, and the sparks that it casts.

use super::super::SceneEntry;
use super::in_medium;
use super::parts::clear;
use super::patches::Patches;
use super::revolve::circle;
use crate::scene::{Camera, Ground, Light, LightKind, Material, Medium, Scene};
use glam::Vec2;
use vitrum_io::Mesh;

pub(in super::super) const SCENES: &[SceneEntry] = &[(
    "gem",
    "the colourful sparks of a diamond, a round brilliant, in fog and on the ground, in the light of a spot",
    scene,
)];

fn scene() -> Scene {
    let mut scene = Scene {
        camera: Camera {
            position: Some([0.0, -6.0, 1.6]),
            target: Some([0.0, 0.0, -0.35]),
            field_of_view: 38.0,
            ..Camera::default()
        },
        light: vec![Light {
            position: Some([0.9, -0.5, 3.6]),
            intensity: 24.0,
            cone_angle: 17.0,
            penumbra: 0.15,
            ..Light::of_kind(LightKind::Spot)
        }],
        material: vec![Material {
            name: Some("diamond".to_owned()),
            ior: IOR,
            abbe: Some(55.3),
            attenuation_color: COLOR,
            attenuation_distance: Some(THICKNESS),
            ..Material::default()
        }],
        ground: Some(Ground { height: Some(-1.5), color: [0.7; 3], ..Ground::default() }),
        ..in_medium("gem", Medium { absorption: [0.004; 3], scattering: [0.12; 3], ..Medium::default() })
    };
    scene.environment.color = [0.02, 0.025, 0.04];
    scene.beams.rays = 96;
    scene.film.exposure = 2.5;
    scene
}

/// Index of refraction of diamond for yellow light.
const IOR: f32 = 2.417;
/// Transmittance of [`THICKNESS`] of the stone.
const COLOR: [f32; 3] = [0.97; 3];
/// Thickness that [`COLOR`] is stated for, in world units.
const THICKNESS: f32 = 2.0;
/// Diameter of the table over that of the girdle.
const TABLE: f32 = 0.53;
/// Tangent of 34.5°, the slope of the crown's main facets.
const CROWN: f32 = 0.687_281;
/// Tangent of 40.75°, the slope of the pavilion's main facets.
const PAVILION: f32 = 0.861_655;
/// Share of the way from the table to the girdle that the star facets take.
const STAR: f32 = 0.5;
/// Share of the way from the girdle to the tip that the pavilion's half facets take.
const HALF: f32 = 0.77;
/// Half the thickness of the girdle, of a radius of 1.
const GIRDLE: f32 = 0.015;
/// Height of the girdle above the middle of the gem.
const MIDDLE: f32 = 0.2693;

/// Radius 1, the table up: the crown has 8 main, 8 star and 16 half facets, the pavilion 8 main and 16 half ones. The girdle between them
/// has 16 sides.
pub(in super::super) fn mesh(name: &str) -> Mesh {
    let turns = circle(2);
    let at = |number: usize, radius: f32, height: f32| (turns[number % 16] * radius).extend(MIDDLE + height);
    // Cosine of half the angle between two main facets.
    let half = turns[1].x;
    let star = {
        let table = TABLE * half;
        table + STAR * (1.0 - table)
    };
    let table = |number: usize| at(number, TABLE, GIRDLE + (1.0 - TABLE) * CROWN);
    let joint = |number: usize| at(number, star, GIRDLE + (1.0 - star * half) * CROWN);
    let upper = |number: usize| at(number, 1.0, GIRDLE);
    let lower = |number: usize| at(number, 1.0, -GIRDLE);
    let below = |number: usize| at(number, 1.0 - HALF, -GIRDLE - (1.0 - (1.0 - HALF) * half) * PAVILION);
    let tip = Vec2::ZERO.extend(MIDDLE - GIRDLE - PAVILION);
    let mut patches = Patches::default();
    patches.polygon(&[0, 2, 4, 6, 8, 10, 12, 14].map(table));
    // Main facets face the even turns.
    for main in (0..16).step_by(2) {
        let (before, next, after) = (main + 15, main + 1, main + 2);
        patches.polygon(&[table(main), joint(before), upper(main), joint(next)]);
        patches.polygon(&[table(main), joint(next), table(after)]);
        patches.polygon(&[joint(next), upper(main), upper(next)]);
        patches.polygon(&[joint(next), upper(next), upper(after)]);
        patches.polygon(&[lower(main), below(before), tip, below(next)]);
        patches.polygon(&[lower(main), below(next), lower(next)]);
        patches.polygon(&[lower(next), below(next), lower(after)]);
        for side in [main, next] {
            patches.polygon(&[lower(side), lower(side + 1), upper(side + 1), upper(side)]);
        }
    }
    patches.into_mesh(name, clear("diamond", IOR, COLOR, THICKNESS))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_brilliant_has_57_facets_and_is_convex() {
        let gem = mesh("gem");
        let mut facets: Vec<(Vec3, f32)> = Vec::new();
        for triangle in &gem.triangles {
            let [a, b, c] = triangle.map(|vertex| Vec3::from_array(gem.positions[vertex as usize]));
            let normal = (b - a).cross(c - a).normalize();
            let distance = normal.dot(a);
            if facets.iter().all(|(known, at)| (normal - known).length() > 1e-4 || (distance - at).abs() > 1e-4) {
                facets.push((normal, distance));
            }
            let farthest = gem.positions.iter().map(|&at| normal.dot(Vec3::from_array(at))).fold(0.0, f32::max);
            assert!(farthest < distance + 1e-5, "a corner stands {} out", farthest - distance);
        }
        assert_eq!(facets.len(), 57 + 16);
        let [low, high] = gem.bounds();
        assert!((low[2] + high[2]).abs() < 1e-3, "{low:?} {high:?}");
    }
}
