//! Flux: what becomes of a texel's light adds up to all of it, and what the fog scatters out of beams is in the picture.

use super::{LAMP, SUN, case, light, on_both, red, sheet};
use std::f64::consts::PI;
use vitrum::backend::Backend;
use vitrum::method::beams;
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{ball, cuboid};
use vitrum_conformance::shadow::view;
use vitrum_conformance::{Failure, frames};
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::pencil;
use vitrum_kernels::glam::{DQuat, DVec3, EulerRot};

/// The largest error of the sum of a texel's shares: f32 rounds each of some ten surfaces' Fresnel terms, and exponentials.
const SHARES: f64 = 1e-3;

/// The largest error of a share of which the statistics are a mean: f32's rounding of Fresnel's equations.
const ROUNDING: f64 = 1e-5;

/// The largest error of a picture's flux, as a share. The lattice is wider than the bodies by 2 · 10⁻⁴ of their width along each axis, so that flat bodies
/// as wide as the lattice get 4 · 10⁻⁴ too much; ends of beams are sampled by pixels.
const PICTURE: f64 = 1e-3;

/// The sums of the shares of all texels whose ray comes to the bodies' box, and the shares: escaped, received, absorbed, extinguished, lost.
pub fn shares(case: &Case, backend: &mut dyn Backend) -> Result<Vec<[f64; 5]>, Failure> {
    let frame = beams::prepare(&case.scene, &case.assets, backend).map_err(Failure::from)?;
    light::trace(&frame, backend)?;
    let records = frame.pencils(backend)?;
    let count = records.len() / pencil::SIZE;
    let of = |component: usize, texel: usize| f64::from(records[component * count + texel]);
    let parts = [pencil::ESCAPED, pencil::RECEIVED, pencil::ABSORBED, pencil::EXTINGUISHED, pencil::LOST];
    let came = |texel: &usize| of(pencil::PIECES, *texel) > 0.0;
    Ok((0..count).filter(came).map(|texel| parts.map(|part| of(part, texel))).collect())
}

/// Clear, absorbing and mirroring bodies in fog above a floor: no light is gained, nor lost without being counted.
#[test]
fn the_shares_of_a_texels_light_add_up() -> Result<(), Failure> {
    let turned = DQuat::from_euler(EulerRot::XYZ, 0.4, 0.3, 0.7);
    let bodies: [(Mesh, &str, [bool; 5]); 4] = [
        (ball(96), "material=[{ior=1.5}]", [true, true, false, true, true]),
        (ball(96), "material=[{ior=2.4,attenuation_color=[0.9,0.5,0.2]}]", [true, true, true, true, true]),
        (cuboid(DVec3::splat(0.6), turned), "material=[{ior=1.5}]", [true, true, false, true, true]),
        (ball(96), "material=[{mirror=true,color=[0.9,0.8,0.7]}]", [true, true, true, true, false]),
    ];
    on_both(|backend| {
        let mut largest = 0.0;
        for (mesh, material, has) in &bodies {
            for light in [LAMP, SUN] {
                let settings = [
                    light,
                    material,
                    "medium={absorption=[0.02,0.05,0],scattering=[0.1,0.05,0.02],extent=6}",
                    "ground={height=-2}",
                    "beams.rays=48",
                    "beams.segments=64",
                ];
                let shares = shares(&case(mesh.clone(), 8, &settings)?, backend)?;
                assert!(shares.len() > 48 * 48 / 2, "{} texels", shares.len());
                let worst = shares.iter().map(|shares| (shares.iter().sum::<f64>() - 1.0).abs()).fold(0.0, larger);
                let means: [f64; 5] =
                    std::array::from_fn(|part| shares.iter().map(|of| of[part]).sum::<f64>() / shares.len() as f64);
                println!("{material}, {light}: {means:.4?}, off by at most {worst:.1e}");
                assert!(worst <= SHARES, "{material}, {light}: the shares' sum is off by {worst:.1e}");
                assert_eq!(means.map(|mean| mean > 0.0), *has, "{material}, {light}: {means:?}");
                largest = larger(worst, largest);
            }
        }
        table::BEAMS_SHARES.hold(largest, backend);
        Ok(())
    })
}

/// What statistics say of light straight down on a level plate of index 1.5 above a floor, F = 0.04. The strongest piece goes on to the floor, the next two up;
/// what is left, (1 − F)² F² to the floor and weaker ones, is lost where pieces are limited to three, and the weaker ones always.
#[test]
fn pieces_beyond_the_limit_are_lost() -> Result<(), Failure> {
    let share: f64 = 0.04;
    let through = (1.0 - share).powi(2);
    let (up, weak) = (share + through * share, through * share * share);
    let plate = || cuboid(DVec3::new(0.5, 0.5, 0.1), DQuat::IDENTITY);
    for (pieces, expected) in [(1, [0.0, through]), (3, [up, through]), (8, [up, through + weak])] {
        let limit = format!("beams.segments={pieces}");
        let case = case(plate(), 8, &[SUN, "material=[{ior=1.5}]", "ground={height=-2}", "beams.rays=16", &limit])?;
        on_both(|backend| {
            let flux = frames::render(&case, backend)?.statistics.flux.expect("the plate is lit");
            println!("{pieces} pieces: {flux:?}");
            let found = [flux.escaped, flux.received, flux.absorbed, flux.extinguished, flux.lost];
            let lost = 1.0 - expected[0] - expected[1];
            for (found, expected) in found.into_iter().zip([expected[0], expected[1], 0.0, 0.0, lost]) {
                assert!((found - expected).abs() <= ROUNDING, "{pieces} pieces: {flux:?}, not {expected}");
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// Half the edge of the fog.
const HALF: f64 = 4.0;

/// Fog so thin that it attenuates nothing; it scatters this share a unit of length.
const SCATTERING: f64 = 1e-6;

/// The sum of the caustics over the pixels of a parallel projection, times a pixel's area, for a body in light straight down; the camera is turned, so that
/// beams end at all places between pixels.
fn in_picture(mesh: Mesh, material: &str, eye: &str, backend: &mut dyn Backend) -> Result<f64, Failure> {
    const EDGE: u32 = 384;
    let medium = format!("medium={{scattering={:?},extent={HALF}}}", [SCATTERING; 3]);
    let settings = [
        SUN,
        &medium,
        material,
        eye,
        "camera.projection=orthographic",
        "camera.target=[0,0,0]",
        "camera.roll=25",
        "beams.rays=64",
    ];
    let mut case = case(mesh, EDGE, &settings)?;
    // All of the fog is seen.
    case.scene.camera.zoom = (view(&case).half_size[1] / (HALF * 3f64.sqrt())) as f32;
    let [width, height] = view(&case).half_size.map(|half| 2.0 * half / f64::from(EDGE));
    Ok(red(&frames::render(&case, backend)?, "caustics").iter().sum::<f64>() * width * height)
}

/// A flat mirror that is tilted by 30° sends its light up at 60° to the vertical. A beam of flux Φ scatters Φ σ_s s / 4π to each side over a length s, and
/// the mean length to the fog's face is the half edge over sin 60°.
#[test]
fn a_mirrors_light_is_in_the_picture() -> Result<(), Failure> {
    let tilt = 30f64.to_radians();
    let (right, up) = (DVec3::X * 0.5, DVec3::new(0.0, tilt.cos(), tilt.sin()) * 0.5);
    let mesh = sheet(&[-right - up, right - up, right + up, up - right], &[[0, 1, 2], [0, 2, 3]]);
    let flux = 0.8 * tilt.cos();
    let expected = flux * SCATTERING * HALF / (2.0 * tilt).sin() / (4.0 * PI);
    on_both(|backend| {
        let material = "material=[{mirror=true,color=[0.8,0.8,0.8]}]";
        // From the side that mirrors, so that the mirror hides nothing.
        let found = in_picture(mesh.clone(), material, "camera.position=[8,-14,9]", backend)?;
        let error = (found / expected - 1.0).abs();
        assert!(error <= PICTURE, "{found:e}, not {expected:e}");
        table::BEAMS_MIRROR.hold(error, backend);
        Ok(())
    })
}

/// A level plate reflects F of light straight down at its first face and, of what comes in, the same at each further one. Up go F + (1 − F)² F, down
/// (1 − F)² (1 + F²); the rest, (1 − F)² F³ and less, is below the threshold.
#[test]
fn a_plates_light_is_in_the_picture() -> Result<(), Failure> {
    let share: f64 = 0.04;
    let (up, down) = (share + (1.0 - share).powi(2) * share, (1.0 - share).powi(2) * (1.0 + share * share));
    let length = HALF - 0.1;
    let expected = (up + down) * length * SCATTERING / (4.0 * PI);
    on_both(|backend| {
        let mesh = cuboid(DVec3::new(0.5, 0.5, 0.1), DQuat::IDENTITY);
        // Along the plate, so that the plate hides nothing.
        let found = in_picture(mesh, "material=[{ior=1.5}]", "camera.position=[9,-16,0]", backend)?;
        let error = (found / expected - 1.0).abs();
        assert!(error <= PICTURE, "{found:e}, not {expected:e}");
        table::BEAMS_PLATE.hold(error, backend);
        Ok(())
    })
}
