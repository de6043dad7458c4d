//! Bodies within a volume: where they are seen, how they are lit, what light they take away, and how clear ones bend rays.

use crate::attenuation::homogeneous;
use crate::matter::lit_from_the_side;
use crate::setup::{backends, cube, end, straight_on};
use std::sync::Arc;
use vitrum::backend::Backend;
use vitrum::io::{Mesh, Volume};
use vitrum::scene::{ColorPoint, Material, OpacityPoint, Scene, Wall};
use vitrum::{Assets, Frame, OutputRequest, render_requested};
use vitrum_conformance::closed_forms::ball::{EDGE, crossing};
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::closed_forms::{orthographic_frame, start};

/// Radius of the body, in a cube of edge 2.
const RADIUS: f64 = 0.7;
/// Pixels along an edge of the picture.
const PIXELS: u32 = 65;

/// A ball around the origin, of triangles an eightieth of its radius wide.
fn ball(radius: f64) -> Mesh {
    const RINGS: u32 = 200;
    const SIDES: u32 = 400;
    let point = |ring: u32, side: u32| {
        let (polar, around) = (
            std::f64::consts::PI * f64::from(ring) / f64::from(RINGS),
            std::f64::consts::TAU * f64::from(side) / f64::from(SIDES),
        );
        [polar.sin() * around.cos(), polar.sin() * around.sin(), polar.cos()].map(|x| (x * radius) as f32)
    };
    let mut positions = vec![point(0, 0)];
    positions.extend((1..RINGS).flat_map(|ring| (0..SIDES).map(move |side| point(ring, side))));
    positions.push(point(RINGS, 0));
    let south = positions.len() as u32 - 1;
    let vertex = |ring: u32, side: u32| match ring {
        0 => 0,
        RINGS => south,
        _ => 1 + (ring - 1) * SIDES + side % SIDES,
    };
    let mut triangles = Vec::new();
    for ring in 0..RINGS {
        for side in 0..SIDES {
            let corners =
                [vertex(ring, side), vertex(ring + 1, side), vertex(ring + 1, side + 1), vertex(ring, side + 1)];
            triangles.push([corners[0], corners[1], corners[2]]);
            triangles.push([corners[0], corners[2], corners[3]]);
        }
    }
    triangles.retain(|[a, b, c]| a != b && b != c && a != c);
    Mesh::new("ball", positions, triangles).expect("a mesh")
}

/// A picture of a volume with a body within it.
fn render(scene: &Scene, volume: &Volume, body: &Arc<Mesh>, backend: &mut dyn Backend) -> Frame {
    let assets = Assets { bodies: Some(Arc::clone(body)), ..Assets::from(volume.clone()) };
    let request = OutputRequest { light: false, ..OutputRequest::default() };
    render_requested(scene, &assets, request, backend, &mut |_| true).expect("the scene renders")
}

/// A volume in which nothing is seen, and its scene, with a white body.
fn empty(azimuth: f32) -> (Volume, Scene) {
    let mut scene = lit_from_the_side(&[(0.0, 0.0)], PIXELS);
    scene.light[0].azimuth = azimuth;
    (cube(48, 2.0, |[x, _, _]| x), white(scene))
}

fn white(mut scene: Scene) -> Scene {
    scene.material = vec![Material { opaque: true, color: Some([1.0; 3]), ..Material::default() }];
    scene
}

/// The pixels whose rays meet the ball inside `share` of its radius: the index, and the point in view space, z towards the viewer from the ball's middle.
fn met(frame: &Frame, share: f64) -> Vec<(usize, [f64; 3])> {
    let (half, _) = orthographic_frame(2.0);
    let pixels = (0..frame.height).flat_map(|y| (0..frame.width).map(move |x| (x, y)));
    let points = pixels.filter_map(|(x, y)| {
        let [across, up] = start(frame, x, y, half);
        let height = RADIUS * RADIUS - across * across - up * up;
        let inside = across.hypot(up) < share * RADIUS;
        inside.then(|| ((y * frame.width + x) as usize, [across, up, height.sqrt()]))
    });
    points.collect()
}

#[test]
fn a_body_is_seen_where_its_surface_is() {
    let body = Arc::new(ball(RADIUS));
    let (_, centre) = orthographic_frame(2.0);
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for sample_distance in [1.0, 0.5] {
            let (volume, mut scene) = empty(0.0);
            scene.sweep.sample_distance = sample_distance;
            let frame = render(&scene, &volume, &body, backend.as_mut());
            let depth = frame.channel("depth", "Z").expect("depth");
            for (index, [.., towards]) in met(&frame, 0.9) {
                worst = larger(worst, (f64::from(depth[index]) - (-centre - towards)).abs() * 24.0);
            }
        }
        table::BODY_DEPTH.hold(worst, backend.as_ref());
    }
}

#[test]
fn a_body_is_lit_by_the_cosine() {
    let body = Arc::new(ball(RADIUS));
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for azimuth in [0.0f32, 60.0] {
            let (volume, scene) = empty(azimuth);
            let frame = render(&scene, &volume, &body, backend.as_mut());
            let color = frame.channel("color", "R").expect("color");
            let (sine, cosine) = f64::from(azimuth).to_radians().sin_cos();
            for (index, [across, _, towards]) in met(&frame, 0.9) {
                let expected = ((across * sine + towards * cosine) / RADIUS).max(0.0);
                worst = larger(worst, (f64::from(color[index]) - expected).abs());
            }
        }
        table::BODY_LIGHT.hold(worst, backend.as_ref());
    }
}

#[test]
fn matter_before_a_body_attenuates_what_is_seen_and_its_light() {
    let (volume, body) = (homogeneous(), Arc::new(ball(RADIUS)));
    let mut scene = white(straight_on(PIXELS));
    scene.environment.visible = false;
    scene.shading.specular = 0.0;
    scene.transfer.reference_length = Some(0.5);
    scene.transfer.opacity = vec![OpacityPoint { value: 0.0, opacity: 0.3 }];
    scene.transfer.color = vec![ColorPoint { value: 0.0, color: [0.0; 3] }];
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for sample_distance in [1.0, 0.5] {
            scene.sweep.sample_distance = sample_distance;
            let frame = render(&scene, &volume, &body, backend.as_mut());
            let color = frame.channel("color", "R").expect("color");
            for (index, [_, _, towards]) in met(&frame, 0.8) {
                // Twice the way from the front of the cube, whose edge is 2.
                let left = 0.7f64.powf(2.0 * (1.0 - towards) / 0.5);
                worst = larger(worst, (f64::from(color[index]) / (left * towards / RADIUS) - 1.0).abs());
            }
        }
        table::BODY_IN_MATTER.hold(worst, backend.as_ref());
    }
}

#[test]
fn a_body_throws_a_shadow_as_large_as_itself() {
    const BEHIND: f64 = 1.2;
    let body = Arc::new(ball(0.4));
    let (volume, mut scene) = empty(50.0);
    scene.wall = Some(Wall { distance: Some(BEHIND as f32), color: [1.0; 3], ..Wall::default() });
    let (sine, cosine) = 50.0f64.to_radians().sin_cos();
    for mut backend in backends() {
        let frame = render(&scene, &volume, &body, backend.as_mut());
        let color = frame.channel("color", "R").expect("color");
        let (half, _) = orthographic_frame(2.0);
        let (mut found, mut expected) = (0.0, 0.0);
        for (index, pixel) in (0..PIXELS * PIXELS).enumerate() {
            let [across, up] = start(&frame, pixel % PIXELS, pixel / PIXELS, half);
            // Light comes from the right and the front: the shadow is on the left.
            if across > -0.5 {
                continue;
            }
            found += 1.0 - f64::from(color[index]) / cosine;
            // The distance of the ball's middle from the light's way to the wall.
            let aside = (across * cosine + BEHIND * sine).hypot(up);
            expected += if aside < 0.4 { 1.0 } else { 0.0 };
        }
        table::BODY_SHADOW.hold((found / expected - 1.0).abs(), backend.as_ref());
    }
}

#[test]
fn a_clear_body_bends_rays_as_a_ball_lens() {
    let volume = cube(64, EDGE as f32, |[x, _, _]| x);
    let body = Arc::new(ball(1.0));
    let mut scene = lit_from_the_side(&[(0.0, 0.0)], 64);
    scene.sweep.sample_distance = 0.5;
    scene.material = vec![Material::default()];
    let (half, centre) = orthographic_frame(EDGE);
    for mut backend in backends() {
        let frame = render(&scene, &volume, &body, backend.as_mut());
        let mut worst = 0.0f64;
        for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
            let [sx, sy] = start(&frame, x, y, half);
            let h = sx.hypot(sy);
            if !(0.1..0.75).contains(&h) {
                continue;
            }
            let end = end(&frame, x, y);
            let radial = |v: [f64; 2]| (v[0] * sx + v[1] * sy) / h;
            let at = radial([end.position[0], end.position[1]]);
            let slope = radial([end.direction[0], end.direction[1]]) / -end.direction[2];
            let z = (centre - end.position[2]) - at / slope;
            worst = larger(worst, (z / crossing(h) - 1.0).abs());
        }
        table::BODY_LENS.hold(worst, backend.as_ref());
    }
}
