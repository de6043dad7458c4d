//! Dispersion: beams of each wavelength go their own way through a prism, and carry all of the flux.

use super::{SUN, case, on_both};
use vitrum::backend::Backend;
use vitrum::method::{PreparedFrame as _, beams};
use vitrum::scene::YELLOW;
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::{cuboid, prism, refract};
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::abi::record::pencil;
use vitrum_kernels::glam::{DQuat, DVec3};

/// Hydrogen's lines C and F and helium's line d between them, in micrometres.
const LINES: [f64; 3] = [0.656_27, YELLOW, 0.486_13];

/// Dense flint: N-SF6.
const FLINT: &str = "material=[{ior=1.80518,abbe=25.36}]";

/// The largest error of a direction, in degrees: f32 rounds the index, the normals and two refractions, each to a few 10⁻⁷ rad.
const DIRECTION: f64 = 1e-4;

/// The largest error of a share: f32's rounding of Fresnel's equations.
const SHARE: f64 = 1e-5;

/// A case as light of one wavelength meets it.
fn at(case: &Case, wavelength: f64) -> Case {
    Case { scene: case.scene.at_wavelength(wavelength), ..case.clone() }
}

/// The directions of the texels' light behind the second of two refractions; weaker parts are not followed.
fn directions(case: &Case, backend: &mut dyn Backend) -> Result<Vec<DVec3>, Failure> {
    let frame = beams::prepare(&case.scene, &case.assets, backend).map_err(Failure::from)?;
    frame.run(backend, &mut |_, _| true)?;
    let records = frame.pencils(backend)?;
    let count = records.len() / pencil::SIZE;
    let of = |component: usize, texel: usize| f64::from(records[component * count + texel]);
    let direction = |texel| DVec3::from_array([0, 1, 2].map(|axis| of(pencil::DIRECTION + axis, texel)));
    Ok((0..count).filter(|&texel| of(pencil::BOUNCES, texel) == 2.0).map(direction).collect())
}

#[test]
fn a_prism_deviates_beams_of_each_line_by_snells_law() -> Result<(), Failure> {
    let (mesh, [first, second]) = prism(-0.6);
    let settings = [
        "light.0={kind='distant',attachment='world',direction=[0,-1,0],angular_radius=0}",
        "medium={scattering=[1e-6,1e-6,1e-6],extent=6}",
        "beams.threshold=0.5",
        "beams.rays=32",
        FLINT,
    ];
    let case = case(mesh, 8, &settings)?;
    on_both(|backend| {
        let mut ways = Vec::new();
        for wavelength in LINES {
            let index = case.scene.material[0].ior_at(wavelength);
            let inside = refract(DVec3::NEG_Y, first, 1.0, index).expect("light gets into glass");
            let expected = refract(inside, second, index, 1.0).expect("it leaves below the critical angle");
            let found = directions(&at(&case, wavelength), backend)?;
            // Others meet the base.
            let angles = found.iter().map(|direction| direction.angle_between(expected).to_degrees());
            let through: Vec<f64> = angles.filter(|&angle| angle < 5.0).collect();
            let worst = through.iter().copied().fold(0.0, f64::max);
            println!("{wavelength} µm: {} beams, off by at most {worst:.1e}° ({})", through.len(), backend.name());
            assert!(through.len() > 100, "{} beams", through.len());
            assert!(worst <= DIRECTION, "{wavelength} µm: off by {worst}°");
            ways.push(expected);
        }
        assert!(ways[0].angle_between(ways[2]).to_degrees() > 3.0, "the lines are apart");
        Ok(())
    })
}

/// Light straight down on a level plate above a floor: (1 − F)² (1 + F²) of it is received by the floor and F + (1 − F)² F escapes, with F at the index of
/// each wavelength; weaker parts, below the threshold, are lost.
#[test]
fn the_flux_of_each_wavelength_is_that_of_its_index() -> Result<(), Failure> {
    let plate = cuboid(DVec3::new(0.5, 0.5, 0.1), DQuat::IDENTITY);
    let case = case(plate, 8, &[SUN, FLINT, "ground={height=-2}", "beams.rays=16"])?;
    on_both(|backend| {
        for wavelength in LINES {
            let index = case.scene.material[0].ior_at(wavelength);
            let share = ((index - 1.0) / (index + 1.0)).powi(2);
            let through = (1.0 - share).powi(2);
            let (received, escaped) = (through * (1.0 + share * share), share + through * share);
            let flux = frames::render(&at(&case, wavelength), backend)?.statistics.flux.expect("the plate is lit");
            println!("{wavelength} µm: {flux:?}");
            let found = [flux.escaped, flux.received, flux.absorbed, flux.extinguished, flux.lost];
            for (found, expected) in found.into_iter().zip([escaped, received, 0.0, 0.0, 1.0 - received - escaped]) {
                assert!((found - expected).abs() <= SHARE, "{wavelength} µm: {flux:?}, not {expected}");
            }
        }
        Ok(())
    })
}
