//! Projections show the largest, the smallest or the mean scalar of each viewing ray: against a walk along the ray in double precision, and
//! against the mean of a field that is linear.

use vitrum::Frame;
use vitrum::backend::Backend;
use vitrum::io::{Volume, Voxels};
use vitrum::method::View;
use vitrum::scene::{BlendMode, Clip, ColorPoint, Crop, OpacityPoint, Projection, Scene};
use vitrum_conformance::closed_forms::{cube, render};
use vitrum_kernels::glam::DVec3;

use crate::setup::backends;

/// Voxels along each edge, of edge 1 around the origin.
const N: u32 = 24;
const PIXELS: u32 = 24;
/// Look-ups in the steps of a projection, as a share of the planes' distance.
const SPACING: f64 = vitrum_kernels::sweep::project_rays::SPACING as f64;
/// Colours are a ratio of two half floats.
const HALVES: f64 = 1.5e-3;

/// A number from 0 to ½ for each voxel, without order.
fn noise(x: u32, y: u32, z: u32) -> f32 {
    let mixed = (x * 73 + y * 179 + z * 283).wrapping_mul(2_654_435_761);
    ((mixed ^ mixed >> 15) % 1000) as f32 / 2000.0
}

/// Noise, with a bright ball in it and a single voxel that is brighter still; `inverted` with a dark one of each.
fn noisy(inverted: bool) -> Volume {
    let value = |x: u32, y: u32, z: u32| {
        let far = (f64::from(x) - 15.0).hypot(f64::from(y) - 9.0).hypot(f64::from(z) - 12.0);
        let bright = if (x, y, z) == (6, 14, 8) {
            1.0
        } else if far < 4.0 {
            0.8
        } else {
            noise(x, y, z)
        };
        if inverted { 1.0 - bright } else { bright }
    };
    let all = (0..N).flat_map(|z| (0..N).flat_map(move |y| (0..N).map(move |x| value(x, y, z)))).collect::<Vec<_>>();
    let mut volume = Volume::new("noise", [N; 3], [1.0; 3], Voxels::F32(all.into())).expect("finite numbers");
    volume.origin = [-0.5 * (N as f32 - 1.0); 3];
    volume
}

/// A scene whose colour is the scalar from 0 to 1.
fn scene(blend_mode: BlendMode) -> Scene {
    let mut scene = Scene::default();
    scene.shading.blend_mode = blend_mode;
    scene.transfer.opacity = vec![OpacityPoint { value: 0.0, opacity: 1.0 }];
    scene.transfer.color = vec![ColorPoint { value: 0.0, color: [0.0; 3] }, ColorPoint { value: 1.0, color: [1.0; 3] }];
    scene.environment.visible = false;
    (scene.camera.azimuth, scene.camera.elevation) = (31.0, 22.0);
    (scene.film.width, scene.film.height) = (PIXELS, PIXELS);
    scene
}

fn voxels(volume: &Volume) -> &[f32] {
    let Voxels::F32(voxels) = &volume.voxels else { panic!("it holds floats") };
    voxels
}

/// The interpolated scalar at a point of the world; beyond the outer voxels' centres it stays as it is.
fn scalar(volume: &Volume, at: DVec3) -> f64 {
    let last = f64::from(N - 1);
    let place = (at + 0.5 * last).clamp(DVec3::ZERO, DVec3::splat(last));
    let low = place.floor().min(DVec3::splat(last - 1.0));
    let t = place - low;
    let corner = |dx: u32, dy: u32, dz: u32| {
        let (x, y, z) = (low.x as u32 + dx, low.y as u32 + dy, low.z as u32 + dz);
        f64::from(voxels(volume)[((z * N + y) * N + x) as usize])
    };
    let along = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let row = |dy, dz| along(corner(0, dy, dz), corner(1, dy, dz), t.x);
    along(along(row(0, 0), row(1, 0), t.y), along(row(0, 1), row(1, 1), t.y), t.z)
}

/// The half-spaces, outward normal and distance, that a ray's way is in: the volume or its crop box, and the clipping planes.
fn half_spaces(scene: &Scene) -> Vec<(DVec3, f64)> {
    let Crop { min, max } = scene.crop.clone().unwrap_or_default();
    let face = |share: f32| (f64::from(share) - 0.5) * f64::from(N);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let faces = (0..3).flat_map(|a| [(-axes[a], -face(min[a])), (axes[a], face(max[a]))]);
    let clips = scene.clip.iter().map(|clip| {
        let normal = DVec3::from_array(clip.normal.map(f64::from)).normalize();
        (normal, f64::from(clip.offset))
    });
    faces.chain(clips).collect()
}

/// The viewing ray of a pixel: a point, and the way to the point one unit of depth further.
fn ray(view: &View, x: u32, y: u32) -> (DVec3, DVec3) {
    let side = |i: u32| (f64::from(i) + 0.5) / f64::from(PIXELS) * 2.0 - 1.0;
    let aside = view.axes * DVec3::new(side(x) * view.half_size[0], -side(y) * view.half_size[1], 0.0);
    if view.orthographic { (view.eye + aside, view.axes.z_axis) } else { (view.eye, view.axes.z_axis + aside) }
}

/// The depths between which a ray is in all half-spaces; `None` where it misses them, or is in them for less than a hundredth of a voxel.
fn depths(scene: &Scene, (from, step): (DVec3, DVec3)) -> Option<[f64; 2]> {
    let (mut near, mut far) = (0.0_f64, f64::INFINITY);
    for (normal, distance) in half_spaces(scene) {
        let (at, speed) = (distance - normal.dot(from), normal.dot(step));
        match speed {
            0.0 if at < 0.0 => return None,
            0.0 => {}
            speed if speed > 0.0 => far = far.min(at / speed),
            speed => near = near.max(at / speed),
        }
    }
    (far - near > 0.01).then_some([near, far])
}

/// The scalars along a ray, two hundred for each voxel, with their depths.
fn walk(volume: &Volume, (from, step): (DVec3, DVec3), [near, far]: [f64; 2]) -> Vec<(f64, f64)> {
    let count = ((far - near) * 200.0).ceil() as u32;
    let depth = |i: u32| near + (far - near) * f64::from(i) / f64::from(count);
    (0..=count).map(|i| (depth(i), scalar(volume, from + step * depth(i)))).collect()
}

fn channel<'a>(frame: &'a Frame, layer: &str, name: &str) -> &'a [f32] {
    frame.channel(layer, name).expect("the output exists")
}

/// Views, clips, crops and steps that a projection goes by.
fn cases(blend_mode: BlendMode) -> Vec<(&'static str, Scene)> {
    let case = |label, change: fn(&mut Scene)| {
        let mut scene = scene(blend_mode);
        change(&mut scene);
        (label, scene)
    };
    vec![
        case("perspective", |_| {}),
        case("orthographic, finer", |scene| {
            scene.camera.projection = Projection::Orthographic;
            scene.sweep.sample_distance = 0.5;
        }),
        case("along an axis", |scene| {
            scene.camera.projection = Projection::Orthographic;
            (scene.camera.azimuth, scene.camera.elevation) = (0.0, 0.0);
        }),
        case("clipped", |scene| {
            let removes = vitrum::scene::Removes::Opacity;
            scene.clip = vec![
                Clip { normal: [0.3, -1.0, 0.2], offset: 2.3, removes },
                Clip { normal: [1.0, 0.5, 0.1], offset: 5.0, ..Clip::default() },
            ];
        }),
        case("cropped", |scene| {
            scene.crop = Some(Crop { min: [0.13, 0.2, 0.1], max: [0.8, 0.93, 0.71] });
        }),
        case("from within", |scene| {
            scene.camera.position = Some([1.5, 2.5, -1.0]);
            scene.camera.target = Some([-2.0, -6.0, 3.0]);
            scene.camera.field_of_view = 70.0;
        }),
    ]
}

/// Holds the picture of an extremum to the extremum of a walk along each ray. The kernel looks up points of the ray at most `SPACING` of a plane's
/// step apart, and the interpolated scalar changes by no more than its steepest slope between the extremum and the nearest of them.
fn hold_extremum(blend_mode: BlendMode, volume: &Volume, backend: &mut dyn Backend) {
    let sign = if blend_mode == BlendMode::Maximum { 1.0 } else { -1.0 };
    for (label, scene) in cases(blend_mode) {
        let frame = render(&scene, volume, backend);
        let view = View::new(&scene, volume);
        let (color, opacity, depth) =
            (channel(&frame, "color", "R"), channel(&frame, "opacity", "Y"), channel(&frame, "depth", "Z"));
        let (mut hits, mut loss) = (0, 0.0_f64);
        for (index, (x, y)) in (0..PIXELS).flat_map(|y| (0..PIXELS).map(move |x| (x, y))).enumerate() {
            let ray = ray(&view, x, y);
            let Some(ends) = depths(&scene, ray) else { continue };
            let walked = walk(volume, ray, ends);
            let steepest = walked
                .windows(2)
                .map(|pair| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs())
                .fold(0.0, f64::max);
            let exact = walked.iter().map(|&(_, scalar)| sign * scalar).fold(f64::NEG_INFINITY, f64::max);
            let found = sign * f64::from(color[index]);
            let bound = steepest * 0.5 * SPACING * f64::from(scene.sweep.sample_distance);
            assert!(
                found <= exact + HALVES && found >= exact - bound - HALVES,
                "{label} ({x}, {y}): {found}, exact {exact}, bound {bound}"
            );
            assert!((f64::from(opacity[index]) - 1.0).abs() < 1e-6, "{label} ({x}, {y})");
            // The scalar is there where the depth says.
            let at = f64::from(depth[index]);
            assert!(at > ends[0] - 1e-3 && at < ends[1] + 1e-3, "{label} ({x}, {y}): depth {at} of {ends:?}");
            let there = sign * scalar(volume, ray.0 + ray.1 * at);
            assert!(
                (there - found).abs() < HALVES + 1e-3 * steepest,
                "{label} ({x}, {y}): {there} at the depth of {found}"
            );
            hits += 1;
            loss = loss.max(exact - found);
        }
        println!("{label}: {hits} rays, the greatest loss {loss:.4}");
        assert!(hits > 60, "{label}: {hits}");
        let missed = (0..PIXELS * PIXELS).filter(|&index| opacity[index as usize] == 0.0).count();
        assert!(hits + missed >= (PIXELS * PIXELS) as usize - 12, "{label}: a ray that misses shows nothing");
    }
}

#[test]
fn a_maximum_is_that_of_a_walk_along_the_ray() {
    for mut backend in backends() {
        hold_extremum(BlendMode::Maximum, &noisy(false), backend.as_mut());
    }
}

#[test]
fn a_minimum_is_that_of_a_walk_along_the_ray() {
    for mut backend in backends() {
        hold_extremum(BlendMode::Minimum, &noisy(true), backend.as_mut());
    }
}

#[test]
fn a_mean_is_that_of_a_walk_along_the_ray() {
    let volume = noisy(false);
    for mut backend in backends() {
        for (label, scene) in cases(BlendMode::Mean) {
            let frame = render(&scene, &volume, backend.as_mut());
            let view = View::new(&scene, &volume);
            let (color, depth) = (channel(&frame, "color", "R"), channel(&frame, "depth", "Z"));
            let (mut hits, mut worst) = (0, 0.0_f64);
            for (index, (x, y)) in (0..PIXELS).flat_map(|y| (0..PIXELS).map(move |x| (x, y))).enumerate() {
                let ray = ray(&view, x, y);
                // Grazing ways are shorter than the rounding of their ends.
                let Some(ends) = depths(&scene, ray).filter(|[near, far]| far - near > 1.0) else { continue };
                let walked = walk(&volume, ray, ends);
                let exact = walked.iter().map(|&(_, scalar)| scalar).sum::<f64>() / walked.len() as f64;
                worst = worst.max((f64::from(color[index]) - exact).abs());
                assert_eq!(depth[index], 0.0, "a mean has no depth");
                hits += 1;
            }
            println!("{label}: {hits} rays, the greatest error {worst:.5}");
            // In noise from voxel to voxel a midpoint is up to ⅛ of the change over a part off, without order.
            assert!(hits > 60 && worst < 6e-3, "{label}: {hits} rays, {worst}");
        }
    }
}

/// Interpolation between voxels' centres reproduces a linear field, and its mean over a chord is the value in the chord's middle.
#[test]
fn the_mean_of_a_linear_field_is_that_in_the_middle_of_the_chord() {
    let field = |at: DVec3| 0.5 + at.dot(DVec3::new(0.013, -0.009, 0.007));
    let volume = cube(N, N as f32, |at| field(DVec3::from_array(at)));
    let (low, high) = (0.5 / N as f32, 1.0 - 0.5 / N as f32);
    for mut backend in backends() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let mut scene = scene(BlendMode::Mean);
            scene.camera.projection = projection;
            scene.crop = Some(Crop { min: [low; 3], max: [high; 3] });
            let frame = render(&scene, &volume, backend.as_mut());
            let view = View::new(&scene, &volume);
            let color = channel(&frame, "color", "R");
            let mut hits = 0;
            for (index, (x, y)) in (0..PIXELS).flat_map(|y| (0..PIXELS).map(move |x| (x, y))).enumerate() {
                let (from, step) = ray(&view, x, y);
                let Some([near, far]) = depths(&scene, (from, step)) else { continue };
                let exact = field(from + step * f64::midpoint(near, far));
                let found = f64::from(color[index]);
                assert!((found - exact).abs() < HALVES, "({x}, {y}): {found}, exact {exact}");
                hits += 1;
            }
            assert!(hits > 200, "{hits}");
        }
    }
}

#[test]
fn what_is_skipped_changes_nothing() {
    let volume = noisy(false);
    for mut backend in backends() {
        for blend_mode in [BlendMode::Maximum, BlendMode::Minimum, BlendMode::Mean] {
            for (label, mut scene) in cases(blend_mode) {
                let skipping = render(&scene, &volume, backend.as_mut());
                scene.sweep.empty_space_skipping = false;
                let all = render(&scene, &volume, backend.as_mut());
                assert!(skipping.layers == all.layers, "{blend_mode:?}, {label}");
            }
        }
    }
}

/// A scene's light, ground, filter and refraction leave a projection as it is; opacity and colour are the table's for one reference length.
#[test]
fn a_projection_shows_the_table_and_nothing_else() {
    let volume = noisy(false);
    for mut backend in backends() {
        let mut plain = scene(BlendMode::Maximum);
        plain.transfer.opacity =
            vec![OpacityPoint { value: 0.3, opacity: 0.2 }, OpacityPoint { value: 1.0, opacity: 0.7 }];
        plain.transfer.reference_length = Some(3.0);
        let mut lit = plain.clone();
        lit.light.push(vitrum::scene::Light { intensity: 7.0, ..Default::default() });
        lit.ground = Some(Default::default());
        lit.shading.ambient = [0.9; 3];
        lit.transfer.ior = vec![vitrum::scene::IorPoint::new(0.0, 1.0), vitrum::scene::IorPoint::new(1.0, 1.5)];
        lit.transfer.filter = vec![ColorPoint { value: 0.0, color: [0.2, 0.5, 0.9] }];
        let [found, same] = [&plain, &lit].map(|scene| render(scene, &volume, backend.as_mut()));
        assert!(found.layers == same.layers);
        let (color, opacity) = (channel(&found, "color", "R"), channel(&found, "opacity", "Y"));
        for (&color, &opacity) in color.iter().zip(opacity).filter(|(_, opacity)| **opacity > 0.0) {
            let scalar = f64::from(color / opacity);
            let expected = 0.2 + 0.5 * ((scalar - 0.3) / 0.7).clamp(0.0, 1.0);
            // The scalar is right to the halves, and the opacity follows it by a slope of ½ / 0.7.
            assert!((f64::from(opacity) - expected).abs() < 3.0 * HALVES, "{opacity} at {scalar}, expected {expected}");
        }
    }
}
