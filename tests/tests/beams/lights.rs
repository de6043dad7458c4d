//! Several lights: a picture of them is the sum of pictures of each, in every output of radiance.

use super::{case, on_both};
use vitrum::Frame;
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::ball;
use vitrum_conformance::{Failure, frames};

/// The outputs that are radiance.
const OUTPUTS: [&str; 5] = ["color", "surfaces", "airlight", "caustics", "shadow"];

/// The intensity of all lights together: a power of two, so that its parts are exact.
const INTENSITY: f64 = 4.0;

/// Half a unit in the last place of an f32 of 1: the rounding of a sum, as a share of it.
const ROUNDING: f64 = 1.0 / 16_777_216.0;

/// Rays along each edge of a light's lattice, and pixels along each edge of the picture: few, since what is said of a picture is said of each pixel by itself,
/// and to the last bit.
const RAYS: u32 = 16;
const EDGE: u32 = 32;

/// A clear ball above a floor in fog of three colours.
fn in_fog(lights: &[String]) -> Result<Case, Failure> {
    let (lights, rays) = (format!("light=[{}]", lights.join(",")), format!("beams.rays={RAYS}"));
    let settings = [
        lights.as_str(),
        "material=[{ior=1.5}]",
        "medium={absorption=[0.02,0.01,0.005],scattering=[0.1,0.2,0.05],anisotropy=0.5,extent=6}",
        "ground={height=-2,color=[0.8,0.5,0.2]}",
        "camera.position=[0,-9,0.5]",
        "camera.target=[0,0,-0.3]",
        "camera.field_of_view=40",
        &rays,
        "beams.views=3",
    ];
    case(ball(64), EDGE, &settings)
}

fn lamp([x, y, z]: [f64; 3], intensity: f64) -> String {
    format!("{{kind='point',position=[{x},{y},{z}],intensity={intensity}}}")
}

/// Red, green and blue of an output, one after the other.
fn values(frame: &Frame, output: &str) -> Vec<f32> {
    let channels =
        ["R", "G", "B"].map(|channel| frame.channel(output, channel).expect("frames of beams have the output"));
    channels.concat()
}

/// Equal lights at one place are one light. Each has a quarter or a sixteenth of the intensity, a power of two, to which the unit of the beams' sums is
/// proportional: its picture is a quarter or a sixteenth of the one light's to the last bit. What is left is the rounding of their sum.
#[test]
fn equal_lights_at_one_place_are_one() -> Result<(), Failure> {
    let of = |count: u32| {
        let light = lamp([0.3, -0.4, 4.0], INTENSITY / f64::from(count));
        in_fog(&vec![light; count as usize])
    };
    let (one, others) = (of(1)?, [(4, of(4)?), (16, of(16)?)]);
    on_both(|backend| {
        let whole = frames::render(&one, backend)?;
        for (count, case) in &others {
            let sum = frames::render(case, backend)?;
            for output in OUTPUTS {
                let (whole, sum) = (values(&whole, output), values(&sum, output));
                assert!(whole.iter().any(|value| *value > 0.0), "{output} is black");
                let bound = f64::from(count - 1) * ROUNDING;
                let error = |(whole, sum): (&f32, &f32)| {
                    (f64::from(*sum) - f64::from(*whole)).abs() / f64::from(*whole).max(1e-30)
                };
                let worst = whole.iter().zip(&sum).map(error).fold(0.0, f64::max);
                println!("{count} lights, {output}: {worst:.1e} ({})", backend.name());
                assert!(worst <= bound, "{count} lights, {output}: off by {worst:.1e}, more than {bound:.1e}");
            }
        }
        Ok(())
    })
}

/// Lights of two kinds at different places: their picture is the sum of one of each to the last bit, since each light has beams and sums of its own.
#[test]
fn lights_at_different_places_add_up() -> Result<(), Failure> {
    let first = lamp([0.3, -0.4, 4.0], INTENSITY);
    let second = "{kind='spot',position=[3,-1,3],direction=[-1,0.3,-1],intensity=9,cone_angle=30}".to_owned();
    let third =
        "{kind='distant',attachment='world',direction=[0.5,0.3,-1],intensity=0.3,color=[1,0.5,0.2],angular_radius=0}"
            .to_owned();
    let all = in_fog(&[first.clone(), second.clone(), third.clone()])?;
    let alone = [in_fog(&[first])?, in_fog(&[second])?, in_fog(&[third])?];
    on_both(|backend| {
        let together = frames::render(&all, backend)?;
        let [first, second, third] = [&alone[0], &alone[1], &alone[2]].map(|case| frames::render(case, backend));
        let (first, second, third) = (first?, second?, third?);
        for output in OUTPUTS {
            let [first, second, third] = [&first, &second, &third].map(|frame| values(frame, output));
            let lit = |values: &[f32]| values.iter().any(|value| *value > 0.0);
            assert!(lit(&first) && lit(&second) && lit(&third), "{output} is black");
            let sum = first.iter().zip(&second).zip(&third).map(|((first, second), third)| first + second + third);
            assert!(values(&together, output).into_iter().eq(sum), "{output}");
        }
        // What is not radiance is the same with any lights.
        for (output, channel) in [("depth", "Z"), ("normal", "X"), ("color", "A")] {
            assert_eq!(together.channel(output, channel), first.channel(output, channel), "{output}");
        }
        Ok(())
    })
}
