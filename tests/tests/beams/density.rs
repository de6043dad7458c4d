//! Media of varying density: the same picture where the density is 1 everywhere, airlight and shadows where it grows evenly, and the error by the number of
//! nodes.

use super::ball::in_fog;
use super::thin::Thin;
use super::{LAMP, case, on_both, on_the_cpu, red, rms};
use std::f64::consts::PI;
use std::sync::Arc;
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::cuboid;
use vitrum_conformance::{Failure, frames};
use vitrum_io::{Volume, Voxels};
use vitrum_kernels::glam::{DQuat, DVec3};

/// Half the edge of the medium's box.
const HALF: f64 = 12.0;

/// Voxels along an edge of the density.
const VOXELS: u32 = 64;

/// The largest difference between a homogeneous medium and one whose density is 1, over the brightest pixel: airlight has other parts, which leave
/// 3 · 10⁻⁵ as for one lamp in fog.
const ALIKE: f64 = 1e-4;

/// The largest error of airlight where the density grows evenly, as a share: between the two points of a part, whose optical depth is taken to grow in
/// proportion, it is curved.
const LARGEST: f64 = 1e-3;

/// The largest part of airlight that is left where a plate hides the lamp, as a share: a thin ray crosses single beams, whose light is linear over their
/// cross-sections. With 64 rays along an edge instead of 256 it is 0.025, in a homogeneous medium as well.
const LEFT: f64 = 0.01;

/// The density at x, before it is limited to the middles of the outer voxels: from 0 to 2.
fn even(x: f64) -> f64 {
    (x + HALF) / HALF
}

/// A density over the medium's box.
fn volume(density: impl Fn(f64) -> f64) -> Result<Arc<Volume>, Failure> {
    let spacing = 2.0 * HALF / f64::from(VOXELS);
    let row: Vec<f32> = (0..VOXELS).map(|i| density((f64::from(i) + 0.5) * spacing - HALF) as f32).collect();
    let values = row.repeat((VOXELS * VOXELS) as usize);
    Ok(Arc::new(Volume::new("density", [VOXELS; 3], [spacing as f32; 3], Voxels::F32(values.into()))?))
}

/// Gives a case's medium a density, in place of its extent.
fn with_density(case: &mut Case, density: impl Fn(f64) -> f64) -> Result<(), Failure> {
    let medium = case.scene.medium.as_mut().expect("a case in fog");
    medium.extent = None;
    // The volume itself is at hand.
    case.scene.set("medium.density.builtin='smoke'")?;
    case.assets.density = Some(volume(density)?);
    Ok(())
}

/// Where the density is 1 everywhere, the medium is homogeneous: seen directly, and through the ball.
#[test]
fn a_density_of_one_is_a_homogeneous_medium() -> Result<(), Failure> {
    let mut fog = in_fog(LAMP, 0.3, 0.5, 24)?;
    fog.resize(32);
    for setting in
        ["camera.position=[0,-9,0.5]", "camera.target=[0,0,-0.6]", "camera.field_of_view=40", "beams.views=3"]
    {
        fog.scene.set(setting)?;
    }
    let mut dense = fog.clone();
    with_density(&mut dense, |_| 1.0)?;
    on_both(|backend| {
        let (expected, found) = (frames::render(&fog, backend)?, frames::render(&dense, backend)?);
        for output in ["color", "airlight", "shadow", "caustics", "surfaces"] {
            let (expected, found) = (red(&expected, output), red(&found, output));
            let brightest = expected.iter().copied().fold(0.0, f64::max);
            let most = expected.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / brightest;
            println!("{output}: {most:.1e}");
            assert!(most <= ALIKE, "{output}: {most:.1e} of the brightest");
        }
        Ok(())
    })
}

/// σ_s and σ_a where the density is 1.
const SCATTERING: f64 = 0.1;
const ABSORPTION: f64 = 0.02;

/// The lamp of [`LAMP`].
const PLACE: DVec3 = DVec3::new(0.0, 0.0, 4.0);

/// A body in a medium whose density grows evenly along x.
fn growing(half: DVec3, settings: &[&str]) -> Result<Case, Failure> {
    let medium = format!("medium={{absorption={:?},scattering={:?}}}", [ABSORPTION; 3], [SCATTERING; 3]);
    let usual = [LAMP, &medium, "material=[{opaque=true,color=[0,0,0]}]", "beams.rays=64", "beams.nodes=32"];
    let mut case = case(cuboid(half, DQuat::IDENTITY), 1, &[&usual, settings].concat())?;
    with_density(&mut case, even)?;
    Ok(case)
}

/// Airlight of a ray from `from` up to a distance, by the midpoint rule: optical depths of a density that grows evenly are those of its mean.
fn airlight(from: DVec3, towards: DVec3, far: f64) -> f64 {
    const STEPS: u32 = 20_000;
    let step = far / f64::from(STEPS);
    let depth = |a: DVec3, b: DVec3| 0.5 * (even(a.x) + even(b.x)) * (b - a).length();
    let at = |number: u32| {
        let point = from + towards * ((f64::from(number) + 0.5) * step);
        let way = (point - PLACE).length();
        let dimmed = (-(SCATTERING + ABSORPTION) * (depth(PLACE, point) + depth(from, point))).exp();
        // 40 W over 4 π, scattered to all sides.
        SCATTERING * even(point.x) * (10.0 / PI) / (way * way) * dimmed / (4.0 * PI) * step
    };
    (0..STEPS).map(at).sum()
}

/// Where rays start.
const EYE: DVec3 = DVec3::new(0.5, -9.0, 1.5);

#[test]
fn airlight_of_a_density_that_grows_evenly() -> Result<(), Failure> {
    on_both(|backend| {
        // A small body that no ray meets.
        let mut thin = Thin::new(growing(DVec3::splat(0.1), &[])?, backend);
        for through in [DVec3::new(0.0, 0.0, 3.0), DVec3::new(4.0, 0.0, -1.0), DVec3::new(-5.0, 0.0, 2.0)] {
            let towards = (through - EYE).normalize();
            // In the last half voxel before a face the density stays, which changes less than 1e-4.
            let faces = (towards.signum() * HALF - EYE) / towards;
            let expected = airlight(EYE, towards, faces.min_element());
            let found = thin.look(EYE, through)?.airlight[0];
            println!("through {through}: {:.1e}", found / expected - 1.0);
            assert!((found / expected - 1.0).abs() <= LARGEST, "through {through}: {found}, not {expected}");
        }
        Ok(())
    })
}

/// Below a plate that hides the lamp there is no light: the shadow, drawn as beams, takes all airlight away.
#[test]
fn a_plate_takes_all_light_away() -> Result<(), Failure> {
    on_both(|backend| {
        let settings = ["beams.rays=256", "beams.pyramid=false"];
        let mut thin = Thin::new(growing(DVec3::new(9.0, 9.0, 0.1), &settings)?, backend);
        for through in [DVec3::new(0.0, 0.0, -3.0), DVec3::new(3.0, 1.0, -2.0), DVec3::new(-2.0, 2.0, -4.0)] {
            let seen = thin.look(DVec3::new(0.5, -5.0, -3.5), through)?;
            let (airlight, shadow) = (seen.airlight[0], seen.shadow[0]);
            println!("through {through}: {:.1e}", shadow / airlight - 1.0);
            // Beyond the shadow's edge, 20 away where the density's box ends, there may be light.
            assert!((shadow / airlight - 1.0).abs() <= LEFT, "through {through}: {shadow} of {airlight}");
        }
        Ok(())
    })
}

/// The error by the number of nodes, against the most (Hu et al. 2010, Fig. 11), root mean square over the brightest pixel.
#[test]
fn more_nodes_are_nearer() -> Result<(), Failure> {
    let smoke = Case::builtin("smoke", 64, None, &["beams.rays=32"])?;
    on_the_cpu(|backend| {
        let mut look = |nodes: u32| {
            let mut smoke = smoke.clone();
            smoke.scene.beams.nodes = nodes;
            Ok::<_, Failure>(red(&frames::render(&smoke, backend)?, "color"))
        };
        let best = look(64)?;
        let brightest = best.iter().copied().fold(0.0, f64::max);
        let mut before = f64::INFINITY;
        for nodes in [4, 8, 16, 32] {
            let error = rms(look(nodes)?.iter().zip(&best).map(|(a, b)| a - b)) / brightest;
            println!("{nodes} nodes: {error:.2e}");
            assert!(error < 0.6 * before, "{nodes} nodes are off by {error:.2e}, half as many by {before:.2e}");
            before = error;
        }
        Ok(())
    })
}
