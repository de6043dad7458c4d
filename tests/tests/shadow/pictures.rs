//! Opaque bodies and receivers in pictures, beside and behind clear ones.

use super::{ABOVE, case, color, on_both, sheets};
use vitrum::OutputRequest;
use vitrum::backend::Backend;
use vitrum::method::{Cache, Job};
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::{self, ball, cuboid, together};
use vitrum_conformance::{Failure, frames};
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::fate;
use vitrum_kernels::glam::{DQuat, DVec3};

/// The largest difference of two pictures' pixels, and how many differ by more than `bound`.
fn difference(a: &[[f32; 3]], b: &[[f32; 3]], bound: f32) -> (f32, usize) {
    let of_pixel =
        |(a, b): (&[f32; 3], &[f32; 3])| (0..3).map(|channel| (a[channel] - b[channel]).abs()).fold(0.0, f32::max);
    let all: Vec<f32> = a.iter().zip(b).map(of_pixel).collect();
    (all.iter().copied().fold(0.0, f32::max), all.iter().filter(|difference| **difference > bound).count())
}

fn moved(mesh: &Mesh, by: [f32; 3]) -> Mesh {
    let positions = mesh.positions.iter().map(|at| std::array::from_fn(|axis| at[axis] + by[axis])).collect();
    Mesh { positions, ..mesh.clone() }
}

/// Ground seen from above below a sheet that hovers: reflectance · (L cos θ e^(−c) + ambient).
#[test]
fn the_ground_is_lit_through_a_sheet() -> Result<(), Failure> {
    let settings = [
        "light.0.elevation=60",
        // From behind, so that the shadow falls towards the camera.
        "light.0.azimuth=180",
        "light.0.color=[2,1,0.5]",
        "light.0.intensity=0.5",
        "shading.ambient=[0.1,0.2,0.3]",
        "ground={height=-1,color=[0.5,0.6,0.7]}",
        "material.0.density=0.9",
        "shadow.resolution=64",
        "camera.elevation=70",
        "camera.azimuth=0",
        "camera.zoom=0.4",
    ];
    let case = case(sheets([0.0]), 96, &settings)?;
    let cosine = 60f32.to_radians().sin();
    let lit = |left: f32| -> [f32; 3] {
        let light = [1.0, 0.5, 0.25];
        std::array::from_fn(|c| [0.5, 0.6, 0.7][c] * (light[c] * cosine * left + [0.1, 0.2, 0.3][c]))
    };
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let status = frame.channel("status", "Y").expect("it is an output");
        assert!(status.iter().all(|&status| status == fate::MET), "the ground is everywhere");
        let count = |expected: [f32; 3]| {
            color(&frame).iter().filter(|pixel| (0..3).all(|c| (pixel[c] - expected[c]).abs() < 1e-4)).count()
        };
        let (free, behind) = (count(lit(1.0)), count(lit((-0.9f32).exp())));
        assert!(free > 4000 && behind > 100, "{free} lit, {behind} behind the sheet");
        Ok(())
    })
}

fn through(backend: &mut dyn Backend, with: &Case, without: &Case, bound: f32) -> Result<(f32, usize), Failure> {
    let (with, without) = (color(&frames::render(with, backend)?), color(&frames::render(without, backend)?));
    Ok(difference(&with, &without, bound))
}

/// Clear bodies of index 1 that absorb nothing are invisible: surfaces behind, before and in them look as without them.
#[test]
fn bodies_and_ground_are_seen_through_clear_ones() -> Result<(), Failure> {
    let opaque = together(&[
        moved(&ball(24), [0.0, -2.5, 0.2]),
        moved(&cuboid(DVec3::splat(0.4), DQuat::IDENTITY), [0.2, 0.0, 0.0]),
    ]);
    let plate = moved(&cuboid(DVec3::new(1.4, 0.5, 1.2), DQuat::from_rotation_z(0.2)), [0.0, 0.2, 0.1]);
    let mut all = together(&[
        moved(&ball(24), [0.0, -2.5, 0.2]),
        moved(&cuboid(DVec3::splat(0.4), DQuat::IDENTITY), [0.2, 0.0, 0.0]),
        plate.clone(),
    ]);
    all.materials[2].name = "plate".to_owned();
    let usual = [
        "light.0.elevation=50",
        "light.0.azimuth=-40",
        "material=[{name=\"plate\",ior=1},{opaque=true,color=[0.8,0.3,0.1]}]",
        "ground={height=-1.2}",
        "camera.elevation=12",
        "camera.azimuth=0",
        "camera.target=[0,-1,0]",
        "camera.position=[1,9,3]",
        "shadow.resolution=128",
        "voxelization.resolution=64",
    ];
    // Boxes differ, and with them the grids of the shadow maps: its edges move by a part of a voxel.
    for (kind, few) in [("voxels.surfaces=exact", 150), ("voxels.surfaces=multi", 150), ("voxels.surfaces=two", 150)] {
        let with = case(all.clone(), 96, &[&usual[..], &[kind]].concat())?;
        let without = case(opaque.clone(), 96, &[&usual[..], &[kind]].concat())?;
        on_both(|backend| {
            let (_, differ) = through(backend, &with, &without, 0.02)?;
            assert!(differ < few, "{kind}: {differ} pixels differ");
            let frame = frames::render(&with, backend)?;
            let bounces = frame.channel("bounces", "Y").expect("it is an output");
            let behind = bounces.iter().filter(|&&bounces| bounces >= 2.0).count();
            let within = bounces.iter().filter(|&&bounces| bounces == 1.0).count();
            assert!(behind > 500 && within > 50, "{kind}: {behind} rays went through the plate, {within} ended in it");
            Ok(())
        })?;
    }
    Ok(())
}

/// A ball of glass on the ground shows it by refraction in each kind of rays.
#[test]
fn glass_on_the_ground_shows_the_ground() -> Result<(), Failure> {
    for kind in ["voxels.surfaces=exact", "voxels.surfaces=multi", "voxels.surfaces=two", "voxels.normals=paper"] {
        let settings = [
            "ground={color=[0.9,0.1,0.1]}",
            "wall={color=[0.1,0.1,0.9]}",
            "light.0.attachment=camera",
            "environment.color=[0,1,0]",
            "environment.kind=color",
            "voxelization.resolution=64",
            kind,
        ];
        let case = refraction::case("ball", ball(48), 64, &settings)?;
        on_both(|backend| {
            let frame = frames::render(&case, backend)?;
            let bounces = frame.channel("bounces", "Y").expect("it is an output");
            let seen = color(&frame);
            let through: Vec<_> =
                (0..seen.len()).filter(|&pixel| bounces[pixel] > 1.0).map(|pixel| seen[pixel]).collect();
            let count = |test: fn(&[f32; 3]) -> bool| through.iter().filter(|pixel| test(pixel)).count();
            let (ground, wall) = (count(|p| p[0] > 2.0 * p[1]), count(|p| p[2] > 2.0 * p[0].max(p[1])));
            assert!(
                ground > 100 && wall > 100,
                "{kind}: {ground} see the ground, {wall} the wall, of {}",
                through.len()
            );
            Ok(())
        })?;
    }
    Ok(())
}

/// The colours of vertices, of materials and of the scene, in that order the other way round.
#[test]
fn bodies_have_their_own_colours() -> Result<(), Failure> {
    let settings = [
        "light.0.attachment=camera",
        "light.0.azimuth=0",
        "light.0.elevation=0",
        "shading.ambient=[0,0,0]",
        "camera.elevation=89",
        "camera.projection=orthographic",
        "ground=none",
    ];
    let sheet = sheets([0.0]);
    let mut of_material = together(std::slice::from_ref(&sheet));
    of_material.materials[0].base_color = Some([0.2, 0.4, 0.6]);
    let mut of_vertices = of_material.clone();
    // Red rises along x.
    of_vertices.colors = Some(sheet.positions.iter().map(|at| [0.5 + 0.5 * at[0], 0.25, 1.0, 1.0]).collect());
    let all = [&ABOVE[..], &settings].concat();
    let named = [&all[..], &["material.0.color=[0.1,0.2,0.3]"]].concat();
    on_both(|backend| {
        let mut middle = |mesh: &Mesh, settings: &[&str]| -> Result<[f32; 3], Failure> {
            let frame = frames::render(&case(mesh.clone(), 33, settings)?, backend)?;
            Ok(color(&frame)[16 * 33 + 16])
        };
        let near = |found: [f32; 3], expected: [f32; 3]| {
            assert!((0..3).all(|c| (found[c] - expected[c]).abs() < 2e-3), "{found:?}, expected {expected:?}");
        };
        near(middle(&sheet, &all)?, [0.7; 3]);
        near(middle(&of_material, &all)?, [0.2, 0.4, 0.6]);
        near(middle(&of_vertices, &all)?, [0.5, 0.25, 1.0]);
        near(middle(&of_vertices, &named)?, [0.1, 0.2, 0.3]);
        Ok(())
    })
}

/// A leaf that is lit from its other side shows the light that it lets through.
#[test]
fn leaves_glow_against_the_light() -> Result<(), Failure> {
    let settings = [
        "camera.elevation=-89",
        "camera.projection=orthographic",
        "shading.ambient=[0,0,0]",
        "ground=none",
        "material.0.density=0.5",
    ];
    on_both(|backend| {
        let frame = frames::render(&case(sheets([0.0]), 33, &[&ABOVE[..], &settings].concat())?, backend)?;
        let [found, ..] = color(&frame)[16 * 33 + 16];
        let expected = 0.7 * (-0.5f32).exp();
        assert!((found - expected).abs() < 1e-4, "{found}, expected {expected}");
        Ok(())
    })
}

/// Without shadows light is everywhere.
#[test]
fn shadows_can_be_turned_off() -> Result<(), Failure> {
    let settings = ["light.0.shadows=false", "ground={height=-1}", "camera.elevation=60", "shading.ambient=[0,0,0]"];
    on_both(|backend| {
        let frame = frames::render(&case(sheets([0.0]), 64, &[&ABOVE[..], &settings].concat())?, backend)?;
        assert!(color(&frame).iter().all(|pixel| (pixel[0] - 0.7).abs() < 1e-5));
        Ok(())
    })
}

/// A renderer makes the shadow map anew when the light or the material has changed, and the old map does not show.
#[test]
fn sessions_follow_the_light() -> Result<(), Failure> {
    let mesh = together(&[ball(16), moved(&sheets([0.0]), [0.0, 0.0, 1.5])]);
    let usual = ["light.0.elevation=50", "shadow.resolution=48", "voxelization.resolution=32"];
    let changes: [&[&str]; 5] = [
        &[],
        &["light.0.azimuth=70"],
        &["light.0.azimuth=70", "shadow.coefficient=uniform"],
        &["material=[{name=\"m0\",ior=1.4},{opaque=true,density=0.3}]"],
        &["light.0.shadows=false"],
    ];
    on_both(|backend| {
        let cases: Vec<Case> = changes
            .iter()
            .map(|change| case(mesh.clone(), 24, &[&usual[..], change].concat()))
            .collect::<Result<_, _>>()?;
        let fresh: Vec<Vec<[f32; 3]>> =
            cases.iter().map(|case| Ok(color(&frames::render(case, backend)?))).collect::<Result<_, Failure>>()?;
        assert!(fresh.windows(2).all(|pair| pair[0] != pair[1]), "the changes are to be seen");
        let mut cache = Cache::default();
        for (case, fresh) in cases.iter().zip(&fresh) {
            let job =
                Job { scene: &case.scene, assets: &cases[0].assets, request: OutputRequest::default(), chosen: None };
            let frame = vitrum::frame(&job, &mut cache, backend, &mut |_| true)?;
            assert!(color(&frame) == *fresh, "{}", case.name);
        }
        Ok(())
    })
}
