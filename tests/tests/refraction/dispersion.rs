//! Dispersion: light of each wavelength goes its own way through a prism, and none is lost.

use super::on_both;
use vitrum::backend::Backend;
use vitrum::scene::YELLOW;
use vitrum_conformance::closed_forms::table::larger;
use vitrum_conformance::refraction::{ball, case, prism, refract, trace};
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::glam::DVec3;

/// Hydrogen's lines C and F and helium's line d between them, in micrometres.
const LINES: [f64; 3] = [0.656_27, YELLOW, 0.486_13];

/// Dense flint, N-SF6.
const FLINT: &str = "material=[{ior=1.80518,abbe=25.36}]";

/// The largest error of a direction, in degrees: f32 rounds the index, the normals and two refractions, each to a few 10⁻⁷ rad.
const DIRECTION: f64 = 1e-4;

/// The largest error of radiance: that of a white furnace without dispersion (`furnace.rs`), and of the weights of seven wavelengths, whose absolute
/// values add up to less than 2.
const RADIANCE: f64 = 1e-6;

/// The angle between the lines C and F behind the prism, and the largest error, in degrees.
fn spread(backend: &mut dyn Backend) -> Result<(f64, f64), Failure> {
    let (mesh, [first, second]) = prism(-0.6);
    let settings = [
        "camera.projection=orthographic",
        "camera.azimuth=0",
        "camera.elevation=0",
        "environment.kind=color",
        "voxels.surfaces=exact",
        FLINT,
    ];
    let case = case("prism", mesh, 64, &settings)?;
    let mut worst = 0.0;
    let mut ways = Vec::new();
    for wavelength in LINES {
        let index = case.scene.material[0].ior_at(wavelength);
        let inside = refract(DVec3::NEG_Y, first, 1.0, index).expect("light gets into glass");
        let expected = refract(inside, second, index, 1.0).expect("it leaves below the critical angle");
        let mut case = case.clone();
        case.scene = case.scene.at_wavelength(wavelength);
        // Those that meet the two faces alone.
        let traced = trace(&case, backend)?;
        let through: Vec<_> =
            traced.iter().filter(|ray| ray.bounces == 2 && ray.direction.angle_between(expected) < 0.1).collect();
        assert!(through.len() > 100, "{} rays", through.len());
        for ray in &through {
            worst = larger(worst, ray.direction.angle_between(expected).to_degrees());
        }
        ways.push(through[0].direction);
    }
    Ok((ways[0].angle_between(ways[2]).to_degrees(), worst))
}

#[test]
fn a_prism_deviates_each_line_by_snells_law() -> Result<(), Failure> {
    on_both(|backend| {
        let (spread, worst) = spread(backend)?;
        println!(
            "{}: lines C and F are {spread:.3}° apart; directions are off by at most {worst:.1e}°",
            backend.name()
        );
        assert!(worst <= DIRECTION, "off by {worst}°");
        assert!(spread > 3.0, "{spread}°");
        Ok(())
    })
}

/// A ball in white surroundings stays white: the weights of the wavelengths add up to that of white.
#[test]
fn a_dispersing_ball_has_radiance_one_in_a_white_furnace() -> Result<(), Failure> {
    for wavelengths in [3, 7] {
        let count = format!("voxels.wavelengths={wavelengths}");
        let settings = [
            "environment.kind=color",
            "environment.color=[1,1,1]",
            "light=[]",
            "voxels.surfaces=exact",
            "material=[{ior=1.5,abbe=10}]",
            &count,
        ];
        let case = case("furnace", ball(64), 32, &settings)?;
        on_both(|backend| {
            let picture = frames::render(&case, backend)?;
            let colors = picture.aov("color").expect("every frame has a colour").color();
            let worst = colors.iter().flatten().map(|channel| (f64::from(*channel) - 1.0).abs()).fold(0.0, larger);
            println!("{wavelengths} wavelengths: {worst:.1e} ({})", backend.name());
            assert!(worst <= RADIANCE, "{wavelengths} wavelengths: off by {worst:.1e}");
            Ok(())
        })?;
    }
    Ok(())
}
