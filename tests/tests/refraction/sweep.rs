//! A plane sweep through meshes: what becomes of surfaces and materials when they are made into volumes.

use super::on_both;
use vitrum::backend::Backend;
use vitrum::scene::{MethodName, Scene};
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{ball, case, cuboid, sweep, through_ball, together, trace};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DQuat, DVec3};

const STRAIGHT_ON: [&str; 3] = ["camera.projection=orthographic", "camera.azimuth=0", "camera.elevation=0"];

/// The error of half the rays through a ball inside 0.75 radii, and of nearly all; towards the rim a surface of three voxels turns rays by
/// more (docs/accuracy.md: 0.44° in the median of all at 128 voxels).
#[test]
fn a_ball_bends_rays_by_snells_law() -> Result<(), Failure> {
    on_both(|backend| {
        let case = case("ball", ball(128), 40, &[&STRAIGHT_ON[..], &["voxelization.resolution=96"]].concat())?;
        let found = sweep(&case, backend)?;
        let rays = trace(&case, backend)?;
        let mut angles: Vec<f64> = rays
            .iter()
            .zip(found)
            .filter(|(ray, _)| (ray.from - ray.towards * ray.from.dot(ray.towards)).length() < 0.75)
            .map(|(ray, found)| {
                let [_, expected] = through_ball(ray.from, ray.towards, 1.5).expect("the ray meets the ball");
                found.map_or(f64::INFINITY, |found| found.angle_between(expected).to_degrees())
            })
            .collect();
        angles.sort_by(f64::total_cmp);
        let [median, most] = [angles[angles.len() / 2], angles[angles.len() * 98 / 100]];
        assert!(angles.len() > 300, "{} rays", angles.len());
        table::SWEEP_BALL.hold(median, backend);
        table::SWEEP_BALL_MOST.hold(most, backend);
        Ok(())
    })
}

/// The transmittance through the middle of the picture, red, green and blue.
fn transmittance(parts: &[Mesh], materials: &str, backend: &mut dyn Backend) -> Result<[f64; 3], Failure> {
    let settings = [&STRAIGHT_ON[..], &["voxelization.resolution=64", materials]].concat();
    let case = case("plates", together(parts), 16, &settings)?;
    let scene = Scene { method: MethodName::Sweep, ..case.scene };
    let frame = vitrum::render(&scene, &case.assets, backend, &mut |_| true)?;
    Ok(["R", "G", "B"]
        .map(|channel| f64::from(frame.channel("transmittance", channel).expect("it is there")[8 * 16 + 8])))
}

/// Two plates that touch, each half as thick as it is wide: e^(−Σ σ ℓ), wherever the mixture at a surface is of several materials.
#[test]
fn plates_absorb_by_beer_and_lambert() -> Result<(), Failure> {
    let plate = |y: f64| {
        let mut plate = cuboid(DVec3::new(1.0, 0.5, 1.0), DQuat::IDENTITY);
        plate.positions.iter_mut().for_each(|position| position[1] += y as f32);
        plate
    };
    let parts = [plate(0.5), plate(-0.5)];
    let cases = [
        // One is far darker than the other; both bend light alike, and not at all straight on.
        (
            "material=[{name=\"m0\",attenuation_color=[0.9,0.5,0.2],attenuation_distance=1},\
             {name=\"m1\",attenuation_color=[0.95,0.9,0.85],attenuation_distance=1}]",
            [0.9 * 0.95, 0.5 * 0.9, 0.2 * 0.85],
        ),
        (
            "material=[{name=\"m0\",ior=1.2,attenuation_color=[0.9,0.5,0.2],attenuation_distance=2},\
             {name=\"m1\",ior=1.7,attenuation_color=[0.9,0.5,0.2],attenuation_distance=2}]",
            [0.9, 0.5, 0.2],
        ),
    ];
    on_both(|backend| {
        let mut worst = 0.0;
        for (materials, expected) in cases {
            let found = transmittance(&parts, materials, backend)?;
            for (found, expected) in found.iter().zip(expected) {
                // A voxel of 32 in each plate is a mixture that may be off by half of it: 1.6 % of the optical depth.
                let bound = 0.016 * -f64::ln(expected) * expected + 1e-3;
                assert!((found - expected).abs() < bound, "{materials}: {found}, expected {expected} within {bound}");
                worst = larger(worst, (found - expected).abs());
            }
        }
        table::SWEEP_PLATES.hold(worst, backend);
        Ok(())
    })
}
