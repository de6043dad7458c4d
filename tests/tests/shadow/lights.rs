//! Several lights: each casts its own shadow, and their light adds up.

use super::{case, color, on_both, sheets};
use vitrum_conformance::{Failure, frames};

/// Ground below a sheet that hovers, in red light from one side and green light from the other: beside the sheet both, in each shadow the other
/// one, and nowhere anything else but the shadows' edges.
#[test]
fn two_lights_cast_two_shadows() -> Result<(), Failure> {
    let settings = [
        "light=[{attachment='world',elevation=50,azimuth=90,color=[1,0,0]},{attachment='world',elevation=50,azimuth=-90,color=[0,1,0]}]",
        "shading.ambient=[0,0,0]",
        "ground={height=-1.5,color=[0.5,0.5,0.5]}",
        "shadow.resolution=64",
        "camera.elevation=80",
        "camera.azimuth=0",
        "camera.zoom=0.3",
    ];
    let case = case(sheets([0.0]), 96, &settings)?;
    let lit = 0.5 * 50f32.to_radians().sin();
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let count = |expected: [f32; 3]| {
            color(&frame).iter().filter(|pixel| (0..3).all(|c| (pixel[c] - expected[c]).abs() < 1e-4)).count()
        };
        let [both, red, green] = [[lit, lit, 0.0], [lit, 0.0, 0.0], [0.0, lit, 0.0]].map(count);
        assert!(both > 4000 && red > 100 && green > 100, "{both} in both lights, {red} in red, {green} in green light");
        assert!(red.abs_diff(green) < red / 10, "the shadows are mirror images: {red} and {green}");
        Ok(())
    })
}

/// Visible surfaces and their coverage do not depend on the lights.
#[test]
fn further_lights_add_radiance_and_nothing_else() -> Result<(), Failure> {
    let lights = [
        "{attachment='world',elevation=40,azimuth=60,color=[1,0.5,0.2]}",
        "{attachment='world',elevation=70,azimuth=-120,color=[0.3,0.5,1]}",
        "{kind='point',position=[1.5,-2,2.5],color=[9,3,5]}",
        "{kind='spot',position=[-2,1,3],color=[2,8,5],cone_angle=25}",
    ];
    let case = |lights: &str, surroundings: &[&str]| {
        let lights = format!("light=[{lights}]");
        case(
            sheets([0.0]),
            32,
            &[&[lights.as_str(), "ground={height=-1}", "shadow.resolution=32"], surroundings].concat(),
        )
    };
    let dark = ["shading.ambient=[0,0,0]", "environment.intensity=0"];
    for [first, second] in [[0, 1], [2, 1], [0, 2], [3, 2]].map(|pair| pair.map(|index: usize| lights[index])) {
        let cases = [case(&[first, second].join(","), &[])?, case(first, &[])?, case(second, &dark)?];
        on_both(|backend| {
            let frames = cases.iter().map(|case| frames::render(case, backend)).collect::<Result<Vec<_>, _>>()?;
            let [both, first, second] = &frames[..] else { unreachable!("there are three cases") };
            assert_ne!(color(second).iter().flatten().sum::<f32>(), 0.0, "the second light is to be seen");
            for ((both, first), second) in color(both).iter().zip(color(first)).zip(color(second)) {
                assert_eq!(*both, std::array::from_fn(|channel| first[channel] + second[channel]));
            }
            for (layer, alone) in both.layers.iter().zip(&first.layers).filter(|(layer, _)| layer.name != "color") {
                assert_eq!(layer, alone, "{}", layer.name);
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// The visible part of a disc behind a straight edge, whose distance from the disc's middle is `x` radii.
pub(super) fn segment(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 + (x.asin() + x * (1.0 - x * x).sqrt()) / std::f64::consts::PI
}

/// Ground a distance of 1 below the edge of a sheet, in light from straight above: the penumbra has a radius of tan α, and in it the light is the
/// part of the source's disc that the edge leaves.
#[test]
fn penumbras_are_as_wide_as_the_source_and_the_distance_say() -> Result<(), Failure> {
    let settings = [
        "light.0.elevation=90",
        "light.0.angular_radius=15",
        "shadow.samples=64",
        "shadow.resolution=256",
        "shading.ambient=[0,0,0]",
        "ground={height=-1,color=[1,1,1]}",
        "camera.projection=orthographic",
        "camera.azimuth=0",
        "camera.elevation=45",
        // On the ground below the sheet's edge, of which the camera sees the side.
        "camera.target=[0,1,-1]",
        "camera.zoom=2",
    ];
    const EDGE: usize = 65;
    let case = case(sheets([0.0]), EDGE as u32, &settings)?;
    let radius = 15f64.to_radians().tan();
    // The mean cosine of the incident directions.
    let lit = 2.0 * (radius.hypot(1.0) - 1.0) / (radius * radius);
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let (color, depth) = (color(&frame), frame.channel("depth", "Z").expect("it is an output"));
        let column = |row: usize| row * EDGE + EDGE / 2;
        let middle = f64::from(depth[column(EDGE / 2)]);
        let mut within = 0;
        for row in 0..EDGE {
            // Depth grows along (0, -1, -1) / √2, and the ground is level.
            let beyond = (middle - f64::from(depth[column(row)])) * std::f64::consts::SQRT_2;
            if beyond.abs() > 1.6 * radius {
                continue;
            }
            let (found, expected) = (f64::from(color[column(row)][0]) / lit, segment(beyond / radius));
            within += usize::from((0.02..0.98).contains(&expected));
            assert!((found - expected).abs() < 0.04, "{beyond} beyond the edge: {found} instead of {expected}");
        }
        assert!(within >= 8, "{within} pixels are in the penumbra");
        Ok(())
    })
}
