//! Surfaces in a vacuum: light that nothing hides, shadows, and light through a plate.

use super::thin::Thin;
use super::{case, on_both, on_the_cpu, red};
use vitrum_conformance::refraction::{ball, cuboid};
use vitrum_conformance::shadow::{seen_on_plane, view};
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::glam::{DQuat, DVec3};

/// The direction in which the light travels, of any length.
const LIGHT: DVec3 = DVec3::new(0.6, 0.3, -0.9);

/// The strength of the light.
const STRENGTH: f64 = 2.0;

/// The largest error of light that nothing hides, as a share: rounding of f32.
const FREE: f64 = 1e-5;

/// The largest error of light through a plate, as a share: f32 rounds cross-sections of beams to 10⁻⁴ of their area.
const THROUGH: f64 = 0.01;

/// The largest error of the mean over a picture of a caustic, as a share: each pixel looks at its middle's neighbourhood alone, and the focus is a few
/// pixels wide.
const LARGE: f64 = 0.01;

fn light() -> String {
    let [x, y, z] = LIGHT.to_array();
    format!(
        "light.0={{kind='distant',attachment='world',direction=[{x},{y},{z}],intensity={STRENGTH},angular_radius=0}}"
    )
}

/// The size of the smallest box around the origin that a ray meets, over the size of the box with these half edges: the ray meets that one where the
/// result is below 1.
fn size_met(half: DVec3, from: DVec3, direction: DVec3) -> f64 {
    // The largest of three convex functions along the ray: a search by thirds.
    let at = |t: f64| ((from + direction * t) / half).abs().max_element();
    let (mut low, mut high) = (0.0, 100.0);
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if at(a) < at(b) { high = b } else { low = a }
    }
    at(low)
}

/// A ground of colour c, lit at an angle θ, has the radiance c L cos θ beside the shadow of a cube, and none within it.
#[test]
fn a_cube_casts_a_shadow_on_the_ground() -> Result<(), Failure> {
    const EDGE: u32 = 96;
    let half = DVec3::splat(0.5);
    let settings = [
        &light(),
        "ground={height=-0.5,color=[0.7,0.7,0.7]}",
        "material=[{opaque=true}]",
        "beams.rays=16",
        "camera.position=[3,-6,7]",
        "camera.target=[0,0,-0.5]",
        "camera.field_of_view=30",
    ];
    let case = case(cuboid(half, DQuat::IDENTITY), EDGE, &settings)?;
    let eye = view(&case).eye;
    let expected = 0.7 * STRENGTH * -LIGHT.normalize().z;
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let (color, surfaces) = (red(&frame, "color"), red(&frame, "surfaces"));
        assert_eq!(color, surfaces, "there is no medium");
        let (mut lit, mut dark) = (0, 0);
        for (found, point) in color.iter().zip(seen_on_plane(&case, 2, -0.5)) {
            let seen = size_met(half, point, (eye - point).normalize());
            let shaded = size_met(half, point, -LIGHT.normalize());
            // A hundredth of the cube away from outlines.
            if seen < 1.02 || (shaded - 1.0).abs() < 0.02 {
                continue;
            }
            if shaded < 1.0 {
                dark += 1;
                assert_eq!(*found, 0.0, "in the shadow at {point}");
            } else {
                lit += 1;
                assert!((found / expected - 1.0).abs() <= FREE, "at {point}: {found}, not {expected}");
            }
        }
        println!("{lit} pixels are lit, {dark} dark");
        assert!(lit > 2000 && dark > 100, "{lit} pixels are lit, {dark} dark");
        Ok(())
    })
}

/// A floor under a ball gets the same light in the mean, however large pixels are beside the texels of the light's rays.
#[test]
fn large_pixels_lose_no_light() -> Result<(), Failure> {
    let settings = [
        "light.0={kind='point',position=[0,0,4],intensity=1}",
        "ground={height=-3,color=[0.7,0.7,0.7]}",
        "material=[{ior=1.5}]",
        "camera.position=[0,-9,3]",
        "camera.target=[0,0,-3]",
        "camera.field_of_view=24",
    ];
    on_the_cpu(|backend| {
        let mut mean = |rays: u32, edge: u32| {
            let rays = format!("beams.rays={rays}");
            let case = case(ball(64), edge, &[&settings[..], &[&*rays]].concat())?;
            let surfaces = red(&frames::render(&case, backend)?, "surfaces");
            Ok::<f64, Failure>(surfaces.iter().sum::<f64>() / surfaces.len() as f64)
        };
        // Texels of 32 rays are wider than these pixels nearly everywhere.
        let expected = mean(32, 256)?;
        for (rays, edge) in [(32, 64), (128, 64), (256, 32)] {
            let found = mean(rays, edge)? / expected - 1.0;
            println!("{rays} rays, {edge} pixels: {found:.2e}");
            assert!(found.abs() <= LARGE, "{rays} rays, {edge} pixels: off by {found:.2e}");
        }
        Ok(())
    })
}

/// Fresnel's share of light that meets glass of index 1.5 at an angle of this cosine.
fn reflectance(cosine: f64) -> f64 {
    let inside = (1.0 - (1.0 - cosine * cosine) / 2.25).sqrt();
    let across = (cosine - 1.5 * inside) / (cosine + 1.5 * inside);
    let along = (1.5 * cosine - inside) / (1.5 * cosine + inside);
    0.5 * (across * across + along * along)
}

/// A plate hides a ground that it lights again: with F at each face (1 − F)² (1 + F² + F⁴ …) = (1 − F) / (1 + F) of the light goes through.
#[test]
fn a_plate_lets_light_through() -> Result<(), Failure> {
    let settings = [&light(), "ground={height=-2,color=[1,1,1]}", "material=[{ior=1.5}]", "beams.rays=64"];
    let case = case(cuboid(DVec3::new(1.0, 1.0, 0.1), DQuat::IDENTITY), 1, &settings)?;
    let cosine = -LIGHT.normalize().z;
    let share = reflectance(cosine);
    let free = STRENGTH * cosine;
    let expected = free * (1.0 - share) / (1.0 + share);
    // The middle of the shadow, but for the shift of a ray by the plate, which is 0.06.
    let middle = LIGHT * (2.0 / -LIGHT.z);
    on_both(|backend| {
        let mut thin = Thin::new(case.clone(), backend);
        let mut at = |x: f64, y: f64| {
            let point = middle + DVec3::new(x, y, 0.0);
            // From below the plate.
            Ok::<f64, Failure>(thin.look(point + DVec3::new(4.0, -3.0, 1.5), point)?.surfaces[0])
        };
        // Light that the face at y = 1 reflects totally comes to y = −0.3.
        for [x, y] in [[0.0, 0.0], [0.31, -0.17], [-0.43, 0.29], [0.56, 0.52], [-0.5, -0.6]] {
            let found = at(x, y)?;
            println!("({x}, {y}): {:.1e}", found / expected - 1.0);
            assert!((found / expected - 1.0).abs() <= THROUGH, "({x}, {y}): {found}, not {expected}");
        }
        for [x, y] in [[1.7, 0.0], [0.0, -1.6]] {
            let found = at(x, y)?;
            assert!((found / free - 1.0).abs() <= FREE, "beside the shadow, ({x}, {y}): {found}, not {free}");
        }
        Ok(())
    })
}
