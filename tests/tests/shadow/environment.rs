//! Light of an environment (`environment.lights`).

use super::{case, color, on_both, sheets, speck};
use vitrum_conformance::{Failure, frames};

/// An environment of one colour, in no other light.
const USUAL: [&str; 7] = [
    "light=[]",
    "shading.ambient=[0,0,0]",
    "environment.kind=color",
    "environment.color=[0.8,0.6,0.4]",
    "environment.intensity=2",
    "ground={height=-1,color=[0.5,0.5,0.5]}",
    "camera.projection=orthographic",
];

/// The radiance of a diffuse plane in an environment of one colour is its reflectance times that colour; of 32 lights the irradiance is off
/// by 3 % at most over all orientations, which is the error of the directions; on level ground by 0.06 %, on the wall by 0.7 %.
#[test]
fn planes_reflect_an_environment_of_one_colour() -> Result<(), Failure> {
    const OFF: f32 = 0.03;
    let ground = ["camera.position=[0.7,4,9]", "camera.target=[0.7,0.5,-1]"];
    let wall = ["ground=none", "wall={azimuth=0,distance=1,color=[0.5,0.5,0.5]}", "camera.position=[0,9,2]"];
    for plane in [&ground[..], &wall] {
        let settings = [&USUAL[..], &["environment.lights=32", "camera.zoom=0.02"], plane].concat();
        let case = case(speck(), 32, &settings)?;
        on_both(|backend| {
            let frame = frames::render(&case, backend)?;
            let off = |pixel: &[f32; 3]| {
                let errors = pixel.iter().zip([0.8, 0.6, 0.4]).map(|(found, expected)| (found / expected - 1.0).abs());
                errors.fold(0.0, f32::max)
            };
            let mut errors: Vec<f32> = color(&frame).iter().map(off).collect();
            errors.sort_by(f32::total_cmp);
            // The others have the speck, and its shadows.
            let most = errors[errors.len() * 95 / 100];
            println!("{plane:?}: off by {most}");
            assert!(most < OFF, "{plane:?}: off by {most}");
            Ok(())
        })?;
    }
    Ok(())
}

/// As ambient light, to a few roundings: opaque triangles, ground and wall.
#[test]
fn ambient_light_of_an_environment_of_one_colour_is_exact() -> Result<(), Failure> {
    let settings = ["environment.ambient=1", "wall={azimuth=0,distance=3,color=[0.5,0.5,0.5]}"];
    let case = case(sheets([0.0]), 24, &[&USUAL[..], &settings, &["camera.elevation=20"]].concat())?;
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let reflectances: Vec<f32> = color(&frame).iter().map(|pixel| pixel[0] / 1.6).collect();
        for (pixel, reflectance) in color(&frame).iter().zip(&reflectances) {
            for (found, radiance) in pixel.iter().zip([1.6, 1.2, 0.8]) {
                assert!((found / (radiance * reflectance) - 1.0).abs() < 1e-5, "{pixel:?}");
            }
        }
        // Ground and wall have a reflectance of a half.
        assert!(reflectances.iter().filter(|reflectance| (**reflectance - 0.5).abs() < 1e-5).count() > 100);
        Ok(())
    })
}

/// Below the middle of a square, at half an edge from it, ground sees what the square leaves of the environment.
///
/// The square's form factor is (4 / π) · atan(1 / √2) / √2 = 0.554. Of 256 lights, each is seen or not: the edge of the square is met to
/// about the root of the number of lights near it, 40, of 256. Found: 0.467 of the environment, not 0.446.
#[test]
fn bodies_hide_the_environment_from_the_ground() -> Result<(), Failure> {
    const EDGE: usize = 17;
    let settings = ["environment.lights=256", "shadow.resolution=64", "camera.elevation=20", "camera.target=[0,0,-1]"];
    let case = case(sheets([0.0]), EDGE as u32, &[&USUAL[..], &settings].concat())?;
    let root = 0.5f64.sqrt();
    let open = 1.0 - 4.0 / std::f64::consts::PI * root.atan() * root;
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let found = f64::from(color(&frame)[EDGE * EDGE / 2][0]) / 0.8;
        println!("{found} of the environment is open, {open} by its closed form");
        assert!((found - open).abs() < 0.025, "{found}, not {open}");
        Ok(())
    })
}

/// Lights in the place of an environment add radiance to the frame without them, and nothing else; further lights of the scene are beside them.
#[test]
fn an_environment_adds_light_to_that_of_the_scene() -> Result<(), Failure> {
    let with = |settings: &[&str]| {
        case(sheets([0.0]), 24, &[&USUAL[1..], &["light.0.elevation=60", "shadow.resolution=32"], settings].concat())
    };
    let dark = ["light=[]", "environment.lights=3"];
    let cases = [with(&["environment.lights=3"])?, with(&[])?, with(&dark)?, with(&["light=[]"])?];
    on_both(|backend| {
        let frames = cases.iter().map(|case| frames::render(case, backend)).collect::<Result<Vec<_>, _>>()?;
        let [both, scene, environment, black] = &frames[..] else { unreachable!("there are four cases") };
        let mut lit = 0;
        for (((both, scene), environment), black) in
            color(both).iter().zip(color(scene)).zip(color(environment)).zip(color(black))
        {
            for channel in 0..3 {
                let light = environment[channel] - black[channel];
                lit += usize::from(light > 0.1);
                let error = both[channel] - scene[channel] - light;
                // The order of the sums alone.
                assert!(error.abs() < 2e-6, "off by {error}");
            }
        }
        assert!(lit > 500, "{lit} values are lit by the environment");
        for (layer, alone) in both.layers.iter().zip(&scene.layers).filter(|(layer, _)| layer.name != "color") {
            assert_eq!(layer, alone, "{}", layer.name);
        }
        Ok(())
    })
}
