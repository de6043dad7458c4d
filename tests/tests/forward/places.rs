//! Points through volumes: shadows by similar triangles, a ball lens, light of a point far away, and the sum of lights of several kinds.

use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::ball;
use crate::shot::{Cuboid, Shot, vector};
use crate::{on_both, on_the_cpu};

const WALL: f64 = 1.25;
const VOXELS: u32 = 40;
const EDGE: f64 = 2.0;
const VOXEL: f64 = EDGE / VOXELS as f64;
/// The half edges of an opaque block, whose faces lie between voxels.
const HALF: DVec3 = DVec3::new(0.4, 0.2, 0.3);
/// The azimuth from which the camera sees the wall beside the block.
const AZIMUTH: f64 = 50.0;

fn wall_seen_from_the_side() -> Vec<String> {
    vec![
        format!("wall={{distance={WALL},color=[1,1,1]}}"),
        format!("camera.azimuth={AZIMUTH}"),
        vector("camera.target", DVec3::new(0.0, -WALL, 0.0)),
        "camera.zoom=0.9".to_owned(),
    ]
}

/// The edges of a block's shadow lie where similar triangles say, within half a voxel of the block's edges.
#[test]
fn the_shadow_of_a_block_spreads_from_a_point() -> Result<(), Failure> {
    let light = DVec3::new(0.15, 2.4, -0.1);
    let is_inside = |at: [f64; 3]| at.iter().zip(HALF.to_array()).all(|(x, half)| x.abs() < half);
    let volume = cube(VOXELS, EDGE as f32, |at| if is_inside(at) { 1.0 } else { 0.0 });
    let mut settings = wall_seen_from_the_side();
    settings.extend([
        "light.0={kind='point',intensity=10}".to_owned(),
        vector("light.0.position", light),
        "transfer.opacity=[{value=0.49,opacity=0},{value=0.51,opacity=1}]".to_owned(),
    ]);
    let shot = Shot::new(volume, 160, &settings)?;
    // The silhouette is that of the face next to the light or of the one behind it, whichever goes farther out.
    let outline = |by: f64| {
        let projected = |x: f64, y: f64, from: f64| from + (x - from) * (light.y + WALL) / (light.y - y);
        let end = |half: f64, from: f64, sign: f64| {
            let at = |y: f64| projected(sign * (half + by), y, from);
            let (near, far) = (at(HALF.y + by), at(-HALF.y - by));
            if sign > 0.0 { near.max(far) } else { near.min(far) }
        };
        let [x, z] =
            [(HALF.x, light.x), (HALF.z, light.z)].map(|(half, from)| [end(half, from, -1.0), end(half, from, 1.0)]);
        [x, z]
    };
    let is_within = |[x, z]: [[f64; 2]; 2], at: DVec3| at.x > x[0] && at.x < x[1] && at.z > z[0] && at.z < z[1];
    let [inner, shrunk, grown, outer] = [-2.0, -0.5, 0.5, 2.0].map(|voxels| outline(voxels * VOXEL));
    let body = Cuboid::around(DVec3::ZERO, HALF);
    on_both(|backend, held| {
        let pixels = shot.render(backend)?;
        let (mut lit, mut dark, mut seen, mut astray) = (0.0f64, 0.0f64, 0, 0);
        for (red, (from, along)) in pixels.red.iter().zip(shot.rays()) {
            if body.grown(1.5 * VOXEL).crossing(from, along).is_some() {
                continue;
            }
            let at = from + along * ((-WALL - from.y) / along.y);
            let way = at - light;
            let open = -10.0 * way.y / way.length() / way.length_squared();
            let share = red / open;
            let is_dark = share < 0.5;
            seen += usize::from(is_within(shrunk, at));
            // The outline is where half of the light is left.
            astray += usize::from((is_within(shrunk, at) && !is_dark) || (!is_within(grown, at) && is_dark));
            if is_within(inner, at) {
                dark = dark.max(share);
            } else if !is_within(outer, at) {
                lit = lit.max((share - 1.0).abs());
            }
        }
        assert!(seen > 100, "{seen} pixels see the shadow");
        assert_eq!(astray, 0, "{}: pixels on the wrong side of the shadow's outline", backend.name());
        // Two voxels off the outline nothing has changed the light, or all of it went through four voxels and more of what is opaque.
        held.at_most(backend, "light in the shadow of a block under a point, relative", dark, 1e-3);
        held.at_most(backend, "light beside the shadow of a block under a point, relative", lit, 1e-3);
        Ok(())
    })
}

/// The flux through discs of a wall behind a ball lens, against rays through the formula of its surface. The voxels' surface is rougher than the formula's
/// and throws some light beside the focus, which is farther behind the ball than that of light from far away: 3.1 % with the usual cells, 7.6 and 8.7 % with
/// two and four times as many, which follow the voxels better.
#[test]
fn light_of_a_point_behind_a_ball_is_all_there_and_in_its_place() -> Result<(), Failure> {
    let distance = 4.0;
    let strength = 16.0;
    let lamp = [
        format!("light.0={{kind='point',intensity={strength}}}"),
        vector("light.0.position", DVec3::new(0.0, distance, 0.0)),
    ];
    let landed = ball::landed_from(distance);
    let shot = ball::shot(ball::IOR)?.with(&lamp)?;
    on_both(|backend, held| {
        let red = shot.render(backend)?.red;
        for (radius, bound) in [(ball::DISC, 0.015), (0.5, 0.035)] {
            let (found, expected) = (ball::flux_of(&shot, &red, radius), strength * ball::flux_from(&landed, radius));
            println!("{}: within {radius}: {found:.4}, rays {expected:.4}", backend.name());
            let error = (found / expected - 1.0).abs();
            held.at_most(backend, &format!("flux of a point within {radius} behind a ball, relative"), error, bound);
        }
        Ok(())
    })
}

/// Where nothing bends it, the flux of a point through a disc is that of its solid angle: on the wall all is told by a cosine and the inverse square.
#[test]
fn light_of_a_point_that_nothing_bends_has_the_flux_of_a_solid_angle() -> Result<(), Failure> {
    let distance = 4.0;
    let lamp =
        ["light.0={kind='point',intensity=16}".to_owned(), vector("light.0.position", DVec3::new(0.0, distance, 0.0))];
    let shot = ball::shot(1.0)?.with(&lamp)?;
    on_the_cpu(|backend, held| {
        let red = shot.render(backend)?.red;
        for radius in [0.5, ball::DISC] {
            let cosine = (distance + ball::WALL) / radius.hypot(distance + ball::WALL);
            let expected = 16.0 * std::f64::consts::TAU * (1.0 - cosine);
            let error = (ball::flux_of(&shot, &red, radius) / expected - 1.0).abs();
            held.at_most(backend, &format!("flux of a point through a disc of radius {radius}, relative"), error, 1e-3);
        }
        Ok(())
    })
}

/// A soft blob that scatters and bends.
fn blob(settings: &[String]) -> Result<Shot, Failure> {
    let volume = cube(32, 2.0, |[x, y, z]| (-6.0 * (x * x + y * y + z * z)).exp());
    let mut all = wall_seen_from_the_side();
    all.extend([
        "transfer.opacity=[{value=0,opacity=0},{value=1,opacity=0.1}]".to_owned(),
        "transfer.ior=[{value=0,ior=1},{value=1,ior=1.02}]".to_owned(),
    ]);
    all.extend_from_slice(settings);
    Shot::new(volume, 64, &all)
}

/// The largest difference of two pictures, over the brightest pixel of the second.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let brightest = b.iter().copied().fold(0.0, f64::max);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / brightest
}

/// A thousand times as far away as the volume is wide, light has one direction to half a thousandth.
#[test]
fn a_point_far_away_is_a_distant_light() -> Result<(), Failure> {
    let towards = DVec3::new(0.2, -1.0, -0.3).normalize();
    let far = 2000.0;
    let distant = blob(&[vector("light.0.direction", towards)])?;
    let point = blob(&[
        format!("light.0={{kind='point',intensity={}}}", far * far),
        vector("light.0.position", towards * -far),
    ])?;
    on_both(|backend, held| {
        let (distant, point) = (distant.render(backend)?.red, point.render(backend)?.red);
        held.at_most(backend, "a point far away against a distant light", difference(&point, &distant), 3e-3);
        Ok(())
    })
}

/// Light adds up, whatever its kinds, to rounding.
#[test]
fn lights_of_several_kinds_add_up() -> Result<(), Failure> {
    let lights = [
        "{kind='distant',attachment='world',direction=[0.2,-1,-0.3],angular_radius=0}",
        "{kind='point',position=[1.5,2,0.5],intensity=3}",
        "{kind='spot',position=[-2,2,4],intensity=30,attachment='camera'}",
    ];
    let all = blob(&[format!("light=[{}]", lights.join(","))])?;
    on_the_cpu(|backend, held| {
        let together = all.render(backend)?.red;
        let mut sum = vec![0.0; together.len()];
        for light in lights {
            let alone = blob(&[format!("light=[{light}]")])?.render(backend)?.red;
            sum.iter_mut().zip(alone).for_each(|(sum, red)| *sum += red);
        }
        held.at_most(backend, "three lights against their sum", difference(&sum, &together), 1e-5);
        Ok(())
    })
}

/// A lamp in the box around the volume is refused by name, for no one axis has all of its light, but shines on all if nothing hides it.
#[test]
fn a_lamp_in_the_box_is_refused_unless_it_casts_no_shadows() -> Result<(), Failure> {
    let lamp = ["light.0={kind='point',position=[0.3,-0.6,0.2],intensity=1}".to_owned()];
    let shot = blob(&lamp)?;
    let shadowless = shot.with(&["light.0.shadows=false".to_owned()])?;
    on_the_cpu(|backend, _| {
        let error = shot.render(backend).err().map(|failure| failure.to_string()).unwrap_or_default();
        assert!(error.contains("light.0") && error.contains("inside the box around the volume"), "{error}");
        let red = shadowless.render(backend)?.red;
        assert!(red.iter().copied().fold(0.0, f64::max) > 0.5);
        Ok(())
    })
}
