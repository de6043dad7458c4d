//! A plate with parallel faces, a prism, a box within a box: what flat faces do.

use super::on_both;
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
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
    // A voxel is 2.2 / 192. Between voxels' centres the field is not quite that of a plane: a thousandth of a radian.
    for (settings, bound) in [(["voxels.surfaces=exact"], 2e-5), (["voxelization.resolution=192"], 2e-3)] {
        on_both(|backend| {
            for degrees in [20.0f64, 40.0, 60.0] {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let expected = 0.4 * sin * (1.0 - cos / (1.5f64.powi(2) - sin * sin).sqrt());
                let rays = plate(degrees, &settings, backend)?;
                assert!(rays.len() > 60);
                for ray in rays {
                    assert_eq!(ray.bounces, 2, "{degrees}°");
                    let aside = ray.left - ray.from;
                    let found = (aside - ray.towards * aside.dot(ray.towards)).length();
                    assert!((found - expected).abs() < bound, "{degrees}°: {found}, expected {expected}");
                    let turned = ray.direction.angle_between(ray.towards);
                    assert!(turned < bound, "{degrees}°: turned by {turned}");
                }
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// e^(−σ d) along straight rays, within 1 %.
#[test]
fn a_box_absorbs_by_beer_lambert() -> Result<(), Failure> {
    let material = "material=[{ior=1.5,attenuation_color=[1,0.3,1],attenuation_distance=1}]";
    for surfaces in ["voxels.surfaces=multi", "voxels.surfaces=exact", "voxels.surfaces=two"] {
        on_both(|backend| {
            let settings = [material, surfaces, "voxelization.resolution=128", "voxels.reflection=false"];
            for ray in plate(0.0, &settings, backend)? {
                let expected = 0.3f64.powf(0.4);
                assert!((ray.transmittance / expected - 1.0).abs() < 0.01, "{}: {expected}", ray.transmittance);
                assert!((ray.length - 0.4).abs() < 4e-3, "{}", ray.length);
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// The transmittance of two faces at normal incidence is (1 − F)², F = ((n − 1) / (n + 1))².
#[test]
fn faces_reflect_by_fresnel() -> Result<(), Failure> {
    on_both(|backend| {
        for ray in plate(0.0, &["voxelization.resolution=64"], backend)? {
            assert!((ray.transmittance - 0.9216).abs() < 1e-4, "{}", ray.transmittance);
        }
        Ok(())
    })
}

/// A square bar with an edge towards the eye: a ray that meets a face at 45° goes on at 28.1°. If it entered near the bar's other edge it
/// meets the next face at 61.9°, beyond the critical angle of 41.8°, is reflected to the one that lies across, and leaves at a right
/// angle to the way it came.
#[test]
fn faces_reflect_totally() -> Result<(), Failure> {
    let mesh = cuboid(DVec3::new(1.0, 1.0, 1.0), DQuat::from_rotation_z(45f64.to_radians()));
    for (settings, bound) in [("voxels.surfaces=exact", 1e-4), ("voxelization.resolution=128", 0.02)] {
        on_both(|backend| {
            let case = case("bar", mesh.clone(), 48, &[&ALONG_Y[..], &[settings]].concat())?;
            let traced = trace(&case, backend)?;
            // Behind 2 tan 28.1° of the face the next one is met: 0.66 < |x|.
            let near = |ray: &&Traced| (0.8..1.2).contains(&ray.from.x.abs()) && ray.from.z.abs() < 0.5;
            let reflected: Vec<&Traced> = traced.iter().filter(near).collect();
            assert!(reflected.len() > 50, "{} rays", reflected.len());
            for ray in reflected {
                let across = DVec3::new(-ray.from.x.signum(), 0.0, 0.0);
                assert_eq!(ray.bounces, 3, "{settings} at {}", ray.from);
                assert!(ray.direction.angle_between(across) < bound, "{settings} at {}: {}", ray.from, ray.direction);
            }
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
    for surfaces in ["voxels.surfaces=multi", "voxels.surfaces=exact"] {
        on_both(|backend| {
            let settings = [material, surfaces, "voxelization.resolution=128", "voxels.reflection=false"];
            let parts = together(&[outer.clone(), inner.clone()]);
            let case = case("nested", parts, 48, &[&ALONG_Y[..], &settings].concat())?;
            for ray in middle(&trace(&case, backend)?, 48) {
                let expected = 0.5f64.sqrt() * 0.1f64.sqrt();
                assert_eq!(ray.bounces, 4);
                assert!((ray.transmittance / expected - 1.0).abs() < 0.01, "{}: {expected}", ray.transmittance);
            }
            Ok(())
        })?;
    }
    Ok(())
}
