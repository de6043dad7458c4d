//! The medium: its phase functions, its colours, and the light of lamps and spots in it, against sums over a viewing ray in f64.

use super::thin::Thin;
use super::{LAMP, SUN, case, on_both};
use std::f64::consts::PI;
use vitrum_conformance::Failure;
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::cuboid;
use vitrum_kernels::abi::beams::{Medium, phase as kind};
use vitrum_kernels::beams::medium::phase;
use vitrum_kernels::glam::{DQuat, DVec3};

/// The largest error of airlight, as a share: Gauss's rule leaves 3 · 10⁻⁵ at most, and f32 as much.
const LARGEST: f64 = 1e-4;

/// Half the edge of the fog's cube around the origin.
const HALF: f64 = 12.0;

const SCATTERING: [f64; 3] = [0.1, 0.05, 0.2];
const ABSORPTION: [f64; 3] = [0.02, 0.1, 0.0];

/// The lamp's place.
const PLACE: DVec3 = DVec3::new(0.0, 0.0, 4.0);

/// Where rays start, and points on them; the first one passes the lamp at a distance of 1. None meets the body at the origin.
const EYE: DVec3 = DVec3::new(0.0, -9.0, 0.5);
const THROUGH: [DVec3; 3] = [DVec3::new(0.0, 0.0, 3.0), DVec3::new(1.0, 0.0, 0.4), DVec3::new(2.5, 1.0, 4.2)];

fn rayleigh(cosine: f64) -> f64 {
    0.75 * (1.0 + cosine * cosine) / (4.0 * PI)
}

/// A small black body in fog of three colours.
fn in_fog(settings: &[&str]) -> Result<Case, Failure> {
    let medium =
        format!("medium={{absorption={ABSORPTION:?},scattering={SCATTERING:?},extent={HALF},phase='rayleigh'}}");
    let usual = [&medium, "material=[{opaque=true,color=[0,0,0]}]", "beams.rays=4"];
    case(cuboid(DVec3::splat(0.1), DQuat::IDENTITY), 1, &[&usual, settings].concat())
}

/// What is left of each colour behind a length of fog.
fn left(length: f64) -> [f64; 3] {
    std::array::from_fn(|channel| (-(SCATTERING[channel] + ABSORPTION[channel]) * length).exp())
}

/// The distance at which a ray leaves the fog.
fn leaves(from: DVec3, towards: DVec3) -> f64 {
    let faces = towards.signum() * HALF;
    ((faces - from) / towards).to_array().into_iter().filter(|way| way.is_finite()).fold(f64::INFINITY, f64::min)
}

/// Light at a point: irradiance, direction, and the way through fog before.
type Light = (f64, DVec3, f64);

/// The light of a source at points.
type Source = fn(DVec3) -> Light;

fn of_lamp(at: DVec3) -> Light {
    let way = at - PLACE;
    let distance = way.length();
    (10.0 / PI / (distance * distance), way / distance, distance)
}

fn of_sun(at: DVec3) -> Light {
    (1.0, -DVec3::Z, HALF - at.z)
}

/// Airlight of the part of a ray between two distances: a sum of the midpoint rule, good to 10⁻⁷.
fn airlight(light: Source, towards: DVec3, [near, far]: [f64; 2]) -> [f64; 3] {
    const STEPS: u32 = 20_000;
    let step = (far - near) / f64::from(STEPS);
    let mut sum = [0.0; 3];
    for number in 0..STEPS {
        let t = near + (f64::from(number) + 0.5) * step;
        let (irradiance, direction, way) = light(EYE + towards * t);
        let strength = irradiance * rayleigh(-direction.dot(towards)) * step;
        let left = left(way + t);
        sum = std::array::from_fn(|channel| sum[channel] + SCATTERING[channel] * strength * left[channel]);
    }
    sum
}

fn hold(found: [f64; 3], expected: [f64; 3], what: &str) {
    for (channel, (found, expected)) in found.into_iter().zip(expected).enumerate() {
        println!("{what}, channel {channel}: {:.1e}", found / expected - 1.0);
        assert!((found / expected - 1.0).abs() <= LARGEST, "{what}, channel {channel}: {found}, not {expected}");
    }
}

/// The integral of a phase function over all directions is 1, that of the cosine g.
#[test]
fn phase_functions_scatter_all_light() {
    const STEPS: u32 = 100_000;
    let henyey_greenstein = |g: f32| (kind::HENYEY_GREENSTEIN, g);
    let all = [-0.9, -0.4, 0.0, 0.3, 0.7, 0.95].map(henyey_greenstein);
    for (kind, anisotropy) in all.into_iter().chain([(kind::RAYLEIGH, 0.0)]) {
        let medium = Medium { phase: kind, anisotropy, ..Medium::default() };
        let (mut whole, mut mean) = (0.0, 0.0);
        for number in 0..STEPS {
            let cosine = (f64::from(number) + 0.5) / f64::from(STEPS) * 2.0 - 1.0;
            let share = f64::from(phase(&medium, &[], cosine as f32)) * 4.0 * PI / f64::from(STEPS);
            (whole, mean) = (whole + share, mean + share * cosine);
        }
        // Where g is 0.95 the peak is as sharp as f32's rounding of 1 + g² − 2 g cos θ.
        assert!((whole - 1.0).abs() < 1e-4, "{kind}, {anisotropy}: {whole}");
        assert!((mean - f64::from(anisotropy)).abs() < 1e-4, "{kind}, {anisotropy}: {mean}");
    }
}

/// Rayleigh's phase function, and fog that attenuates each colour by its own coefficient.
#[test]
fn each_colour_has_its_own_airlight() -> Result<(), Failure> {
    on_both(|backend| {
        let lights: [(&str, Source); 2] = [(LAMP, of_lamp), (SUN, of_sun)];
        for (setting, light) in lights {
            let mut thin = Thin::new(in_fog(&[setting])?, backend);
            for through in THROUGH {
                let towards = (through - EYE).normalize();
                let expected = airlight(light, towards, [0.0, leaves(EYE, towards)]);
                hold(thin.look(EYE, through)?.airlight, expected, &format!("{setting}, through {through}"));
            }
        }
        Ok(())
    })
}

/// Fog in front of a surface attenuates its light, and that in front of the light's source.
#[test]
fn fog_attenuates_surfaces() -> Result<(), Failure> {
    on_both(|backend| {
        let mut thin = Thin::new(in_fog(&[SUN, "ground={height=-3,color=[0.5,0.5,0.5]}"])?, backend);
        let point = DVec3::new(1.0, 0.5, -3.0);
        let expected = left(HALF + 3.0 + (point - EYE).length()).map(|left| 0.5 / PI * left);
        hold(thin.look(EYE, point)?.surfaces, expected, "the ground");
        Ok(())
    })
}

/// A spot 3.5 above a level ray lights the part of it that is within its cone: all of it by 80°, 3.5 tan 20° to each side by 20°, none where the ray passes
/// the cone.
#[test]
fn a_spot_lights_the_fog_in_its_cone() -> Result<(), Failure> {
    let spot = |angle: f64| {
        format!(
            "light.0={{kind='spot',position=[0,0,4],direction=[0,0,-1],cone_angle={angle},penumbra=0,intensity=1.0132118364233778}}"
        )
    };
    let aside = |x: f64| EYE + DVec3::new(x, 9.0, 0.0);
    on_both(|backend| {
        let mut wide = Thin::new(in_fog(&[&spot(80.0)])?, backend);
        let whole = airlight(of_lamp, DVec3::Y, [0.0, HALF + 9.0]);
        hold(wide.look(EYE, aside(0.0))?.airlight, whole, "a wide spot");
        let mut narrow = Thin::new(in_fog(&[&spot(20.0)])?, backend);
        let radius = 3.5 * 20f64.to_radians().tan();
        let part = airlight(of_lamp, DVec3::Y, [9.0 - radius, 9.0 + radius]);
        hold(narrow.look(EYE, aside(0.0))?.airlight, part, "a narrow spot");
        for x in [-1.5 * radius, 1.2 * radius] {
            assert_eq!(narrow.look(EYE, aside(x))?.airlight, [0.0; 3], "beside the cone at {x}");
        }
        // Above the spot, which shines downwards.
        assert_eq!(narrow.look(EYE, DVec3::new(0.0, 0.0, 5.0))?.airlight, [0.0; 3]);
        Ok(())
    })
}
