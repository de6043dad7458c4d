//! Light that a mesh's clear bodies refract onto receivers: that of a sweep through the same mesh.

use super::on_both;
use vitrum::Frame;
use vitrum::backend::Backend;
use vitrum::scene::{MethodName, Scene};
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::larger;
use vitrum_conformance::refraction::{ball, case, cuboid, together};
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::fate;
use vitrum_kernels::glam::{DQuat, DVec3};

const EDGE: usize = 96;
/// White ground below the middle of the bodies, seen from far above; without ambient light pixels are irradiance.
const ABOVE: [&str; 8] = [
    "light.0.attachment=world",
    "light.0.elevation=50",
    "ground={height=-2,color=[1,1,1]}",
    "shading.ambient=[0,0,0]",
    "camera.projection=orthographic",
    "camera.elevation=89",
    "camera.zoom=0.2",
    "voxelization.resolution=96",
];

fn color(frame: &Frame) -> Vec<[f64; 3]> {
    frame
        .aov("color")
        .expect("every frame has a colour")
        .color()
        .into_iter()
        .map(|pixel| pixel.map(f64::from))
        .collect()
}

/// The pixels that see the ground past all bodies, and past a margin of two pixels around them, since volumes are larger than bodies.
fn beside(frame: &Frame) -> Vec<bool> {
    let bounces = frame.channel("bounces", "Y").expect("it is an output");
    let status = frame.channel("status", "Y").expect("it is an output");
    let straight = |at: usize| bounces[at] == 0.0 && status[at] == fate::MET;
    let around = |at: usize| {
        let (x, y) = (at % EDGE, at / EDGE);
        let near = |at: usize| at.saturating_sub(2)..=(at + 2).min(EDGE - 1);
        near(y).flat_map(move |y| near(x).map(move |x| y * EDGE + x))
    };
    (0..EDGE * EDGE).map(|at| around(at).all(straight)).collect()
}

/// A ball of glass and a leaning block of coloured glass.
fn bodies() -> Mesh {
    let turned = DQuat::from_rotation_x(0.5) * DQuat::from_rotation_z(0.3);
    let mut block = cuboid(DVec3::new(0.5, 0.7, 0.3), turned);
    block.positions.iter_mut().for_each(|position| position[0] += 1.8);
    together(&[ball(64), block])
}

const MATERIALS: &str =
    "material=[{name='m0',ior=1.5},{name='m1',ior=1.4,attenuation_color=[0.9,0.5,0.2],attenuation_distance=1}]";

/// The largest difference of the irradiance on the ground from that of a sweep, over unoccluded light's.
fn difference(case: &Case, backend: &mut dyn Backend) -> Result<f64, Failure> {
    let rays = vitrum::render(&case.scene, &case.assets, backend, &mut |_| true)?;
    let scene = Scene { method: MethodName::Sweep, ..case.scene.clone() };
    let swept = vitrum::render(&scene, &case.assets, backend, &mut |_| true)?;
    let (found, expected, seen) = (color(&rays), color(&swept), beside(&rays));
    let count = seen.iter().filter(|seen| **seen).count();
    assert!(count > 5000, "{count} pixels see the ground");
    let lit: Vec<&[f64; 3]> = expected.iter().zip(&seen).filter(|(_, seen)| **seen).map(|(pixel, _)| pixel).collect();
    let [dark, bright] = [f64::min, f64::max].map(|of| lit.iter().map(|pixel| pixel[2]).reduce(of).unwrap_or(0.0));
    // Unoccluded light has sin 50° = 0.77.
    assert!(bright > 0.9 && dark < 0.5, "there is a caustic of {bright} and a shadow of {dark}");
    let apart = |at: usize| (0..3).map(|c| (found[at][c] - expected[at][c]).abs()).fold(0.0, larger);
    Ok((0..found.len()).filter(|at| seen[*at]).map(apart).fold(0.0, larger))
}

/// Of a crisp light, a soft one and a lamp.
#[test]
fn the_ground_has_the_light_that_a_sweep_throws_there() -> Result<(), Failure> {
    on_both(|backend| {
        let mut worst = 0.0;
        for light in [
            "light.0.angular_radius=0",
            "light.0.angular_radius=3",
            "light.0={kind='point',position=[1,3,6],intensity=60}",
        ] {
            let case = case("caustics", bodies(), EDGE as u32, &[&ABOVE[..], &[MATERIALS, light]].concat())?;
            worst = larger(worst, difference(&case, backend)?);
        }
        // Rays meet the ground a 64th of a voxel early, which moves the caustic's crisp edges.
        assert!(worst < 0.08, "{worst}");
        Ok(())
    })
}
