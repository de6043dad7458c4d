//! Flat faces that are not parallel: the normal of a tilted face, a prism, an octahedron.

use super::on_both;
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{Traced, case, cuboid, prism, refract, trace};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DQuat, DVec3, EulerRot};

/// Rays along −y, the camera's way at azimuth 0 and elevation 0.
const ALONG_Y: [&str; 4] =
    ["camera.projection=orthographic", "camera.azimuth=0", "camera.elevation=0", "environment.kind=color"];

/// Pixels along an edge of the pictures.
const EDGE: usize = 64;

/// The rays of a mesh, n = 1.5, as voxels: `resolution` along its longest edge.
fn rays(mesh: &Mesh, settings: &[&str], backend: &mut dyn Backend) -> Result<Vec<Traced>, Failure> {
    trace(&case("faces", mesh.clone(), EDGE as u32, &[&ALONG_Y, settings].concat())?, backend)
}

/// The rays near the middle of the picture, a tenth of its edge to each side.
fn middle(traced: &[Traced]) -> impl Iterator<Item = &Traced> {
    let near = |index: usize| (EDGE * 2 / 5..EDGE * 3 / 5).contains(&index);
    traced.iter().enumerate().filter(move |(at, _)| near(at % EDGE) && near(at / EDGE)).map(|(_, ray)| ray)
}

/// The largest angle, in degrees, between the normals of faces that are tilted by some angles and those that rays find there.
fn lean(resolution: u32, backend: &mut dyn Backend) -> Result<f64, Failure> {
    let mut worst = 0.0;
    for [x, y, z] in [[0.2, 0.0, 0.35], [0.5, 0.3, 0.1], [0.05, 0.0, 0.6], [0.4, 0.7, -0.3]] {
        let turned = DQuat::from_euler(EulerRot::XYZ, x, y, z);
        let mesh = cuboid(DVec3::new(1.0, 0.6, 1.0), turned);
        let setting = format!("voxelization.resolution={resolution}");
        let traced = rays(&mesh, &[&setting], backend)?;
        for ray in middle(&traced) {
            worst = larger(worst, ray.normal.angle_between(turned * DVec3::Y).to_degrees());
        }
    }
    Ok(worst)
}

/// Distances that are cut off too near the surface lean its normals, at any resolution.
#[test]
fn the_normal_of_a_tilted_face_converges() -> Result<(), Failure> {
    on_both(|backend| {
        let leans = [64, 128, 256].map(|resolution| lean(resolution, backend));
        let [coarse, middling, fine] = leans;
        let (coarse, middling, fine) = (coarse?, middling?, fine?);
        println!("{}: {coarse:.4}°, {middling:.4}°, {fine:.4}°", backend.name());
        table::TILTED_FACE.hold(middling, backend);
        // Distances of 16 bits over twelve voxels are right to 9e-5 voxels: a normal from two of them, two voxels apart, to 0.005°.
        assert!(middling < coarse && fine < 5e-3, "{coarse}°, {middling}°, {fine}°");
        Ok(())
    })
}

#[test]
fn a_prism_deviates_rays_by_snells_law_at_both_faces() -> Result<(), Failure> {
    on_both(|backend| {
        let mut worst = 0.0;
        for turned in [-0.225, -0.325, -0.425] {
            let (mesh, [first, second]) = prism(turned);
            let towards = DVec3::NEG_Y;
            let inside = refract(towards, first, 1.0, 1.5).expect("light gets into glass");
            let expected = refract(inside, second, 1.5, 1.0).expect("it leaves below the critical angle");
            let traced = rays(&mesh, &["voxelization.resolution=128"], backend)?;
            let mut through = 0;
            // Rays that meet both faces three tenths of an edge or more from their ends.
            for ray in &traced {
                let along = |normal: DVec3, at: DVec3| at.dot(normal.cross(DVec3::Z));
                let enters = ray.from + ray.towards * ((0.5 - ray.from.dot(first)) / ray.towards.dot(first));
                let leaves = enters + inside * ((0.5 - enters.dot(second)) / inside.dot(second));
                if along(first, enters).abs() < 0.5 && along(second, leaves).abs() < 0.5 && enters.z.abs() < 0.4 {
                    through += 1;
                    worst = larger(worst, ray.direction.angle_between(expected).to_degrees());
                }
            }
            assert!(through > 30, "{through} rays");
        }
        table::PRISM_OF_VOXELS.hold(worst, backend);
        Ok(())
    })
}

/// Rays through an octahedron as voxels against those through its eight triangles.
#[test]
fn an_octahedron_of_voxels_is_that_of_triangles() -> Result<(), Failure> {
    let turned = DQuat::from_euler(EulerRot::XYZ, 0.3, 0.7, 1.1);
    let axes = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let positions = axes.map(|axis| (turned * axis).as_vec3().to_array()).to_vec();
    #[rustfmt::skip]
    let triangles = vec![
        [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
    ];
    let mesh = Mesh::new("octahedron", positions, triangles).expect("a valid mesh");
    on_both(|backend| {
        let exact = rays(&mesh, &["voxels.surfaces=exact"], backend)?;
        let voxels = rays(&mesh, &["voxelization.resolution=256"], backend)?;
        let errors: Vec<f64> = exact
            .iter()
            .zip(&voxels)
            .filter(|(exact, _)| exact.bounces > 0)
            .map(|(exact, voxels)| exact.direction.angle_between(voxels.direction).to_degrees())
            .collect();
        let far = errors.iter().filter(|&&error| error.is_nan() || error >= 0.5).count();
        println!("{}: {far} of {} rays are off by more than 0.5°", backend.name(), errors.len());
        assert!(errors.len() > 800, "{} rays meet it", errors.len());
        table::OCTAHEDRON.hold(far as f64 / errors.len() as f64, backend);
        Ok(())
    })
}
