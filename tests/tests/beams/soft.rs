//! Soft lights: as many crisp ones as samples, which become one light when the source shrinks.

use super::{case, on_the_cpu, red, rms};
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction::ball;
use vitrum_conformance::{Failure, frames};

/// Samples of a soft light.
const SAMPLES: u32 = 8;

/// Sizes of the source, each a quarter of the one before: radii in world units of a lamp 4 from the ball, and in degrees of distant light.
const RADII: [f64; 3] = [0.2, 0.05, 0.0125];

/// The least factor by which the difference from a crisp light falls when the source becomes a quarter as large. Samples lie evenly around the middle, so that the
/// picture is of second order in the size where it is smooth. A texel at a body's outline is lit or not, and the outline's edge in the picture is a pixel wide:
/// there squares are of first order, and the root of their mean of the order ½, by which the factor is 2. Found are 2.2 to 12.
const LEAST: f64 = 1.8;

/// The largest difference of the smallest source, over the brightest pixel, root mean square. Found are up to 4 · 10⁻⁴: the outline, see [`LEAST`].
const LARGEST: f64 = 1e-3;

fn in_fog(light: &str, samples: u32) -> Result<Case, Failure> {
    let samples = format!("shadow.samples={samples}");
    let settings = [
        light,
        &samples,
        "material=[{ior=1.5}]",
        "medium={absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],extent=6}",
        "ground={height=-3,color=[0,0,0]}",
        "camera.position=[0,-9,0.5]",
        "camera.target=[0,0,-0.3]",
        "camera.field_of_view=40",
        "beams.rays=64",
        "beams.views=1",
    ];
    case(ball(128), 96, &settings)
}

/// The setting of a light of a size.
type Soft = fn(f64) -> String;

fn lamp(radius: f64) -> String {
    format!("light.0={{kind='point',position=[0,0,4],radius={radius}}}")
}

fn sun(radius: f64) -> String {
    format!("light.0={{kind='distant',attachment='world',direction=[0.1,0.2,-1],angular_radius={radius}}}")
}

#[test]
fn soft_lights_become_crisp_ones() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        let kinds: [(&str, Soft); 2] = [("a lamp", lamp), ("distant light", sun)];
        for (name, light) in kinds {
            let crisp = frames::render(&in_fog(&light(0.0), 1)?, backend)?;
            let soft = RADII.map(|radius| frames::render(&in_fog(&light(radius), SAMPLES)?, backend));
            let soft = soft.into_iter().collect::<Result<Vec<_>, _>>()?;
            for output in ["caustics", "shadow"] {
                let expected = red(&crisp, output);
                let brightest = expected.iter().copied().fold(0.0, f64::max);
                let mut before = f64::INFINITY;
                for (radius, soft) in RADII.iter().zip(&soft) {
                    let soft = red(soft, output);
                    let error = rms(soft.iter().zip(&expected).map(|(soft, crisp)| soft - crisp)) / brightest;
                    println!("{name}, {radius}, {output}: {error:.2e}");
                    assert!(
                        error > 0.0 && error * LEAST <= before,
                        "{name}, {radius}, {output}: {error:.2e} after {before:.2e}"
                    );
                    before = error;
                }
                assert!(before <= LARGEST, "{name}, {output}: {before:.2e}");
            }
        }
        Ok(())
    })
}

/// A source without an extent is one light, whatever the samples.
#[test]
fn a_source_without_extent_is_crisp() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        for light in [lamp(0.0), sun(0.0)] {
            let [one, many] = [1, SAMPLES].map(|samples| in_fog(&light, samples));
            let (one, many) = (frames::render(&one?, backend)?, frames::render(&many?, backend)?);
            assert_eq!(one.layers, many.layers, "{light}");
        }
        Ok(())
    })
}
