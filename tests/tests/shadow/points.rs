//! Light of points: it falls with the square of the distance, and shadows are in perspective.

use super::lights::segment;
use super::{case, color, on_both, sheets, speck};
use vitrum_conformance::refraction::{self, ball, cuboid};
use vitrum_conformance::shadow::{Map, seen_on_plane, view};
use vitrum_conformance::{Failure, frames};
use vitrum_kernels::glam::{DQuat, DVec2, DVec3};

/// Where `is_lit` changes between a lit and a dark place, by halving.
pub(super) fn edge(mut lit: DVec3, mut dark: DVec3, is_lit: impl Fn(DVec3) -> bool) -> DVec3 {
    for _ in 0..40 {
        let middle = 0.5 * (lit + dark);
        if is_lit(middle) { lit = middle } else { dark = middle }
    }
    lit
}

/// Reflectance · L cos θ / d² on ground and wall, L the radiance at a distance of 1.
#[test]
fn light_falls_with_the_square_of_the_distance() -> Result<(), Failure> {
    const LIGHT: DVec3 = DVec3::new(0.3, -0.4, 1.2);
    let usual = [
        "light.0={kind='point',position=[0.3,-0.4,1.2],color=[2,1,0.5],intensity=3}",
        "shading.ambient=[0,0,0]",
        "camera.projection=orthographic",
        "camera.zoom=0.02",
    ];
    let ground =
        ["ground={height=-0.5,color=[0.5,0.5,0.5]}", "camera.position=[0.7,4,9]", "camera.target=[0.7,0.5,-0.5]"];
    let wall = ["ground=none", "wall={azimuth=0,distance=1,color=[0.5,0.5,0.5]}", "camera.position=[0,9,2]"];
    for (plane, axis, at, normal) in [(&ground[..], 2, -0.5, DVec3::Z), (&wall, 1, -1.0, DVec3::Y)] {
        for shadows in ["light.0.shadows=true", "light.0.shadows=false"] {
            let case = case(speck(), 48, &[&usual[..], plane, &[shadows]].concat())?;
            on_both(|backend| {
                let frame = frames::render(&case, backend)?;
                let (mut compared, mut worst) = (0, 0f64);
                for (pixel, point) in color(&frame).iter().zip(seen_on_plane(&case, axis, at)) {
                    let way = point - LIGHT;
                    // The speck's shadow is on the ground below it, and it hides a part of the wall behind it.
                    let near = [DVec3::Z * -0.5, DVec3::new(0.0, -1.0, -0.2)].map(|middle| (point - middle).length());
                    if near.into_iter().any(|distance| distance < 0.3) {
                        continue;
                    }
                    let expected = 0.5 * 3.0 * -normal.dot(way) / way.length().powi(3);
                    for (found, color) in pixel.iter().zip([2.0, 1.0, 0.5]) {
                        worst = worst.max((f64::from(*found) / (color * expected) - 1.0).abs());
                    }
                    compared += 1;
                }
                println!("{shadows}: off by {worst:.1e}");
                assert!(compared > 2000 && worst < 1.4e-5, "{compared} pixels, off by {worst}");
                Ok(())
            })?;
        }
    }
    Ok(())
}

/// The shadow of a square is larger than the square by the ratio of the distances from the light.
#[test]
fn a_squares_shadow_is_its_projection() -> Result<(), Failure> {
    const LIGHT: DVec3 = DVec3::new(0.5, -0.3, 2.0);
    for resolution in [64, 256] {
        let setting = format!("shadow.resolution={resolution}");
        let light = "light.0={kind='point',position=[0.5,-0.3,2]}";
        let case = case(sheets([0.0]), 8, &[light, &setting])?;
        on_both(|backend| {
            let map = Map::of(&case, backend)?;
            let mut worst = 0f64;
            for depth in [0.3, 1.0, 6.0] {
                let projected = |x: f64, y: f64| LIGHT + (DVec3::new(x, y, 0.0) - LIGHT) * ((2.0 + depth) / 2.0);
                for (inner, outer) in [([0.6, 0.1], [1.4, 0.1]), ([-0.6, 0.1], [-1.4, 0.1]), ([0.1, 0.6], [0.1, 1.4])] {
                    let [dark, lit] = [inner, outer].map(|[x, y]: [f64; 2]| projected(x, y));
                    let found = edge(lit, dark, |point| map.at(point)[0] > 0.5);
                    let expected = projected(inner[0].clamp(-1.0, 1.0) / 0.6 * 1.0, inner[1]);
                    let expected = if inner[1] > 0.5 { projected(inner[0], 1.0) } else { expected };
                    let along = if inner[1] > 0.5 { DVec3::Y } else { DVec3::X };
                    // A column is in the shadow or is not; columns are as wide across the axis, and longer on a plane that leans.
                    let columns = (found - expected).dot(along).abs() / map.width(found);
                    worst = worst.max(columns);
                }
            }
            println!("{resolution}: off by at most {worst:.3} columns");
            assert!(worst < 0.6, "{resolution}: off by {worst} columns");
            Ok(())
        })?;
    }
    Ok(())
}

/// The shadow of a ball, on the ground below a light that stands above it, is a circle.
#[test]
fn a_balls_shadow_is_the_section_of_its_tangent_cone() -> Result<(), Failure> {
    let settings = ["light.0={kind='point',position=[0,0,3]}", "shadow.resolution=256"];
    let case = case(ball(128), 8, &settings)?;
    // Over a height of 5, tan asin(1/3) a unit.
    let radius = 5.0 / 8f64.sqrt();
    on_both(|backend| {
        let map = Map::of(&case, backend)?;
        let mut worst = 0f64;
        for step in 0..64 {
            let side = DVec2::from_angle(std::f64::consts::TAU * f64::from(step) / 64.0).extend(0.0);
            let below = DVec3::Z * -2.0;
            let found = edge(below + side * 3.0, below + side, |point| map.at(point)[0] > 0.5);
            worst = worst.max(((found - below).length() - radius).abs() / map.width(found));
        }
        println!("off by at most {worst:.3} columns of {:.4}", map.width(DVec3::Z * -2.0));
        assert!(worst < 0.8, "off by {worst} columns");
        Ok(())
    })
}

/// Beer and Lambert along each ray from the light, however obliquely it goes through a slab.
#[test]
fn clear_slabs_absorb_over_the_way_through_them() -> Result<(), Failure> {
    let mesh = cuboid(DVec3::new(1.0, 0.8, 0.3), DQuat::IDENTITY);
    let material = "material=[{ior=1.5,attenuation_color=[0.9,0.5,0.2],attenuation_distance=1.2}]";
    for light in [DVec3::new(0.2, 0.1, 1.0), DVec3::new(-1.5, 0.4, 1.3), DVec3::new(0.0, 0.0, 40.0)] {
        for (resolution, bound) in [("shadow.resolution=64", 3e-4), ("shadow.resolution=256", 2.5e-5)] {
            let position = format!("light.0={{kind='point',position=[{},{},{}]}}", light.x, light.y, light.z);
            let settings = [material, &position, resolution, "voxelization.resolution=32"];
            let case = case(mesh.clone(), 8, &settings)?;
            on_both(|backend| {
                let map = Map::of(&case, backend)?;
                let mut worst = 0f64;
                for x in [-0.7, -0.3, 0.0, 0.4, 0.8] {
                    for y in [-0.6, 0.1, 0.5] {
                        // Where the ray leaves the slab's lower face, and where it got into it.
                        let leaves = DVec3::new(x, y, -0.3);
                        let way = leaves - light;
                        let enters = light + way * ((light.z - 0.3) / (light.z + 0.3));
                        if enters.x.abs() > 0.97 || enters.y.abs() > 0.77 {
                            continue;
                        }
                        let found = map.at(leaves + way * 0.3);
                        for (found, color) in found.iter().zip([0.9f64, 0.5, 0.2]) {
                            let expected = color.powf((leaves - enters).length() / 1.2);
                            worst = worst.max((found - expected).abs());
                        }
                    }
                }
                println!("{light}, {resolution}: off by at most {worst:.1e}");
                assert!(worst < bound, "{light}, {resolution}: off by {worst}");
                Ok(())
            })?;
        }
    }
    Ok(())
}

/// What is convex does not shade itself where it faces the light.
#[test]
fn bodies_do_not_shade_themselves() -> Result<(), Failure> {
    let turned = cuboid(DVec3::new(0.7, 0.5, 0.9), DQuat::from_rotation_x(0.4) * DQuat::from_rotation_y(0.9));
    for mesh in [ball(48), turned] {
        for light in [DVec3::new(1.5, 0.9, 1.2), DVec3::new(6.0, -9.0, 5.0)] {
            for more in ["shadow.filter_radius=0", "shadow.filter_radius=0.1"] {
                for resolution in [16, 47, 128] {
                    let settings = [
                        &format!("light.0={{kind='point',position=[{},{},{}]}}", light.x, light.y, light.z),
                        "material.0={opaque=true,color=[1,1,1]}",
                        "shading.ambient=[0,0,0]",
                        // From about where the light is.
                        &format!("camera.azimuth={}", (-light.x).atan2(light.y).to_degrees()),
                        &format!("shadow.resolution={resolution}"),
                        more,
                    ];
                    let case = refraction::case("ball", mesh.clone(), 64, &settings)?;
                    on_both(|backend| {
                        let frame = frames::render(&case, backend)?;
                        let view = view(&case);
                        let channel = |layer: &str, name: &str| frame.channel(layer, name).expect("it is an output");
                        let normals = ["X", "Y", "Z"].map(|name| channel("normal", name));
                        let (color, alpha) = (channel("color", "R"), channel("color", "A"));
                        let depth = channel("depth", "Z");
                        let rays = seen_on_plane(&case, 2, 0.0);
                        let (mut lit, mut worst) = (0, 0f64);
                        for pixel in 0..color.len() {
                            let [x, y, z] = normals.map(|normal| f64::from(normal[pixel]));
                            if f64::from(alpha[pixel]) < 1.0 || (x, y, z) == (0.0, 0.0, 0.0) {
                                continue;
                            }
                            let towards = rays[pixel] - view.eye;
                            let point = view.eye + towards * (f64::from(depth[pixel]) / towards.dot(view.axes.z_axis));
                            let way = point - light;
                            let cosine = -(view.axes * DVec3::new(x, y, -z)).dot(way.normalize());
                            if cosine < 0.05 {
                                continue;
                            }
                            lit += 1;
                            let (found, expected) = (f64::from(color[pixel]), cosine / way.length_squared());
                            worst = worst.max((found / expected - 1.0).abs());
                        }
                        println!("{resolution}, {light}: {lit} lit, off by at most {worst:.1e}");
                        assert!(worst < 8e-6, "{resolution}, {light}: off by {worst}");
                        assert!(lit > 150, "{resolution}, {light}: {lit}");
                        Ok(())
                    })?;
                }
            }
        }
    }
    Ok(())
}

/// A point far away is a distant light: its shadow map lets the same light through.
#[test]
fn far_points_are_distant_lights() -> Result<(), Failure> {
    let mesh = || refraction::together(&[ball(32), cuboid(DVec3::new(1.2, 0.2, 1.4), DQuat::from_rotation_x(0.3))]);
    let usual =
        ["material=[{name=\"m1\",attenuation_color=[0.2,0.5,0.9]},{opaque=true,density=0.4}]", "shadow.resolution=96"];
    let near = case(mesh(), 8, &[&usual[..], &["light.0={kind='point',position=[30000,20000,50000]}"]].concat())?;
    let far = case(mesh(), 8, &[&usual[..], &["light.0.direction=[-3,-2,-5]"]].concat())?;
    on_both(|backend| {
        let (near, far) = (Map::of(&near, backend)?, Map::of(&far, backend)?);
        let (mut squares, mut count) = (0.0, 0);
        for x in -12..=12 {
            for y in -12..=12 {
                let point = DVec3::new(f64::from(x) * 0.15 - 1.0, f64::from(y) * 0.15 - 0.7, -1.6);
                squares += (near.at(point)[1] - far.at(point)[1]).powi(2);
                count += 1;
            }
        }
        let rms = (squares / f64::from(count)).sqrt();
        println!("rms {rms:.1e}");
        assert!(rms < 9e-5, "{rms}");
        Ok(())
    })
}

/// In a penumbra the light is the part of the ball's disc that a straight edge leaves.
#[test]
fn penumbras_show_the_part_of_the_ball_that_an_edge_leaves() -> Result<(), Failure> {
    const LIGHT: DVec3 = DVec3::new(0.0, 1.0, 4.0);
    const RADIUS: f64 = 0.3;
    let settings = [
        "light.0={kind='point',position=[0,1,4],radius=0.3,intensity=16}",
        "shadow.samples=64",
        "shading.ambient=[0,0,0]",
        "ground={height=-1,color=[1,1,1]}",
        "camera.projection=orthographic",
        "camera.azimuth=0",
        "camera.elevation=60",
        // Below the edge of the sheet that runs along x at y = 1.
        "camera.target=[0,1,-1]",
        "camera.zoom=4",
    ];
    let case = case(sheets([0.0]), 65, &settings)?;
    on_both(|backend| {
        let frame = frames::render(&case, backend)?;
        let (mut within, mut worst, mut lit) = (0, 0f64, 0);
        for (pixel, point) in color(&frame).iter().zip(seen_on_plane(&case, 2, -1.0)) {
            if point.x.abs() > 0.4 {
                continue;
            }
            let way = point - LIGHT;
            let free = 16.0 * -way.z / way.length().powi(3);
            // The distance of the ball's middle from the plane through the point and the edge.
            let [to_edge, to_light] = [DVec3::new(0.0, 1.0, 0.0) - point, LIGHT - point].map(|v| DVec2::new(v.y, v.z));
            let beyond = -to_edge.normalize().perp_dot(to_light) / RADIUS;
            let expected = segment(beyond);
            within += u32::from((0.02..0.98).contains(&expected));
            let found = f64::from(pixel[0]) / free;
            lit += u32::from(beyond > 1.2 && (found - 1.0).abs() < 2e-3);
            worst = worst.max((found - expected).abs());
        }
        println!("{within} in the penumbra, {lit} lit, off by at most {worst:.3}");
        assert!(within > 100 && lit > 100 && worst < 0.08, "{within}, {lit}, off by {worst}");
        Ok(())
    })
}
