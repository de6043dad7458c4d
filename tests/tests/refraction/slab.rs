//! A plate with parallel faces, a prism, a box within a box: what flat faces do.

use super::on_both;
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{Traced, case, cuboid, together, trace};
use vitrum_kernels::glam::{DQuat, DVec3};

/// Rays along −y, the camera's way at azimuth 0 and elevation 0.
const ALONG_Y: [&str; 4] =
    ["camera.projection=orthographic", "camera.azimuth=0", "camera.elevation=0", "environment.kind=color"];

/// The rays near the middle of the picture, a tenth of its edge to each side: away from the edges, which voxels round off.
fn middle(traced: &[Traced], edge: usize) -> impl Iterator<Item = &Traced> {
    let near = move |index: usize| (edge * 2 / 5..edge * 3 / 5).contains(&index);
    traced.iter().enumerate().filter(move |(at, _)| near(at % edge) && near(at / edge)).map(|(_, ray)| ray)
}

fn plate(degrees: f64, settings: &[&str], backend: &mut dyn Backend) -> Result<Vec<Traced>, Failure> {
    let mesh = cuboid(DVec3::new(1.0, 0.2, 1.0), DQuat::from_rotation_z(degrees.to_radians()));
    let case = case("plate", mesh, 48, &[&ALONG_Y, settings].concat())?;
    Ok(middle(&trace(&case, backend)?, 48).copied().collect())
}

/// A plate of thickness t moves a ray that meets it at θ by t sin θ (1 − cos θ / √(n² − sin² θ)) to the side.
#[test]
fn a_plate_moves_rays_to_the_side() -> Result<(), Failure> {
    // A voxel is 2.2 / 192; parallel faces make up for each other's errors, others are those of `faces.rs`.
    for (settings, of_side, of_turn) in [
        (["voxels.surfaces=exact"], table::PLATE_SIDE_EXACT, table::PLATE_TURN_EXACT),
        (["voxelization.resolution=192"], table::PLATE_SIDE_VOXELS, table::PLATE_TURN_VOXELS),
    ] {
        on_both(|backend| {
            let (mut side, mut turn) = (0.0, 0.0);
            for degrees in [20.0f64, 40.0, 60.0] {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let expected = 0.4 * sin * (1.0 - cos / (1.5f64.powi(2) - sin * sin).sqrt());
                let rays = plate(degrees, &settings, backend)?;
                assert!(rays.len() > 60);
                for ray in rays {
                    assert_eq!(ray.bounces, 2, "{degrees}°");
                    let aside = ray.left - ray.from;
                    let found = (aside - ray.towards * aside.dot(ray.towards)).length();
                    side = larger(side, (found - expected).abs());
                    turn = larger(turn, ray.direction.angle_between(ray.towards));
                }
            }
            of_side.hold(side, backend);
            of_turn.hold(turn, backend);
            Ok(())
        })?;
    }
    Ok(())
}

/// e^(−σ d) along straight rays.
#[test]
fn a_box_absorbs_by_beer_lambert() -> Result<(), Failure> {
    let material = "material=[{ior=1.5,attenuation_color=[1,0.3,1],attenuation_distance=1}]";
    for (kinds, of_transmittance, of_length) in [
        (&["voxels.surfaces=multi", "voxels.surfaces=two"][..], table::BOX_VOXELS, table::BOX_LENGTH_VOXELS),
        (&["voxels.surfaces=exact"], table::BOX_EXACT, table::BOX_LENGTH_EXACT),
    ] {
        on_both(|backend| {
            let (mut transmittance, mut length) = (0.0, 0.0);
            for surfaces in kinds {
                let settings = [material, surfaces, "voxelization.resolution=128", "voxels.reflection=false"];
                for ray in plate(0.0, &settings, backend)? {
                    transmittance = larger(transmittance, (ray.transmittance / 0.3f64.powf(0.4) - 1.0).abs());
                    length = larger(length, (ray.length - 0.4).abs());
                }
            }
            of_transmittance.hold(transmittance, backend);
            of_length.hold(length, backend);
            Ok(())
        })?;
    }
    Ok(())
}

/// The transmittance of two faces at normal incidence is (1 − F)², F = ((n − 1) / (n + 1))².
#[test]
fn faces_reflect_by_fresnel() -> Result<(), Failure> {
    on_both(|backend| {
        let rays = plate(0.0, &["voxelization.resolution=64"], backend)?;
        table::FRESNEL.hold(rays.iter().map(|ray| (ray.transmittance - 0.9216).abs()).fold(0.0, larger), backend);
        Ok(())
    })
}

/// A square bar with an edge towards the eye: a ray that meets a face at 45° goes on at 28.1°. If it entered near the bar's other edge it
/// meets the next face at 61.9°, beyond the critical angle of 41.8°, is reflected to the one that lies across, and leaves at a right
/// angle to the way it came.
#[test]
fn faces_reflect_totally() -> Result<(), Failure> {
    let mesh = cuboid(DVec3::new(1.0, 1.0, 1.0), DQuat::from_rotation_z(45f64.to_radians()));
    for (settings, of_turn) in
        [("voxels.surfaces=exact", table::BAR_EXACT), ("voxelization.resolution=128", table::BAR_VOXELS)]
    {
        on_both(|backend| {
            let case = case("bar", mesh.clone(), 48, &[&ALONG_Y[..], &[settings]].concat())?;
            let traced = trace(&case, backend)?;
            // Behind 2 tan 28.1° of the face the next one is met: 0.66 < |x|.
            let near = |ray: &&Traced| (0.8..1.2).contains(&ray.from.x.abs()) && ray.from.z.abs() < 0.5;
            let reflected: Vec<&Traced> = traced.iter().filter(near).collect();
            assert!(reflected.len() > 50, "{} rays", reflected.len());
            let mut turn = 0.0;
            for ray in reflected {
                let across = DVec3::new(-ray.from.x.signum(), 0.0, 0.0);
                assert_eq!(ray.bounces, 3, "{settings} at {}", ray.from);
                turn = larger(turn, ray.direction.angle_between(across));
            }
            of_turn.hold(turn, backend);
            Ok(())
        })?;
    }
    Ok(())
}

/// Where bodies overlap, the smaller one fills the space: each absorbs along its own part of the way.
#[test]
fn a_box_within_a_box_has_a_material_of_its_own() -> Result<(), Failure> {
    let outer = cuboid(DVec3::new(1.0, 0.5, 1.0), DQuat::IDENTITY);
    let inner = cuboid(DVec3::new(0.7, 0.25, 0.7), DQuat::IDENTITY);
    let material = "material=[{name=\"m0\",ior=1.5,attenuation_color=[1,0.5,1],attenuation_distance=1},\
                    {name=\"m1\",ior=1.2,attenuation_color=[1,0.1,1],attenuation_distance=1}]";
    for (surfaces, of_transmittance) in
        [("voxels.surfaces=multi", table::NESTED_VOXELS), ("voxels.surfaces=exact", table::NESTED_EXACT)]
    {
        on_both(|backend| {
            let settings = [material, surfaces, "voxelization.resolution=128", "voxels.reflection=false"];
            let parts = together(&[outer.clone(), inner.clone()]);
            let case = case("nested", parts, 48, &[&ALONG_Y[..], &settings].concat())?;
            let mut transmittance = 0.0;
            for ray in middle(&trace(&case, backend)?, 48) {
                let expected = 0.5f64.sqrt() * 0.1f64.sqrt();
                assert_eq!(ray.bounces, 4);
                transmittance = larger(transmittance, (ray.transmittance / expected - 1.0).abs());
            }
            of_transmittance.hold(transmittance, backend);
            Ok(())
        })?;
    }
    Ok(())
}
