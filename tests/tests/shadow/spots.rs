//! Spots: cones of light, and pictures that they project.

use super::{case, color, on_both, sheets, speck};
use std::sync::Arc;
use vitrum_conformance::case::Case;
use vitrum_conformance::shadow::{Map, seen_on_plane};
use vitrum_conformance::{Failure, frames};
use vitrum_io::{Mesh, Picture};
use vitrum_kernels::glam::{DVec2, DVec3};

/// Ground at a height of −1 as seen from above, in a spot's light alone.
fn from_above(mesh: Mesh, edge: u32, settings: &[&str]) -> Result<Case, Failure> {
    let usual = [
        "ground={height=-1,color=[1,1,1]}",
        "shading.ambient=[0,0,0]",
        "camera.projection=orthographic",
        "camera.position=[0,2,9]",
        "camera.target=[0,0,-1]",
    ];
    case(mesh, edge, &[&usual[..], settings].concat())
}

/// A circle of light on the ground whose radius is the distance times tan α, with a fade that ends there; nothing outside of it.
#[test]
fn a_cone_ends_at_its_angle() -> Result<(), Failure> {
    for (angle, penumbra) in [(20.0, 0.0), (35.0, 0.5), (35.0, 1.0)] {
        let light = format!(
            "light.0={{kind='spot',position=[0.2,-0.1,2],direction=[0,0,-2],cone_angle={angle},penumbra={penumbra},intensity=9}}"
        );
        let case = from_above(speck(), 96, &[&light, "camera.zoom=0.01"])?;
        let [outer, inner] = [angle, angle * (1.0 - penumbra)].map(|angle: f64| angle.to_radians().tan());
        on_both(|backend| {
            let frame = frames::render(&case, backend)?;
            let (mut counts, mut worst) = ([0; 3], 0f64);
            for (pixel, point) in color(&frame).iter().zip(seen_on_plane(&case, 2, -1.0)) {
                let way = point - DVec3::new(0.2, -0.1, 2.0);
                let tangent = way.truncate().length() / 3.0;
                if (tangent - outer).abs() < 1e-4 || point.truncate().length() < 0.3 {
                    continue;
                }
                let share = ((outer - tangent) / (outer - inner).max(1e-9)).clamp(0.0, 1.0);
                let share = share * share * (3.0 - 2.0 * share);
                let expected = 9.0 * 3.0 / way.length().powi(3) * share;
                counts[if share == 0.0 {
                    0
                } else if share < 1.0 {
                    1
                } else {
                    2
                }] += 1;
                if share == 0.0 {
                    assert_eq!(pixel, &[0.0; 3], "outside of the cone, at {point}");
                }
                worst = worst.max((f64::from(pixel[0]) - expected).abs());
            }
            println!("{angle}°, {penumbra}: {counts:?}, off by at most {worst:.1e}");
            assert!(counts[0] > 1000 && (penumbra == 1.0 || counts[2] > 500), "{counts:?}");
            assert!(worst < 4.5e-6, "off by {worst}");
            Ok(())
        })?;
    }
    Ok(())
}

/// Four colours: red and green on top, blue and white below.
fn slide(case: &mut Case) {
    let texels = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]];
    case.scene.light[0].texture = Some("slide.png".into());
    case.assets.textures.insert("slide.png".into(), Arc::new(Picture::rgb(2, 2, texels)));
}

/// A picture is upright on a wall that the spot shines at past the viewer, and on the ground for one who looks down.
#[test]
fn pictures_are_upright() -> Result<(), Failure> {
    let wall = [
        "light.0={kind='spot',position=[0,3,0.05],direction=[0,-1,0],cone_angle=30,penumbra=0,intensity=16}",
        "ground=none",
        "wall={azimuth=0,distance=1,color=[1,1,1]}",
        "camera.position=[0,9,0.05]",
        "camera.target=[0,-1,0.05]",
        "camera.zoom=0.01",
    ];
    let ground = [
        "light.0={kind='spot',position=[0,0,2],direction=[0,0,-1],cone_angle=30,penumbra=0,intensity=9}",
        "camera.zoom=0.01",
    ];
    let by_camera = [
        "light.0={kind='spot',position=[0,0,2],direction=[0,0,-1],cone_angle=30,penumbra=0,intensity=9,attachment='camera'}",
        "camera.roll=90",
        "camera.zoom=0.01",
    ];
    for (settings, axis, at) in [(&wall[..], 1, -1.0), (&ground, 2, -1.0), (&by_camera, 2, -1.0)] {
        let mut case = from_above(speck(), 64, settings)?;
        slide(&mut case);
        let points = seen_on_plane(&case, axis, at);
        on_both(|backend| {
            let frame = frames::render(&case, backend)?;
            let pixels = color(&frame);
            // The middle of the light, in pixels, and the pixel a quarter of the picture away from it towards a corner.
            let (mut lit, mut sum) = (0.0, DVec2::ZERO);
            for (index, _) in pixels.iter().enumerate().filter(|(_, pixel)| pixel.iter().any(|channel| *channel > 0.0))
            {
                lit += 1.0;
                sum += DVec2::new((index % 64) as f64, (index / 64) as f64);
            }
            let (middle, radius) = (sum / lit, (lit / std::f64::consts::PI).sqrt());
            assert!(radius > 8.0 && radius < 31.0, "{radius} at {middle}, {}", points[32 * 64 + 32]);
            let at = |across: f64, down: f64| {
                let place = middle + DVec2::new(across, down) * radius * 0.6;
                pixels[place.y.round() as usize * 64 + place.x.round() as usize]
            };
            let is = |pixel: [f32; 3], expected: [bool; 3]| {
                let brightest = pixel.iter().copied().fold(0.0, f32::max);
                let found = pixel.map(|channel| channel > 0.5 * brightest);
                assert!(brightest > 0.3 && found == expected, "{settings:?}: {pixel:?}, not {expected:?}");
            };
            is(at(-1.0, -1.0), [true, false, false]);
            is(at(1.0, -1.0), [false, true, false]);
            is(at(-1.0, 1.0), [false, false, true]);
            is(at(1.0, 1.0), [true; 3]);
            Ok(())
        })?;
    }
    Ok(())
}

/// Halfway between two texels' middles is the mean of both, in the place that the tangents give.
#[test]
fn pictures_are_interpolated_between_texels() -> Result<(), Failure> {
    let light = "light.0={kind='spot',position=[0,0,2],direction=[0,0,-1],cone_angle=30,penumbra=0,intensity=9}";
    let mut case = from_above(speck(), 64, &[light, "camera.zoom=0.01"])?;
    slide(&mut case);
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let (mut compared, mut worst) = (0, 0f64);
        for (pixel, point) in color(&frame).iter().zip(seen_on_plane(&case, 2, -1.0)) {
            let place = point.truncate() / (3.0 * 30f64.to_radians().tan());
            if place.length() > 0.99 || point.truncate().length() < 0.1 {
                continue;
            }
            // Towards the viewer, who stands at +y, and to his right, which is −x.
            let across = (0.5 + (0.5 * -place.x + 0.5) * 2.0 - 1.0).clamp(0.0, 1.0);
            let down = (0.5 + (0.5 * place.y + 0.5) * 2.0 - 1.0).clamp(0.0, 1.0);
            let [red, green, blue] = [(1.0 - across) * (1.0 - down) + across * down, across, down];
            let way = point - DVec3::Z * 2.0;
            let free = 9.0 * 3.0 / way.length().powi(3);
            for (found, expected) in pixel.iter().zip([red, green, blue]) {
                worst = worst.max((f64::from(*found) - free * expected).abs());
            }
            compared += 1;
        }
        println!("{compared} pixels, off by at most {worst:.1e}");
        assert!(compared > 1000 && worst < 4e-6, "{compared} pixels, off by {worst}");
        Ok(())
    })
}

/// The shadow of a square in a narrow cone, whose columns are narrower than those of a point's light, too.
#[test]
fn narrow_cones_have_fine_shadows() -> Result<(), Failure> {
    let of = |kind: &str| {
        case(sheets([0.0]), 8, &["shadow.resolution=64", &format!("light.0={{{kind},position=[1.2,0.1,3]}}")])
    };
    let spot = of("kind='spot',direction=[-0.1,0,-1],cone_angle=6")?;
    let point = of("kind='point'")?;
    on_both(|backend| {
        let (spot, point) = (Map::of(&spot, backend)?, Map::of(&point, backend)?);
        let light = DVec3::new(1.2, 0.1, 3.0);
        let expected = light + (DVec3::new(1.0, 0.1, 0.0) - light) * (4.0 / 3.0);
        assert!(
            spot.width(expected) < 0.5 * point.width(expected),
            "{} {}",
            spot.width(expected),
            point.width(expected)
        );
        for map in [&spot, &point] {
            let found =
                super::points::edge(expected + DVec3::X * 0.2, expected - DVec3::X * 0.2, |at| map.at(at)[0] > 0.5);
            let columns = (found - expected).length() / map.width(expected);
            println!("off by {columns:.3} columns of {:.4}", map.width(expected));
            assert!(columns < 0.45, "off by {columns} columns");
        }
        Ok(())
    })
}
